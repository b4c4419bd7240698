// SPDX-License-Identifier: MIT
// The conventions of the file a motion was read from, so that a file written from it can have the
// same. The sample rate is not among them, since it belongs to the clip.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace mocapress {

/// The axis that points up in a file; in memory it is always Y. The values are part of the file
/// format.
enum class UpAxis : std::uint8_t { Y = 0, Z = 1 };

/// "y", "z".
constexpr std::string_view name(UpAxis up) {
  return up == UpAxis::Y ? "y" : "z";
}

/// The use of a BVH's translation channels: they add to OFFSET or replace it (as MotionBuilder,
/// Mixamo and LAFAN1 write, and Blender reads). The values are part of the file format.
enum class TranslationConvention : std::uint8_t { Adds = 0, Replaces = 1 };

/// "add", "replace".
constexpr std::string_view name(TranslationConvention convention) {
  return convention == TranslationConvention::Adds ? "add" : "replace";
}

struct SourceFormat {
  /// The kind of the source file. The values are part of the file format.
  enum class Kind : std::uint8_t { None = 0, Bvh = 1, Acclaim = 2, Fbx = 3, Gltf = 4 };

  Kind kind = Kind::None;
  double cm_per_unit = 1;  // scale of files of that kind; unused without a kind
  UpAxis up = UpAxis::Y;
  std::optional<TranslationConvention> root;  // unset: no BVH, or both conventions agree

  bool operator==(const SourceFormat&) const = default;
};

}  // namespace mocapress
