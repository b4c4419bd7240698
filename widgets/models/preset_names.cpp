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
            Presets::tr(
                "Characters the camera comes near to: an error of 0.65 mm on the skin, heads and "
                "hands turned by about a degree at most.")};
  if (word == "gameplay")
    return {Presets::tr("Gameplay"),
            Presets::tr(
                "Characters in play: an error of 2.5 mm on the skin, heads turned by 2.5 degrees "
                "at most and hands by 4.")};
  if (word == "planted-feet")
    return {
        Presets::tr("Planted feet"),
        Presets::tr("As Gameplay, with feet that stay where they stand: much less sliding, for 5 "
                    "to 13 % more bytes.")};
  if (word == "crowd")
    return {
        Presets::tr("Crowd"),
        Presets::tr("Figures in the background: an error of 6 mm on the skin, heads turned by 7.5 "
                    "degrees at most and hands by 12.")};
  if (word == "archive")
    return {Presets::tr("Archive"),
            Presets::tr("To keep in place of the source: no point of the body more than 1 mm off "
                        "at any frame.")};
  return {QString::fromStdString(preset.name), {}};
}

/// The name of a body part in the user's language, a joint's own as it is.
QString partText(const std::string& name) {
  for (const BodyPart part : kBodyParts)
    if (name == mocapress::name(part)) return displayName(part);
  return QString::fromStdString(name);
}

}  // namespace

QString displayName(BodyPart part) {
  switch (part) {
    case BodyPart::Feet:
      return Presets::tr("Feet");
    case BodyPart::Hands:
      return Presets::tr("Hands");
    case BodyPart::Fingers:
      return Presets::tr("Fingers");
    case BodyPart::Head:
      return Presets::tr("Head");
  }
  return {};
}

QString displayName(Effort effort) {
  switch (effort) {
    case Effort::Draft:
      return Presets::tr("Draft");
    case Effort::Default:
      return Presets::tr("Default");
    case Effort::Best:
      return Presets::tr("Best");
  }
  return {};
}

QString displayName(Ends ends) {
  switch (ends) {
    case Ends::Free:
      return Presets::tr("Free");
    case Ends::Even:
      return Presets::tr("Even");
    case Ends::Exact:
      return Presets::tr("Exact");
  }
  return {};
}

QString importanceText(const NamedImportance& importance) {
  QStringList texts;
  const auto add = [&](const QString& name, double factor) {
    texts << Presets::tr("%1 × %L2").arg(name).arg(factor, 0, 'g', 3);
  };
  for (const auto& [name, factor] : importance.factors) add(partText(name), factor);
  if (importance.contacts > 0) add(Presets::tr("Contacts"), importance.contacts);
  return texts.join(QStringLiteral(", "));
}

QString detailsOf(const Preset& preset) {
  QStringList texts;
  if (!preset.importance.is_even())
    texts << Presets::tr("Importance: %1.").arg(importanceText(preset.importance));
  if (preset.effort != Effort::Default)
    texts << Presets::tr("Effort: %1.").arg(displayName(preset.effort));
  if (preset.ends != Ends::Even) texts << Presets::tr("Ends: %1.").arg(displayName(preset.ends));
  if (preset.contacts)
    texts << Presets::tr("%Ln contact(s) of its own.", nullptr,
                         static_cast<int>(preset.contacts->size()));
  return texts.join(QLatin1Char(' '));
}

QString displayName(const Preset& preset) {
  return textsOf(preset).name;
}

QString purposeOf(const Preset& preset) {
  return textsOf(preset).purpose;
}

}  // namespace mocapress
