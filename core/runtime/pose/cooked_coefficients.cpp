// SPDX-License-Identifier: MIT
#include "core/runtime/pose/cooked_coefficients.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/runtime/decode/frame_decoder.h"
#include "core/runtime/pose/lifting_line.h"

namespace mocapress::runtime {
namespace {

constexpr int kRowsAtATime = 128;
constexpr double kFineStep = 0x1p-14;  // in radians; quantisation step of angles that are cooked
                                       // exactly
constexpr int kFewestOctaves = -8;     // this and the next: range of CookedCoefficients::octaves_
constexpr int kMostOctaves = 24;
/// Coefficients below this many steps become zero, which takes the least space. That space reduces
/// the error more if the step is made finer instead.
constexpr double kLeastKept = 0.62;

/// Rounds to the nearest integer within bounds. The values of a hostile file may be beyond all
/// integers.
std::int32_t whole(double steps) {
  return static_cast<std::int32_t>(std::lround(std::clamp(steps, -0x1p30, 0x1p30)));
}

std::int32_t rounded(double steps) {
  return std::abs(steps) < kLeastKept ? 0 : whole(steps);
}

}  // namespace

CookedCoefficients::CookedCoefficients(Memory& memory, const ClipBlock& clip,
                                       const mcpr_cook_options& options)
    : clip_(clip),
      apply_ik_(options.apply_ik != 0 && clip.effector_count > 0),
      ik_error_(static_cast<double>(options.ik_error)) {
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
  fitted_ = memory.take<float>(channels * (ik_error_ > 0 ? frames : 0));
  places_ = memory.take<JointPlace>(ik_error_ > 0 ? 2 * std::uint64_t{clip_.joint_count} : 0);
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
  if (ik_error_ > 0) choose_steps();
}

/// Decodes all frames with the IK correction, and with the end corrections.
void CookedCoefficients::decode_corrected() {
  mcpr_request request{};
  request.apply_ik = 1;
  Memory memory(decoding_, static_cast<std::size_t>(decoding_bytes_));
  FrameDecoder(memory, clip_, request).decode(0, clip_.segments.frames, corrected_);
}

/// Finds, by bisection, the coarsest quantisation steps that move no joint by more than `ik_error`.
/// Bisection works because coarser steps move joints further, as a rule. If the finest steps do not
/// suffice, the channels are cooked exactly.
void CookedCoefficients::choose_steps() {
  int first = kFewestOctaves;
  int last = kMostOctaves + 1;
  while (first < last) {
    octaves_ = (first + last) >> 1;
    double move = 0;
    for (int k = 0; k < clip_.segments.count() && move <= ik_error_; ++k)
      move = std::max(move, largest_move(k));
    if (move <= ik_error_)
      last = octaves_;
    else
      first = octaves_ + 1;
  }
  octaves_ = first > kMostOctaves ? kExact : first;
  loaded_ = -1;
}

/// The largest distance, in cm, between a joint's places as decoded and as cooked, at any frame of
/// a segment.
double CookedCoefficients::largest_move(int segment) {
  loaded_ = -1;
  load(segment);
  const int first = clip_.segments.first(segment);
  const int frames = clip_.segments.frames_of(segment);
  const std::ptrdiff_t channels = channel_count();
  float* const corrected = corrected_ + first * channels;
  std::copy_n(corrected, frames * channels, fitted_);
  for (int c = 0; c < channel_count(); ++c) {
    if (!is_corrected_[c]) continue;
    const std::span<const double> samples = samples_of(c, 0);
    for (int i = 0; i < frames; ++i)
      fitted_[i * channels + c] = static_cast<float>(samples[static_cast<std::size_t>(i)]);
  }
  JointPlace* const fitted_places = places_ + clip_.joint_count;
  double largest = 0;
  for (int i = 0; i < frames; ++i) {
    place_joints(clip_, corrected + i * channels, places_);
    place_joints(clip_, fitted_ + i * channels, fitted_places);
    for (std::uint32_t j = 0; j < clip_.joint_count; ++j)
      largest = std::max(largest, norm(fitted_places[j].origin - places_[j].origin));
  }
  return largest;
}

/// Recovers the coefficients of a segment as whole numbers. Unpacked values are multiples of the
/// step with a small rounding error, so rounding them is safe.
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
              whole(rows_[(i - first) * stride + s] / (steps_[s] * gain));
    }
  }
  for (int s = 0; s < channel_count(); ++s)
    if (is_corrected_[s]) fit_corrected(s, segment);
}

/// Transforms a channel's samples after IK correction to coefficients of its own.
void CookedCoefficients::fit_corrected(int channel, int segment) {
  const int length = clip_.segments.frames_of(segment);
  const float* from = corrected_ +
                      static_cast<std::ptrdiff_t>(clip_.segments.first(segment)) * channel_count() +
                      channel;
  for (int i = 0; i < length; ++i, from += channel_count()) line_[i] = static_cast<double>(*from);
  double& step = steps_[channel];
  step = octaves_ == kExact || step == 0 ? kFineStep : step * power_of_root_two(-octaves_);
  std::int32_t* const values = values_ + std::ptrdiff_t{channel} * length;
  double* fine = line_;
  double* coarse = other_line_;
  for (int b = bands_.count - 1; b > 0; --b) {
    const int rest = bands_.length(b);
    split_line(clip_.motion(segment).wavelet(), rest, fine, coarse, samples_);
    const double gain = power_of_root_two(-bands_.depth(b));
    for (int i = 0; i < bands_[b].size; ++i)
      values[bands_[b].first + i] = octaves_ == kExact ? whole(samples_[i] / (step * gain))
                                                       : rounded(samples_[i] / (step * gain));
    std::swap(fine, coarse);
  }
  const double gain = power_of_root_two(-bands_.depth(0));
  for (int i = 0; i < bands_[0].size; ++i) values[i] = whole(fine[i] / (step * gain));
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
