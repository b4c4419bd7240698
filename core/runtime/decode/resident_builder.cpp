// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>

#include "core/runtime/decode/resident_signals.h"
#include "core/runtime/format/bits.h"

namespace mocapress::runtime {
namespace {

constexpr int kEntriesOfBlock = 12;  // least average number of coefficients in a block; with
                                     // smaller blocks the index would be large
constexpr int kMostLog2Rows = 15;
constexpr std::uint64_t kDenseIsWorth =
    4;  // a dense band may be this many times as large as a sparse one: it is faster

/// Width in bits of the values in a dense band. A value is stored with a bias of 2^(width - 1).
int width_of(std::int32_t least, std::int32_t most) {
  if (least == 0 && most == 0) return 0;
  const auto magnitude = static_cast<std::uint32_t>(std::max(~least, most));
  return static_cast<int>(std::bit_width(magnitude)) + 1;
}

}  // namespace

/// Lays out a resident form. Without memory it only measures.
class ResidentBuilder {
 public:
  ResidentBuilder(const QuantisedSource& source, std::byte* memory)
      : source_(source), bands_(source.length), memory_(memory) {}

  std::uint64_t run() {
    ResidentSignals head;
    head.length_ = source_.length;
    head.signals_ = source_.signal_count;
    head.wavelet_ = source_.wavelet;
    head.band_count_ = static_cast<std::uint8_t>(bands_.count);
    wide_numbers_ = head.has_wide_numbers();
    used_ = sizeof(ResidentSignals);
    choose_kinds();
    head.steps_ = reserve(sizeof(float) * 8 * static_cast<std::uint64_t>(group_count()), 4);
    if (memory_ != nullptr && source_.signal_count > 0)
      std::memcpy(memory_ + head.steps_, source_.steps,
                  sizeof(float) * static_cast<std::size_t>(source_.signal_count));
    add_double_precision(head);
    head.entries_ = reserve(sizeof(Entry) * static_cast<std::uint64_t>(bands_.count), 4);
    for (int b = 0; b < bands_.count; ++b) {
      const Entry entry = add_band(b);
      if (memory_ != nullptr)
        std::memcpy(memory_ + head.entries_ + sizeof(Entry) * static_cast<std::size_t>(b), &entry,
                    sizeof entry);
    }
    used_ += kReadAhead;
    if (memory_ != nullptr) new (memory_) ResidentSignals(head);
    return used_;
  }

  /// Lists the signals that need double precision: those with a coefficient so large that floats
  /// might not be precise enough for the samples.
  void add_double_precision(ResidentSignals& head) {
    for (int s = 0; s < source_.signal_count; ++s) {
      if (!is_double_precision(s)) continue;
      const std::uint32_t at = reserve(sizeof(std::uint16_t), 2);
      if (head.double_precision_count_++ == 0) head.wide_ = at;
      const auto number = static_cast<std::uint16_t>(s);
      if (memory_ != nullptr) std::memcpy(memory_ + at, &number, sizeof number);
    }
  }

  bool is_double_precision(int signal) const {
    const double limit = static_cast<double>(source_.double_precision_limits[signal]) /
                         static_cast<double>(source_.steps[signal]);
    for (int b = 0; b < bands_.count; ++b) {
      const std::int32_t* const first = values(signal, bands_[b]);
      const double most = limit * power_of_root_two(bands_.depth(b));
      if (std::any_of(first, first + bands_[b].size, [&](std::int32_t value) {
            return std::abs(static_cast<double>(value)) > most;
          }))
        return true;
    }
    return false;
  }

 private:
  using Entry = ResidentSignals::BandEntry;
  using Kind = ResidentSignals::Kind;

  /// Reserves bytes at the end of the form, and returns their offset.
  std::uint32_t reserve(std::uint64_t bytes, std::uint64_t alignment) {
    used_ = (used_ + alignment - 1) / alignment * alignment;
    const std::uint64_t at = used_;
    used_ += bytes;
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(
        at, std::numeric_limits<std::uint32_t>::max()));  // no form larger than 4 GiB is ever
                                                          // built: its size is checked before
  }
  const std::int32_t* values(int signal, const Band& band) const {
    return source_.values + static_cast<std::ptrdiff_t>(signal) * source_.length + band.first;
  }
  void find_widths(const Band& band) {
    for (int s = 0; s < source_.signal_count; ++s) {
      source_.notes[s] = 0;
      if (band.size == 0) continue;
      const std::int32_t* const first = values(s, band);
      const auto [least, most] = std::minmax_element(first, first + band.size);
      source_.notes[s] = static_cast<std::uint8_t>(width_of(*least, *most));
    }
  }
  int width(int signal) const { return source_.notes[signal]; }

  int group_count() const { return (source_.signal_count + 7) / 8; }

