// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/sight_colour.h"

#include <algorithm>
#include <cmath>

namespace mocapress {

QColor sightColour(Sight sight) {
  switch (sight) {
    case Sight::NotVisible:
      return {0x3d, 0x4d, 0x5f};
    case Sight::Borderline:
      return {0xf2, 0xb7, 0x05};
    case Sight::Visible:
      return {0xd5, 0x3e, 0x1a};
  }
  return {};
}

QColor sightColour(double times_noticed) {
  const Sight sight = sight_of(times_noticed);
  const QColor colour = sightColour(sight);
  if (sight != Sight::NotVisible) return colour;
  constexpr double kDarkest = 0.45;  // of the colour's lightness
  const double share = kDarkest + (1 - kDarkest) * std::clamp(times_noticed, 0.0, 1.0);
  const auto darker = [share](int part) { return static_cast<int>(std::lround(share * part)); };
  return {darker(colour.red()), darker(colour.green()), darker(colour.blue())};
}

}  // namespace mocapress
