// SPDX-License-Identifier: MIT
#include "core/codec/decoder.h"

#include "core/codec/signal_coder.h"
#include "core/codec/signal_decoder.h"
#include "core/decoder/wide_limits.h"

namespace mocapress {
namespace {

/// Those of the runtime decoder, by what a signal moves.
std::vector<float> wide_limits(const CompressedClip& clip) {
  std::vector<decoder::JointModel> joints(static_cast<std::size_t>(clip.skeleton.joint_count()));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = clip.skeleton.joints()[j];
    joints[j].parent = joint.parent;
    for (int i = 0; i < 3; ++i) {
      joints[j].offset[i] = joint.offset(i);
      if (joint.end_site) joints[j].end_site[i] = static_cast<float>((*joint.end_site)(i));
    }
  }
  std::vector<float> reach(joints.size());
  decoder::find_reach(joints.data(), clip.skeleton.joint_count(), reach.data());
  std::vector<float> limits;
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (const ChannelKind kind : clip.skeleton.joints()[j].channels)
      limits.push_back(decoder::wide_limit(static_cast<std::uint8_t>(kind), reach[j]));
  if (clip.correction)
    limits.resize(limits.size() + static_cast<std::size_t>(clip.correction->signal_count()),
                  decoder::kWideLength);
  return limits;
}

/// frames x signals of a segment.
Eigen::MatrixXd decode_segment(const QuantisedSignals& coded, Basis basis,
                               const std::vector<float>& limits) {
  std::vector<float> steps;
  for (int s = 0; s < coded.signal_count(); ++s) steps.push_back(static_cast<float>(coded.step(s)));
  return decode_signals(coded.values, steps, basis, limits);
}

/// frames x signals of all segments.
Eigen::MatrixXd decode_adaptive(const CompressedClip& compressed) {
  const std::vector<float> limits = wide_limits(compressed);
  const SegmentLayout layout = compressed.segment_layout();
  AdaptiveSegments segments(compressed);
  const auto next = [&] { return decode_segment(segments.next(), compressed.basis, limits); };
  if (layout.count() == 1) return next();
  Eigen::MatrixXd samples(compressed.frames, std::ssize(limits));
  for (int k = 0; k < layout.count(); ++k) lay_over(next(), layout, k, samples);
  return samples;
}

}  // namespace

Uncorrected decode_uncorrected(const CompressedClip& compressed) {
  if (!is_of_words(compressed.coding)) {
    Eigen::MatrixXd decoded = decode_adaptive(compressed);
    if (!compressed.correction)
      return {.clip = {compressed.sample_rate_hz, std::move(decoded)}, .differences = {}};
    const int channels = compressed.skeleton.channel_count();
    return {.clip = {compressed.sample_rate_hz, decoded.leftCols(channels)},
            .differences = decoded.rightCols(decoded.cols() - channels)};
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
