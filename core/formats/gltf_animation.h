// SPDX-License-Identifier: MIT
// The animation of a glTF: section 3.11 of the glTF 2.0 specification.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/formats/gltf_output.h"
#include "core/formats/node_tracks.h"
#include "core/motion/scalar_track.h"

namespace mocapress {

/// All morph weights of a node.
struct WeightsTrack {
  std::size_t node = 0;  // its index in the file
  std::vector<const ScalarTrack*> of_target;
};

/// Appends the samplers and channels of tracks to an animation.
class AnimationWriter {
 public:
  AnimationWriter(BufferWriter& buffer, Json& animation, double first_s, int frames,
                  double sample_rate_hz);

  /// `always`: adds the track even if nothing changes in it.
  void add(const NodeTrack& track, bool always);
  void add(const WeightsTrack& weights);

 private:
  void add_channel(std::size_t node, const char* path, std::size_t input, std::size_t output,
                   const char* interpolation = "LINEAR");

  BufferWriter& buffer_;
  Json& animation_;
  double first_s_;
  std::size_t times_;
  std::optional<std::size_t> start_;  // an accessor of the first frame's time only
};

Json json_of(const Eigen::Vector3d& vector);

/// Writes the parts of a transform that differ from glTF's defaults.
void set_transform(Json& node, const LocalTransform& local);

}  // namespace mocapress
