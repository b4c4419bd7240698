// SPDX-License-Identifier: MIT
// Compresses by ACL for comparison, if its headers are found (../shared/peers or MOCAPRESS_PEERS).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <span>

#include "core/motion/clip.h"

namespace mocapress {

/// A clip compressed by ACL's defaults at level medium, with its recommended lossy pre-processing,
/// a shell of 3 cm and the bind pose as default.
class AclClip {
 public:
  /// Throws Error if ACL refuses the motion.
  AclClip(const Motion& motion, double precision_cm);
  ~AclClip();

  std::size_t bytes() const;

  /// The compressed clip, whole and without pointers.
  std::span<const std::byte> block() const;

  /// Time to compress the transforms, including ACL's pre-processing.
  double encode_seconds() const;

  /// body_tracks() of every decoded frame.
  Eigen::MatrixXd tracks(const Skeleton& skeleton) const;

  /// Decodes the local transforms of all frames into the clip's own memory. Requires open().
  void decode_frames();

  /// Makes a decoding context as an engine does that trusts the bytes.
  void open();

  /// Samples local transforms at an instant into the clip's own memory, interpolated as ACL does.
  /// Requires open().
  void sample(float seconds);

 private:
  friend class AclPlayer;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Samples a clip for one thread with a context that is kept; the clip must outlive it.
class AclPlayer {
 public:
  explicit AclPlayer(const AclClip& clip);
  AclPlayer(AclPlayer&&) noexcept;
  ~AclPlayer();

  /// A player of a block(), which outlives it and is aligned to 16 bytes.
  explicit AclPlayer(const std::byte* block, std::size_t joints);

  void sample(float seconds);

  /// Goes over to another clip with as many joints.
  void open(const std::byte* block);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mocapress
