// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/picture_space.h"

#include <cmath>

#include "widgets/viewport/figure_shape.h"

namespace mocapress {
namespace {

constexpr double kDividerReach = 10;  // pixels on each side of the divider

}  // namespace

std::vector<OrbitCamera> PictureSpace::cameras() const {
  if (!arrangement_.quartered) return {camera_};
  return {camera_, camera_.along(ViewAxis::Front), camera_.along(ViewAxis::Side),
          camera_.along(ViewAxis::Top)};
}

int PictureSpace::quarterAt(const QPointF& position) const {
  if (!arrangement_.quartered) return 0;
  return (2 * position.x() < window_.width() ? 0 : 1) +
         (2 * position.y() < window_.height() ? 0 : 2);
}

bool PictureSpace::isOnDivider(const QPointF& position) const {
  if (!arrangement_.has_divider || arrangement_.panes > 1) return false;
  const double divider = (1 + static_cast<double>(arrangement_.dividerAt())) / 2 * window_.width();
  return std::abs(position.x() - divider) <= kDividerReach;
}

std::optional<QPointF> PictureSpace::pixelOf(const QVector3D& place, const Pane& pane) const {
  const auto pixel = camera_.project(place + offset_);
  if (!pixel) return {};
  // Unset outside the pane, where the pixel would seem to belong to another pane.
  const QPointF at = *pixel + QPointF(leftOfPane(pane), 0);
  const auto device_x = static_cast<float>(2 * at.x() / viewWidth() - 1);
  const bool beside = arrangement_.panes > 1 && !pane.contains(device_x);
  const bool off_quarter =
      arrangement_.quartered && (std::abs(device_x) > 1 || 2 * at.y() > window_.height());
  return beside || off_quarter ? std::nullopt : std::optional(at);
}

std::optional<PictureSpace::Pointed> PictureSpace::pointedAt(const std::vector<Drawn>& figures,
                                                             int joint_count,
                                                             const QPointF& position,
                                                             double reach) const {
  const int quarter = quarterAt(position);
  OrbitCamera camera = cameras()[static_cast<std::size_t>(quarter)];
  camera.moveBy(-offset_);  // into the clip's world
  const QPointF in_quarter =
      position - QPointF(quarter % 2 * viewWidth(), quarter / 2 * window_.height() / 2);
  const auto device_x = static_cast<float>(2 * in_quarter.x() / viewWidth() - 1);
  std::optional<Pointed> nearest;
  double least = reach;
  for (const Drawn& figure : figures) {
    if (!figure.pane.contains(device_x)) continue;
    const QPointF in_pane = in_quarter - QPointF(leftOfPane(figure.pane), 0);
    const auto picked = pickJoint(camera, figure.tracks, figure.frame, joint_count, in_pane, least);
    if (!picked || (nearest && picked->distance >= least)) continue;
    least = picked->distance;
    nearest = {picked->joint, landmarkAt(figure.tracks, figure.frame, picked->joint), in_pane,
               camera};
  }
  return nearest;
}

/// The width in pixels of a quarter if the window is quartered, else of the window.
double PictureSpace::viewWidth() const {
  return arrangement_.quartered ? window_.width() / 2 : window_.width();
}

/// The pixels from the left of a view to the left of the camera's picture in a pane.
double PictureSpace::leftOfPane(const Pane& pane) const {
  const double width = viewWidth();
  return (width - width / arrangement_.panes) / 2 + static_cast<double>(pane.shift) * width / 2;
}

}  // namespace mocapress
