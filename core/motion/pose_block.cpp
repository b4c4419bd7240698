// SPDX-License-Identifier: MIT
#include "core/motion/pose_block.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace mocapress {
namespace {

constexpr int kFrames = PoseBlock::kMostFrames;

// Loops below are over all frames a block may have, and over restricted pointers: so the compiler
// makes vector instructions of them.

double rounded(double value) {
  constexpr double kWhole = 6755399441055744;  // 1.5 * 2^52: what is added to it loses its fraction
  return value + kWhole - kWhole;
}

/// Sines and cosines, to the last digit or so, of angles up to kMostTurned. The polynomials are
/// fdlibm's for a quarter turn about zero.
constexpr double kMostTurned = 1e5;  // radians

void find_sines_and_cosines(const double* __restrict radians, double* __restrict sines,
                            double* __restrict cosines) {
  constexpr double kQuarter = 1.57079632673412561417;  // pi / 2 to 33 bits
  constexpr double kRest = 6.07710050650619224932e-11;
  for (int t = 0; t < kFrames; ++t) {
    const double quarters = rounded(radians[t] * 0.63661977236758134308);
    const double x = radians[t] - quarters * kQuarter - quarters * kRest;
    const double z = x * x;
    const double sine =
        x +
        x * z *
            (-1.66666666666666324348e-01 +
             z * (8.33333333332248946124e-03 +
                  z * (-1.98412698298579493134e-04 +
                       z * (2.75573137070700676789e-06 +
                            z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
    const double cosine =
        1 - (0.5 * z - z * z *
                           (4.16666666666666019037e-02 +
                            z * (-1.38888888888741095749e-03 +
                                 z * (2.48015872894767294178e-05 +
                                      z * (-2.75573143513906633035e-07 +
                                           z * (2.08757232129817482790e-09 +
                                                z * -1.13596475577881948265e-11))))));
    const double odd = quarters - 2 * rounded(0.5 * quarters);    // -1, 0 or 1
    const double turn = quarters - 4 * rounded(0.25 * quarters);  // -2 to 2
    const double sine_sign = turn < -0.5 || turn > 1.5 ? -1 : 1;
    const double cosine_sign = turn * turn > 0.5 && (turn > 0.5 || turn < -1.5) ? -1 : 1;
    sines[t] = sine_sign * (odd == 0 ? sine : cosine);
    cosines[t] = cosine_sign * (odd == 0 ? cosine : sine);
  }
}

/// Mixes two columns.
void turn_columns(const double* __restrict sines, const double* __restrict cosines,
                  double* __restrict first, double* __restrict second) {
  for (int t = 0; t < kFrames; ++t) {
    const double a = first[t];
    const double b = second[t];
    first[t] = cosines[t] * a + sines[t] * b;
    second[t] = cosines[t] * b - sines[t] * a;
  }
}

void combine(const double* __restrict a, const double* __restrict b, const double* __restrict c,
             double of_a, double of_b, double of_c, double* __restrict sum) {
  for (int t = 0; t < kFrames; ++t) sum[t] = a[t] * of_a + b[t] * of_b + c[t] * of_c;
}

}  // namespace

PoseBlock::PoseBlock(const Skeleton& skeleton)
    : skeleton_(skeleton),
      origins_(Eigen::MatrixXd::Zero(kMostFrames, Eigen::Index{3} * skeleton.joint_count())),
      axes_(Eigen::MatrixXd::Zero(kMostFrames, Eigen::Index{9} * skeleton.joint_count())),
      in_parent_(kMostFrames, 3) {}

void PoseBlock::compute(const Eigen::MatrixXd& channels, int first, int frames,
                        Eigen::MatrixXd* axes) {
  assert(frames <= kMostFrames && channels.cols() == skeleton_.channel_count());
  frames_ = frames;
  for (int j = 0; j < skeleton_.joint_count(); ++j) compute_joint(j, channels, first, axes);
}

void PoseBlock::compute_joint(int j, const Eigen::MatrixXd& channels, int first,
                              Eigen::MatrixXd* axes) {
  const Joint& joint = skeleton_.joint(j);
  const JointAxes& fixed = skeleton_.axes(j);
  const bool is_root = joint.parent < 0;
  auto mine = axes_.block(0, Eigen::Index{9} * j, frames_, 9);
  auto my_origin = origins_.block(0, Eigen::Index{3} * j, frames_, 3);
  if (joint.channels.empty() && !is_root) {
    mine = axes_.block(0, Eigen::Index{9} * joint.parent, frames_, 9);
    my_origin = place(joint.parent, joint.offset).matrix();
    return;
  }
  if (is_root)
    mine.rowwise() = fixed.parent_from_axes.reshaped().transpose();
  else
    multiply(joint.parent, fixed.parent_from_axes, j);
  auto in_parent = in_parent_.topRows(frames_);
  in_parent.rowwise() = joint.offset.transpose();
  for (std::size_t i = 0; i < joint.channels.size(); ++i) {
    const Eigen::Index channel = skeleton_.first_channel(j) + static_cast<Eigen::Index>(i);
    const auto values = channels.col(channel).segment(first, frames_);
    const int along = axis_of(joint.channels[i]);
    const bool rotates = is_rotation(joint.channels[i]);
    if (axes) {
      auto seen = axes->block(first, 3 * channel, frames_, 3);
      if (rotates)
        seen = axis(j, along).matrix();
      else if (is_root)
        seen.rowwise() = Eigen::RowVector3d::Unit(along);
      else
        seen = axis(joint.parent, along).matrix();
    }
    if (rotates)
      turn(j, along, values);
    else
      in_parent.col(along) += values;
  }
  if (is_root)
    my_origin = in_parent;
  else
    for (int i = 0; i < 3; ++i)
      my_origin.col(i) =
          (origin(joint.parent).col(i) + (axis(joint.parent, 0).col(i) * in_parent.col(0).array() +
                                          axis(joint.parent, 1).col(i) * in_parent.col(1).array() +
                                          axis(joint.parent, 2).col(i) * in_parent.col(2).array()))
              .matrix();
  multiply(j, fixed.axes_from_joint, j);
}

void PoseBlock::multiply(int from, const Eigen::Matrix3d& matrix, int joint) {
  const bool is_identity = matrix == Eigen::Matrix3d::Identity();
  if (is_identity && from == joint) return;
  if (is_identity) {
    axes_.middleCols<9>(Eigen::Index{9} * joint) = axes_.middleCols<9>(Eigen::Index{9} * from);
    return;
  }
  before_ = axes_.middleCols<9>(Eigen::Index{9} * from);
  for (Eigen::Index column = 0; column < 3; ++column)
    for (Eigen::Index row = 0; row < 3; ++row)
      combine(before_.col(row).data(), before_.col(3 + row).data(), before_.col(6 + row).data(),
              matrix(0, column), matrix(1, column), matrix(2, column),
              axes_.col(Eigen::Index{9} * joint + 3 * column + row).data());
}

void PoseBlock::turn(int joint, int axis, const Eigen::Ref<const Eigen::VectorXd>& radians) {
  std::array<double, kFrames> angles{};
  std::array<double, kFrames> sines;
  std::array<double, kFrames> cosines;
  std::copy(radians.begin(), radians.end(), angles.begin());
  if (radians.cwiseAbs().maxCoeff() < kMostTurned)
    find_sines_and_cosines(angles.data(), sines.data(), cosines.data());
  else
    for (std::size_t t = 0; t < angles.size(); ++t) {
      sines[t] = std::sin(angles[t]);
      cosines[t] = std::cos(angles[t]);
    }
  const Eigen::Index first = Eigen::Index{9} * joint;
  const int next = 3 * ((axis + 1) % 3);
  const int last = 3 * ((axis + 2) % 3);
  for (int i = 0; i < 3; ++i)
    turn_columns(sines.data(), cosines.data(), axes_.col(first + next + i).data(),
                 axes_.col(first + last + i).data());
}

}  // namespace mocapress
