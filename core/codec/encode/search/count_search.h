// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// Finds the number of coefficients that meets a target. It takes as few trials as possible, for a
/// trial may be a whole annealing. The caller answers each count() with its excess: the logarithm
/// of the result over the target, signed so that it grows with the count. Bytes and 1 / error are
/// about proportional to a power of the count, so the search is linear in logarithms.
class CountSearch {
 public:
  struct Window {
    double low;  // an excess in [low, high] ends the search
    double high;
  };

  /// Counts are in [0, most].
  CountSearch(int most, int first_guess, Window window, int most_trials);

  bool done() const { return done_; }
  int count() const { return count_; }  // to be tried next
  void tried(double excess);

 private:
  struct Bound {
    int count;
    double excess;
    bool tried;  // its excess is known
  };

  int next_count(double excess);

  int count_;
  Window window_;
  int trials_left_;
  double reach_ = 1;  // grows while only one side of the target has been tried
  Bound below_;       // largest count known to give too little
  Bound above_;       // smallest count known to give too much
  bool done_ = false;
};

}  // namespace mocapress
