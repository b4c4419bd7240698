// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <array>
#include <memory>

#include "core/metrics/distortion.h"

namespace mocapress {

/// What is told of an error: how far a landmark is off (cm), or by how much the joint that carries
/// it is turned in the world (degrees).
enum class ErrorQuantity { Distance, Angle };

/// Errors of a clip as views share them; null: unknown.
using ErrorsPtr = std::shared_ptr<const Distortion>;

/// Frames x landmarks, cm or degrees.
const Eigen::MatrixXf& errorsOver(const Distortion& errors, ErrorQuantity quantity);

/// "4.6 mm", "2.3°".
QString errorText(double error, ErrorQuantity quantity);

/// As on a scale: "5 mm", "2.5°".
QString roundErrorText(double error, ErrorQuantity quantity);

/// Both of a landmark at a frame: "4.6 mm · 2.3°".
QString errorsText(const Distortion& errors, int frame, int landmark);

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
