// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/runtime/decode/clip.h"
#include "core/runtime/format/bands.h"
#include "core/runtime/format/memory.h"

namespace mocapress::runtime {

/// The coefficients of a clip's channels as whole numbers, segment by segment: as they are in the
/// clip, and where an IK correction turns a channel, from its corrected samples transformed anew.
class CookedCoefficients {
 public:
  /// With measuring memory only to know how much.
  CookedCoefficients(Memory& memory, const ClipBlock& clip, bool apply_ik);

  /// To be called first: decodes what the correction made of the clip.
  void prepare();
  bool is_corrected(int channel) const { return is_corrected_[channel]; }

  void load(int segment);

  // Of the segment that is loaded:
  const Bands& bands() const { return bands_; }
  double step(int channel) const { return steps_[channel]; }  // of coefficients at depth 0
  std::int32_t value(int channel, int band, int row) const {
    return values_[std::ptrdiff_t{channel} * bands_.length(bands_.count - 1) + bands_[band].first +
                   row];
  }
  /// The samples that are left when so many of the finest bands are; until the next call.
  std::span<double> samples_of(int channel, int left_out);

 private:
  int channel_count() const { return static_cast<int>(clip_.channel_count); }
  void decode_corrected();
  void fit_corrected(int channel, int segment);
  void unpack(int channel, int band, double* to) const;

  const ClipBlock& clip_;
  const bool apply_ik_;
  bool* is_corrected_;
  int loaded_ = -1;
  Bands bands_;
  std::int32_t* values_;  // channel after channel
  double* steps_;
  double* rows_;  // to unpack into
  std::int32_t* in_order_;
  double* line_;
  double* other_line_;
  double* samples_;
  float* corrected_ = nullptr;  // frames x channels
  std::byte* decoding_ = nullptr;
  std::uint64_t decoding_bytes_ = 0;
};

}  // namespace mocapress::runtime
