// SPDX-License-Identifier: MIT
#include "core/runtime/pose/cooked_coefficients.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/runtime/decode/frame_decoder.h"
#include "core/runtime/format/end_poses.h"
#include "core/runtime/pose/lifting_line.h"

namespace mocapress::runtime {
namespace {

constexpr int kRowsAtATime = 128;
constexpr double kFineStep = 0x1p-14;  // radians; step of angles that a correction changed

}  // namespace

CookedCoefficients::CookedCoefficients(Memory& memory, const ClipBlock& clip, bool apply_ik)
    : clip_(clip), apply_ik_(apply_ik && clip.effector_count > 0) {
  const auto channels = std::uint64_t{clip_.channel_count};
  const auto frames = static_cast<std::uint64_t>(clip_.largest.length);
  const auto signals = static_cast<std::uint64_t>((clip_.largest.signal_count + 7) / 8 * 8);
  is_corrected_ = memory.take<bool>(channels);
  values_ = memory.take<std::int32_t>(channels * frames);
  steps_ = memory.take<double>(channels);
  rows_ = memory.take<double>(signals * kRowsAtATime);
  in_order_ = memory.take<std::int32_t>(signals);
  line_ = memory.take<double>(frames);
  other_line_ = memory.take<double>(frames);
  samples_ = memory.take<double>(frames);
  if (!apply_ik_) return;
  corrected_ = memory.take<float>(channels * static_cast<std::uint64_t>(clip_.segments.frames));
  mcpr_request request{};
  request.apply_ik = 1;
  Memory measured;
  const FrameDecoder decoder(measured, clip_, request);
  decoding_bytes_ = measured.used();
  decoding_ = memory.take<std::byte>(decoding_bytes_);
}

void CookedCoefficients::prepare() {
  std::fill_n(is_corrected_, clip_.channel_count, false);
  if (!apply_ik_) return;
  decode_corrected();
  for (int l = 0; l < clip_.limb_count; ++l)
    for (int a = 0; a < clip_.limb(l).turns; ++a)
      is_corrected_[clip_.limb(l).turn[a].channel] = true;
}

/// Decodes all frames with the IK correction but without the end corrections, which sampling adds
/// at every instant.
void CookedCoefficients::decode_corrected() {
  mcpr_request request{};
  request.apply_ik = 1;
  Memory memory(decoding_, static_cast<std::size_t>(decoding_bytes_));
  const int frames = clip_.segments.frames;
  FrameDecoder(memory, clip_, request).decode(0, frames, corrected_);
  for (int end = 0; end < kMostEnds; ++end) {
    const int reach = std::min<int>(clip_.end_reaches.frames[end], frames);
    for (int away = 0; away < reach; ++away) {
      const int frame = end == kFirstPose ? away : frames - 1 - away;
      float* const row =
          corrected_ + std::ptrdiff_t{frame} * static_cast<std::ptrdiff_t>(clip_.channel_count);
      for (int c = 0; c < channel_count(); ++c)
        row[c] -= end_share(end, away, reach) * clip_.end_values(end)[c];
    }
  }
}

/// Recovers the coefficients as whole numbers. Unpacked values are close enough to multiples of the
/// step to be rounded safely.
void CookedCoefficients::load(int segment) {
  if (loaded_ == segment) return;
  loaded_ = segment;
  const ResidentSignals& motion = clip_.motion(segment);
  bands_ = Bands(motion.length());
  const std::ptrdiff_t stride = (motion.signal_count() + 7) / 8 * 8;
  for (int s = 0; s < motion.signal_count(); ++s)
    in_order_[s] = s < channel_count() ? s : ResidentSignals::Columns::kNone;
  const ResidentSignals::Columns columns{in_order_, false, stride, nullptr};
  for (int s = 0; s < channel_count(); ++s) steps_[s] = static_cast<double>(motion.step(s));
  std::fill_n(values_, std::ptrdiff_t{channel_count()} * bands_.length(bands_.count - 1), 0);
  for (int b = 0; b < bands_.count; ++b) {
    if (motion.is_empty(b)) continue;
    const double gain = power_of_root_two(-bands_.depth(b));
    for (int first = 0; first < bands_[b].size; first += kRowsAtATime) {
      const int end = std::min(first + kRowsAtATime, bands_[b].size);
      motion.unpack(b, first, end, columns, rows_);
      for (int s = 0; s < channel_count(); ++s)
        for (int i = first; i < end; ++i)
          values_[std::ptrdiff_t{s} * motion.length() + bands_[b].first + i] =
              static_cast<std::int32_t>(
                  std::lround(rows_[(i - first) * stride + s] / (steps_[s] * gain)));
    }
  }
  for (int s = 0; s < channel_count(); ++s)
    if (is_corrected_[s]) fit_corrected(s, segment);
}

/// Transforms the corrected samples of a channel.
void CookedCoefficients::fit_corrected(int channel, int segment) {
  const int length = clip_.segments.frames_of(segment);
  const float* from = corrected_ +
                      static_cast<std::ptrdiff_t>(clip_.segments.first(segment)) * channel_count() +
                      channel;
  for (int i = 0; i < length; ++i, from += channel_count()) line_[i] = static_cast<double>(*from);
  steps_[channel] = kFineStep;
  std::int32_t* const values = values_ + std::ptrdiff_t{channel} * length;
  double* fine = line_;
  double* coarse = other_line_;
  for (int b = bands_.count - 1; b > 0; --b) {
    const int rest = bands_.length(b);
    split_line(clip_.motion(segment).wavelet(), rest, fine, coarse, samples_);
    const double gain = power_of_root_two(-bands_.depth(b));
    for (int i = 0; i < bands_[b].size; ++i)
      values[bands_[b].first + i] =
          static_cast<std::int32_t>(std::lround(samples_[i] / (kFineStep * gain)));
    std::swap(fine, coarse);
  }
  const double gain = power_of_root_two(-bands_.depth(0));
  for (int i = 0; i < bands_[0].size; ++i)
    values[i] = static_cast<std::int32_t>(std::lround(fine[i] / (kFineStep * gain)));
}

std::span<double> CookedCoefficients::samples_of(int channel, int left_out) {
  const int count = std::max(bands_.count - left_out, 1);
  unpack(channel, 0, samples_);
  for (int b = 1; b < count; ++b) {
    unpack(channel, b, other_line_);
    join_line(clip_.motion(loaded_).wavelet(), bands_.length(b), samples_, other_line_, line_);
    std::copy_n(line_, bands_.length(b), samples_);
  }
  return {samples_, static_cast<std::size_t>(bands_.length(count - 1))};
}

void CookedCoefficients::unpack(int channel, int band, double* to) const {
  const double step = steps_[channel] * power_of_root_two(-bands_.depth(band));
  for (int i = 0; i < bands_[band].size; ++i) to[i] = step * value(channel, band, i);
}

}  // namespace mocapress::runtime
