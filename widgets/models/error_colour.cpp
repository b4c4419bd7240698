// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/error_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/models/number_text.h"

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

namespace {

// Samples of the map at equal distances. Linear interpolation between them is off by at most two
// steps of 8-bit colour.
constexpr std::array<QRgb, 11> kViridis = {0xff440154, 0xff482475, 0xff414487, 0xff355f8d,
                                           0xff2a788e, 0xff21918c, 0xff22a884, 0xff44bf70,
                                           0xff7ad151, 0xffbddf26, 0xfffde725};

}  // namespace

QColor viridis(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (kViridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  const double rest = place - static_cast<double>(below);
  const QColor a(kViridis[below]);
  const QColor b(kViridis[below + 1]);
  const auto mix = [rest](int x, int y) {
    return static_cast<int>(std::lround(x + rest * (y - x)));
  };
  return QColor(mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue()));
}

double ErrorScale::share(double error) const {
  return std::clamp(error / top, 0.0, 1.0);
}

ErrorScale errorScaleFor(double error, ErrorQuantity quantity) {
  if (!(error > 0) || !std::isfinite(error)) return {.quantity = quantity};
  constexpr double kRounding = 1e-9;  // allows for rounding: 0.2 is not quite 2 x 0.1
  const double decade = std::pow(10.0, std::floor(std::log10(error)));
  for (const double step : {1.0, 2.0, 5.0})
    if (error <= step * decade * (1 + kRounding)) return {step * decade, quantity};
  return {10 * decade, quantity};
}

}  // namespace mocapress
