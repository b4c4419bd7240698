// SPDX-License-Identifier: MIT
// ACL as a peer, built where its headers are (../shared/peers or MOCAPRESS_PEERS).
#pragma once

#include "core/motion/clip.h"

namespace mocapress {

struct AclResult {
  std::size_t bytes = 0;
  Eigen::MatrixXd tracks;  // body_tracks() of what it decodes
};

/// Compresses local transforms by ACL's defaults at level medium, with its recommended lossy
/// pre-processing, a shell of 3 cm and the bind pose as default, and decodes every frame. Throws
/// Error when ACL refuses.
AclResult compress_by_acl(const Motion& motion, double precision_cm);

}  // namespace mocapress
