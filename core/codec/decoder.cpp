// SPDX-License-Identifier: MIT
#include "core/codec/decoder.h"

#include <tbb/parallel_for.h>

#include "core/codec/deflate.h"
#include "core/codec/rle16.h"
#include "core/wavelet/lifting.h"

namespace mocapress {
namespace {

Eigen::MatrixXd decode_coefficients(std::span<const std::byte> bytes, Coding coding, int frames,
                                    int signals) {
  if (coding == Coding::Rle16) return rle16_decode(bytes, frames, signals);
  return rle16_decode(inflate_bytes(bytes, rle16_bound(frames, signals)), frames, signals);
}

}  // namespace

Clip decode(const CompressedClip& compressed) {
  return {compressed.sample_rate_hz,
          decode_signals(compressed.motion, compressed.coding, compressed.basis, compressed.frames,
                         compressed.skeleton.channel_count())};
}

Eigen::MatrixXd decode_signals(std::span<const std::byte> bytes, Coding coding, Basis basis,
                               int frames, int signals) {
  Eigen::MatrixXd columns = decode_coefficients(bytes, coding, frames, signals);
  const Lifting lifting(basis, frames);
  const std::vector<double> gains = lifting.gains();
  const Eigen::Map<const Eigen::VectorXd> gain(gains.data(), frames);
  tbb::parallel_for(Eigen::Index{0}, columns.cols(), [&](Eigen::Index c) {
    const std::span<double> signal(columns.col(c).data(), static_cast<std::size_t>(frames));
    columns.col(c).array() /= gain.array();
    lifting.inverse(signal, signal);
  });
  return columns;
}

}  // namespace mocapress
