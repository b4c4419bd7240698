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

/// Directions along the figure's front and side, and down, as in a drawing of a machine part.
enum class ViewAxis { Front, Side, Top };

/// A perspective camera on a sphere around its target, y up. Lengths are cm in the world; pixels
/// are logical, counted from the top left.
class OrbitCamera {
 public:
  static constexpr float kFieldOfView = 32;  // degrees, from bottom to top

  void setViewSize(const QSizeF& pixels);

  /// Looks at a whole sphere from the front right.
  void lookAt(const QVector3D& centre, float radius);

  /// Looks at points from the front right so that they fill the view up to a margin. The limits of
  /// zoom() and the clipping planes follow their size, at least `least_radius`.
  void frame(std::span<const QVector3D> points, float least_radius);

  /// The direction in which the front is, in radians from +z towards +x.
  void setFront(float azimuth) { front_ = azimuth; }

  /// Looks at the same target along an axis: at the front, or at the side to the right of this
  /// view. A second call returns to the earlier view.
  void lookAlong(ViewAxis axis);

  /// The camera that looks at the same target along an axis.
  OrbitCamera along(ViewAxis axis) const;

  /// Looks at a sphere from where the camera is, so that it fills the view.
  void lookClose(const QVector3D& centre, float radius);

  /// Everything that dragging and zooming change, lengths in cm.
  struct Place {
    QVector3D target;
    float distance, azimuth, elevation;
  };
  Place place() const { return {target_, distance_, azimuth_, elevation_}; }
  void setPlace(const Place& place);

  /// Turns the scene with a drag. Stops short of the poles.
  void orbit(const QPointF& pixels);

  /// Moves the scene with a drag, so that a point at the target's depth stays under the mouse.
  void pan(const QPointF& pixels);

  /// Positive notches zoom in. The distance ranges from a fraction of the radius to where the
  /// target can still be seen.
  void zoom(float notches);

  void moveBy(const QVector3D& offset) { target_ += offset; }

  /// The point under a pixel that is as deep in the picture as a point of the world.
  QVector3D beside(const QVector3D& in_world, const QPointF& pixel) const;

  QVector3D eye() const { return target_ + distance_ * targetToEye(); }
  QVector3D target() const { return target_; }
  float distance() const { return distance_; }
  float aspectRatio() const;

  /// The clipping planes scale with distance and radius, so that tiny and huge figures are not
  /// clipped.
  float nearPlane() const { return 0.02f * distance_; }
  float farPlane() const { return 10 * distance_ + 40 * radius_; }

  QMatrix4x4 clipFromWorld() const;

  /// Projects a point to pixels; nothing if it is behind the eye.
  std::optional<QPointF> project(const QVector3D& in_world) const;

 private:
  QVector3D targetToEye() const;  // unit
  QVector3D right() const;        // unit, horizontal

  QSizeF size_{1, 1};
  QVector3D target_;
  float radius_ = 1;
  float distance_ = 4;
  float front_ = 0;      // radians from +z towards +x
  float azimuth_ = 0;    // likewise
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

/// The joint whose projection is nearest to the cursor, within `reach` pixels. Among joints in one
/// place the first wins, which is nearest to the root. The first `joint_count` landmarks of
/// `tracks` are the joints.
std::optional<PickedJoint> pickJoint(const OrbitCamera& camera, const Eigen::MatrixXd& tracks,
                                     int frame, int joint_count, const QPointF& cursor,
                                     double reach = 12);

}  // namespace mocapress
