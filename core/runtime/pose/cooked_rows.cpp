// SPDX-License-Identifier: MIT
#include "core/runtime/pose/cooked_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

#include "core/runtime/format/bit_pattern.h"

namespace mocapress::runtime {
namespace {

constexpr std::uint64_t kMostPerBlock = 20;    // largest average number of entries per block, if
                                               // blocks have more than one row
constexpr std::uint64_t kMostEntries = 65535;  // in a band; the starts of blocks have 16 bits

struct Limits {
  std::int32_t least;
  std::int32_t most;
};

constexpr Limits limits_of(RowKind kind) {
  switch (kind) {
    case RowKind::None:
      return {0, 0};
    case RowKind::Crumbs:
      return {-2, 1};
    case RowKind::Nibbles:
      return {-8, 7};
    case RowKind::Bytes:
      return {-128, 127};
    case RowKind::Words:
      break;
  }
  return {-32768, 32767};
}

/// The part of a value that dense rows of this kind have no bits for.
constexpr std::int32_t left_by(RowKind kind, std::int32_t value) {
  const Limits limits = limits_of(kind);
  return value - std::clamp(value, limits.least, limits.most);
}

constexpr std::int32_t kLeastOfEntry = -(1 << (15 - kColumnBits - kRowBits));
constexpr std::int32_t kMostOfEntry = -kLeastOfEntry - 1;

/// Number of entries needed to add up to `value`.
constexpr std::uint64_t entries_for(std::int32_t value) {
  return static_cast<std::uint64_t>(value < 0 ? (value + kLeastOfEntry + 1) / kLeastOfEntry
                                              : (value + kMostOfEntry - 1) / kMostOfEntry);
}

/// The upper half of a float, rounded to nearest; with `up`, to a magnitude that is not smaller.
std::uint16_t upper_half(double value, bool up) {
  constexpr double kMost = 0x1p127;  // a bound, so that rounding gives a finite number
  const auto bits =
      bit_pattern<std::uint32_t>(static_cast<float>(std::clamp(value, -kMost, kMost)));
  return static_cast<std::uint16_t>((bits + (up ? 0xFFFFU : 0x8000U)) >> 16);
}

/// Adds a sample to a group's zeroed row. Samples of 16 bits are eight words. Samples of 12 bits
/// take three times four bytes: the low eight bits of samples 0 to 3; bytes with the high four bits
/// of samples 0 to 3 and, above these, the low four bits of samples 4 to 7; the high eight bits of
/// samples 4 to 7. Samples of 20 or 24 bits: first the lowest byte of each sample, then the rest as
/// samples of 12 or 16 bits.
void put_sample(std::byte* row, int bits, int lane, long sample) {
  const auto put = [&](int at, long byte) { row[at] |= static_cast<std::byte>(byte & 0xFF); };
  if (bits > 16) {
    put(lane, sample);
    put_sample(row + kGroup, bits - 8, lane, sample >> 8);
  } else if (bits == 16) {
    put(2 * lane, sample);
    put(2 * lane + 1, sample >> 8);
  } else if (lane < 4) {
    put(lane, sample);
    put(lane + 4, sample >> 8 & 15);
  } else {
    put(lane, sample << 4 & 0xF0);
    put(lane + 4, sample >> 4);
  }
}

class RowWriter {
 public:
  RowWriter(CookedBlock& block, const CookedColumns& columns, CookedCoefficients& coefficients)
      : block_(block), columns_(columns), coefficients_(coefficients) {}

  CookedRows put_part(const CookedPart& part);
  /// Writes the entries of a band. Call put_part() for all parts first.
  CookedEntries put_entries(int first_group, int depth);

 private:
  float put_steps(const CookedPart& part, std::byte* scales) const;
  CookedBand put_band(const CookedPart& part, int depth);
  void put_dense(std::byte* rows, const CookedPart& part, RowKind kind, int depth) const;
  const Bands& bands() const { return coefficients_.bands(); }
  int rows_of(int depth) const { return bands()[bands().count - depth].size; }
  std::int32_t value(int column, int depth, int row) const {
    const std::int32_t channel = columns_.column(column).channel;
    return channel < 0 ? 0 : coefficients_.value(channel, bands().count - depth, row);
  }
  bool may_have_entries(int depth) const {
    return static_cast<std::uint64_t>(rows_of(depth)) >> kMostLog2RowsOfBlock < kMostEntries;
  }

