// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>

namespace mocapress {

/// Matplotlib's viridis: grows evenly lighter from 0 (dark violet) to 1 (yellow), and reads the
/// same in all kinds of colour vision and in print.
QColor viridis(double share);

/// Errors from nothing to a round number of centimetres; what is beyond is as bad as it gets.
struct ErrorScale {
  double top_cm = 1;

  double share(double cm) const;  // 0 ... 1
  QColor colour(double cm) const { return viridis(share(cm)); }

  bool operator==(const ErrorScale&) const = default;
};

/// Scales to choose from, cm. They do not depend on the clip: a colour means the same error in any.
inline constexpr std::array kErrorScales = {0.1, 0.5, 1.0, 5.0};

/// Up to the least of 1, 2 and 5 times a power of ten that is not below `cm`: steps wide enough
/// that a scale stays while settings are tuned.
ErrorScale errorScaleFor(double cm);

}  // namespace mocapress