  /// Bytes that a group of 8 signals takes in a dense row.
  std::uint32_t bytes_of_group(int group) const {
    int bits = 0;
    for (int s = 8 * group; s < std::min(8 * group + 8, source_.signal_count); ++s)
      bits += width(s);
    return static_cast<std::uint32_t>(bits + 7) / 8;
  }

  /// Sizes of a band in both forms, dense and sparse, in bytes.
  struct Sizes {
    Entry sparse;  // kind Empty if the band is empty
    std::uint64_t sparse_bytes = 0;
    std::uint32_t row_bytes = 0;
    std::uint64_t dense_bytes = 0;
    bool is_dense = false;
  };

  Sizes measure(const Band& band) {
    Sizes sizes;
    std::uint64_t entries = 0;
    find_widths(band);
    for (int s = 0; s < source_.signal_count; ++s) {
      if (width(s) == 0) continue;
      ++sizes.sparse.present;
      const std::int32_t* const first = values(s, band);
      entries += static_cast<std::uint64_t>(band.size -
                                            std::count(first, first + band.size, std::int32_t{0}));
    }
    if (entries == 0) return sizes;
    Entry& sparse = sizes.sparse;
    sparse.kind = Kind::Sparse;
    while (sparse.log2_rows < kMostLog2Rows && band.size >> sparse.log2_rows > 1 &&
           (entries << sparse.log2_rows) / static_cast<std::uint64_t>(band.size) < kEntriesOfBlock)
      ++sparse.log2_rows;
    sizes.sparse_bytes = choose_shifts(band, sparse) / 8;
    for (int g = 0; g < group_count(); ++g) sizes.row_bytes += bytes_of_group(g);
    sizes.dense_bytes = std::uint64_t{sizes.row_bytes} * static_cast<std::uint64_t>(band.size) +
                        8 * static_cast<std::uint64_t>(group_count());
    sizes.is_dense = sizes.dense_bytes <= sizes.sparse_bytes;
    return sizes;
  }

  /// Chooses the smaller form for each band. Then makes more bands dense, for speed, from the
  /// coarsest on, as long as the total stays within the budget.
  void choose_kinds() {
    std::uint64_t total = 0;
    for (int b = 0; b < bands_.count; ++b) {
      sizes_[b] = measure(bands_[b]);
      total += std::min(sizes_[b].sparse_bytes, sizes_[b].dense_bytes);
    }
    for (int b = 0; b < bands_.count; ++b) {
      Sizes& sizes = sizes_[b];
      if (sizes.is_dense || sizes.dense_bytes > kDenseIsWorth * sizes.sparse_bytes) continue;
      const std::uint64_t more = sizes.dense_bytes - sizes.sparse_bytes;
      if (total + more > source_.budget_bytes) continue;
      total += more;
      sizes.is_dense = true;
    }
  }

  Entry add_band(int b) {
    const Sizes& sizes = sizes_[b];
    if (sizes.sparse.kind == Kind::Empty) return {};
    find_widths(bands_[b]);
    return sizes.is_dense ? add_dense(bands_[b], sizes.row_bytes)
                          : add_sparse(bands_[b], sizes.sparse, sizes.sparse_bytes);
  }

  Entry add_dense(const Band& band, std::uint32_t row_bytes) {
    Entry entry{.kind = Kind::Dense, .present = row_bytes};
    entry.offset = reserve(8 * static_cast<std::uint64_t>(group_count()), 1);
    entry.bits_offset =
        reserve(std::uint64_t{row_bytes} * static_cast<std::uint64_t>(band.size), 1);
    if (memory_ == nullptr) return entry;
    std::memcpy(memory_ + entry.offset, source_.notes,
                static_cast<std::size_t>(source_.signal_count));
    BitWriter writer(memory_ + entry.bits_offset);
    // Each row is stored group by group, and each group of 8 signals starts at a byte.
    for (int i = 0; i < band.size; ++i)
      for (int s = 0; s < source_.signal_count; ++s) {
        if (s % 8 == 0) writer.align_to_byte();
        if (width(s) == 0) continue;
        const std::int64_t bias = std::int64_t{1} << (width(s) - 1);
        writer.put(static_cast<std::uint64_t>(values(s, band)[i] + bias), width(s));
      }
    return entry;
  }

  /// Calls visit(gap, value) for each nonzero value of a block.
  template <typename Visit>
  void visit_block(const Band& band, const Entry& entry, int block, const Visit& visit) const {
    const int first = block << entry.log2_rows;
    const int end = std::min(band.size, (block + 1) << entry.log2_rows);
    std::uint32_t next = 0;  // position after the previous nonzero value
    std::uint32_t of_signal = 0;
    for (int s = 0; s < source_.signal_count; ++s) {
      if (width(s) == 0) continue;
      for (int i = first; i < end; ++i) {
        const std::int32_t value = values(s, band)[i];
        if (value == 0) continue;
        const std::uint32_t place = of_signal + static_cast<std::uint32_t>(i - first);
        visit(place - next, value);
        next = place + 1;
      }
      of_signal += std::uint32_t{1} << entry.log2_rows;
    }
  }

