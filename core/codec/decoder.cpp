// SPDX-License-Identifier: MIT
#include "core/codec/decoder.h"

#include "core/codec/signal_coder.h"

namespace mocapress {

Clip decode_uncorrected(const CompressedClip& compressed) {
  return {compressed.sample_rate_hz,
          decode_signals(compressed.motion, compressed.basis, compressed.coding, compressed.frames,
                         compressed.skeleton.channel_count())};
}

CorrectionReport correct(const CompressedClip& compressed, Clip& clip) {
  if (!compressed.correction) return {};
  const CodedCorrection& correction = *compressed.correction;
  const Eigen::MatrixXd differences =
      decode_signals(correction.differences, compressed.basis, compressed.coding, compressed.frames,
                     3 * static_cast<int>(correction.effectors.size()));
  return apply_correction(compressed.skeleton, correction.effectors, correction.solver, differences,
                          clip);
}

Clip decode(const CompressedClip& compressed) {
  Clip clip = decode_uncorrected(compressed);
  correct(compressed, clip);
  return clip;
}

}  // namespace mocapress
