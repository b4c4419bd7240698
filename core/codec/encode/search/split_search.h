// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace mocapress {

/// The result of one split of the bytes between motion and IK correction.
struct Split {
  double ratio;     // r_IK: see EncodeCorrection::ratio
  double price;     // the quantity that the target leaves free: bytes, or eps_x in cm
  double slide_cm;  // footskate
  double worst_cm;  // slide of the worst contact
};

/// Finds the cheapest r_IK that removes nine tenths of the slide, or leaves no contact more than a
/// millimetre of it. If none does, it finds the one with the least slide. Price and slide come from
/// whole encodes, so the search takes few of them. It starts at the paper's 16 and goes by factors
/// of two: up until the feet are no longer held, down until the price rises; where 16 does not hold
/// them, the coarsest is tried before finer ones. Then it takes finer steps between the best ratio
/// and the next larger one that was tried.
class SplitSearch {
 public:
  static constexpr double kFirst = 16;  // as in the paper's video
  static constexpr double kMost = 64;
  static constexpr double kLeast = 1;

  /// `slide_without_cm`: footskate of the same encode without a correction.
  SplitSearch(double slide_without_cm, int finer_steps);

  /// The r_IK to try next; empty when the search is over.
  std::optional<double> next() const;

  /// Records the result of an r_IK that was tried; returns whether it is the best so far. The price
  /// of a target that was missed is infinite.
  bool tried(const Split& split);

  const Split& best() const { return best_; }

 private:
  bool holds(const Split& split) const;
  bool is_better(const Split& split) const;

  double enough_cm_;
  int finer_steps_;
  std::vector<Split> tried_;  // by r_IK
  Split best_;
};

}  // namespace mocapress
