// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/characters.h"

#include "core/base/error.h"
#include "core/formats/motion_file.h"
#include "core/motion/rig.h"

namespace mocapress {

PutCharacter characterOn(const Characters& characters, const Skeleton& skeleton) {
  const auto found = characters.find(rig_of(skeleton));
  return found == characters.end() ? PutCharacter() : found->second;
}

PutCharacter readCharacterOn(Characters& characters, const Skeleton& skeleton) {
  const auto found = characters.find(rig_of(skeleton));
  if (found == characters.end()) return {};
  PutCharacter& put = found->second;
  if (put.path.isEmpty() || put.character.skin || !put.trouble.isEmpty()) return put;
  try {
    put.character = read_character(put.path.toStdU16String());
  } catch (const Error& error) {
    put.trouble = QString::fromUtf8(error.what());
  }
  return put;
}

CharacterFiles filesOf(const Characters& characters) {
  CharacterFiles files;
  for (const auto& [rig, put] : characters) files.emplace(rig, put.path);
  return files;
}

QString characterFile(const CharacterFiles& files, const std::string& rig) {
  if (rig.empty() && files.size() == 1) return files.begin()->second;
  const auto found = files.find(rig);
  return found == files.end() ? QString() : found->second;
}

}  // namespace mocapress
