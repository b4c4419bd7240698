// SPDX-License-Identifier: MIT
// The animation of a glTF: section 3.11 of the glTF 2.0 specification.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/formats/gltf_output.h"
#include "core/formats/node_motion.h"
#include "core/motion/scalar_track.h"

namespace mocapress {

/// A node's movement against its parent, in the file's unit.
struct NodeTrack {
  std::size_t node = 0;  // its index in the file
  LocalTransform rest;
  std::vector<Eigen::Vector3d> translation;
  std::vector<Eigen::Quaterniond> rotation;
  std::optional<Eigen::Vector3d> scale;  // where it is another than at rest
  std::vector<Eigen::Vector3d> scales;   // where it changes
};

/// The scales that tracks have of joints.
class JointScales {
 public:
  JointScales(const ScalarTracks& tracks, const Skeleton& skeleton);

  bool any() const { return any_; }
  bool has(std::size_t joint) const;
  /// Along axes without a track it is 1.
  Eigen::Vector3d at(std::size_t joint, int frame) const;

 private:
  std::vector<std::array<const ScalarTrack*, 3>> of_joint_;
  bool any_ = false;
};

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

  /// `always`: though it rests.
  void add(const NodeTrack& track, bool always);
  void add(const WeightsTrack& weights);

 private:
  void add_channel(std::size_t node, const char* path, std::size_t input, std::size_t output,
                   const char* interpolation = "LINEAR");

  BufferWriter& buffer_;
  Json& animation_;
  double first_s_;
  std::size_t times_;
  std::optional<std::size_t> start_;  // the time of the first frame alone
};

Json json_of(const Eigen::Vector3d& vector);

/// Writes what is not the default.
void set_transform(Json& node, const LocalTransform& local);

}  // namespace mocapress
