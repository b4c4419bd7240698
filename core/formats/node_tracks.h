// SPDX-License-Identifier: MIT
// Turns a motion back into moving nodes, for the writers of FBX and glTF.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/node_motion.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/scalar_track.h"

namespace mocapress {

/// A node's movement relative to its parent, in the file's unit.
struct NodeTrack {
  std::size_t node = 0;  // its index
  LocalTransform rest;
  std::vector<Eigen::Vector3d> translation;
  std::vector<Eigen::Quaterniond> rotation;
  std::optional<Eigen::Vector3d> scale;  // set if it differs from that at rest
  std::vector<Eigen::Vector3d> scales;   // one for each frame, if it changes
};

/// Scales of joints over time, from tracks.
class JointScales {
 public:
  JointScales(const ScalarTracks& tracks, const Skeleton& skeleton);

  bool any() const { return any_; }
  bool has(std::size_t joint) const;
  /// The scale of a joint at a frame; 1 along axes without a track.
  Eigen::Vector3d at(std::size_t joint, int frame) const;

 private:
  std::vector<std::array<const ScalarTrack*, 3>> of_joint_;
  bool any_ = false;
};

/// The pose in which bones stand when nothing moves them: all channels at zero or, of a source that
/// has no such pose (FBX, glTF), the first frame.
Pose resting_pose(const Motion& motion, const SourceFormat& source);

/// The tracks of all joints; nodes have the numbers of their joints. Throws WriteError if a scale
/// of zero leaves the children of a joint without a place.
std::vector<NodeTrack> tracks_of(const Motion& motion, const Pose& rest, double cm_per_unit,
                                 const JointScales& scales);

/// The placements of these nodes at rest, in cm.
std::vector<NodePlacement> rest_placements(const Skeleton& skeleton,
                                           const std::vector<NodeTrack>& tracks,
                                           double cm_per_unit);

/// The end of a joint's bone in the axes of its node, which may be scaled.
Eigen::Vector3d end_in_node(const NodePlacement& node, const Eigen::Vector3d& end_site);

/// Tracks for the nodes of a take that have the names of the joints of `motion`, one for each
/// joint, so that the nodes move as the joints do in the world. `names` are the joints' names as a
/// reader gives them; `options` are those the take was read with. Throws InputError, which names
/// `file`, if a joint has no node.
std::vector<NodeTrack> tracks_following(const std::string& file, const NodeTake& take,
                                        const Motion& motion, const std::vector<std::string>& names,
                                        const ReadOptions& options, const JointScales& scales);

}  // namespace mocapress
