// SPDX-License-Identifier: MIT
#include "resources/samples/generator/variation.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace mocapress::samples {

double jitter(Random& random) {
  const double first = random.unit();
  return first - random.unit();
}

Drift::Drift(Random& random) {
  constexpr int kWaves = 14;
  constexpr double kLowest = 0.25;  // Hz
  constexpr double kHighest = 15.0;
  double power = 0;
  for (int i = 0; i < kWaves; ++i) {
    const double octave_share = (i + random.unit()) / kWaves;
    const double hz = kLowest * std::pow(kHighest / kLowest, octave_share);
    const double amplitude = std::pow(hz, -0.75);
    waves_.push_back({2 * std::numbers::pi * hz, 2 * std::numbers::pi * random.unit(), amplitude});
    power += amplitude * amplitude / 2;
  }
  for (Wave& wave : waves_) wave.amplitude /= std::sqrt(power);
}

double Drift::at(double seconds) const {
  double sum = 0;
  for (const Wave& wave : waves_)
    sum += wave.amplitude * std::sin(wave.radians_per_second * seconds + wave.phase);
  return sum;
}

double sensor_noise(Random& random) {
  constexpr int kDraws = 4;  // each of variance 1/12
  double sum = 0;
  for (int i = 0; i < kDraws; ++i) sum += random.unit() - 0.5;
  return sum * std::sqrt(12.0 / kDraws);
}

Unrest unrest_of(const std::string& joint) {
  // The farther from the trunk, the freer, and the smaller what the markers sit on.
  constexpr std::array<std::pair<std::string_view, Unrest>, 10> kByEnding = {{
      {"root", {0.35, 0.02}},
      {"back", {0.40, 0.03}},
      {"thorax", {0.50, 0.03}},
      {"neck", {0.80, 0.04}},
      {"head", {1.00, 0.03}},
      {"clavicle", {0.50, 0.03}},
      {"humerus", {1.30, 0.04}},
      {"radius", {1.50, 0.04}},
      {"wrist", {1.60, 0.05}},
      {"hand", {1.60, 0.05}},
  }};
  for (const auto& [ending, unrest] : kByEnding)
    if (joint.ends_with(ending)) return unrest;
  return {1.5, 0.05};  // fingers and thumbs
}

}  // namespace mocapress::samples
