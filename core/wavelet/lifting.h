// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 3, and
// W. Sweldens, "The lifting scheme: a construction of second generation wavelets", 1998.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/runtime/format/kinds.h"

namespace mocapress {

/// The interpolating wavelet bases.
using Basis = runtime::Wavelet;

/// "haar", "linear", "cubic".
std::string_view name(Basis basis);

/// A contiguous run of coefficients at one scale.
struct Band {
  int first;
  int size;
};

/// The wavelet transform for signals of one length, which may be any. Coefficients run from coarse
/// to fine: bands()[0] holds the coarse samples (fewer than 4), each further band holds the details
/// that double the resolution.
///
/// One level splits a signal into even and odd samples. Even neighbours predict each odd sample,
/// which keeps the difference (cubic: -1/16, 9/16, 9/16, -1/16; near the borders the Lagrange
/// polynomial through the nearest 4, beyond the last even sample a line through the last 2). A
/// quarter of the details beside it is then added to each even sample.
class Lifting {
 public:
  Lifting(Basis basis, int length);

  int length() const { return length_; }
  Basis basis() const { return basis_; }
  const std::vector<Band>& bands() const { return bands_; }

  /// Transform length() values and back; input and output may be the same memory.
  void forward(std::span<const double> samples, std::span<double> coefficients) const;
  void forward(std::span<const float> samples, std::span<float> coefficients) const;
  void inverse(std::span<const double> coefficients, std::span<double> samples) const;
  void inverse(std::span<const float> coefficients, std::span<float> samples) const;

  /// The transpose of inverse(): the inner product of a signal with each synthesis function.
  void correlate(std::span<const double> samples, std::span<double> products) const;
  void correlate(std::span<const float> samples, std::span<float> products) const;

  /// L2 norm of each coefficient's synthesis function, that is, of the signal that one unit of it
  /// adds.
  std::vector<double> norms() const;

  /// The norms of an orthonormal basis: 2^(depth / 2), with the finest details at depth 1 and the
  /// coarse samples at the depth of the coarsest details. Within a factor of 1.5 of norms(), and,
  /// unlike those, equal throughout a band: part of the file format.
  std::vector<double> gains() const;

 private:
  std::vector<double> norms_of_band(const Band& band) const;
  double norm(int coefficient) const;

  Basis basis_;
  int length_;
  std::vector<Band> bands_;
  std::vector<int> lengths_;  // signal length at each level, finest first
};

}  // namespace mocapress
