// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/colours.h"

#include <algorithm>
#include <cmath>

#include "core/codec/methods/compression_method.h"

namespace mocapress {

SeriesStyle seriesStyle(std::string_view method, bool feet_held) {
  const auto all = compression_methods();
  const CompressionMethod* compression_method = find_compression_method(method);
  const auto place =
      compression_method ? static_cast<std::size_t>(compression_method - all.data()) : all.size();
  // Methods beyond the seventh reuse the colours, starting at the third one, so that the methods
  // that a study usually compares all differ.
  const std::size_t round = place / kCurveColours.size();
  return {QColor(kCurveColours[(place + 2 * round) % kCurveColours.size()]),
          static_cast<int>(place) % kSeriesShapes, feet_held || round > 0, feet_held};
}

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
  constexpr double kDarkest = 0.45;  // share of the colour's lightness
  const double share = kDarkest + (1 - kDarkest) * std::clamp(times_noticed, 0.0, 1.0);
  const auto darker = [share](int part) { return static_cast<int>(std::lround(share * part)); };
  return {darker(colour.red()), darker(colour.green()), darker(colour.blue())};
}

namespace {

constexpr double kNothing = 0.1;  // cm: smaller slides count as none
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

SceneColours sceneColours(const QPalette& palette) {
  const bool dark = palette.color(QPalette::Window).lightnessF() < 0.5f;
  SceneColours colours;
  colours.backdrop_centre = dark ? QColor(0x42484f) : QColor(0xf6f7f9);
  colours.backdrop_edge = dark ? QColor(0x1d2024) : QColor(0xc9d0d8);
  colours.grid = dark ? QColor(0x9aa4ae) : QColor(0x6c7883);
  colours.x_axis = dark ? QColor(0xd08770) : QColor(0xb8654a);
  colours.z_axis = dark ? QColor(0x6f9fd8) : QColor(0x3f74b5);
  colours.original = dark ? QColor(0xaab3bc) : QColor(0x3f4953);
  colours.compressed = QColor(0xd8352c);
  colours.trail = slideColour(0);
  colours.alert = slideColour(100);
  colours.past = dark ? QColor(0x56b4e9) : QColor(0x0072b2);
  colours.future = QColor(0xe69f00);
  colours.plate = dark ? QColor(0x202327) : QColor(0xffffff);
  colours.text = dark ? QColor(0xe8eaec) : QColor(0x1c2024);
  return colours;
}

}  // namespace mocapress
