// SPDX-License-Identifier: MIT
#include "core/motion/body_tracks.h"

#include <algorithm>
#include <cassert>
#include <numbers>

#include "core/base/instruction_sets.h"
#include "core/motion/landmarks.h"
#include "core/motion/pose_block.h"

namespace mocapress {

namespace {

/// Writes the tracks of some frames into the first rows of `tracks`.
void fill_tracks(const Skeleton& skeleton, const std::vector<Landmark>& points,
                 const Eigen::MatrixXd& channels, int from, int end, Eigen::MatrixXd& tracks) {
  const Eigen::Index shell = 3 * std::ssize(points);
  visit_poses(skeleton, channels, from, end, [&](const PoseBlock& poses, int first, int frames) {
    const int row = first - from;
    place_landmarks(points, poses, row, frames, tracks);
    // The points of shell_points(): three for each joint, along its axes.
    for (int j = 0; j < skeleton.joint_count(); ++j)
      for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 3; ++i)
          tracks.col(shell + 9 * j + 3 * axis + i).segment(row, frames) =
              (poses.origin(j).col(i) + kShellRadius * poses.axis(j, axis).col(i)).matrix();
  });
}

Eigen::Index columns_of(const Skeleton& skeleton, const std::vector<Landmark>& points) {
  return 3 * std::ssize(points) + Eigen::Index{9} * skeleton.joint_count();
}

}  // namespace

Eigen::MatrixXd body_tracks(const Skeleton& skeleton, const Clip& clip) {
  const std::vector<Landmark> points = landmarks(skeleton);
  Eigen::MatrixXd tracks(clip.frames(), columns_of(skeleton, points));
  fill_tracks(skeleton, points, clip.channels, 0, clip.frames(), tracks);
  return tracks;
}

JointErrors::JointErrors(const Skeleton& skeleton,
                         const Eigen::Ref<const Eigen::MatrixXd>& original,
                         const Eigen::Ref<const Eigen::MatrixXd>& decoded)
    : original_(original),
      decoded_(decoded),
      shell_(original.cols() - Eigen::Index{9} * skeleton.joint_count()),
      found_(static_cast<std::size_t>(skeleton.joint_count())) {
  assert(original.rows() == decoded.rows() && original.cols() == decoded.cols() && shell_ >= 0);
}

namespace {

/// Columns of two matrices of tracks, and their differences.
struct TrackColumns {
  const double* original;
  const double* decoded;
  Eigen::Index original_stride;
  Eigen::Index decoded_stride;
  Eigen::Index rows;

  template <typename Vector>
  MOCAPRESS_INLINE void difference(Eigen::Index column, Eigen::Index row, Vector& found) const {
    Vector before;
    load(decoded + column * decoded_stride + row, found);
    load(original + column * original_stride + row, before);
    found -= before;
  }
};

/// Writes errors of a joint, laid out as OfJoint, from row t on. Returns the first row of the rest
/// that fills no whole vector.
template <typename Vector>
MOCAPRESS_INLINE Eigen::Index find_errors(const TrackColumns& tracks, Eigen::Index origin,
                                          Eigen::Index shell, Eigen::Index t, double* errors) {
  constexpr double kPerLength = 1 / kShellRadius;
  for (; t + kLanes<Vector, double> <= tracks.rows; t += kLanes<Vector, double>)
    for (Eigen::Index i = 0; i < 3; ++i) {
      Vector of_origin;
      tracks.difference(origin + i, t, of_origin);
      store(of_origin, errors + i * tracks.rows + t);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        Vector along;
        tracks.difference(shell + 3 * axis + i, t, along);
        const Vector error = (along - of_origin) * kPerLength;
        store(error, errors + (3 + 3 * axis + i) * tracks.rows + t);
      }
    }
  return t;
}

}  // namespace

const JointErrors::OfJoint& JointErrors::of(int joint) {
  std::optional<OfJoint>& found = found_[joint];
  if (found) return *found;
  OfJoint& errors = found.emplace(original_.rows(), 12);
  const TrackColumns tracks{original_.data(), decoded_.data(), original_.outerStride(),
                            decoded_.outerStride(), original_.rows()};
  const Eigen::Index origin = Eigen::Index{3} * joint;
  const Eigen::Index shell = shell_ + Eigen::Index{9} * joint;
  Eigen::Index t = 0;
  with_avx2([&]() MOCAPRESS_INLINED {
    t = find_errors<Doubles4>(tracks, origin, shell, 0, errors.data());
  });
  t = find_errors<Doubles2>(tracks, origin, shell, t, errors.data());
  find_errors<Doubles1>(tracks, origin, shell, t, errors.data());
  return errors;
}

namespace {

/// Writes the squared error of a point from row t on. Returns the first row of the rest that fills
/// no whole vector. `columns` are laid out as OfJoint.
template <typename Vector>
MOCAPRESS_INLINE Eigen::Index square_of(const double* columns, Eigen::Index rows,
                                        const Eigen::Vector3d& in_joint, Eigen::Index t,
                                        double* squares) {
  const double x = in_joint.x();
  const double y = in_joint.y();
  const double z = in_joint.z();
  for (; t + kLanes<Vector, double> <= rows; t += kLanes<Vector, double>) {
    Vector sum{};
    for (Eigen::Index i = 0; i < 3; ++i) {
      Vector origin;
      Vector along_x;
      Vector along_y;
      Vector along_z;
      load(columns + i * rows + t, origin);
      load(columns + (3 + i) * rows + t, along_x);
      load(columns + (6 + i) * rows + t, along_y);
      load(columns + (9 + i) * rows + t, along_z);
      const Vector error = origin + x * along_x + y * along_y + z * along_z;
      sum += error * error;
    }
    store(sum, squares + t);
  }
  return t;
}

}  // namespace

void JointErrors::find_squares(const OfJoint& of_joint, const Eigen::Vector3d& in_joint,
                               Eigen::Ref<Eigen::VectorXd> squares) {
  Eigen::Index t = 0;
  with_avx2([&]() MOCAPRESS_INLINED {
    t = square_of<Doubles4>(of_joint.data(), of_joint.rows(), in_joint, 0, squares.data());
  });
  t = square_of<Doubles2>(of_joint.data(), of_joint.rows(), in_joint, t, squares.data());
  square_of<Doubles1>(of_joint.data(), of_joint.rows(), in_joint, t, squares.data());
}

Eigen::VectorXd JointErrors::degrees(const OfJoint& of_joint) {
  // A rotation by an angle a moves the ends of the three axes by squared distances that sum to 8
  // sin(a / 2)^2.
  Eigen::ArrayXd sine = of_joint.col(3).cwiseAbs2();
  for (Eigen::Index i = 4; i < 12; ++i) sine += of_joint.col(i).array().square();
  sine = (sine / 8).min(1).sqrt();
  return (360 / std::numbers::pi) * sine.asin();
}

void visit_tracks(const Skeleton& skeleton, const Clip& clip, const TrackBlock& visit) {
  constexpr int kBlock = 512;  // frames at a time, few enough for the cache
  const std::vector<Landmark> points = landmarks(skeleton);
  Eigen::MatrixXd tracks;
  for (int first = 0; first == 0 || first < clip.frames(); first += kBlock) {
    const int end = std::min(first + kBlock, clip.frames());
    tracks.resize(end - first, columns_of(skeleton, points));
    fill_tracks(skeleton, points, clip.channels, first, end, tracks);
    visit(first, tracks);
  }
}

}  // namespace mocapress
