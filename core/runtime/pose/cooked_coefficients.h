// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/runtime/decode/clip.h"
#include "core/runtime/format/bands.h"
#include "core/runtime/format/memory.h"

namespace mocapress::runtime {

/// The coefficients of a clip's channels as whole numbers, one segment at a time. Channels that the
/// IK correction turns are decoded with the correction and transformed again, as finely as
/// `ik_error` asks. Other channels keep the clip's coefficients.
class CookedCoefficients {
 public:
  /// If `memory` only measures, this counts bytes and does nothing else.
  CookedCoefficients(Memory& memory, const ClipBlock& clip, const mcpr_cook_options& options);

  /// Decodes the channels that the IK correction turns. Call it first.
  void prepare();
  /// True if the IK correction turns the channel and is cooked exactly, which needs wide samples.
  bool is_fine(int channel) const { return is_corrected_[channel] && octaves_ == kExact; }

  /// The value of an end correction for a channel; 0 if the IK correction turns the channel, since
  /// its coefficients include the end corrections.
  float end_value(int end, int channel) const {
    return is_corrected_[channel] ? 0 : clip_.end_values(end)[channel];
  }

  void load(int segment);

  // The following functions refer to the loaded segment.
  const Bands& bands() const { return bands_; }
  double step(int channel) const { return steps_[channel]; }  // quantisation step at depth 0
  std::int32_t value(int channel, int band, int row) const {
    return values_[std::ptrdiff_t{channel} * bands_.length(bands_.count - 1) + bands_[band].first +
                   row];
  }
  /// The samples of a channel, reconstructed without the finest `left_out` bands. Valid until the
  /// next call.
  std::span<double> samples_of(int channel, int left_out);

 private:
  int channel_count() const { return static_cast<int>(clip_.channel_count); }
  void decode_corrected();
  void choose_steps();
  double largest_move(int segment);
  void fit_corrected(int channel, int segment);
  void unpack(int channel, int band, double* to) const;

  const ClipBlock& clip_;
  const bool apply_ik_;
  const double ik_error_;  // cm; 0: exact
  static constexpr int kExact = 64;
  int octaves_ = kExact;  // steps of corrected channels are the clip's, divided by 2^(octaves_ / 2)
  bool* is_corrected_;
  int loaded_ = -1;
  Bands bands_;
  std::int32_t* values_;  // channel by channel
  double* steps_;
  double* rows_;  // work space for unpacking
  std::int32_t* in_order_;
  double* line_;
  double* other_line_;
  double* samples_;
  float* corrected_ = nullptr;    // frames x channels
  float* fitted_ = nullptr;       // the same as cooked, for one segment
  JointPlace* places_ = nullptr;  // joints of the corrected pose, then of the pose as cooked
  std::byte* decoding_ = nullptr;
  std::uint64_t decoding_bytes_ = 0;
};

}  // namespace mocapress::runtime
