// SPDX-License-Identifier: MIT
#include "core/codec/decoder.h"

#include "core/codec/signal_coder.h"
#include "core/codec/signal_decoder.h"

namespace mocapress {

Uncorrected decode_uncorrected(const CompressedClip& compressed) {
  if (!is_of_words(compressed.coding)) {
    const QuantisedSignals coded = unpack_adaptive(compressed);
    std::vector<float> steps;
    for (int s = 0; s < coded.signal_count(); ++s)
      steps.push_back(static_cast<float>(coded.step(s)));
    const Eigen::MatrixXd signals = decode_signals(coded.values, steps, compressed.basis);
    const int channels = compressed.skeleton.channel_count();
    return {.clip = {compressed.sample_rate_hz, signals.leftCols(channels)},
            .differences = signals.rightCols(signals.cols() - channels)};
  }
  const std::vector<std::byte> words = unpack_motion(compressed);
  ByteReader reader(words);
  const auto next = [&](int count) {
    return read_signals(reader, compressed.basis, compressed.frames, count);
  };
  Uncorrected decoded;
  decoded.clip = {compressed.sample_rate_hz, next(compressed.skeleton.channel_count())};
  if (compressed.correction) decoded.differences = next(compressed.correction->signal_count());
  reader.expect_end();
  return decoded;
}

CorrectionReport correct(const CompressedClip& compressed, const Eigen::MatrixXd& differences,
                         Clip& clip) {
  if (!compressed.correction) return {};
  return apply_correction(compressed.skeleton, compressed.correction->effectors,
                          compressed.correction->solver, differences, clip);
}

Clip decode(const CompressedClip& compressed) {
  Uncorrected decoded = decode_uncorrected(compressed);
  correct(compressed, decoded.differences, decoded.clip);
  return std::move(decoded.clip);
}

}  // namespace mocapress
