// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/kept_coefficients.h"

#include <cmath>

#include "core/wavelet/lifting.h"

namespace mocapress {
namespace {

constexpr double kRounding = 1e-6;  // covers the rounding of decoding in floats

}  // namespace

std::vector<KeptBand> keptByScale(const Eigen::VectorXd& decoded, Basis basis) {
  std::vector<KeptBand> bands;
  if (decoded.size() == 0) return bands;
  const Lifting lifting(basis, static_cast<int>(decoded.size()));
  Eigen::VectorXd coefficients(decoded.size());
  lifting.forward({decoded.data(), static_cast<std::size_t>(decoded.size())},
                  {coefficients.data(), static_cast<std::size_t>(coefficients.size())});
  const double least = kRounding * std::max(1.0, coefficients.cwiseAbs().maxCoeff());
  for (const Band& band : lifting.bands()) {
    const auto values = coefficients.segment(band.first, band.size).array().abs();
    bands.push_back({static_cast<int>((values > least).count()), band.size});
  }
  return bands;
}

}  // namespace mocapress