  CookedBlock& block_;
  const CookedColumns& columns_;
  CookedCoefficients& coefficients_;
  // For each band of each group: the chosen kind of dense rows. A band that is not kept has neither
  // dense rows nor entries.
  struct Chosen {
    RowKind kind = RowKind::None;
    bool is_kept = false;
  };
  Chosen chosen_[kMostColumns / kGroup][kMostKeptBands];
};

CookedRows RowWriter::put_part(const CookedPart& part) {
  CookedRows rows;
  const int columns = kGroup * part.groups;
  const int kept = std::min<int>(part.kept_bands, bands().count - 1);
  const bool is_wide = part.is_wide != 0;
  rows.scales = block_.reserve(scale_bytes(is_wide, static_cast<std::uint64_t>(columns)));
  std::byte* const scales = block_.at(rows.scales);
  if (scales != nullptr) rows.unit = put_steps(part, scales);
  const int samples = std::max(bands().length(bands().count - 1 - kept), kSampleWindow);
  const std::ptrdiff_t row_bytes = part.sample_place(part.groups);
  rows.samples = block_.reserve(static_cast<std::uint64_t>(row_bytes * samples));
  std::byte* const sample_rows = block_.at(rows.samples);
  for (int c = 0; sample_rows != nullptr && c < columns; ++c) {
    const CookedColumns::Column& from = columns_.column(kGroup * part.first_group + c);
    const bool is_empty = from.channel < 0;  // true: the column has no channel, so all samples are
                                             // its base
    double none = 0;
    const std::span<double> own =
        is_empty ? std::span(&none, 1) : coefficients_.samples_of(from.channel, kept);
    const std::size_t repeats = is_empty ? static_cast<std::size_t>(samples) : 1;
    for (double& sample : own) sample = sample * from.factor + from.base;
    std::byte* to = sample_rows + part.sample_place(c / kGroup);
    const int bits = part.sample_bits(c / kGroup);
    const double furthest = std::exp2(bits - 1) - 1;
    const auto [least, most] = std::minmax_element(own.begin(), own.end());
    const std::uint16_t offset = upper_half(0.5 * (*least + *most), false);
    const auto middle = static_cast<double>(from_upper_half(offset));
    const std::uint16_t scale = upper_half(
        std::max({(*most - middle) / furthest, (middle - *least) / furthest, 1e-30}), true);
    std::memcpy(scales + 2 * c, &offset, sizeof offset);
    std::memcpy(scales + 2 * (columns + c), &scale, sizeof scale);
    for (std::size_t i = 0; i < repeats * own.size(); ++i) {
      const double value = own[is_empty ? 0 : i] - middle;
      put_sample(to, bits, c % kGroup,
                 std::lround(value / static_cast<double>(from_upper_half(scale))));
      to += row_bytes;
    }
  }
  CookedBand* const bands = block_.reserve_for<CookedBand>(part.kept_bands, rows.bands);
  for (int depth = 1; depth <= kept; ++depth) {
    const CookedBand band = put_band(part, depth);
    if (bands != nullptr) bands[depth - 1] = band;
  }
  return rows;
}

/// Writes the steps of a part's columns, and returns the factor that they share. The factor
/// includes 2^-15, because integer weights have a factor of 2^15.
float RowWriter::put_steps(const CookedPart& part, std::byte* scales) const {
  const int columns = kGroup * part.groups;
  const auto step_of = [&](int c) {
    const CookedColumns::Column& from = columns_.column(kGroup * part.first_group + c);
    return from.channel < 0 ? 0 : coefficients_.step(from.channel) * from.factor;
  };
  scales += 4 * columns;
  if (part.is_wide != 0) {
    for (int c = 0; c < columns; ++c) {
      const auto step = static_cast<float>(step_of(c));
      std::memcpy(scales + 4 * c, &step, sizeof step);
    }
    return 0x1p-15F;
  }
  double largest = 0;
  for (int c = 0; c < columns; ++c) largest = std::max(largest, step_of(c));
  for (int c = 0; c < columns; ++c) {
    const std::uint16_t step = upper_half(largest > 0 ? step_of(c) / largest : 0, false);
    std::memcpy(scales + 2 * c, &step, sizeof step);
  }
  // Steps are the largest step divided by powers of sqrt(2). Stored as upper halves of floats,
  // every other of these is 1.07e-4 too small. Half of that is added to all steps.
  return static_cast<float>(largest * 0x1p-15 * (1 + 0.535e-4));
}

/// Chooses the kind of dense rows with the least cost. A byte of entries costs more than a byte of
/// dense rows, because entries are added one by one.
CookedBand RowWriter::put_band(const CookedPart& part, int depth) {
  constexpr std::uint64_t kEntryIsWorth = 15;  // cost of an entry, in quarters of a byte of dense
                                               // rows
  const int rows = rows_of(depth);
  const int first = kGroup * part.first_group;
  const int end = first + kGroup * part.groups;
  CookedBand best;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (const RowKind kind :
       {RowKind::None, RowKind::Crumbs, RowKind::Nibbles, RowKind::Bytes, RowKind::Words}) {
    std::uint64_t entries = 0;
    for (int c = first; c < end; ++c)
      for (int i = 0; i < rows; ++i) entries += entries_for(left_by(kind, value(c, depth, i)));
    if (entries > (may_have_entries(depth) ? kMostEntries * part.groups / kMostGroupsOfPart : 0))
      continue;
    const std::uint64_t cost =
        4 * static_cast<std::uint64_t>(bundles_of(kind, rows)) * bundle_bytes(kind) * part.groups +
        kEntryIsWorth * entries;
    if (cost >= least) continue;
    least = cost;
    best.kind = kind;
  }
  for (int g = 0; g < part.groups; ++g)
    chosen_[part.first_group + g][depth - 1] = {best.kind, true};
  if (best.kind == RowKind::None) return best;
  best.rows = block_.reserve(static_cast<std::uint64_t>(bundles_of(best.kind, rows)) *
                             bundle_bytes(best.kind) * part.groups);
  if (std::byte* const memory = block_.at(best.rows)) put_dense(memory, part, best.kind, depth);
  return best;
}

void RowWriter::put_dense(std::byte* rows, const CookedPart& part, RowKind kind, int depth) const {
  const int count = rows_of(depth);
  const int together = rows_together(kind);
  const Limits limits = limits_of(kind);
  const auto put = [&](unsigned bits, int bytes) {
    for (int i = 0; i < bytes; ++i) *rows++ = static_cast<std::byte>(bits >> (8 * i));
  };
  for (int bundle = 0; bundle < bundles_of(kind, count); ++bundle)
    for (int c = 0; c < kGroup * part.groups; ++c) {
      unsigned bits = 0;
      for (int i = 0; i < together; ++i) {
        const int row = together * bundle + i;
        const std::int32_t number =
            row < count ? std::clamp(value(kGroup * part.first_group + c, depth, row), limits.least,
                                     limits.most)
                        : 0;
        if (kind == RowKind::Crumbs)
          bits |= static_cast<unsigned>(number + 2) << (2 * i);
        else if (kind == RowKind::Nibbles)
          bits |= static_cast<unsigned>(number + 8) << (4 * i);
        else if (kind == RowKind::Bytes)
          bits |= (static_cast<unsigned>(number) & 0xFF) << (8 * i);
        else
          bits |= (static_cast<unsigned>(number) & 0xFFFF) << (16 * i);
      }
      put(bits, static_cast<int>(bundle_bytes(kind)) / kGroup);
    }
}

CookedEntries RowWriter::put_entries(int first_group, int depth) {
  const int groups = std::min(columns_.row_groups() - first_group, kMostGroupsOfPart);
  const int rows = depth < bands().count ? rows_of(depth) : 0;
  const auto each = [&](int first_row, int end_row, const auto& use) {
    for (int row = first_row; row < end_row; ++row)
      for (int c = 0; c < kGroup * groups; ++c) {
        const Chosen& chosen = chosen_[first_group + c / kGroup][depth - 1];
        if (!chosen.is_kept) continue;
        use(row, c, left_by(chosen.kind, value(kGroup * first_group + c, depth, row)));
      }
  };
  std::uint64_t count = 0;
  each(0, rows, [&](int, int, std::int32_t left) { count += entries_for(left); });
  CookedEntries made;
  if (count == 0) return made;
  const auto blocks = [&] { return static_cast<std::uint64_t>((rows - 1) >> made.log2_rows) + 1; };
  while (made.log2_rows < kMostLog2RowsOfBlock &&
         (2 * count <= kMostPerBlock * blocks() || blocks() > kMostEntries))
    ++made.log2_rows;
  made.blocks = static_cast<std::uint16_t>(blocks());
  made.begins = block_.reserve(2 * (blocks() + 1 + count), 2);
  std::byte* const memory = block_.at(made.begins);
  if (memory == nullptr) return made;
  const auto put = [&](std::uint64_t at, std::uint16_t word) {
    std::memcpy(memory + 2 * at, &word, sizeof word);
  };
  std::uint64_t entries = 0;
  for (int block = 0; block < made.blocks; ++block) {
    put(static_cast<std::uint64_t>(block), static_cast<std::uint16_t>(entries));
    each(block << made.log2_rows, std::min(rows, (block + 1) << made.log2_rows),
         [&](int row, int c, std::int32_t left) {
           while (left != 0) {
             const std::int32_t now = std::clamp(left, kLeastOfEntry, kMostOfEntry);
             put(made.blocks + 1U + entries++,
                 static_cast<std::uint16_t>(static_cast<unsigned>(now) << (kColumnBits + kRowBits) |
                                            (static_cast<unsigned>(row) & ((1U << kRowBits) - 1))
                                                << kColumnBits |
                                            static_cast<unsigned>(c)));
             left -= now;
           }
         });
  }
  put(made.blocks, static_cast<std::uint16_t>(entries));
  return made;
}

}  // namespace

void lay_out_rows(CookedBlock& block, const CookedColumns& columns,
                  CookedCoefficients& coefficients, CookedRows* rows, CookedEntries* entries) {
  RowWriter writer(block, columns, coefficients);
  for (const CookedPart& part : columns.parts()) {
    const CookedRows made = writer.put_part(part);
    if (rows != nullptr) *rows++ = made;
  }
  for (int group = 0; group < columns.row_groups(); group += kMostGroupsOfPart)
    for (int depth = 1; depth <= kMostKeptBands; ++depth) {
      const CookedEntries made = writer.put_entries(group, depth);
      if (entries != nullptr) *entries++ = made;
    }
}

}  // namespace mocapress::runtime
