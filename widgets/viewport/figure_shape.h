// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QVector3D>
#include <QVector4D>
#include <span>
#include <utility>
#include <vector>

#include "core/motion/skeleton.h"

namespace mocapress {

/// A round body between two balls, laid out for the figure's shader. Each capsule is one instance
/// of the mesh.
struct Capsule {
  QVector3D start;     // cm, in the world
  float start_radius;  // cm
  QVector3D end;
  float end_radius;
  float alert;           // strength of the alert colour, 0 to 1
  QVector4D start_tint;  // red, green, blue and opacity, each 0 to 1
  QVector4D end_tint;
};
static_assert(sizeof(Capsule) == 17 * sizeof(float));

/// An opaque tint in this colour.
QVector4D tintOf(const QColor& colour);

/// Marks on a figure in one frame.
struct FigureMarks {
  std::vector<float> alerts;     // for each joint, 0 to 1; empty: none
  std::vector<QVector4D> tints;  // for each landmark; empty: none
};

/// A landmark's position in a frame of landmark_tracks().
QVector3D landmarkAt(const Eigen::MatrixXd& tracks, int frame, int landmark);

/// The body of a skeleton as tapered capsules. A human has a skull, a trunk with volume, limbs of
/// human proportions, hands and feet, whichever joints carry them. Other bodies have bones whose
/// thickness follows from their length. The shape is derived from landmark positions alone. It
/// stores thicknesses; the pose is given with every frame.
///
/// Proportions are measured in the first frame of `tracks`, or in the rest pose if `tracks` is
/// empty. The rest pose of an FBX or glTF file may be no pose at all, for example with both
/// shoulders in one place.
class FigureShape {
 public:
  explicit FigureShape(const Skeleton& skeleton, const Eigen::MatrixXd& tracks = {});

  int jointCount() const { return static_cast<int>(ball_radii_.size()); }
  int capsuleCount() const { return static_cast<int>(parts_.size() + ball_radii_.size()); }

  /// Number of capsules that are parts of the body. Parts are the last capsules and have round
  /// ends. The other capsules are balls inside the body, one for each joint.
  int partCount() const { return static_cast<int>(parts_.size()); }

  /// The skeleton's body_root().
  int bodyRoot() const { return body_root_; }

  /// The longest side (cm) of the box around the rest pose.
  float size() const { return size_; }

  /// The radius (cm) of a ring around a joint that is visible outside the body.
  float ringRadius(int joint) const { return ring_radii_[static_cast<std::size_t>(joint)]; }

  /// All capsules at a frame of landmark_tracks().
  std::vector<Capsule> posed(const Eigen::MatrixXd& tracks, int frame,
                             const FigureMarks& marks) const;

  /// Fills capsuleCount() capsules: first a ball for each joint, in joint order, then the parts.
  void pose(const Eigen::MatrixXd& tracks, int frame, const FigureMarks& marks,
            std::span<Capsule> capsules) const;

  /// The positions of the body's landmarks at a frame, and the top of each part's end.
  std::vector<QVector3D> body(const Eigen::MatrixXd& tracks, int frame) const;

  /// The centre of the box around the body's landmarks at a frame.
  QVector3D centre(const Eigen::MatrixXd& tracks, int frame) const;

 private:
  /// A weighted mean of landmarks, with weights that sum to 1. A negative weight leads beyond the
  /// other landmarks.
  using Place = std::vector<std::pair<int, float>>;
  struct Part {
    Place start;
    float start_radius;  // cm
    Place end;
    float end_radius;
  };
  class Builder;

  static QVector3D at(const Place& place, const Eigen::MatrixXd& tracks, int frame);
  static int nearestLandmark(const Place& place);

  /// Depth (cm) of a point of the first frame below the body's surface; 0: outside the body.
  float depth(const QVector3D& point, const Eigen::MatrixXd& tracks) const;

  std::vector<Part> parts_;
  std::vector<float> ball_radii_;  // cm, by joint
  std::vector<float> ring_radii_;  // cm, by joint
  int body_root_;
  float size_;
};

}  // namespace mocapress
