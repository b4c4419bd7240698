// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/report_language.h"

namespace mocapress {

/// Translations for reports into the program's language, including core's messages in them.
ReportLanguage reportLanguage();

}  // namespace mocapress
