// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
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

}  // namespace mocapress
