// SPDX-License-Identifier: MIT
#include "core/codec/decode/decoder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "core/codec/format/rle16.h"
#include "core/codec/format/signal_coder.h"
#include "core/ik/limb.h"
#include "core/runtime/decode/signal_decoder.h"
#include "core/runtime/format/double_precision_limits.h"
#include "core/runtime/own_memory.h"

namespace mocapress {

namespace {

constexpr float kUnknown = 8;  // limit for signals whose effect on the pose is unknown

/// Owns some signals in the runtime decoder's resident form.
class OwnResidentSignals {
 public:
  explicit OwnResidentSignals(const runtime::QuantisedSource& source)
      : bytes_(static_cast<std::size_t>(runtime::ResidentSignals::size(source))) {
    std::memset(bytes_.data(), 0, bytes_.size());
    signals_ = runtime::ResidentSignals::build(source, bytes_.data());
  }
  const runtime::ResidentSignals& operator*() const { return *signals_; }

 private:
  AlignedBytes bytes_;
  const runtime::ResidentSignals* signals_;
};

}  // namespace

Eigen::MatrixXd decode_signals(const Eigen::MatrixXi& values, const std::vector<float>& steps,
                               Basis basis, const std::vector<float>& double_precision_limits) {
  const auto length = static_cast<int>(values.rows());
  const auto count = static_cast<int>(values.cols());
  std::vector<float> limits = double_precision_limits;
  limits.resize(steps.size(), kUnknown);
  std::vector<std::uint8_t> notes(steps.size());
  const OwnResidentSignals resident(
      runtime::QuantisedSource{.length = length,
                               .signal_count = count,
                               .wavelet = basis,
                               .steps = steps.data(),
                               .double_precision_limits = limits.data(),
                               .values = values.data(),
                               .notes = notes.data(),
                               .budget_bytes = std::numeric_limits<std::uint64_t>::max()});
  std::vector<std::int32_t> columns(steps.size());
  std::iota(columns.begin(), columns.end(), 0);
  OwnMemory<runtime::SignalDecoder> signal_decoder(
      *resident, runtime::SignalRequest{columns.data(), true, count, 0, &runtime::best_rows()});
  Eigen::MatrixXd samples(length, count);
  Eigen::MatrixXf window(count, runtime::kWindow);  // a column is a frame
  for (int first = 0; first < length; first += runtime::kWindow) {
    const int frames = std::min(runtime::kWindow, length - first);
    signal_decoder->decode_window(first, frames, window.data(), count);
    samples.middleRows(first, frames) = window.leftCols(frames).transpose().cast<double>();
  }
  return samples;
}

Eigen::MatrixXd read_signals(ByteReader& words, Basis basis, int samples, int count) {
  const Rle16Values read = rle16_read(words, samples, count);
  std::vector<float> steps;
  for (const int exponent : read.exponents) steps.push_back(std::ldexp(1.0F, exponent));
  return decode_signals(read.values, steps, basis);
}

namespace {

/// Joins the samples of consecutive segments (frames x signals, as decode_signals() gives them) and
/// blends them where they overlap. Only the overlap of the previous segment is kept in memory.
class SegmentJoin {
 public:
  explicit SegmentJoin(const SegmentLayout& layout) : layout_(layout) {}

  /// Takes the samples of the next segment. Returns its frames, blended with the previous
  /// segment's, without those that it shares with the segment after it.
  Eigen::MatrixXd next(Eigen::MatrixXd samples);

