// SPDX-License-Identifier: MIT
#include "core/runtime/pose/pose_packing.h"

#include "core/runtime/format/bit_pattern.h"

namespace mocapress::runtime {
namespace {

constexpr std::uint32_t kFour = 4;         // joints in a vector
constexpr std::uint32_t kFourValues = 40;  // numbers in a vector: translation, rotation and scale
                                           // of four joints

/// Rounds to the nearest 16-bit float; halfway between two, to the even one.
std::uint16_t half_of(float value) {
  const auto bits = bit_pattern<std::uint32_t>(value);
  const std::uint32_t sign = bits >> 16 & 0x8000U;
  const std::uint32_t size = bits & 0x7FFFFFFFU;
  std::uint32_t half;
  if (size >= 0x47800000U)  // 65536 or more, infinity, or not a number
    half = size > 0x7F800000U ? 0x7E00U : 0x7C00U;
  else if (size < 0x38800000U)  // below 2^-14; beside 1/2, floats have steps of 2^-24, as small
                                // 16-bit floats do
    half = bit_pattern<std::uint32_t>(bit_pattern<float>(size) + 0.5F) - 0x3F000000U;
  else
    half = (size - 0x38000000U + 0xFFFU + (size >> 13 & 1U)) >> 13;
  return static_cast<std::uint16_t>(sign | half);
}

void pack_fours(bool w_last, const mcpr_transform* pose, std::uint32_t joints, float* out) {
  static constexpr mcpr_transform kOwnRest = {{1, 0, 0, 0}, {}};
  static constexpr mcpr_transform kRest = {{0, 0, 0, 1}, {}};
  for (std::uint32_t first = 0; first < joints; first += kFour, out += kFourValues)
    for (std::uint32_t i = 0; i < kFour; ++i) {
      const bool is_joint = first + i < joints;
      const mcpr_transform& joint = is_joint ? pose[first + i] : w_last ? kRest : kOwnRest;
      for (std::uint32_t k = 0; k < 3; ++k) {
        out[kFour * k + i] = joint.translation[k];
        out[kFour * (7 + k) + i] = 1;
      }
      for (std::uint32_t k = 0; k < 4; ++k) out[kFour * (3 + k) + i] = joint.rotation[k];
    }
}

void pack_halves(const mcpr_transform* pose, std::uint32_t joints, std::uint16_t* out) {
  for (std::uint32_t j = 0; j < joints; ++j, out += 8)
    for (std::uint32_t k = 0; k < 4; ++k) {
      out[k] = half_of(pose[j].rotation[k]);
      out[4 + k] = half_of(pose[j].translation[k]);
    }
}

}  // namespace

std::size_t values_of_pose(mcpr_layout layout, std::uint32_t joints) {
  switch (layout) {
    case MCPR_TRANSFORMS:
      break;
    case MCPR_ARRAYS:
      return std::size_t{7} * joints;
    case MCPR_MATRICES:
      return std::size_t{12} * joints;
    case MCPR_FOURS:
      return std::size_t{kFourValues} * ((joints + kFour - 1) / kFour);
    case MCPR_HALVES:
      return std::size_t{4} * joints;
    case MCPR_WRITER:
      return sizeof(mcpr_writer) / sizeof(float);
  }
  return std::size_t{8} * joints;
}

void pack(const mcpr_sample_request& request, const mcpr_transform* pose, std::uint32_t joints,
          void* out) {
  if (request.layout == MCPR_FOURS) {
    const bool w_last = request.convention != nullptr && request.convention->w_last != 0;
    pack_fours(w_last, pose, joints, static_cast<float*>(out));
  } else if (request.layout == MCPR_HALVES) {
    pack_halves(pose, joints, static_cast<std::uint16_t*>(out));
  } else {
    const auto& writer = *static_cast<const mcpr_writer*>(out);
    for (std::uint32_t j = 0; j < joints; ++j) writer.write(writer.context, j, &pose[j]);
  }
}

}  // namespace mocapress::runtime
