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

/// A perspective camera on a sphere around its target, y up. Lengths are cm in the world; pixels
/// are logical, counted from the top left.
class OrbitCamera {
 public:
  static constexpr float kFieldOfView = 32;  // degrees, from bottom to top

  void setViewSize(const QSizeF& pixels);

  /// Looks at a sphere from the front right, so that the whole of it is in sight.
  void lookAt(const QVector3D& centre, float radius);

  /// Looks at points from the front right, so near that they fill the view but for a margin. The
  /// limits of zoom() and both planes follow their size, which is taken as `least_radius` at least.
  void frame(std::span<const QVector3D> points, float least_radius);

  /// The same sphere from above, as on a floor plan. Once more: from where it was seen before.
  void lookDown();

  /// A drag: the scene turns with the hand. Stops short of the poles.
  void orbit(const QPointF& pixels);

  /// A drag: what lies at the target's depth stays under the hand.
  void pan(const QPointF& pixels);

  /// Positive notches of the wheel go nearer: as far as a fraction of the radius, and away as far
  /// as what was looked at is still seen.
  void zoom(float notches);

  void moveBy(const QVector3D& offset) { target_ += offset; }

  QVector3D eye() const { return target_ + distance_ * targetToEye(); }
  QVector3D target() const { return target_; }
  float distance() const { return distance_; }
  float aspectRatio() const;

  /// Both scale with the distance and the radius looked at: tiny and huge figures are not clipped.
  float nearPlane() const { return 0.02f * distance_; }
  float farPlane() const { return 10 * distance_ + 40 * radius_; }

  QMatrix4x4 clipFromWorld() const;

  /// Where a point is seen; nothing when it is behind the eye.
  std::optional<QPointF> project(const QVector3D& in_world) const;

 private:
  QVector3D targetToEye() const;  // unit
  QVector3D right() const;        // unit, horizontal

  QSizeF size_{1, 1};
  QVector3D target_;
  float radius_ = 1;
  float distance_ = 4;
  float azimuth_ = 0;    // radians from +z towards +x
  float elevation_ = 0;  // radians above the ground plane

  struct Angles {
    float azimuth, elevation;
  };
  std::optional<Angles> before_;  // looking down
};

struct PickedJoint {
  int joint;
  double distance;  // logical pixels from the cursor
};

/// The joint seen nearest to the cursor, within `reach` pixels; of joints at one place the first,
/// which is nearest to the root. The first `joint_count` landmarks of `tracks` are the joints.
std::optional<PickedJoint> pickJoint(const OrbitCamera& camera, const Eigen::MatrixXd& tracks,
                                     int frame, int joint_count, const QPointF& cursor,
                                     double reach = 12);

}  // namespace mocapress
