// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/display_names.h"

#include <QCoreApplication>
#include <string>

#include "core/codec/methods/compression_method.h"
#include "widgets/models/number_text.h"

namespace mocapress {

namespace {

struct Methods {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Methods)
};

// The titles come from core and are repeated here so that lupdate finds them. A test fails when one
// is missing.
[[maybe_unused]] constexpr const char* kTitles[] = {
    QT_TRANSLATE_NOOP("mocapress::Methods", "Closed-loop wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Annealed wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Standard wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Per-channel wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Haar wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Linear wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "PCA"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Frame subsampling"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Quaternion wavelets"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Segment PCA, after Liu & McMillan"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Clustered PCA, after Arikan"),
    QT_TRANSLATE_NOOP("mocapress::Methods", "Key frames per track"),
};

}  // namespace

QString translatedMethod(const char* title) {
  return Methods::tr(title);
}

QString methodTitle(std::string_view name) {
  return Methods::tr(std::string(method_title(name)).c_str());
}

QString seriesTitle(std::string_view method, const std::optional<double>& ik_ratio) {
  const QString title = methodTitle(method);
  return ik_ratio ? Methods::tr("%1 + IK %L2:1").arg(title).arg(*ik_ratio) : title;
}

namespace {

struct Presets {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Presets)
};

struct Texts {
  QString name, purpose;
};

Texts textsOf(const Settings& preset) {
  const std::string word = slug(preset.name);
  if (word == "hero-close-up")
    return {Presets::tr("Hero close-up"),
            Presets::tr("Characters near the camera: an error of 0.65 mm on the body's surface, "
                        "about a degree of heads and hands.")};
  if (word == "gameplay")
    return {Presets::tr("Gameplay"),
            Presets::tr("Characters in play: an error of 2.5 mm on the body's surface, at most "
                        "2.5 degrees of heads and 4 of hands.")};
  if (word == "planted-feet")
    return {
        Presets::tr("Planted feet"),
        Presets::tr("Like Gameplay, with much less sliding of feet, for 5 to 13 % more bytes.")};
  if (word == "crowd")
    return {Presets::tr("Crowd"),
            Presets::tr("Figures in the background: an error of 6 mm on the body's surface, at "
                        "most 7.5 degrees of heads and 12 of hands.")};
  if (word == "archive")
    return {Presets::tr("Archive"), Presets::tr("For archives that replace the source: no point of "
                                                "the body's surface has an error above 1 mm at any "
                                                "frame.")};
  return {QString::fromStdString(preset.name), {}};
}

/// The name of a body part in the user's language; a joint keeps its own name.
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

QString detailsOf(const Settings& preset) {
  QStringList texts;
  if (!preset.importance.is_even())
    texts << Presets::tr("Importance: %1.").arg(importanceText(preset.importance));
  if (preset.effort != Effort::Default)
    texts << Presets::tr("Effort: %1.").arg(displayName(preset.effort));
  if (preset.ends != Ends::Even) texts << Presets::tr("Ends: %1.").arg(displayName(preset.ends));
  if (preset.limits.distance_m != kUsualDistance)
    texts << Presets::tr("Watched from %L1 m.").arg(preset.limits.distance_m, 0, 'g', 3);
  if (preset.contacts)
    texts << Presets::tr("%Ln contact(s) of its own.", nullptr,
                         static_cast<int>(preset.contacts->size()));
  if (!preset.ranges.empty())
    texts << Presets::tr("%Ln range(s) with more care.", nullptr,
                         static_cast<int>(preset.ranges.size()));
  return texts.join(QLatin1Char(' '));
}

QString displayName(const Settings& preset) {
  return textsOf(preset).name;
}

QString purposeOf(const Settings& preset) {
  return textsOf(preset).purpose;
}

namespace {

struct Names {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Names)
};

}  // namespace

QString displayName(Method method) {
  return methodTitle(name(method));
}

QString displayName(Coding coding) {
  switch (coding) {
    case Coding::Rle16:
      return Names::tr("16-bit runs");
    case Coding::Deflate:
      return Names::tr("16-bit runs + DEFLATE");
    case Coding::Adaptive:
      return Names::tr("Adaptive");
  }
  return {};
}

QString displayName(Weighting weighting) {
  switch (weighting) {
    case Weighting::BoneEnds:
      return Names::tr("Bone ends");
    case Weighting::JointOrigins:
      return Names::tr("Joint origins");
    case Weighting::Surface:
      return Names::tr("Surface");
    case Weighting::Shell:
      return Names::tr("Shell");
    case Weighting::Skin:
      return Names::tr("Skin");
  }
  return {};
}

QString displayName(CorrectAt at) {
  return at == CorrectAt::EveryFrame ? Names::tr("Every frame") : Names::tr("Contacts");
}

namespace {

struct SightTexts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Sight)
};

}  // namespace

QString displayName(Sight sight) {
  switch (sight) {
    case Sight::NotVisible:
      return SightTexts::tr("not visible");
    case Sight::Borderline:
      return SightTexts::tr("borderline");
    case Sight::Visible:
      return SightTexts::tr("visible");
  }
  return {};
}

QString sightText(Sight sight, double distance_m) {
  return SightTexts::tr("%1 from %L2 m").arg(displayName(sight)).arg(distance_m, 0, 'g', 3);
}

QString displayName(Cue cue) {
  switch (cue) {
    case Cue::Velocity:
      return SightTexts::tr("velocity");
    case Cue::Place:
      return SightTexts::tr("place about the body");
    case Cue::Jitter:
      return SightTexts::tr("trembling");
    case Cue::Slide:
      return SightTexts::tr("sliding foot");
    case Cue::Lift:
      return SightTexts::tr("floating foot");
    case Cue::Floor:
      return SightTexts::tr("below the floor");
    case Cue::Flight:
      return SightTexts::tr("flight");
    case Cue::Head:
      return SightTexts::tr("turned head");
    case Cue::Hand:
      return SightTexts::tr("turned hand");
  }
  return {};
}

QString sightText(const WorstSight& seen) {
  const QString verdict = displayName(sight_of(seen.times_noticed()));
  if (seen.value <= 0) return verdict;
  const bool is_angle = seen.cue == Cue::Head || seen.cue == Cue::Hand;
  const QString of_unit =
      is_angle ? QStringLiteral("°")
               : QLatin1Char(' ') + QString::fromUtf8(unit(seen.cue).data(), unit(seen.cue).size());
  return SightTexts::tr("%1: %2 %3, noticed from %4")
      .arg(verdict, displayName(seen.cue), shownFigure(seen.value) + of_unit,
           shownFigure(seen.noticed_from) + of_unit);
}

}  // namespace mocapress
