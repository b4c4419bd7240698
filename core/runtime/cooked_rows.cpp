// SPDX-License-Identifier: MIT
#include "core/runtime/cooked_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace mocapress::runtime {
namespace {

constexpr std::uint64_t kMostPerBlock = 20;    // at most on average, if a block has several rows
constexpr std::uint64_t kMostEntries = 65535;  // of a band: where a block begins is 16 bits

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

/// What dense rows of a kind leave to entries.
constexpr std::int32_t left_by(RowKind kind, std::int32_t value) {
  const Limits limits = limits_of(kind);
  return value - std::clamp(value, limits.least, limits.most);
}

constexpr std::int32_t kLeastOfEntry = -(1 << (15 - kColumnBits - kRowBits));
constexpr std::int32_t kMostOfEntry = -kLeastOfEntry - 1;

/// Entries whose values come to this.
constexpr std::uint64_t entries_for(std::int32_t value) {
  return static_cast<std::uint64_t>(value < 0 ? (value + kLeastOfEntry + 1) / kLeastOfEntry
                                              : (value + kMostOfEntry - 1) / kMostOfEntry);
}

/// The rows of a part in the segment that is loaded.
class RowWriter {
 public:
  RowWriter(CookedBlock& block, const CookedPart& part, const CookedColumns& columns,
            CookedCoefficients& coefficients)
      : block_(block), part_(part), columns_(columns), coefficients_(coefficients) {}

  CookedRows put();

 private:
  CookedBand put_band(int depth);
  void put_dense(std::byte* rows, RowKind kind, int depth) const;
  void put_entries(std::byte* memory, const CookedBand& band, int depth) const;
  const CookedColumns::Column& column(int c) const {
    return columns_.column(kGroup * part_.first_group + c);
  }
  const Bands& bands() const { return coefficients_.bands(); }
  int rows_of(int depth) const { return bands()[bands().count - depth].size; }
  std::int32_t value(int c, int depth, int row) const {
    const std::int32_t channel = column(c).channel;
    return channel < 0 ? 0 : coefficients_.value(channel, bands().count - depth, row);
  }

