// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace mocapress {

/// A sentence of core (a warning, an error) in the language of the program. What stands before it
/// with a colon, such as a file and a line, stays; so does a sentence that is not in the list.
QString translatedSentence(const QString& sentence);

/// The list, in English, with %1 and on for what differs.
std::vector<QString> translatableSentences();

}  // namespace mocapress
