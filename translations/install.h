// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QCoreApplication;

namespace mocapress {

/// The program's and Qt's own texts in the user's language, as far as there are any; else English.
/// A second call replaces them by those of another language.
void installTranslations(QCoreApplication& application);

}  // namespace mocapress
