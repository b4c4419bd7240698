// SPDX-License-Identifier: MIT
// Moving quantities other than joints: morph weights, custom properties, events, scales.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mocapress {

/// The values are part of the file format: never reassign one.
enum class TrackKind : std::uint8_t {
  Property = 0,     // custom properties, IK and event curves
  MorphWeight = 1,  // 0: not at all, 1: all of the shape
  ScaleX = 2,       // a joint's, relative to its parent
  ScaleY = 3,
  ScaleZ = 4,
};

inline constexpr int kTrackKinds = 5;

constexpr bool is_scale(TrackKind kind) {
  return kind >= TrackKind::ScaleX;
}

constexpr TrackKind scale_along(int axis) {
  return static_cast<TrackKind>(2 + axis);
}

/// One number over time, without a unit.
struct ScalarTrack {
  TrackKind kind = TrackKind::Property;
  std::string node;           // the owner: a joint, or the node of a mesh; empty: the clip
  std::string name;           // the property or the morph target; empty for a scale
  bool steps = false;         // true: constant between frames; false: linear
  std::vector<float> values;  // one for each frame; finite

  bool operator==(const ScalarTrack&) const = default;
};

using ScalarTracks = std::vector<ScalarTrack>;

/// The default bound on a decoded value's error: a smaller error of a morph is not seen.
inline constexpr double kUsualTrackError = 0.002;

/// "property", "morph-weight", "scale-x" ...
constexpr const char* name(TrackKind kind) {
  constexpr const char* kNames[kTrackKinds] = {"property", "morph-weight", "scale-x", "scale-y",
                                               "scale-z"};
  return kNames[static_cast<int>(kind)];
}

/// "Face.smile", "Hips.scale-x".
inline std::string label(const ScalarTrack& track) {
  const std::string own = is_scale(track.kind) ? name(track.kind) : track.name;
  return track.node.empty() ? own : track.node + '.' + own;
}

}  // namespace mocapress
