// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/wavelet/lifting.h"

namespace mocapress {

/// How much of a scale is kept.
struct KeptBand {
  int kept = 0;
  int all = 0;

  bool operator==(const KeptBand&) const = default;
};

/// The coefficients that a decoded channel consists of, by scale from coarse to fine: those that
/// are not zero when it is transformed again.
std::vector<KeptBand> keptByScale(const Eigen::VectorXd& decoded, Basis basis);

}  // namespace mocapress
