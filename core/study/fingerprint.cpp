// SPDX-License-Identifier: MIT
// FNV-1a, 64 bits, as in RFC 9923.
#include "core/study/fingerprint.h"

#include <cstdint>
#include <cstdio>
#include <span>

#include "core/codec/skeleton_section.h"

namespace mocapress {
namespace {

class Fnv1a {
 public:
  void add(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) {
      state_ ^= std::to_integer<std::uint64_t>(byte);
      state_ *= 0x100000001b3u;
    }
  }
  std::uint64_t state() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace

std::string fingerprint(const Motion& motion) {
  Fnv1a hash;
  hash.add(encode_skeleton(motion.skeleton));
  hash.add(std::as_bytes(std::span(&motion.clip.sample_rate_hz, 1)));
  const Eigen::MatrixXd& channels = motion.clip.channels;
  hash.add(std::as_bytes(std::span(channels.data(), static_cast<std::size_t>(channels.size()))));
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash.state()));
  return text;
}

}  // namespace mocapress
