// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <map>
#include <string>

#include "core/motion/skin.h"

namespace mocapress {

/// A character put on clips, and the file it came from.
struct PutCharacter {
  Character character;  // without a skin: it was not read yet, or cannot be
  QString path;         // empty: each clip has its own
  QString trouble;      // why it cannot be read; empty: it can, or nobody tried
};

/// By rig_of(): each is on all clips of its rig. The one of "" is on all clips of other rigs, where
/// it fits: projects had one character for all.
using Characters = std::map<std::string, PutCharacter>;

/// The character on clips of this skeleton.
PutCharacter characterOn(const Characters& characters, const Skeleton& skeleton);

/// The same, read now where it was not, which the map keeps.
PutCharacter readCharacterOn(Characters& characters, const Skeleton& skeleton);

/// The files alone.
using CharacterFiles = std::map<std::string, QString>;
CharacterFiles filesOf(const Characters& characters);

/// The file of what is on clips of this rig; empty: each has its own. A clip whose rig is not known
/// yet ("") gets the only one there is: where that does not fit it is left off, and that is said.
QString characterFile(const CharacterFiles& files, const std::string& rig);

}  // namespace mocapress
