// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/wavelet/lifting.h"

namespace mocapress {

/// The magnitudes of a signal's coefficients, up to 255, for contexts that look at neighbours. Each
/// band is padded with zeros, so that neighbours beyond its ends read as zero.
class Magnitudes {
 public:
  static constexpr int kBefore = 4;  // zeros before each band; kAfter: behind it
  static constexpr int kAfter = 12;

  explicit Magnitudes(const std::vector<Band>& bands);

  /// Reads all coefficients of a signal.
  void read(const std::vector<Band>& bands, const int* signal);

  void set(int band, int i, int value) {
    bytes_[places_[static_cast<std::size_t>(band)] + static_cast<std::size_t>(i)] = of(value);
  }
  const std::uint8_t* in(int band) const {
    return bytes_.data() + places_[static_cast<std::size_t>(band)];
  }

 private:
  static std::uint8_t of(int value) {
    const int magnitude = value < 0 ? -value : value;
    return static_cast<std::uint8_t>(magnitude < 255 ? magnitude : 255);
  }

  std::vector<std::size_t> places_;  // where each band begins
  std::vector<std::uint8_t> bytes_;
};

/// Estimates the bits that the adaptive coder takes for a coefficient, by a geometric distribution.
/// Its mean grows with the two coefficients before and the two parents, which are the nearest in
/// the next coarser band. A distribution learned from the values would be closer to the coded bits,
/// but sweeps would end with 2 to 3 % more bytes: rare values would look so dear that no sweep
/// would try them.
class RateTable {
 public:
  /// The bands must outlive the table.
  explicit RateTable(const std::vector<Band>& bands) : bands_(bands) {}

  /// The bits of coefficient `i` of band `b` > 0 if it had this value.
  double bits(const Magnitudes& magnitudes, int b, int i, int value) const;

  /// The bits of coefficient `i` of band `b` for any value of it, plus those of the coefficients
  /// whose context it is part of. Looks up the neighbours once for all values.
  class Around {
   public:
    Around(const RateTable& table, const Magnitudes& magnitudes, int b, int i);
    double bits(int value) const;

   private:
    /// A coefficient whose expected size depends on the magnitude of coefficient `i`.
    struct Follower {
      int magnitude;
      int before, above;    // weighted magnitudes without coefficient `i`
      int share_of_before;  // factor of the magnitude of coefficient `i`
      int share_of_above;
    };
    int before_ = 0;
    int above_ = 0;
    int count_ = 0;           // number of followers
    bool is_lonely_ = false;  // all neighbours are zero and no end of a band is near
    std::array<Follower, 6> followers_;
  };

  /// The most bits that a move by one step towards zero can save, in the moved coefficient and its
  /// neighbours together.
  static constexpr double kMostSaved = 8.6;
  static constexpr double kMostSavedBeside = 3;

  /// The bits of a difference between two coarse samples.
  static double coarse_bits(int difference) {
    return 1 + 2 * std::log2(1.0 + 2 * std::abs(difference));
  }

  /// The bits of a whole signal. `magnitudes` are the signal's.
  double bits(const int* signal, const Magnitudes& magnitudes) const;

 private:
  struct Neighbours {
    int before = 0;  // weighted magnitudes
    int above = 0;
  };
  static Neighbours neighbours_of(const std::uint8_t* own, const std::uint8_t* upper, int i);
  const std::uint8_t* above(const Magnitudes& magnitudes, int b) const;

  const std::vector<Band>& bands_;
};

}  // namespace mocapress
