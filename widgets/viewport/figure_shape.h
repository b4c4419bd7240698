// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QVector3D>
#include <QVector4D>
#include <span>
#include <vector>

#include "core/motion/skeleton.h"

namespace mocapress {

/// A round body between two balls, as the figure's shader takes it: one instance of the mesh.
struct Capsule {
  QVector3D start;     // cm, in the world
  float start_radius;  // cm
  QVector3D end;
  float end_radius;
  float highlight;       // 0 or 1
  float alert;           // 0 ... 1
  QVector4D start_tint;  // red, green, blue, and how much of them, each 0 ... 1
  QVector4D end_tint;
};
static_assert(sizeof(Capsule) == 18 * sizeof(float));

/// A tint that covers what is under it.
QVector4D tintOf(const QColor& colour);

/// What is marked on a figure at a frame.
struct FigureMarks {
  int selected_joint = -1;
  std::vector<float> alerts;     // of each joint, 0 ... 1; empty: none
  std::vector<QVector4D> tints;  // of each landmark; empty: none
};

/// A point of a frame of landmark_tracks().
QVector3D landmarkAt(const Eigen::MatrixXd& tracks, int frame, int landmark);

/// The body of a skeleton: a tapered capsule a bone, a ball a joint. Knows thicknesses, which stay,
/// and not the pose, which comes with every frame.
class FigureShape {
 public:
  explicit FigureShape(const Skeleton& skeleton);

  int jointCount() const { return static_cast<int>(ball_radii_.size()); }
  int capsuleCount() const { return static_cast<int>(bones_.size() + ball_radii_.size()); }

  /// Of those the bones, which come last. They are round at their ends.
  int boneCount() const { return static_cast<int>(bones_.size()); }

  /// The first joint that carries the body. A game's root on the floor does not: the hips walk away
  /// from it. Landmarks from here on are the body's.
  int bodyRoot() const { return body_root_; }

  /// The longest side (cm) of the box around the rest pose.
  float size() const { return size_; }

  /// Fills capsuleCount() capsules, joint j the j-th of them, bones after the joints.
  void pose(const Eigen::MatrixXd& tracks, int frame, const FigureMarks& marks,
            std::span<Capsule> capsules) const;

  /// The body's landmarks at a frame.
  std::vector<QVector3D> body(const Eigen::MatrixXd& tracks, int frame) const;

  /// The centre of the box around them.
  QVector3D centre(const Eigen::MatrixXd& tracks, int frame) const;

 private:
  struct Bone {
    int start;  // landmarks
    int end;
    float radius;  // cm, at its start
  };
  std::vector<Bone> bones_;
  std::vector<float> ball_radii_;  // cm, one a joint
  int body_root_;
  float size_;
};

}  // namespace mocapress
