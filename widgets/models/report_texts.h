// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/report_language.h"

namespace mocapress {

/// The program's language, for reports. Messages of core in them are translated, too.
ReportLanguage reportLanguage();

}  // namespace mocapress
