// SPDX-License-Identifier: MIT
#include "core/runtime/pose/pose_cursor.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/runtime/format/interpolation.h"

namespace mocapress::runtime {
namespace {

/// The level of the inverse transform that makes the given samples. Finds the even samples and
/// details that it needs.
LiftLevel level_below(Wavelet wavelet, int length, RowRange samples, bool only_evens) {
  LiftLevel level{.wavelet = wavelet,
                  .even_count = evens_in(length),
                  .odd_count = odds_in(length),
                  .only_evens = only_evens,
                  .samples = samples};
  const RowRange odds{samples.first >> 1, only_evens ? samples.first >> 1 : samples.end >> 1};
  RowRange evens{(samples.first + 1) >> 1, (samples.end + 1) >> 1};
  if (odds.first < odds.end) {
    const Neighbours first = neighbours_of(wavelet, odds.first, level.even_count);
    const Neighbours last = neighbours_of(wavelet, odds.end - 1, level.even_count);
    evens = {std::min(evens.first, first.first), std::max(evens.end, last.first + last.count)};
  }
  level.evens = evens;
  // Details start at an even row and end after an odd one.
  level.details = {std::clamp(std::min(odds.first, evens.first - 1), 0, level.odd_count - 1) & ~1,
                   (std::min(std::max(odds.end, evens.end), level.odd_count) + 1) & ~1};
  return level;
}

/// Adds the entries of a band to rows of 16-bit sums. Column `first_column` of the entries is
/// column 0 of `out`.
void spread_entries(const mcpr_cooked& clip, const CookedEntries& entries, RowRange rows,
                    int first_column, int columns, std::int16_t* out) {
  const auto* const begins = clip.at<std::uint16_t>(entries.begins);
  const std::uint16_t* const all = begins + entries.blocks + 1;
  const auto row_count = static_cast<unsigned>(rows.end - rows.first);
  const auto column_count = static_cast<unsigned>(columns);
  const int end = std::min(((rows.end - 1) >> entries.log2_rows) + 1, int{entries.blocks});
  for (int block = rows.first >> entries.log2_rows; block < end; ++block) {
    const int first = block << entries.log2_rows;
    for (int i = begins[block]; i < begins[block + 1]; ++i) {
      const int bits = static_cast<std::int16_t>(all[i]);
      const int row =
          (((bits >> kColumnBits) - first) & ((1 << kRowBits) - 1)) + (first - rows.first);
      const int column = (bits & ((1 << kColumnBits) - 1)) - first_column;
      if (static_cast<unsigned>(row) >= row_count || static_cast<unsigned>(column) >= column_count)
        continue;
      std::int16_t& sum = out[row * columns + column];
      sum = static_cast<std::int16_t>(sum + (bits >> (kColumnBits + kRowBits)));
    }
  }
}

/// The part of two ranges that they share.
RowRange shared(RowRange a, RowRange b) {
  return {std::max(a.first, b.first), std::min(a.end, b.end)};
}

}  // namespace
}  // namespace mocapress::runtime

namespace runtime = mocapress::runtime;

int mcpr_cursor::capacity_for(const mcpr_cooked& clip, std::size_t bytes, int fewest) {
  const int columns = runtime::kGroup * static_cast<int>(clip.row_groups);
  if (columns == 0) return 0;
  const int fitting = static_cast<int>(bytes) / (4 * columns);
  return fitting < fewest ? 0 : std::min(fitting, runtime::kMostLiftedFrames);
}

mcpr_cursor mcpr_cursor::empty(const mcpr_cooked& clip, std::size_t bytes, int fewest) {
  return {.clip = &clip,
          .first = 0,
          .count = 0,
          .capacity = capacity_for(clip, bytes, fewest),
          .columns = runtime::kGroup * static_cast<std::int32_t>(clip.row_groups),
          .step = 1,
          .last = 0,
          .left_out = 0};
}

std::size_t mcpr_cursor::bytes_for(const mcpr_cooked& clip) {
  return kHead + sizeof(float) * static_cast<std::size_t>(runtime::kGroup) * clip.row_groups *
                     static_cast<std::size_t>(capacity_for(clip));
}

bool mcpr_cursor::keep(const runtime::PoseKernels& kernels, int number, bool and_next,
                       int left_out_bands, std::span<std::int16_t> work) {
  if (capacity == 0) return false;
  if (std::exchange(left_out, left_out_bands) != left_out_bands) count = 0;
  const int before = std::exchange(last, number);
  if (has(number) && (!and_next || has(number + 1))) return true;
  const runtime::SegmentLayout layout = clip->layout();
  const runtime::SegmentLayout::Stretch stretch = layout.stretch_at(number);
  const int first_of_stretch =
      layout.first(stretch.segment) + (stretch.segment > 0 ? layout.overlap : 0);
  // At half the rate only even frames are cached: they can be made without the odd ones.
  const bool is_even = (number - layout.first(stretch.segment)) % 2 == 0;
  step = is_even && !and_next && std::abs(number - before) == 2 ? 2 : 1;
  // Playing backwards, so cache frames before the current one.
  first = number;
  if (number < before)
    first -=
        std::min(number - first_of_stretch, step * (capacity - (and_next ? 2 : 1))) / step * step;
  count = std::min(capacity, (number + stretch.frames - 1 - first) / step + 1);
  fill(kernels, stretch.segment, work);
  return true;
}

