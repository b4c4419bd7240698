// SPDX-License-Identifier: MIT
#include "synthesis.h"

#include <algorithm>

namespace mocapress::decoder {
namespace {

constexpr int kBorderRows = 16;  // that a window may need beyond itself, at any band

/// The Lagrange polynomial through `count` samples at 0, 1, ... at `position`, as weights.
void lagrange_weights(int count, float position, float* weights) {
  for (int i = 0; i < count; ++i) {
    float weight = 1;
    for (int j = 0; j < count; ++j)
      if (j != i) weight *= (position - static_cast<float>(j)) / static_cast<float>(i - j);
    weights[i] = weight;
  }
}

}  // namespace

Synthesis::Synthesis(Memory& memory, const ResidentSignals& signals, const SynthesisPlan& plan)
    : signals_(signals),
      plan_(plan),
      bands_(signals.length()),
      stride_((plan.columns + 7) / 8 * 8) {
  const auto rows = [&](int count) {
    return memory.take<float>(static_cast<std::uint64_t>(count) *
                              static_cast<std::uint64_t>(stride_));
  };
  samples_ = rows(kWindow + kBorderRows);
  made_ = rows(kWindow + kBorderRows);
  details_ = rows(kWindow / 2 + kBorderRows);
  zeros_ = rows(1);
  if (memory.holds()) std::fill_n(zeros_, stride_, 0.0F);
}

bool Synthesis::has_details(int band) const {
  return band < bands_.count - plan_.bands_left_out && !signals_.is_empty(band);
}

/// An odd sample is predicted from the four even ones around it or, near a border, the outermost.
void Synthesis::find_needs(int first, int count) {
  needs_[bands_.count - 1] = {first, first + count};
  for (int b = bands_.count - 1; b > 0; --b) {
    const Range& need = needs_[b];
    const int evens = bands_[b].first;
    Range& above = needs_[b - 1];
    above = {(need.first + 1) / 2, (need.end + 1) / 2};
    const int first_odd = need.first / 2;
    const int end_odd = need.end / 2;
    if (first_odd == end_odd) continue;
    above.first = std::min(above.first, std::max(std::min(first_odd - 1, evens - 4), 0));
    above.end = std::max(above.end, std::min(std::max(end_odd + 2, 4), evens));
  }
}

float* Synthesis::window(int first, int count) {
  find_needs(first, count);
  const ResidentSignals::Columns columns{plan_.column_of_signal, signals_.steps(), stride_};
  if (signals_.is_empty(0))
    std::fill_n(samples_, (needs_[0].end - needs_[0].first) * stride_, 0.0F);
  else
    signals_.unpack(0, needs_[0].first, needs_[0].end, columns, samples_);
  int first_sample = needs_[0].first;  // that samples_ holds
  for (int b = 1; b < bands_.count; ++b) {
    const Range evens = needs_[b - 1];
    const float* const details = has_details(b) ? unpack_details(b, evens) : nullptr;
    const float* const coarse = samples_ + (evens.first - first_sample) * stride_;
    place_evens(b, evens, coarse, details, made_);
    place_odds(b, evens, details, made_);
    std::swap(samples_, made_);
    first_sample = 2 * evens.first;
  }
  return samples_ + (first - first_sample) * stride_;
}

const float* Synthesis::unpack_details(int band, Range evens) {
  const ResidentSignals::Columns columns{plan_.column_of_signal, signals_.steps(), stride_};
  const int end = std::min(evens.end, bands_[band].size);
  signals_.unpack(band, first_detail(evens), end, columns, details_);
  return details_;
}

/// Sample 2 i of the finer signal, for each i of `evens`, in every other row of `out`.
void Synthesis::place_evens(int band, Range evens, const float* coarse, const float* details,
                            float* out) {
  if (details == nullptr) {
    for (int i = evens.first; i < evens.end; ++i, coarse += stride_, out += 2 * stride_)
      std::copy_n(coarse, stride_, out);
    return;
  }
  const int odds = bands_[band].size;
  const int first_held = first_detail(evens);
  const auto place = [&](int first, int end, int before, int after) {  // details of `first`
    const auto row = [&](int detail) { return details + (detail - first_held) * stride_; };
    const std::ptrdiff_t at = (first - evens.first) * stride_;
    plan_.rows->update({.out = out + 2 * at,
                        .even = coarse + at,
                        .detail_before = row(before),
                        .detail_after = row(after),
                        .stride = stride_,
                        .rows = end - first});
  };
  const int inner_end = std::min(evens.end, odds);
  if (signals_.wavelet() == Wavelet::Haar) {
    // The mean less half of the detail after it; a last one without is as it was.
    if (evens.first < inner_end) place(evens.first, inner_end, evens.first, evens.first);
    if (evens.end > odds)
      std::copy_n(coarse + (odds - evens.first) * stride_, stride_,
                  out + 2 * (odds - evens.first) * stride_);
    return;
  }
  int i = evens.first;
  if (i == 0) place(i++, 1, 0, 0);  // mirrored at the borders
  if (i < inner_end) place(i, inner_end, i - 1, i);
  if (evens.end > odds) place(odds, odds + 1, odds - 1, odds - 1);
}

/// Sample 2 i + 1 for each i that the window needs, in the rows between.
void Synthesis::place_odds(int band, Range evens, const float* details, float* out) {
  const int end = needs_[band].end / 2;
  const int count_of_evens = bands_[band].first;
  const auto detail = [&](int i) {
    return details == nullptr ? zeros_ : details + (i - first_detail(evens)) * stride_;
  };
  int i = needs_[band].first / 2;
  if (signals_.wavelet() != Wavelet::Haar) {
    const bool cubic = signals_.wavelet() == Wavelet::Cubic;
    for (; i < std::min(end, 1); ++i) place_odd_at_border(band, i, evens, detail(i), out);
    const int inner_end = std::min(end, count_of_evens - 2);
    if (i < inner_end) {
      const std::ptrdiff_t at = 2 * (i - evens.first) * stride_;
      plan_.rows->predict({.out = out + at + stride_,
                           .even = out + at - 2 * stride_,
                           .detail = detail(i),
                           .stride = stride_,
                           .detail_stride = details == nullptr ? 0 : stride_,
                           .rows = inner_end - i,
                           .near = cubic ? 9.0F / 16 : 0.5F,
                           .far = cubic ? -1.0F / 16 : 0.0F});
      i = inner_end;
    }
  }
  for (; i < end; ++i) place_odd_at_border(band, i, evens, detail(i), out);
}

void Synthesis::place_odd_at_border(int band, int odd, Range evens, const float* detail,
                                    float* out) {
  const int available = bands_[band].first;
  const bool haar = signals_.wavelet() == Wavelet::Haar;
  const int wanted = haar ? 1 : signals_.wavelet() == Wavelet::Linear ? 2 : 4;
  const int count = std::min(wanted, available);
  const int first = haar ? odd : std::clamp(odd + 1 - count / 2, 0, available - count);
  BorderRow row{.out = out + (2 * (odd - evens.first) + 1) * stride_,
                .even = {zeros_, zeros_, zeros_, zeros_},
                .weight = {},
                .detail = detail,
                .stride = stride_};
  lagrange_weights(count, haar ? 0 : static_cast<float>(odd - first) + 0.5F, row.weight);
  for (int i = 0; i < count; ++i) row.even[i] = out + 2 * (first + i - evens.first) * stride_;
  plan_.rows->predict_at_border(row);
}

}  // namespace mocapress::decoder
