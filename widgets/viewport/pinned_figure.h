// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QStringList>
#include <memory>

namespace mocapress {

/// Another result of the clip, seen beside the current one.
struct PinnedFigure {
  std::shared_ptr<const Eigen::MatrixXd> tracks;  // frames x 3 * landmarks, cm
  QColor colour;
  QStringList title;  // in one line where there is room, else one below the other
};

}  // namespace mocapress
