// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <array>
#include <memory>

#include "core/metrics/distortion.h"

namespace mocapress {

/// The quantity of an error: a landmark's distance (cm), or the angle by which its joint is turned
/// in the world (degrees).
enum class ErrorQuantity { Distance, Angle };

/// A clip's errors, shared by several views; null: unknown.
using ErrorsPtr = std::shared_ptr<const Distortion>;

/// Errors of one quantity, frames x landmarks, in cm or degrees.
const Eigen::MatrixXf& errorsOver(const Distortion& errors, ErrorQuantity quantity);

/// Formats an error as "4.6 mm" or "2.3°".
QString errorText(double error, ErrorQuantity quantity);

/// Formats a round error, as on a scale: "5 mm", "2.5°".
QString roundErrorText(double error, ErrorQuantity quantity);

/// Both errors of a landmark at a frame: "4.6 mm · 2.3°".
QString errorsText(const Distortion& errors, int frame, int landmark);

/// Matplotlib's viridis: grows evenly lighter from 0 (dark violet) to 1 (yellow), and reads the
/// same in all kinds of colour vision and in print.
QColor viridis(double share);

/// Colour scale of errors from zero to a round number; larger errors get the last colour.
struct ErrorScale {
  double top = 1;  // cm, or degrees
  ErrorQuantity quantity = ErrorQuantity::Distance;

  double share(double error) const;  // position on the scale, 0 to 1
  QColor colour(double error) const { return viridis(share(error)); }

  bool operator==(const ErrorScale&) const = default;
};

/// Scales to choose from, in cm or degrees. They are the same for every clip, so a colour always
/// means the same error.
constexpr std::array<double, 4> errorScales(ErrorQuantity quantity) {
  if (quantity == ErrorQuantity::Angle) return {1, 2.5, 5, 15};
  return {0.1, 0.5, 1, 5};
}

/// The smallest scale that reaches `error`; its top is 1, 2 or 5 times a power of ten. These steps
/// are coarse, so that the scale rarely changes while settings are tuned.
ErrorScale errorScaleFor(double error, ErrorQuantity quantity = ErrorQuantity::Distance);

}  // namespace mocapress