void mcpr_cursor::keep_run(const runtime::PoseKernels& kernels, int from, int frames,
                           int left_out_bands, std::span<std::int16_t> work) {
  first = from;
  count = frames;
  step = 1;
  left_out = left_out_bands;
  fill(kernels, clip->layout().stretch_at(from).segment, work);
}

/// Computes the cached frames by the inverse transform, for as many groups of columns at a time
/// as `work` has room for the entries of.
void mcpr_cursor::fill(const runtime::PoseKernels& kernels, int segment,
                       std::span<std::int16_t> work) {
  using namespace runtime;
  constexpr std::size_t kMostWork = std::size_t{1} << 30;  // limit of the work space: an int counts
                                                           // its numbers
  const SegmentLayout layout = clip->layout();
  LiftLevel levels[kMostKeptBands];
  int length = layout.frames_of(segment);
  int level_count = 0;
  const int first_sample = first - layout.first(segment);
  RowRange samples[kMostKeptBands + 1] = {{first_sample, first_sample + step * (count - 1) + 1}};
  int most_levels = 0;
  for (int p = 0; p < clip->parts; ++p)
    most_levels = std::max<int>(most_levels, clip->part(p).kept_bands);
  int rows_of_entries = 0;
  for (; level_count < most_levels && length >= kCoarsest; length = evens_in(length)) {
    LiftLevel& level = levels[level_count];
    level = level_below(clip->wavelet, length, samples[level_count], step == 2 && level_count == 0);
    level.is_left_out = level_count < left_out;
    rows_of_entries += level.details.end - level.details.first;
    samples[++level_count] = level.evens;
  }
  const int groups_at_once =
      rows_of_entries > 0
          ? static_cast<int>(std::min(work.size(), kMostWork)) / (kGroup * rows_of_entries)
          : static_cast<int>(clip->row_groups);
  for (int group = 0; group < static_cast<int>(clip->row_groups); group += groups_at_once) {
    const RowRange groups{group,
                          std::min(group + groups_at_once, static_cast<int>(clip->row_groups))};
    const int entry_columns = kGroup * (groups.end - groups.first);
    std::fill_n(work.data(), rows_of_entries * entry_columns, 0);
    std::int16_t* next = work.data();
    for (int b = 0; b < level_count; ++b) {
      LiftLevel& level = levels[b];
      level.entries = next;
      for (int e = 0; e < clip->entry_parts() && !level.is_left_out; ++e) {
        const CookedEntries& band = clip->entries_of(segment, e, b);
        const int first_of_part = kMostGroupsOfPart * e;
        const RowRange wanted = shared(groups, {first_of_part, first_of_part + kMostGroupsOfPart});
        if (band.blocks > 0 && wanted.first < wanted.end)
          spread_entries(*clip, band, level.details, kGroup * (groups.first - first_of_part),
                         entry_columns, next);
      }
      next += (level.details.end - level.details.first) * entry_columns;
    }
    for (int p = 0; p < clip->parts; ++p) {
      const CookedPart& part = clip->part(p);
      const RowRange wanted = shared(groups, {part.first_group, part.first_group + part.groups});
      if (wanted.first >= wanted.end) continue;
      const CookedRows& rows = clip->rows_of(segment, p);
      const int kept = std::min<int>(part.kept_bands, level_count);
      const int first_group = wanted.first - part.first_group;
      const std::ptrdiff_t row_bytes = part.sample_place(part.groups);
      kernels.lift({.levels = levels,
                    .level_count = kept,
                    .bands = clip->at<CookedBand>(rows.bands),
                    .clip = clip->at<std::byte>(std::uint32_t{0}),
                    .samples = clip->at<std::byte>(rows.samples) + samples[kept].first * row_bytes +
                               part.sample_place(first_group),
                    .row_bytes = row_bytes,
                    .sample_count = samples[kept].end - samples[kept].first,
                    .sample_step = kept == 0 ? step : 1,
                    .unit = rows.unit,
                    .scales = clip->at<std::byte>(rows.scales),
                    .groups_of_part = part.groups,
                    .first_group = first_group,
                    .groups = wanted.end - wanted.first,
                    .narrow = part.narrow_within(first_group, wanted.end - part.first_group),
                    .wide = part.is_wide != 0,
                    .first_entry = kGroup * (wanted.first - groups.first),
                    .entry_columns = entry_columns,
                    .frames = const_cast<float*>(frame(first)) + kGroup * wanted.first,
                    .frame_columns = columns});
    }
  }
}
