// SPDX-License-Identifier: MIT
#include "core/codec/decoder.h"

#include <tbb/parallel_for.h>

#include "core/codec/deflate.h"
#include "core/codec/rle16.h"
#include "core/wavelet/lifting.h"

namespace mocapress {
namespace {

Eigen::MatrixXd decode_coefficients(const CompressedClip& compressed) {
  const int channels = compressed.skeleton.channel_count();
  if (compressed.coding == Coding::Rle16)
    return rle16_decode(compressed.motion, compressed.frames, channels);
  const auto words = inflate_bytes(compressed.motion, rle16_bound(compressed.frames, channels));
  return rle16_decode(words, compressed.frames, channels);
}

}  // namespace

Clip decode(const CompressedClip& compressed) {
  Clip clip{compressed.sample_rate_hz, decode_coefficients(compressed)};
  const Lifting lifting(compressed.basis, compressed.frames);
  const std::vector<double> gains = lifting.gains();
  const Eigen::Map<const Eigen::VectorXd> gain(gains.data(), clip.frames());
  tbb::parallel_for(Eigen::Index{0}, clip.channels.cols(), [&](Eigen::Index c) {
    const std::span<double> signal(clip.channels.col(c).data(),
                                   static_cast<std::size_t>(clip.frames()));
    clip.channels.col(c).array() /= gain.array();
    lifting.inverse(signal, signal);
  });
  return clip;
}

}  // namespace mocapress
