// SPDX-License-Identifier: MIT
// ACL as a peer, built where its headers are (../shared/peers or MOCAPRESS_PEERS).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>

#include "core/motion/clip.h"

namespace mocapress {

/// A clip compressed by ACL's defaults at level medium, with its recommended lossy pre-processing,
/// a shell of 3 cm and the bind pose as default.
class AclClip {
 public:
  /// Throws Error when ACL refuses.
  AclClip(const Motion& motion, double precision_cm);
  ~AclClip();

  std::size_t bytes() const;

  /// What compressing took, with ACL's pre-processing, from transforms on that it wants.
  double encode_seconds() const;

  /// body_tracks() of every frame as it decodes them.
  Eigen::MatrixXd tracks(const Skeleton& skeleton) const;

  /// Local transforms of every frame, one after the other, into memory of its own. After open().
  void decode_frames();

  /// Makes a context for it, as an engine does that trusts its bytes.
  void open();

  /// Local transforms at an instant, between two frames interpolated as ACL does, into memory of
  /// its own. After open().
  void sample(float seconds);

 private:
  friend class AclPlayer;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Samples a clip for one thread, with a context that is kept; the clip must outlive it.
class AclPlayer {
 public:
  explicit AclPlayer(const AclClip& clip);
  AclPlayer(AclPlayer&&) noexcept;
  ~AclPlayer();

  void sample(float seconds);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mocapress
