// SPDX-License-Identifier: MIT
#include "core/motion/pose_block.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <type_traits>

#include "core/base/instruction_sets.h"

namespace mocapress {
namespace {

constexpr int kMost = PoseBlock::kMostFrames;

// The loops below run over a number of frames known at compile time, and over restricted pointers,
// so that the compiler vectorises them.

/// Calls work(count) with a compile-time count of at least `frames`.
template <typename Work>
void for_frames(int frames, const Work& work) {
  if (frames <= 4)
    work(std::integral_constant<int, 4>());
  else if (frames <= 16)
    work(std::integral_constant<int, 16>());
  else
    work(std::integral_constant<int, kMost>());
}

/// Runs `work` on a block of kFrames frames, with AVX2 if the block is large enough for vectors of
/// four to pay.
template <int kFrames, typename Work>
void for_block(const Work& work) {
  if (kFrames != kMost || !with_avx2(work)) work();
}

MOCAPRESS_INLINE double rounded(double value) {
  constexpr double kWhole = 6755399441055744;  // 1.5 * 2^52: adding it rounds to a whole number
  return value + kWhole - kWhole;
}

/// The largest angle whose sine and cosine are right to the last digit or so. The polynomials are
/// fdlibm's for a quarter turn about zero.
constexpr double kMostTurned = 1e5;  // radians

template <int kFrames>
MOCAPRESS_INLINE void find_sines_and_cosines(const double* __restrict radians,
                                             double* __restrict sines, double* __restrict cosines) {
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
    // Computed without branches, since branches would not be vectorised.
    const double sine_sign = std::copysign(1.0, 1 - std::abs(turn - 0.5));
    const double cosine_sign = std::copysign(1.0, 1 - std::abs(turn + 0.5));
    const double swapped = odd * odd;  // 0 or 1
    sines[t] = sine_sign * ((1 - swapped) * sine + swapped * cosine);
    cosines[t] = cosine_sign * ((1 - swapped) * cosine + swapped * sine);
  }
}

/// Rotates two columns into one another, by each frame's angle.
template <int kFrames>
MOCAPRESS_INLINE void turn_columns(const double* __restrict sines, const double* __restrict cosines,
                                   double* __restrict first, double* __restrict second) {
  for (int t = 0; t < kFrames; ++t) {
    const double a = first[t];
    const double b = second[t];
    first[t] = cosines[t] * a + sines[t] * b;
    second[t] = cosines[t] * b - sines[t] * a;
  }
}

/// x, y, z of a joint's three axes, each a column of frames.
using Axes = std::array<double*, 9>;

/// Turns axes a and b of a joint by angles, given by their sines and cosines.
template <int kFrames>
MOCAPRESS_INLINE void turn_axes(const double* sines, const double* cosines, const Axes& axes, int a,
                                int b) {
  for (int i = 0; i < 3; ++i)
    turn_columns<kFrames>(sines, cosines, axes[3 * a + i], axes[3 * b + i]);
}

template <int kFrames>
MOCAPRESS_INLINE void combine(const double* __restrict a, const double* __restrict b,
                              const double* __restrict c, double of_a, double of_b, double of_c,
                              double* __restrict sum) {
  for (int t = 0; t < kFrames; ++t) sum[t] = a[t] * of_a + b[t] * of_b + c[t] * of_c;
}

/// to = from * matrix, for each frame. `from` and `to` must not overlap.
template <int kFrames>
MOCAPRESS_INLINE void multiply_axes(const Axes& from, const Eigen::Matrix3d& matrix,
                                    const Axes& to) {
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t row = 0; row < 3; ++row) {
      const auto of = static_cast<Eigen::Index>(column);
      combine<kFrames>(from[row], from[3 + row], from[6 + row], matrix(0, of), matrix(1, of),
                       matrix(2, of), to[3 * column + row]);
    }
}

}  // namespace

PoseBlock::PoseBlock(const Skeleton& skeleton)
    : skeleton_(skeleton),
      origins_(kMostFrames, Eigen::Index{3} * skeleton.joint_count()),
      axes_(kMostFrames, Eigen::Index{9} * skeleton.joint_count()),
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
  if (from == joint) before_ = axes_.middleCols<9>(Eigen::Index{9} * from);
  Axes given;
  Axes made;
  for (Eigen::Index i = 0; i < 9; ++i) {
    given[i] = from == joint ? before_.col(i).data() : axes_.col(Eigen::Index{9} * from + i).data();
    made[i] = axes_.col(Eigen::Index{9} * joint + i).data();
  }
  for_frames(frames_, [&](auto count) {
    constexpr int kFrames = decltype(count)::value;
    for_block<kFrames>([&]() MOCAPRESS_INLINED { multiply_axes<kFrames>(given, matrix, made); });
  });
}

void PoseBlock::turn(int joint, int axis, const Eigen::Ref<const Eigen::VectorXd>& radians) {
  std::array<double, kMost> angles{};
  std::array<double, kMost> sines;
  std::array<double, kMost> cosines;
  std::ranges::copy(radians, angles.begin());
  const bool is_far = !(radians.cwiseAbs().maxCoeff() < kMostTurned);
  Axes axes;
  for (Eigen::Index i = 0; i < 9; ++i) axes[i] = axes_.col(Eigen::Index{9} * joint + i).data();
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  if (is_far)
    for (std::size_t t = 0; t < angles.size(); ++t) {
      sines[t] = std::sin(angles[t]);
      cosines[t] = std::cos(angles[t]);
    }
  for_frames(frames_, [&](auto count) {
    constexpr int kFrames = decltype(count)::value;
    for_block<kFrames>([&]() MOCAPRESS_INLINED {
      if (!is_far) find_sines_and_cosines<kFrames>(angles.data(), sines.data(), cosines.data());
      turn_axes<kFrames>(sines.data(), cosines.data(), axes, next, last);
    });
  });
}

}  // namespace mocapress