  static int block_count(const Band& band, const Entry& entry) {
    return ((band.size - 1) >> entry.log2_rows) + 1;
  }
  static std::uint32_t beyond_one(std::int32_t value) {
    return (value < 0 ? 0U - static_cast<std::uint32_t>(value)
                      : static_cast<std::uint32_t>(value)) -
           1;
  }

  /// Adds up the bits of numbers for every shift of a Rice code, to find the best shift.
  struct RiceCosts {
    std::uint64_t bits[kMostRiceShift + 1] = {};
    void add(std::uint32_t v) {
      for (int shift = 0; shift <= kMostRiceShift; ++shift)
        bits[shift] += static_cast<std::uint64_t>(rice_bits(v, shift));
    }
    int best() const {
      return static_cast<int>(std::min_element(bits, bits + kMostRiceShift + 1) - bits);
    }
  };

  /// Chooses the shifts of the band's Rice codes, and returns the size of the sparse band in bits.
  std::uint64_t choose_shifts(const Band& band, Entry& entry) const {
    RiceCosts gaps;
    RiceCosts sizes;
    std::uint64_t entries = 0;
    std::uint64_t counts = 0;
    for (int block = 0; block < block_count(band, entry); ++block) {
      std::uint32_t count = 0;
      visit_block(band, entry, block, [&](std::uint32_t gap, std::int32_t value) {
        gaps.add(gap);
        sizes.add(beyond_one(value));
        ++count;
      });
      entries += count;
      counts += static_cast<std::uint64_t>(rice_bits(count, ResidentSignals::kCountShift));
    }
    entry.gap_shift = static_cast<std::uint8_t>(gaps.best());
    entry.value_shift = static_cast<std::uint8_t>(sizes.best());
    return gaps.bits[entry.gap_shift] + sizes.bits[entry.value_shift] + entries + counts +
           20 * static_cast<std::uint64_t>(block_count(band, entry)) +
           8 * static_cast<std::uint64_t>(entry.present);
  }

  Entry add_sparse(const Band& band, Entry entry, std::uint64_t about_bytes) {
    const auto blocks = static_cast<std::uint64_t>(block_count(band, entry));
    if (about_bytes + blocks > 0xFFFF) entry.kind = Kind::SparseWide;
    const std::uint64_t offset_size = entry.kind == Kind::SparseWide ? 4 : 2;
    const std::uint64_t number_size = wide_numbers_ ? 2 : 1;
    entry.offset = reserve(offset_size * blocks, 1);
    entry.list_offset = reserve(number_size * entry.present, 1);
    entry.bits_offset = reserve(0, 1);
    if (memory_ != nullptr) list_signals(memory_ + entry.list_offset);
    BitWriter writer(memory_ == nullptr ? nullptr : memory_ + entry.bits_offset);
    for (int block = 0; block < static_cast<int>(blocks); ++block) {
      writer.align_to_byte();
      const std::uint64_t byte = writer.bits() / 8;
      if (memory_ != nullptr)
        std::memcpy(memory_ + entry.offset + offset_size * static_cast<std::uint64_t>(block), &byte,
                    static_cast<std::size_t>(offset_size));
      write_block(band, entry, block, writer);
    }
    reserve((writer.bits() + 7) / 8, 1);
    return entry;
  }

  void list_signals(std::byte* list) const {
    for (int s = 0; s < source_.signal_count; ++s) {
      if (width(s) == 0) continue;
      std::memcpy(list, &s, wide_numbers_ ? 2 : 1);
      list += wide_numbers_ ? 2 : 1;
    }
  }

  void write_block(const Band& band, const Entry& entry, int block, BitWriter& writer) const {
    std::uint32_t count = 0;
    visit_block(band, entry, block, [&](std::uint32_t, std::int32_t) { ++count; });
    writer.put_rice(count, ResidentSignals::kCountShift);
    visit_block(band, entry, block, [&](std::uint32_t gap, std::int32_t value) {
      writer.put_rice(gap, entry.gap_shift);
      writer.put_rice(beyond_one(value), entry.value_shift);
      writer.put(value < 0 ? 1 : 0, 1);
    });
  }

  const QuantisedSource& source_;
  const Bands bands_;
  Sizes sizes_[kMostBands];
  std::byte* memory_;  // zeroed by the caller
  std::uint64_t used_ = 0;
  bool wide_numbers_ = false;
};

std::uint64_t ResidentSignals::size(const QuantisedSource& source) {
  return ResidentBuilder(source, nullptr).run();
}

const ResidentSignals* ResidentSignals::build(const QuantisedSource& source, std::byte* memory) {
  ResidentBuilder(source, memory).run();
  return std::launder(reinterpret_cast<const ResidentSignals*>(memory));
}

}  // namespace mocapress::runtime
