// SPDX-License-Identifier: MIT
// Scalar tracks: FORMAT.md, trks. Writing and reading share this code.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/runtime/format/bit_pattern.h"
#include "core/runtime/format/digit_coder.h"
#include "core/runtime/format/file_sections.h"
#include "core/runtime/format/joint_bytes.h"
#include "core/runtime/format/signal_neighbours.h"

namespace mocapress::runtime {

/// Curves with larger samples are decoded in double precision, as channels are.
inline constexpr float kTrackDoublePrecision = 8;

/// Finds out which field of a track record the next byte belongs to.
class TrackFields {
 public:
  static constexpr int kCount = 6;  // node name's length, node name, track name's length, track
                                    // name, kind, flags

  int field() const { return field_; }

  void follow(std::uint8_t byte) {
    if (field_ == 0 || field_ == 2) left_ = byte;
    if ((field_ == 1 || field_ == 3) && --left_ > 0) return;
    const bool is_empty_name = (field_ == 0 || field_ == 2) && left_ == 0;
    field_ = (field_ + (is_empty_name ? 2 : 1)) % kCount;
  }

 private:
  int field_ = 0;
  int left_ = 0;  // remaining bytes of a name
};

using TrackByteCoder = RecordByteCoder<TrackFields>;

struct TrackRecord {
  static constexpr std::uint8_t kIsCurve = 1;  // flags
  static constexpr std::uint8_t kSteps = 2;

  const std::uint8_t* node = nullptr;  // UTF-8
  std::uint8_t node_length = 0;
  const std::uint8_t* name = nullptr;
  std::uint8_t name_length = 0;
  std::uint8_t kind = 0;
  std::uint8_t flags = 0;

  bool is_curve() const { return (flags & kIsCurve) != 0; }
  bool steps() const { return (flags & kSteps) != 0; }
};

/// Consecutive frames whose values are equal bit by bit.
struct TrackRun {
  std::uint32_t end;  // one past its last frame
  float value;
};

/// Codes the runs of held tracks, track after track.
class RunCoder {
 public:
  /// Codes the run that begins at frame `first` of a track with this many frames. `Bits` as in
  /// CoefficientCoder.
  template <typename Bits>
  void code(Bits& bits, std::uint32_t first, std::uint32_t frames, TrackRun& run) {
    const bool goes_on = first > 0;  // true: not the first run of the track
    if (code_bit(bits, is_last_[goes_on], run.end == frames)) {
      run.end = frames;
    } else {
      const auto length = static_cast<std::int32_t>(run.end - first);
      run.end = first + 1 + static_cast<std::uint32_t>(length_.code(bits, length - 1));
      if (run.end >= frames) bits.refuse();
    }
    code_value(bits, place_[goes_on], run.value);
  }

 private:
  static constexpr std::int32_t kRecent = 16;

  /// Codes a value as its place among recent values, or else in full.
  template <typename Bits>
  void code_value(Bits& bits, DigitCoder& coder, float& value) {
    auto pattern = bit_pattern<std::uint32_t>(value);
    std::int32_t place = 0;
    while (place < kRecent && recent_[static_cast<std::size_t>(place)] != pattern) ++place;
    place = coder.code(bits, place);
    if (place > kRecent) return bits.refuse();
    if (place == kRecent) {
      std::uint32_t coded = 0;
      for (int d = 31; d >= 0; --d)
        coded =
            coded << 1 | static_cast<std::uint32_t>(bits.code((pattern >> d & 1) != 0, kEvenOdds));
      pattern = coded;
      --place;  // the oldest recent value is dropped
    } else {
      pattern = recent_[static_cast<std::size_t>(place)];
    }
    for (auto i = static_cast<std::size_t>(place); i > 0; --i) recent_[i] = recent_[i - 1];
    recent_[0] = pattern;
    value = bit_pattern<float>(pattern);
    if (!std::isfinite(value)) bits.refuse();
  }

  AdaptiveBit is_last_[2];
  DigitCoder length_;
  DigitCoder place_[2];
  std::array<std::uint32_t, kRecent> recent_ = {0, 0x3F800000};  // 0.0, 1.0, then zeros
};

/// Makes the previous curve the only neighbour of each curve.
inline void set_track_neighbours(int curves, SignalNeighbours* neighbours) {
  for (int s = 0; s < curves; ++s) neighbours[s] = {s - 1, -1};
}

/// Parses the next track's record.
mcpr_result read_track_record(Cursor& cursor, TrackRecord& record);

/// Decodes everything but the curves: head.record_bytes into `records`, and head.runs into `runs`,
/// ordered by held track. Checks all records.
mcpr_result decode_tracks(const TracksHead& head, std::uint32_t frames, TrackByteCoder& coder,
                          std::uint8_t* records, TrackRun* runs);

}  // namespace mocapress::runtime
