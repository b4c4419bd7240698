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

/// A round body between two balls, as the figure's shader takes it: one instance of the mesh.
struct Capsule {
  QVector3D start;     // cm, in the world
  float start_radius;  // cm
  QVector3D end;
  float end_radius;
  float alert;           // 0 ... 1
  QVector4D start_tint;  // red, green, blue, and how much of them, each 0 ... 1
  QVector4D end_tint;
};
static_assert(sizeof(Capsule) == 17 * sizeof(float));

/// A tint that covers what is under it.
QVector4D tintOf(const QColor& colour);

/// What is marked on a figure at a frame.
struct FigureMarks {
  std::vector<float> alerts;     // of each joint, 0 ... 1; empty: none
  std::vector<QVector4D> tints;  // of each landmark; empty: none
};

/// A point of a frame of landmark_tracks().
QVector3D landmarkAt(const Eigen::MatrixXd& tracks, int frame, int landmark);

/// The body of a skeleton, in tapered capsules. That of a human has a skull, a trunk with volume,
/// limbs of human proportions, hands and feet, whatever joints carry it; that of anything else has
/// bones as thick as what hangs on them. It follows from places of landmarks alone. Knows
/// thicknesses, which stay, and not the pose, which comes with every frame.
///
/// Proportions are those of the first frame of `tracks`, or of the rest pose without any. Channels
/// of an FBX or glTF at zero are no pose that anybody has been in: both shoulders may be at one
/// place there.
class FigureShape {
 public:
  explicit FigureShape(const Skeleton& skeleton, const Eigen::MatrixXd& tracks = {});

  int jointCount() const { return static_cast<int>(ball_radii_.size()); }
  int capsuleCount() const { return static_cast<int>(parts_.size() + ball_radii_.size()); }

  /// Of those the parts of the body, which come last. They are round at their ends. The others are
  /// balls within it, one a joint.
  int partCount() const { return static_cast<int>(parts_.size()); }

  /// The skeleton's body_root().
  int bodyRoot() const { return body_root_; }

  /// The longest side (cm) of the box around the rest pose.
  float size() const { return size_; }

  /// The width (cm) of a ring around a joint that the body does not cover.
  float ringRadius(int joint) const { return ring_radii_[static_cast<std::size_t>(joint)]; }

  /// All capsules at a frame of landmark_tracks().
  std::vector<Capsule> posed(const Eigen::MatrixXd& tracks, int frame,
                             const FigureMarks& marks) const;

  /// Fills capsuleCount() capsules, joint j the j-th of them, parts after the joints.
  void pose(const Eigen::MatrixXd& tracks, int frame, const FigureMarks& marks,
            std::span<Capsule> capsules) const;

  /// The body's landmarks at a frame, and how high its parts reach.
  std::vector<QVector3D> body(const Eigen::MatrixXd& tracks, int frame) const;

  /// The centre of the box around them.
  QVector3D centre(const Eigen::MatrixXd& tracks, int frame) const;

 private:
  /// A mean of landmarks, with weights that sum to 1. Negative ones lead beyond the others.
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

  /// How deep (cm) below the surface of the body a point of the first frame is; 0: outside.
  float depth(const QVector3D& point, const Eigen::MatrixXd& tracks) const;

  std::vector<Part> parts_;
  std::vector<float> ball_radii_;  // cm, one a joint
  std::vector<float> ring_radii_;  // likewise
  int body_root_;
  float size_;
};

}  // namespace mocapress
