// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/wavelet/lifting.h"

namespace mocapress {

/// How large the coefficients of a signal are, up to 255: for what depends on neighbours. Each band
/// lies between zeros, so that neighbours beyond its ends are zero too.
class Magnitudes {
 public:
  static constexpr int kBefore = 4;  // zeros that may be looked at
  static constexpr int kAfter = 12;

  explicit Magnitudes(const std::vector<Band>& bands);

  /// Those of all coefficients.
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

  std::vector<std::size_t> places_;  // of bands
  std::vector<std::uint8_t> bytes_;
};

/// About how many bits the adaptive coding takes for a coefficient. The estimate is a geometric law
/// whose mean follows the two coefficients before and the two parents. A law learned from the
/// values would be nearer to the coded bits, but sweeps would end with 2 to 3 % more of them: rare
/// values would cost so much that no sweep would try them.
class RateTable {
 public:
  /// The bands must outlive the table.
  explicit RateTable(const std::vector<Band>& bands) : bands_(bands) {}

  /// The bits of coefficient `i` of band `b` > 0 if it were `value`.
  double bits(const Magnitudes& magnitudes, int b, int i, int value) const;

  /// The bits of a coefficient, were it one value or another, plus those of the coefficients that
  /// it is a neighbour of: looked up around it once, for several values.
  class Around {
   public:
    Around(const RateTable& table, const Magnitudes& magnitudes, int b, int i);
    double bits(int value) const;

   private:
    /// A coefficient whose mean follows this one's magnitude, besides what else it follows.
    struct Follower {
      int magnitude;
      int before, above;    // without this one's share
      int share_of_before;  // times its magnitude
      int share_of_above;
    };
    int before_ = 0;
    int above_ = 0;
    int count_ = 0;           // of followers
    bool is_lonely_ = false;  // all around it is zero, nor is it near the ends of a band
    std::array<Follower, 6> followers_;
  };

  /// No move by one step towards zero saves more, or more in the coefficients beside it.
  static constexpr double kMostSaved = 8.6;
  static constexpr double kMostSavedBeside = 3;

  /// The bits of a difference between coarse samples.
  static double coarse_bits(int difference) {
    return 1 + 2 * std::log2(1.0 + 2 * std::abs(difference));
  }

  /// The bits of a whole signal, and of its magnitudes.
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
