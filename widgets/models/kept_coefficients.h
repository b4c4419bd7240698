// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/wavelet/lifting.h"

namespace mocapress {

/// The number of coefficients kept in one scale of the wavelet transform.
struct KeptBand {
  int kept = 0;
  int all = 0;

  bool operator==(const KeptBand&) const = default;
};

/// Transforms a decoded channel again and counts its non-zero coefficients in each scale, coarse to
/// fine.
std::vector<KeptBand> keptByScale(const Eigen::VectorXd& decoded, Basis basis);

}  // namespace mocapress
