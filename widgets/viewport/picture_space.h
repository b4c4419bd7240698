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

/// Converts between places in the clip's world and pixels of a window's picture. Pixels are
/// logical, from the window's top left.
class PictureSpace {
 public:
  /// `offset` (cm) moves drawn figures away from their places in the clip.
  PictureSpace(const Arrangement& arrangement, const QSizeF& window, const OrbitCamera& camera,
               const QVector3D& offset)
      : arrangement_(arrangement), window_(window), camera_(camera), offset_(offset) {}

  /// The cameras of the window's views: one, or one for each quarter.
  std::vector<OrbitCamera> cameras() const;

  /// The index of the quarter at a pixel; 0 in a window with one view.
  int quarterAt(const QPointF& position) const;

  /// True if a wipe's divider can be gripped at the pixel.
  bool isOnDivider(const QPointF& position) const;

  /// The pixel of a place in the first view; unset if it is outside the pane of the place's figure.
  std::optional<QPointF> pixelOf(const QVector3D& place, const Pane& pane) const;

  /// A figure at the shown frame.
  struct Drawn {
    const Eigen::MatrixXd& tracks;
    int frame;
    Pane pane;
  };

  /// A joint under a pixel.
  struct Pointed {
    int joint;
    QVector3D place;     // in the clip's world
    QPointF in_pane;     // the pixel, relative to the joint's pane
    OrbitCamera camera;  // camera of the joint's pane, in the clip's world
  };

  /// The joint nearest to a pixel, if it is within `reach` pixels.
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
