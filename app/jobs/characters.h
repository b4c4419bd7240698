// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <map>
#include <string>

#include "core/motion/skin.h"

namespace mocapress {

/// A character put on clips, and its file.
struct PutCharacter {
  Character character;  // has no skin until it is read
  QString path;         // empty: each clip keeps its own
  QString trouble;      // why it cannot be read; empty: no error so far
};

/// Characters by rig_of(); each is shown on all clips of its rig.
using Characters = std::map<std::string, PutCharacter>;

/// The character for clips of this skeleton.
PutCharacter characterOn(const Characters& characters, const Skeleton& skeleton);

/// Like characterOn(), but reads the character's file on first use and keeps the result in the map.
PutCharacter readCharacterOn(Characters& characters, const Skeleton& skeleton);

/// The files of characters, by rig_of().
using CharacterFiles = std::map<std::string, QString>;
CharacterFiles filesOf(const Characters& characters);

/// The file of the character for clips of this rig; empty: each clip keeps its own. A clip whose
/// rig is unknown ("") gets the only character if there is exactly one; if that does not fit, the
/// clip keeps its own, with a warning.
QString characterFile(const CharacterFiles& files, const std::string& rig);

}  // namespace mocapress
