// SPDX-License-Identifier: MIT
#include "core/runtime/pose/conventions.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace mocapress::runtime {
namespace {

constexpr std::int8_t kOwnAxes[3] = {1, 2, 3};

/// The numbers of one joint in a pose of the layout MCPR_ARRAYS.
struct InArrays {
  float* rotation;  // w x y z
  float* translation;
  std::size_t stride;  // distance from one number to the next

  InArrays(std::uint32_t joints, std::uint32_t joint, float* pose)
      : rotation(pose + joint), translation(rotation + std::size_t{4} * joints), stride(joints) {}
};

/// The numbers of one joint in a pose of transforms. They are adjacent: `stride` is a constant, so
/// that the compiler makes fast loops over them.
struct InTransforms {
  float* rotation;
  float* translation;
  static constexpr std::size_t stride = 1;

  InTransforms(std::uint32_t, std::uint32_t joint, float* pose)
      : rotation(pose + std::size_t{8} * joint), translation(rotation + 4) {}
};

template <typename Joint>
void place_in_parent(const Joint& parent, const Joint& joint) {
  float p[4], q[4], t[3];
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = parent.rotation[i * parent.stride];
    q[i] = joint.rotation[i * joint.stride];
  }
  for (std::size_t i = 0; i < 3; ++i) t[i] = joint.translation[i * joint.stride];
  const float product[4] = {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
                            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
                            p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
                            p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
  // v + 2 w (u x v) + 2 u x (u x v), where u is the vector part
  const float c[3] = {p[2] * t[2] - p[3] * t[1], p[3] * t[0] - p[1] * t[2],
                      p[1] * t[1] - p[2] * t[0]};
  const float d[3] = {p[2] * c[2] - p[3] * c[1], p[3] * c[0] - p[1] * c[2],
                      p[1] * c[1] - p[2] * c[0]};
  for (std::size_t i = 0; i < 4; ++i) joint.rotation[i * joint.stride] = product[i];
  for (std::size_t i = 0; i < 3; ++i)
    joint.translation[i * joint.stride] =
        parent.translation[i * parent.stride] + (t[i] + 2 * (p[0] * c[i] + d[i]));
}

/// m = parent * m, for 3 x 4 matrices.
void multiply(const float* parent, float* m) {
  for (int column = 0; column < 4; ++column) {
    const float x = m[column];
    const float y = m[4 + column];
    const float z = m[8 + column];
    for (int row = 0; row < 3; ++row) {
      const float* const p = parent + 4 * row;
      const float sum = p[0] * x + p[1] * y + p[2] * z;
      m[4 * row + column] = column == 3 ? sum + p[3] : sum;
    }
  }
}

/// For each axis of an engine: the clip's axis that it is, and its sign.
struct AxisMap {
  int from[3];
  float sign[3];
  float hand = 1;  // -1 if the engine's axes have the other handedness

  explicit AxisMap(const mcpr_convention& convention) {
    const bool own = convention.axes[0] == 0;
    for (int i = 0; i < 3; ++i) {
      const int axis = own ? kOwnAxes[i] : convention.axes[i];
      from[i] = std::abs(axis) - 1;
      sign[i] = axis < 0 ? -1.0F : 1.0F;
      hand *= sign[i];
    }
    if ((from[0] + 1) % 3 != from[1]) hand = -hand;
  }
};

template <typename Joint>
void convert(const AxisMap& map, float length, bool w_last, const Joint& joint) {
  const std::size_t stride = joint.stride;
  float q[4], t[3];
  for (std::size_t i = 0; i < 4; ++i) q[i] = joint.rotation[i * stride];
  for (std::size_t i = 0; i < 3; ++i) t[i] = joint.translation[i * stride];
  const std::size_t x = w_last ? 0 : 1;
  joint.rotation[(w_last ? 3 : 0) * stride] = q[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const int from = map.from[i];
    joint.rotation[(x + i) * stride] = map.hand * map.sign[i] * q[1 + from];
    joint.translation[i * stride] = length * map.sign[i] * t[from];
  }
}

void convert(const AxisMap& map, float length, float* matrix) {
  float m[12];
  for (int i = 0; i < 12; ++i) m[i] = matrix[i];
  for (int row = 0; row < 3; ++row) {
    const float* const from = m + 4 * map.from[row];
    for (int column = 0; column < 3; ++column)
      matrix[4 * row + column] = map.sign[row] * map.sign[column] * from[map.from[column]];
    matrix[4 * row + 3] = length * map.sign[row] * from[3];
  }
}

}  // namespace

bool is_convention(const mcpr_convention& convention) {
  if (!std::isfinite(convention.length)) return false;
  unsigned seen = 0;
  for (const std::int8_t axis : convention.axes)
    if (axis >= -3 && axis <= 3) seen |= 1U << (axis < 0 ? -axis : axis);
  return seen == 0b1110 || (seen == 1 && convention.axes[0] == 0);
}

bool are_parents(const std::int16_t* parents, std::uint32_t joints) {
  for (std::uint32_t j = 0; j < joints; ++j)
    if (parents[j] < -1 || parents[j] >= static_cast<std::int32_t>(j)) return false;
  return true;
}

void place_in_model(mcpr_layout layout, const std::int16_t* parents, std::uint32_t joints,
                    float* pose) {
  for (std::uint32_t j = 0; j < joints; ++j) {
    if (parents[j] < 0) continue;
    const auto parent = static_cast<std::uint32_t>(parents[j]);
    if (layout == MCPR_MATRICES)
      multiply(pose + std::size_t{12} * parent, pose + std::size_t{12} * j);
    else if (layout == MCPR_ARRAYS)
      place_in_parent(InArrays(joints, parent, pose), InArrays(joints, j, pose));
    else
      place_in_parent(InTransforms(joints, parent, pose), InTransforms(joints, j, pose));
  }
}

void convert(const mcpr_convention& convention, mcpr_layout layout, std::uint32_t joints,
             float* pose) {
  const AxisMap map(convention);
  const float length = convention.length == 0 ? 1 : convention.length;
  for (std::uint32_t j = 0; j < joints; ++j)
    if (layout == MCPR_MATRICES)
      convert(map, length, pose + std::size_t{12} * j);
    else if (layout == MCPR_ARRAYS)
      convert(map, length, convention.w_last != 0, InArrays(joints, j, pose));
    else
      convert(map, length, convention.w_last != 0, InTransforms(joints, j, pose));
}

}  // namespace mocapress::runtime
