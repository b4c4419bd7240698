// SPDX-License-Identifier: MIT
#include "core/study/fingerprint.h"

#include <span>

#include "core/base/fnv1a.h"
#include "core/codec/skeleton_section.h"

namespace mocapress {

std::string fingerprint(const Motion& motion) {
  Fnv1a hash;
  hash.add(encode_skeleton(motion.skeleton));
  hash.add(std::as_bytes(std::span(&motion.clip.sample_rate_hz, 1)));
  const Eigen::MatrixXd& channels = motion.clip.channels;
  hash.add(std::as_bytes(std::span(channels.data(), static_cast<std::size_t>(channels.size()))));
  return hash.text();
}

}  // namespace mocapress
