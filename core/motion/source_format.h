// SPDX-License-Identifier: MIT
// How the file a motion was read from puts it into numbers, so that a file written from it can be
// the same. The sample rate is not among it: that is the clip's own.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace mocapress {

/// The axis of a file that points up. In memory it is always Y. The values are part of the file
/// format.
enum class UpAxis : std::uint8_t { Y = 0, Z = 1 };

/// "y", "z".
constexpr std::string_view name(UpAxis up) {
  return up == UpAxis::Y ? "y" : "z";
}

/// Whether translation channels of a BVH add to OFFSET or replace it (MotionBuilder, Mixamo,
/// LAFAN1, and how Blender reads all of them). The values are part of the file format.
enum class TranslationConvention : std::uint8_t { Adds = 0, Replaces = 1 };

/// "add", "replace".
constexpr std::string_view name(TranslationConvention convention) {
  return convention == TranslationConvention::Adds ? "add" : "replace";
}

struct SourceFormat {
  /// The values are part of the file format.
  enum class Kind : std::uint8_t { None = 0, Bvh = 1, Acclaim = 2, Fbx = 3, Gltf = 4 };

  Kind kind = Kind::None;
  double cm_per_unit = 1;  // of files of that kind; of other kinds there is no saying
  UpAxis up = UpAxis::Y;
  std::optional<TranslationConvention> root;  // unset: no BVH, or both come to the same

  bool operator==(const SourceFormat&) const = default;
};

}  // namespace mocapress
