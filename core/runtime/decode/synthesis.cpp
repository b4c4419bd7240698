// SPDX-License-Identifier: MIT
#include "core/runtime/decode/synthesis.h"

#include <algorithm>

#include "core/runtime/format/interpolation.h"

namespace mocapress::runtime {
namespace {

constexpr int kBorderRows = 8;  // rows that a band may need beyond half the rows of the next finer
                                // band

}  // namespace

template <typename Real>
Synthesis<Real>::Synthesis(Memory& memory, const ResidentSignals* motion, int length,
                           const SynthesisPlan<Real>& plan)
    : signals_(motion), plan_(plan), bands_(length), stride_((plan.count + 7) / 8 * 8) {
  plan_.columns.stride = stride_;
  const auto rows = [&](int count) {
    return memory.take<Real>(static_cast<std::uint64_t>(count) *
                             static_cast<std::uint64_t>(stride_));
  };
  int most = kWindow;  // largest number of samples that a window needs in a band
  for (int b = bands_.count - 1; b > 0; --b) {
    most = most / 2 + kBorderRows;
    // Twice as many rows as needed, so that rows seldom have to be moved to the front.
    for (Held* const held : {&levels_[b].evens, &levels_[b].details}) {
      held->capacity = 2 * most;
      held->memory = rows(held->capacity);
      held->rows = held->memory;
    }
  }
  coarse_samples_ = rows(kCoarsest);
  zeros_ = rows(1);
  if (memory.holds()) std::fill_n(zeros_, stride_, Real{0});
}

template <typename Real>
bool Synthesis<Real>::has_details(int band) const {
  return band < bands_.count - plan_.bands_left_out && !signals_->is_empty(band);
}

template <typename Real>
const Real* Synthesis<Real>::even_row(int band, int i) const {
  const Held& evens = levels_[band].evens;
  return evens.rows + (i - evens.range.first) * stride_;
}

template <typename Real>
const Real* Synthesis<Real>::detail_row(int band, int i) const {
  if (!has_details(band)) return zeros_;
  const Held& details = levels_[band].details;
  return details.rows + (i - details.range.first) * stride_;
}

/// Keeps the held rows that lie within `range`, forgets earlier ones, and makes room for the rest
/// of the range. Forgets all rows if the range starts before them or leaves a gap after them.
template <typename Real>
void Synthesis<Real>::hold(Held& held, Range range) {
  if (range.first < held.range.first || range.first > held.range.end) {
    held.range = {range.first, range.first};
    held.rows = held.memory;
    return;
  }
  held.rows += (range.first - held.range.first) * stride_;
  held.range.first = range.first;
  const std::ptrdiff_t end = held.rows - held.memory + (range.end - range.first) * stride_;
  if (end <= held.capacity * stride_) return;
  std::copy(held.rows, held.rows + (held.range.end - held.range.first) * stride_, held.memory);
  held.rows = held.memory;
}

/// Finds the samples needed in each band, from the finest to the coarsest. An odd sample needs the
/// four even ones around it or, near a border, the outermost four. Samples that are held already
/// are not requested again.
template <typename Real>
void Synthesis<Real>::find_needs(int first, int count) {
  Range wanted = {first, first + count};
  for (int b = bands_.count - 1; b > 0; --b) {
    Level& level = levels_[b];
    level.wanted = wanted;
    if (wanted.is_empty()) continue;
    const int evens = bands_[b].first;
    Range need = {(wanted.first + 1) / 2, (wanted.end + 1) / 2};
    const int first_odd = wanted.first / 2;
    const int end_odd = wanted.end / 2;
    if (first_odd < end_odd) {
      need.first = std::min(need.first, std::max(std::min(first_odd - 1, evens - 4), 0));
      need.end = std::max(need.end, std::min(std::max(end_odd + 2, 4), evens));
    }
    level.needs_evens = need;
    hold(level.evens, need);
    wanted = {level.evens.range.end, need.end};
  }
  coarse_ = wanted;
}

template <typename Real>
void Synthesis<Real>::decode_window(int first, int count, Real* out, std::ptrdiff_t out_step) {
  find_needs(first, count);
  put_coarse(out, out_step);
  for (int b = 1; b < bands_.count; ++b) {
    Level& level = levels_[b];
    if (level.wanted.is_empty()) continue;
    // put_samples() of the previous band, or put_coarse(), has written these even samples.
    const Range added = {level.evens.range.end, level.needs_evens.end};
    if (has_details(b)) {
      unpack_details(b, added);
      update_evens(b, added);
    }
    level.evens.range.end = std::max(level.evens.range.end, added.end);
    if (b == bands_.count - 1)
      put_samples(b, out, out_step, plan_.count);
    else
      put_samples(b, evens_to_come(b + 1), stride_, stride_);
  }
}

/// The place for the samples of the next coarser band: they are the even samples of `band`.
template <typename Real>
Real* Synthesis<Real>::evens_to_come(int band) {
  Held& evens = levels_[band].evens;
  return evens.rows + (evens.range.end - evens.range.first) * stride_;
}

template <typename Real>
void Synthesis<Real>::put_coarse(Real* out, std::ptrdiff_t out_step) {
  if (coarse_.is_empty()) return;
  Real* const rows = bands_.count == 1 ? coarse_samples_ : evens_to_come(1);
  if (signals_->is_empty(0))
    std::fill_n(rows, (coarse_.end - coarse_.first) * stride_, Real{0});
  else
    signals_->unpack(0, coarse_.first, coarse_.end, plan_.columns, rows);
  if (bands_.count > 1) return;
  plan_.kernels->copy({.out = out,
                       .from = rows,
                       .out_step = out_step,
                       .stride = stride_,
                       .width = plan_.count,
                       .rows = coarse_.end - coarse_.first});
}

/// Unpacks the details that update the new even samples, and those of the odd samples to make.
template <typename Real>
void Synthesis<Real>::unpack_details(int band, Range new_evens) {
  Level& level = levels_[band];
  Range need = {level.wanted.first / 2, level.wanted.end / 2};
  if (!new_evens.is_empty()) {
    const int first = std::max(new_evens.first - 1, 0);
    need = need.is_empty() ? Range{first, new_evens.end}
                           : Range{std::min(need.first, first), std::max(need.end, new_evens.end)};
  }
  need.end = std::min(need.end, bands_[band].size);
  if (need.is_empty()) return;
  Held& details = level.details;
  hold(details, need);
  if (details.range.end >= need.end) return;
  signals_->unpack(band, details.range.end, need.end, plan_.columns,
                   details.rows + (details.range.end - details.range.first) * stride_);
  details.range.end = need.end;
}

/// Undoes the update step: subtracts what the encoder added to each even sample for the details
/// beside it.
template <typename Real>
void Synthesis<Real>::update_evens(int band, Range added) {
  const int odds = bands_[band].size;
  const int inner_end = std::min(added.end, odds);
  if (signals_->wavelet() == Wavelet::Haar) {
    // Both details are the one that follows, so this subtracts half of it. A last even sample
    // without a following detail stays as it is.
    update_rows(band, added.first, inner_end, 0, 0);
    return;
  }
  int i = added.first;
  // Details are mirrored at the borders.
  if (i == 0 && !added.is_empty()) update_rows(band, i++, 1, 0, 0);
  update_rows(band, i, inner_end, -1, 0);
  if (added.end > odds) update_rows(band, std::max(i, odds), added.end, -1, -1);
}

/// Updates even samples first ... end - 1. `before` and `after` are the positions of the adjacent
/// details, relative to the sample's own.
template <typename Real>
void Synthesis<Real>::update_rows(int band, int first, int end, int before, int after) {
  if (first >= end) return;
  const Held& evens = levels_[band].evens;
  Real* const rows = evens.rows + (first - evens.range.first) * stride_;
  plan_.kernels->update({.out = rows,
                         .even = rows,
                         .detail_before = detail_row(band, first + before),
                         .detail_after = detail_row(band, first + after),
                         .stride = stride_,
                         .rows = end - first});
}

/// Interleaves the held even samples with newly predicted odd ones.
template <typename Real>
void Synthesis<Real>::put_samples(int band, Real* out, std::ptrdiff_t out_step,
                                  std::ptrdiff_t width) {
  const Range wanted = levels_[band].wanted;
  const int first_even = (wanted.first + 1) / 2;
  plan_.kernels->copy({.out = out + (2 * first_even - wanted.first) * out_step,
                       .from = even_row(band, first_even),
                       .out_step = 2 * out_step,
                       .stride = stride_,
                       .width = width,
                       .rows = (wanted.end + 1) / 2 - first_even});
  const int first_odd = wanted.first / 2;
  put_odds(band, first_odd, wanted.end / 2, out + (2 * first_odd + 1 - wanted.first) * out_step,
           2 * out_step, width);
}

/// Predicts odd samples first ... end - 1; `out` is the row of the first.
template <typename Real>
void Synthesis<Real>::put_odds(int band, int first, int end, Real* out, std::ptrdiff_t out_step,
                               std::ptrdiff_t width) {
  const int inner_end = std::min(end, bands_[band].first - 2);
  int i = first;
  const auto put_borders = [&](int before) {
    for (; i < before; ++i, out += out_step) put_odd_at_border(band, i, out, width);
  };
  if (signals_->wavelet() != Wavelet::Haar) {
    put_borders(std::min(end, 1));
    const InnerWeights inner = inner_weights(signals_->wavelet());
    if (i < inner_end) {
      plan_.kernels->predict({.out = out,
                              .even = even_row(band, i - 1),
                              .detail = detail_row(band, i),
                              .out_step = out_step,
                              .stride = stride_,
                              .detail_step = has_details(band) ? stride_ : 0,
                              .width = width,
                              .rows = inner_end - i,
                              .near = static_cast<Real>(inner.near),
                              .far = static_cast<Real>(inner.far)});
      out += (inner_end - i) * out_step;
      i = inner_end;
    }
  }
  put_borders(end);
}

template <typename Real>
void Synthesis<Real>::put_odd_at_border(int band, int odd, Real* out, std::ptrdiff_t width) {
  const Wavelet wavelet = signals_->wavelet();
  const Neighbours neighbours = neighbours_of(wavelet, odd, bands_[band].first);
  BorderRow<Real> row{.out = out,
                      .even = {zeros_, zeros_, zeros_, zeros_},
                      .weight = {},
                      .detail = detail_row(band, odd),
                      .width = width};
  weights_of(wavelet, odd, neighbours, row.weight);
  for (int i = 0; i < neighbours.count; ++i) row.even[i] = even_row(band, neighbours.first + i);
  plan_.kernels->predict_at_border(row);
}

template class Synthesis<float>;
template class Synthesis<double>;

}  // namespace mocapress::runtime