  CookedBlock& block_;
  const CookedPart& part_;
  const CookedColumns& columns_;
  CookedCoefficients& coefficients_;
};

CookedRows RowWriter::put() {
  CookedRows rows;
  const int columns = kGroup * part_.groups;
  const int kept = std::min<int>(part_.kept_bands, bands().count - 1);
  float* const scales =
      block_.reserve_for<float>(3 * static_cast<std::uint64_t>(columns), rows.scales);
  // Whole sums are times 2^15.
  for (int c = 0; scales != nullptr && c < columns; ++c) {
    const CookedColumns::Column& from = column(c);
    scales[c] = static_cast<float>(from.base);
    if (from.channel >= 0)
      scales[2 * columns + c] =
          static_cast<float>(coefficients_.step(from.channel) * from.factor * 0x1p-15);
  }
  const int samples = std::max(bands().length(bands().count - 1 - kept), kSampleWindow);
  const std::size_t width = part_.wide_samples != 0 ? 4 : 2;
  rows.samples =
      block_.reserve(width * static_cast<std::size_t>(columns) * static_cast<std::size_t>(samples));
  std::byte* const sample_rows = block_.at(rows.samples);
  for (int c = 0; sample_rows != nullptr && c < columns; ++c) {
    const CookedColumns::Column& from = column(c);
    if (from.channel < 0) continue;
    const std::span<double> own = coefficients_.samples_of(from.channel, kept);
    for (double& sample : own) sample *= from.factor;
    std::byte* to = sample_rows + width * static_cast<std::size_t>(c);
    const std::size_t row_bytes = width * static_cast<std::size_t>(columns);
    if (part_.wide_samples != 0) {
      scales[columns + c] = 1;
      for (const double value : own) {
        const auto sample = static_cast<float>(value);
        std::memcpy(to, &sample, sizeof sample);
        to += row_bytes;
      }
      continue;
    }
    const auto [least, most] = std::minmax_element(own.begin(), own.end());
    const double middle = 0.5 * (*least + *most);
    const double scale = std::max((*most - *least) / 65534, 1e-30);
    scales[c] += static_cast<float>(middle);
    scales[columns + c] = static_cast<float>(scale);
    for (const double value : own) {
      const auto sample = static_cast<std::int16_t>(std::lround((value - middle) / scale));
      std::memcpy(to, &sample, sizeof sample);
      to += row_bytes;
    }
  }
  CookedBand* const bands = block_.reserve_for<CookedBand>(part_.kept_bands, rows.bands);
  for (int depth = 1; depth <= kept; ++depth) {
    const CookedBand band = put_band(depth);
    if (bands != nullptr) bands[depth - 1] = band;
  }
  return rows;
}

/// The smallest of all kinds, where a byte of entries, which take time one by one, counts as more.
CookedBand RowWriter::put_band(int depth) {
  constexpr std::uint64_t kEntryIsWorth = 3;  // bytes of dense rows
  const int rows = rows_of(depth);
  const int columns = kGroup * part_.groups;
  CookedBand best;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t entries_of_best = 0;
  for (const RowKind kind :
       {RowKind::None, RowKind::Crumbs, RowKind::Nibbles, RowKind::Bytes, RowKind::Words}) {
    CookedBand band{.kind = kind};
    std::uint64_t entries = 0;
    for (int c = 0; c < columns; ++c)
      for (int i = 0; i < rows; ++i) entries += entries_for(left_by(kind, value(c, depth, i)));
    while (band.log2_rows < kMostLog2RowsOfBlock &&
           (entries << (band.log2_rows + 1)) / static_cast<std::uint64_t>(rows) <= kMostPerBlock)
      ++band.log2_rows;
    const std::uint64_t blocks =
        entries == 0 ? 0 : static_cast<std::uint64_t>((rows - 1) >> band.log2_rows) + 1;
    const std::uint64_t dense =
        static_cast<std::uint64_t>(bundles_of(kind, rows)) * bundle_bytes(kind) * part_.groups;
    const std::uint64_t cost = dense + kEntryIsWorth * entries + 2 * blocks;
    if (cost >= least || entries > kMostEntries || blocks > kMostEntries) continue;
    least = cost;
    band.blocks = static_cast<std::uint16_t>(blocks);
    best = band;
    entries_of_best = entries;
  }
  if (best.kind != RowKind::None) {
    best.rows = block_.reserve(static_cast<std::uint64_t>(bundles_of(best.kind, rows)) *
                               bundle_bytes(best.kind) * part_.groups);
    if (std::byte* const memory = block_.at(best.rows)) put_dense(memory, best.kind, depth);
  }
  if (best.blocks > 0) {
    best.entries = block_.reserve(2 * (std::uint64_t{best.blocks} + 1 + entries_of_best));
    if (std::byte* const memory = block_.at(best.entries)) put_entries(memory, best, depth);
  }
  return best;
}

void RowWriter::put_dense(std::byte* rows, RowKind kind, int depth) const {
  const int count = rows_of(depth);
  const int together = rows_together(kind);
  const Limits limits = limits_of(kind);
  const auto put = [&](unsigned bits, int bytes) {
    for (int i = 0; i < bytes; ++i) *rows++ = static_cast<std::byte>(bits >> (8 * i));
  };
  for (int bundle = 0; bundle < bundles_of(kind, count); ++bundle)
    for (int c = 0; c < kGroup * part_.groups; ++c) {
      unsigned bits = 0;
      for (int i = 0; i < together; ++i) {
        const int row = together * bundle + i;
        const std::int32_t number =
            row < count ? std::clamp(value(c, depth, row), limits.least, limits.most) : 0;
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

void RowWriter::put_entries(std::byte* memory, const CookedBand& band, int depth) const {
  const int count = rows_of(depth);
  const auto put = [&](std::uint64_t at, std::uint16_t word) {
    std::memcpy(memory + 2 * at, &word, sizeof word);
  };
  std::uint64_t entries = 0;
  for (int block = 0; block < band.blocks; ++block) {
    put(static_cast<std::uint64_t>(block), static_cast<std::uint16_t>(entries));
    const int end = std::min(count, (block + 1) << band.log2_rows);
    for (int row = block << band.log2_rows; row < end; ++row)
      for (int c = 0; c < kGroup * part_.groups; ++c) {
        std::int32_t left = left_by(band.kind, value(c, depth, row));
        while (left != 0) {
          const std::int32_t now = std::clamp(left, kLeastOfEntry, kMostOfEntry);
          put(band.blocks + 1U + entries++,
              static_cast<std::uint16_t>(static_cast<unsigned>(now) << (kColumnBits + kRowBits) |
                                         (static_cast<unsigned>(row) & ((1U << kRowBits) - 1))
                                             << kColumnBits |
                                         static_cast<unsigned>(c)));
          left -= now;
        }
      }
  }
  put(band.blocks, static_cast<std::uint16_t>(entries));
}

}  // namespace

CookedRows lay_out_rows(CookedBlock& block, const CookedPart& part, const CookedColumns& columns,
                        CookedCoefficients& coefficients) {
  return RowWriter(block, part, columns, coefficients).put();
}

}  // namespace mocapress::runtime
