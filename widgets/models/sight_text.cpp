// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/sight_text.h"

#include <QCoreApplication>

#include "widgets/models/shown_number.h"

namespace mocapress {
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
