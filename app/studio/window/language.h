// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mocapress {

/// The code of the language that the user chose, such as "fr"; empty: the system's.
QString chosenLanguage();
void chooseLanguage(const QString& code);

/// The event loop's exit code that asks for a window in the language chosen last.
inline constexpr int kOtherLanguage = 1000;

}  // namespace mocapress
