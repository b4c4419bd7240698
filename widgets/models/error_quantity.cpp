// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/error_quantity.h"

#include "widgets/models/angle_text.h"
#include "widgets/models/length_text.h"

namespace mocapress {

const Eigen::MatrixXf& errorsOver(const Distortion& errors, ErrorQuantity quantity) {
  return quantity == ErrorQuantity::Angle ? errors.turns : errors.distances;
}

QString errorText(double error, ErrorQuantity quantity) {
  return quantity == ErrorQuantity::Angle ? angleText(error) : lengthText(error);
}

QString roundErrorText(double error, ErrorQuantity quantity) {
  return quantity == ErrorQuantity::Angle ? roundAngleText(error) : roundLengthText(error);
}

QString errorsText(const Distortion& errors, int frame, int landmark) {
  return lengthText(static_cast<double>(errors.distances(frame, landmark))) +
         QStringLiteral(" · ") + angleText(static_cast<double>(errors.turns(frame, landmark)));
}

}  // namespace mocapress
