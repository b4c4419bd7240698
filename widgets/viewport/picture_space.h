// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QPointF>
#include <QSizeF>
#include <QVector3D>
#include <optional>
#include <vector>

#include "widgets/viewport/orbit_camera.h"
#include "widgets/viewport/view_arrangement.h"

namespace mocapress {

/// Where places of the clip's world are in a window's picture, and what is under one of its pixels.
/// Pixels are logical, from the window's top left.
class PictureSpace {
 public:
  /// `offset` is how far figures are drawn from their places in the clip, cm.
  PictureSpace(const Arrangement& arrangement, const QSizeF& window, const OrbitCamera& camera,
               const QVector3D& offset)
      : arrangement_(arrangement), window_(window), camera_(camera), offset_(offset) {}

  /// Cameras of the window's views: one, or those of the quarters.
  std::vector<OrbitCamera> cameras() const;

  /// The quarter at a pixel; 0 in a window with one view.
  int quarterAt(const QPointF& position) const;

  /// The divider of a wipe can be gripped there.
  bool isOnDivider(const QPointF& position) const;

  /// A place in the picture of the first view; unset outside the pane of its figure.
  std::optional<QPointF> pixelOf(const QVector3D& place, const Pane& pane) const;

  /// A figure at the frame that is shown.
  struct Drawn {
    const Eigen::MatrixXd& tracks;
    int frame;
    Pane pane;
  };

  /// A joint under a pixel.
  struct Pointed {
    int joint;
    QVector3D place;     // in the clip's world
    QPointF in_pane;     // the pixel, in the joint's pane
    OrbitCamera camera;  // the joint's pane's, in the clip's world
  };

  /// The nearest joint within `reach` pixels.
  std::optional<Pointed> pointedAt(const std::vector<Drawn>& figures, int joint_count,
                                   const QPointF& position, double reach) const;

 private:
  double viewWidth() const;
  double leftOfPane(const Pane& pane) const;

  const Arrangement& arrangement_;
  QSizeF window_;
  OrbitCamera camera_;
  QVector3D offset_;
};

}  // namespace mocapress
