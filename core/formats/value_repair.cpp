// SPDX-License-Identifier: MIT
#include "core/formats/value_repair.h"

#include <algorithm>
#include <cmath>

namespace mocapress {
namespace {

constexpr double kLargest = 1e9;  // file units or degrees

bool usable(double value) {
  return std::abs(value) <= kLargest;
}

}  // namespace

long repair_values(RawRows rows) {
  long repaired = 0;
  for (Eigen::Index c = 0; c < rows.cols(); ++c) {
    Eigen::Index good = 0;
    while (good < rows.rows() && !usable(rows(good, c))) ++good;
    double previous = good < rows.rows() ? rows(good, c) : 0.0;
    for (Eigen::Index t = 0; t < rows.rows(); ++t) {
      if (!usable(rows(t, c))) {
        rows(t, c) = previous;
        ++repaired;
      }
      previous = rows(t, c);
    }
  }
  return repaired;
}

bool tells_of_damage(std::string_view warning) {
  return std::ranges::any_of(
      std::initializer_list<std::string_view>{kRepaired, kTruncated, kOtherFrames, kRepeated,
                                              kKeysLeftOut},
      [&](std::string_view text) { return warning.find(text) != warning.npos; });
}

}  // namespace mocapress
