// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QMatrix4x4>
#include <QPointF>
#include <QSizeF>
#include <QVector3D>
#include <optional>
#include <span>

namespace mocapress {

/// Views of the figure from the front, from the side and from above.
enum class ViewAxis { Front, Side, Top };

/// A perspective camera on a sphere around its target, with y up. Lengths are in cm, in world
/// space; pixels are logical, counted from the top left.
class OrbitCamera {
 public:
  static constexpr float kFieldOfView = 32;  // degrees, from bottom to top

  void setViewSize(const QSizeF& pixels);

  /// Looks at a sphere from the front right, so that all of it is visible.
  void lookAt(const QVector3D& centre, float radius);

  /// Looks at points from the front right so that they fill the view up to a margin. Sets the
  /// limits of zoom() and the clipping planes by the size of the points, but at least
  /// `least_radius`.
  void frame(std::span<const QVector3D> points, float least_radius);

  /// Sets the azimuth of the figure's front, in radians from +z towards +x.
  void setFront(float azimuth) { front_ = azimuth; }

  /// Looks at the same target from the front, from above, or from the side that is on the right in
  /// the front view. A second call returns to the earlier view.
  void lookAlong(ViewAxis axis);

  /// Returns a camera that looks at the same target along an axis.
  OrbitCamera along(ViewAxis axis) const;

  /// Moves towards or away from a sphere, without turning, so that it fills the view.
  void lookClose(const QVector3D& centre, float radius);

  /// The values that dragging and zooming change; lengths in cm.
  struct Place {
    QVector3D target;
    float distance, azimuth, elevation;
  };
  Place place() const { return {target_, distance_, azimuth_, elevation_}; }
  void setPlace(const Place& place);

  /// Turns the camera around its target with a drag. It stops short of the poles.
  void orbit(const QPointF& pixels);

  /// Moves the camera with a drag, so that a point at the target's depth stays under the mouse.
  void pan(const QPointF& pixels);

  /// Zooms; positive notches zoom in. The distance is limited to multiples of the radius.
  void zoom(float notches);

  void moveBy(const QVector3D& offset) { target_ += offset; }

  /// The point under a pixel that is at the same depth as a given point.
  QVector3D beside(const QVector3D& in_world, const QPointF& pixel) const;

  QVector3D eye() const { return target_ + distance_ * targetToEye(); }
  QVector3D target() const { return target_; }
  float distance() const { return distance_; }
  float aspectRatio() const;

  /// The clipping planes scale with distance and radius, so that neither tiny nor huge figures are
  /// clipped.
  float nearPlane() const { return 0.02f * distance_; }
  float farPlane() const { return 10 * distance_ + 40 * radius_; }

  QMatrix4x4 clipFromWorld() const;

  /// Projects a point to pixels; unset if it is behind the eye.
  std::optional<QPointF> project(const QVector3D& in_world) const;

 private:
  QVector3D targetToEye() const;  // unit
  QVector3D right() const;        // unit, horizontal

  QSizeF size_{1, 1};
  QVector3D target_;
  float radius_ = 1;
  float distance_ = 4;
  float front_ = 0;      // radians from +z towards +x
  float azimuth_ = 0;    // radians from +z towards +x
  float elevation_ = 0;  // radians above the ground plane

  struct Angles {
    float azimuth, elevation;
    bool operator==(const Angles&) const = default;
  };
  std::optional<Angles> before_;  // angles before lookAlong()
};

struct PickedJoint {
  int joint;
  double distance;  // logical pixels from the cursor
};

/// The joint whose projection is nearest to the cursor, if it is within `reach` pixels. Of joints
/// in the same place, the first one is returned, which is nearest to the root. The first
/// `joint_count` landmarks of `tracks` are the joints.
std::optional<PickedJoint> pickJoint(const OrbitCamera& camera, const Eigen::MatrixXd& tracks,
                                     int frame, int joint_count, const QPointF& cursor,
                                     double reach = 12);

}  // namespace mocapress
