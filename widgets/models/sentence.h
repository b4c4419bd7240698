// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace mocapress {

/// Translates a sentence of core (a warning, an error) into the program's language. A beginning
/// that ends with a colon, such as file and line, is kept; so is a sentence that is not in the
/// list.
QString translatedSentence(const QString& sentence);

/// The list, in English, with %1 and on for what differs.
std::vector<QString> translatableSentences();

}  // namespace mocapress
