// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/slide_colour.h"

#include <algorithm>
#include <cmath>

namespace mocapress {
namespace {

constexpr double kNothing = 0.1;  // cm
constexpr double kWorst = 2.0;

}  // namespace

float slideSeverity(double slid_cm) {
  const double share =
      std::log(std::max(slid_cm, kNothing) / kNothing) / std::log(kWorst / kNothing);
  return static_cast<float>(std::min(share, 1.0));
}

QColor slideColour(double slid_cm) {
  const QColor stands(0x2a, 0x9d, 0x9f);
  const QColor slides(0x9b, 0x2f, 0xe0);
  const float share = slideSeverity(slid_cm);
  const auto mix = [share](float a, float b) { return a + share * (b - a); };
  return QColor::fromRgbF(mix(stands.redF(), slides.redF()), mix(stands.greenF(), slides.greenF()),
                          mix(stands.blueF(), slides.blueF()));
}

}  // namespace mocapress
