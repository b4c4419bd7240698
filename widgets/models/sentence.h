// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace mocapress {

/// Translates a sentence of core (a warning, an error) into the program's language. Keeps a prefix
/// that ends with a colon, such as file and line. A sentence that is not in the list stays as it
/// is.
QString translatedSentence(const QString& sentence);

/// All sentences that can be translated, in English; %1, %2 and so on stand for the parts that
/// vary.
std::vector<QString> translatableSentences();

}  // namespace mocapress
