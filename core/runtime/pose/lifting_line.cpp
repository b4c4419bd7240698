// SPDX-License-Identifier: MIT
#include "core/runtime/pose/lifting_line.h"

#include "core/runtime/format/bands.h"
#include "core/runtime/format/interpolation.h"

namespace mocapress::runtime {
namespace {

double predicted(Wavelet wavelet, int odd, const double* evens, int even_count) {
  const Neighbours neighbours = neighbours_of(wavelet, odd, even_count);
  double weights[kMostNeighbours];
  weights_of(wavelet, odd, neighbours, weights);
  double sum = 0;
  for (int i = 0; i < neighbours.count; ++i) sum += weights[i] * evens[neighbours.first + i];
  return sum;
}

/// The number that the update step adds to an even sample, for the details beside it.
double update(Wavelet wavelet, int even, const double* details, int odd_count) {
  if (wavelet == Wavelet::Haar) return even < odd_count ? 0.5 * details[even] : 0;
  const double after = details[even < odd_count ? even : even - 1];
  const double before = details[even > 0 ? even - 1 : 0];
  return 0.25 * (before + after);
}

}  // namespace

void split_line(Wavelet wavelet, int length, const double* samples, double* evens,
                double* details) {
  const int even_count = evens_in(length);
  const int odd_count = odds_in(length);
  for (int i = 0; i < even_count; ++i) evens[i] = samples[2 * i];
  for (int i = 0; i < odd_count; ++i)
    details[i] = samples[2 * i + 1] - predicted(wavelet, i, evens, even_count);
  for (int i = 0; i < even_count; ++i) evens[i] += update(wavelet, i, details, odd_count);
}

void join_line(Wavelet wavelet, int length, double* evens, const double* details, double* samples) {
  const int even_count = evens_in(length);
  const int odd_count = odds_in(length);
  for (int i = 0; i < even_count; ++i) evens[i] -= update(wavelet, i, details, odd_count);
  for (int i = 0; i < even_count; ++i) samples[2 * i] = evens[i];
  for (int i = 0; i < odd_count; ++i)
    samples[2 * i + 1] = details[i] + predicted(wavelet, i, evens, even_count);
}

}  // namespace mocapress::runtime
