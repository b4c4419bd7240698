// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>
#include <utility>

#include "core/runtime/decode/resident_signals.h"
#include "core/runtime/format/bits.h"

namespace mocapress::runtime {

/// Validates a resident form from an untrusted source, so that decoding never reads outside it.
class ResidentChecker {
 public:
  ResidentChecker(const ResidentSignals& signals, std::uint64_t bytes)
      : signals_(signals), bands_(signals.length_), bytes_(bytes) {}

  bool run() const {
    const auto groups = static_cast<std::uint64_t>(signals_.group_count());
    if (signals_.wavelet_ > Wavelet::Cubic || signals_.band_count_ != bands_.count ||
        signals_.double_precision_count_ > signals_.signals_ ||
        !has_array(signals_.wide_, 2, signals_.double_precision_count_, 2) ||
        !has_array(signals_.steps_, sizeof(float), 8 * groups, 4) ||
        !has_array(signals_.entries_, sizeof(Entry), signals_.band_count_, 4))
      return false;
    int before = -1;
    for (int i = 0; i < signals_.double_precision_count_; ++i) {
      const int signal = signals_.double_precision_signals()[i];
      if (signal <= before || signal >= signals_.signals_) return false;
      before = signal;
    }
    for (std::uint64_t s = 0; s < 8 * groups; ++s)
      if (!std::isfinite(signals_.steps()[s])) return false;
    for (int b = 0; b < bands_.count; ++b)
      if (!is_band(signals_.entries()[b], bands_[b].size)) return false;
    return true;
  }

 private:
  using Entry = ResidentSignals::BandEntry;
  using Kind = ResidentSignals::Kind;
  static constexpr int kMostLog2Rows = 15;
  static constexpr int kMostWidth = 32;

  /// True if an array, and kReadAhead bytes after it, lie within the block: decoders that read
  /// whole words may touch those bytes.
  bool has_array(std::uint32_t offset, std::uint64_t size, std::uint64_t count,
                 std::uint32_t alignment) const {
    return offset % alignment == 0 && offset + size * count + kReadAhead <= bytes_;
  }

  bool is_band(const Entry& entry, int rows) const {
    switch (entry.kind) {
      case Kind::Empty:
        return true;
      case Kind::Dense:
        return is_dense(entry, rows);
      case Kind::Sparse:
      case Kind::SparseWide:
        return rows > 0 && is_sparse(entry, rows);
    }
    return false;
  }

  /// True if `present`, the bytes of a row, matches the widths of the signals. In a row, each group
  /// of 8 signals starts at a whole byte.
  bool is_dense(const Entry& entry, int rows) const {
    const auto groups = static_cast<std::uint64_t>(signals_.group_count());
    if (!has_array(entry.offset, 8, groups, 1) ||
        !has_array(entry.bits_offset, entry.present, static_cast<std::uint64_t>(rows), 1))
      return false;
    const auto* const widths = signals_.at<std::uint8_t>(entry.offset);
    std::uint64_t row_bytes = 0;
    for (std::uint64_t g = 0; g < groups; ++g) {
      std::uint64_t bits = 0;
      for (std::uint64_t s = 8 * g; s < 8 * g + 8; ++s) {
        if (widths[s] > kMostWidth) return false;
        bits += widths[s];
      }
      row_bytes += (bits + 7) / 8;
    }
    return row_bytes == entry.present;
  }

  bool is_sparse(const Entry& entry, int rows) const {
    if (entry.log2_rows > kMostLog2Rows || entry.gap_shift > kMostRiceShift ||
        entry.value_shift > kMostRiceShift)
      return false;
    const std::uint64_t blocks = (static_cast<std::uint64_t>(rows - 1) >> entry.log2_rows) + 1;
    const std::uint64_t offset_size = entry.kind == Kind::SparseWide ? 4 : 2;
    if (!has_array(entry.offset, offset_size, blocks, 1) ||
        !has_array(entry.list_offset, signals_.has_wide_numbers() ? 2 : 1, entry.present, 1))
      return false;
    for (std::uint32_t i = 0; i < entry.present; ++i)
      if (signals_.listed_signal(entry, i) >= signals_.signals_) return false;
    std::uint64_t begin = 0;
    for (std::uint64_t block = 0; block < blocks; ++block) {
      std::uint32_t offset = 0;
      std::memcpy(
          &offset,
          signals_.at<std::byte>(entry.offset) + static_cast<std::size_t>(offset_size * block),
          static_cast<std::size_t>(offset_size));
      if (offset != begin || !is_block(entry, begin)) return false;
    }
    return true;
  }

  /// Walks a block as the decoder does. Adds the size of the block to `begin`.
  bool is_block(const Entry& entry, std::uint64_t& begin) const {
    const std::uint64_t first_byte = entry.bits_offset + begin;
    if (first_byte + kReadAhead > bytes_) return false;
    BitReader reader(signals_.at<std::byte>(entry.bits_offset) + begin);
    std::uint32_t place = 0;
    for (std::uint32_t left = reader.rice(ResidentSignals::kCountShift); left > 0;
         --left, ++place) {
      if (first_byte + reader.bits() / 8 + kReadAhead > bytes_) return false;
      place += reader.rice(entry.gap_shift);
      reader.rice(entry.value_shift);
      reader.flag();
      if (place >> entry.log2_rows >= entry.present) return false;
    }
    begin += (reader.bits() + 7) / 8;
    return true;
  }

  const ResidentSignals& signals_;
  const Bands bands_;
  const std::uint64_t bytes_;
};

bool ResidentSignals::is_sound(std::uint64_t bytes, std::uint32_t length,
                               std::uint32_t signals) const {
  return std::cmp_equal(length_, length) && std::cmp_equal(signals_, signals) &&
         ResidentChecker(*this, bytes).run();
}

}  // namespace mocapress::runtime
