// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/preset_names.h"

#include <QCoreApplication>

namespace mocapress {
namespace {

struct Presets {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Presets)
};

struct Texts {
  QString name, purpose;
};

Texts textsOf(const Preset& preset) {
  const std::string word = slug(preset.name);
  if (word == "hero-close-up")
    return {Presets::tr("Hero close-up"),
            Presets::tr("Characters the camera comes near to: no point of the body more than 5 mm "
                        "off at any frame.")};
  if (word == "gameplay")
    return {Presets::tr("Gameplay"),
            Presets::tr("Characters in play: an error of 5 mm, up to which the paper saw no "
                        "artifact.")};
  if (word == "crowd")
    return {Presets::tr("Crowd"),
            Presets::tr("Figures in the background: an error of 2 cm, as small as it gets.")};
  if (word == "archive")
    return {Presets::tr("Archive"),
            Presets::tr("To keep in place of the source: no point of the body more than 1 mm off "
                        "at any frame.")};
  return {QString::fromStdString(preset.name), {}};
}

}  // namespace

QString displayName(const Preset& preset) {
  return textsOf(preset).name;
}

QString purposeOf(const Preset& preset) {
  return textsOf(preset).purpose;
}

}  // namespace mocapress