 private:
  SegmentLayout layout_;
  int segment_ = 0;
  Eigen::MatrixXd shared_;  // the last frames of the previous segment
};

Eigen::MatrixXd SegmentJoin::next(Eigen::MatrixXd samples) {
  for (Eigen::Index i = 0; i < shared_.rows(); ++i) {
    const float share = runtime::share_of_later(layout_, static_cast<int>(i));
    for (Eigen::Index s = 0; s < samples.cols(); ++s)
      samples(i, s) = static_cast<double>(runtime::blended(
          static_cast<float>(shared_(i, s)), static_cast<float>(samples(i, s)), share));
  }
  if (++segment_ == layout_.count()) return samples;
  shared_ = samples.bottomRows(layout_.overlap);
  return samples.topRows(layout_.hop());
}

/// The magnitude of each signal beyond which the runtime decoder decodes it in double precision. It
/// depends on the channel's kind and, for angles, on the reach of what the joint turns.
std::vector<float> double_precision_limits(const CompressedClip& clip) {
  const std::vector<runtime::JointModel> joints = models_of(clip.skeleton);
  std::vector<float> reach(joints.size());
  runtime::find_reach(joints.data(), clip.skeleton.joint_count(), reach.data());
  std::vector<float> limits;
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (const ChannelKind kind : clip.skeleton.joints()[j].channels)
      limits.push_back(runtime::double_precision_limit(static_cast<std::uint8_t>(kind), reach[j]));
  if (clip.correction)
    limits.resize(limits.size() + static_cast<std::size_t>(clip.correction->signal_count()),
                  runtime::kDoublePrecisionLength);
  return limits;
}

std::vector<float> steps_of(const QuantisedSignals& coded) {
  std::vector<float> steps;
  for (int s = 0; s < coded.signal_count(); ++s) steps.push_back(static_cast<float>(coded.step(s)));
  return steps;
}

/// Decodes one segment: frames x signals.
Eigen::MatrixXd decode_segment(const QuantisedSignals& coded, Basis basis,
                               const std::vector<float>& limits) {
  return decode_signals(coded.values, steps_of(coded), basis, limits);
}

EndPoses end_poses(const CompressedClip& compressed) {
  const auto [first, last] = steps_at_ends(compressed);
  return {*compressed.ends, first, last};
}

void visit_adaptive(const CompressedClip& compressed, const DecodedBlock& visit) {
  const std::vector<float> limits = double_precision_limits(compressed);
  const SegmentLayout layout = compressed.segment_layout();
  const int channels = compressed.skeleton.channel_count();
  AdaptiveSegments segments(compressed);
  SegmentJoin join(layout);
  const auto decode_next = [&](const QuantisedSignals& coded) {
    return decode_segment(coded, compressed.basis, limits);
  };
  for (int k = 0; k < layout.count(); ++k) {
    Eigen::MatrixXd samples = join.next(compressed.known ? compressed.known->samples(decode_next)
                                                         : decode_next(segments.next()));
    Uncorrected block{.clip = {compressed.sample_rate_hz, {}}, .differences = {}};
    if (compressed.correction) {
      block.clip.channels = samples.leftCols(channels);
      block.differences = samples.rightCols(samples.cols() - channels);
    } else {
      block.clip.channels = std::move(samples);
    }
    visit(layout.first(k), block);
  }
}

void visit_words(const CompressedClip& compressed, const DecodedBlock& visit) {
  const std::vector<std::byte> words = unpack_motion(compressed);
  ByteReader reader(words);
  const auto next = [&](int count) {
    return read_signals(reader, compressed.basis, compressed.frames, count);
  };
  Uncorrected decoded;
  decoded.clip = {compressed.sample_rate_hz, next(compressed.skeleton.channel_count())};
  if (compressed.correction) decoded.differences = next(compressed.correction->signal_count());
  reader.expect_end();
  visit(0, decoded);
}

}  // namespace

std::pair<std::vector<float>, std::vector<float>> steps_at_ends(const CompressedClip& compressed) {
  if (compressed.known) {
    const std::vector<float> steps = steps_of(compressed.known->coded());
    return {steps, steps};
  }
  AdaptiveSegments segments(compressed);
  const std::vector<float> first = steps_of(segments.next());
  const int count = compressed.segment_layout().count();
  if (count == 1) return {first, first};
  for (int k = 1; k < count - 1; ++k) segments.skip();
  return {first, steps_of(segments.next())};
}

void visit_decoded(const CompressedClip& compressed, const DecodedBlock& visit) {
  if (uses_rle(compressed.coding))
    visit_words(compressed, visit);
  else
    visit_adaptive(compressed, visit);
}

void put_rows(Eigen::MatrixXd rows, int first, int all, Eigen::MatrixXd& matrix) {
  if (rows.rows() == all) {
    matrix = std::move(rows);
    return;
  }
  matrix.resize(all, rows.cols());
  matrix.middleRows(first, rows.rows()) = rows;
}

Clip in_source_channels(const CompressedClip& compressed, Clip coded) {
  if (compressed.forms.empty()) return coded;
  return with_forms(Motion{compressed.coded_skeleton(), std::move(coded)},
                    rotation_forms(compressed.skeleton))
      .clip;
}

Uncorrected decode_uncorrected(const CompressedClip& compressed) {
  Uncorrected decoded{.clip = {compressed.sample_rate_hz, {}}, .differences = {}};
  visit_decoded(compressed, [&](int first, Uncorrected& block) {
    put_rows(std::move(block.clip.channels), first, compressed.frames, decoded.clip.channels);
    put_rows(std::move(block.differences), first, compressed.frames, decoded.differences);
  });
  Finish(compressed).add_ends(0, decoded.clip.channels);
  return decoded;
}

Finish::Finish(const CompressedClip& compressed)
    : compressed_(compressed), coded_skeleton_(compressed.coded_skeleton()) {
  if (compressed.ends) ends_.emplace(end_poses(compressed));
}

CorrectionReport Finish::operator()(int first_frame, Uncorrected& block) const {
  CorrectionReport report;
  if (compressed_.correction)
    report = apply_correction(coded_skeleton_, compressed_.correction->effectors,
                              compressed_.correction->solver, block.differences, block.clip);
  add_ends(first_frame, block.clip.channels);
  return report;
}

void Finish::add_ends(int first_frame, Eigen::MatrixXd& channels) const {
  if (ends_) ends_->add_to(first_frame, compressed_.frames, channels);
}

Clip decode(const CompressedClip& compressed) {
  Clip clip{compressed.sample_rate_hz, {}};
  const Finish finish(compressed);
  visit_decoded(compressed, [&](int first, Uncorrected& block) {
    finish(first, block);
    put_rows(std::move(block.clip.channels), first, compressed.frames, clip.channels);
  });
  return in_source_channels(compressed, std::move(clip));
}

}  // namespace mocapress
