// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace mocapress {

/// Codes of the languages whose texts are in the program.
QStringList shippedLanguages();

}  // namespace mocapress
