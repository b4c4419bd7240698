// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>

#include "widgets/models/error_quantity.h"

namespace mocapress {

/// Matplotlib's viridis: grows evenly lighter from 0 (dark violet) to 1 (yellow), and reads the
/// same in all kinds of colour vision and in print.
QColor viridis(double share);

/// Errors from nothing to a round number; what is beyond is as bad as it gets.
struct ErrorScale {
  double top = 1;  // cm, or degrees
  ErrorQuantity quantity = ErrorQuantity::Distance;

  double share(double error) const;  // 0 ... 1
  QColor colour(double error) const { return viridis(share(error)); }

  bool operator==(const ErrorScale&) const = default;
};

/// Scales to choose from, cm or degrees. They do not depend on the clip: a colour means the same
/// error in any.
constexpr std::array<double, 4> errorScales(ErrorQuantity quantity) {
  if (quantity == ErrorQuantity::Angle) return {1, 2.5, 5, 15};
  return {0.1, 0.5, 1, 5};
}

/// Up to the least of 1, 2 and 5 times a power of ten that is not below `error`: steps wide enough
/// that a scale stays while settings are tuned.
ErrorScale errorScaleFor(double error, ErrorQuantity quantity = ErrorQuantity::Distance);

}  // namespace mocapress
