// SPDX-License-Identifier: MIT
#include "core/codec/encode/search/count_search.h"

#include <algorithm>
#include <cmath>

namespace mocapress {

CountSearch::CountSearch(int most, int first_guess, Window window, int most_trials)
    : count_(std::clamp(first_guess, 0, most)),
      window_(window),
      trials_left_(most_trials),
      below_{-1, 0, false},
      above_{most + 1, 0, false} {}

int CountSearch::next_count(double excess) {
  const double aim = (window_.low + window_.high) / 2;
  double guess = 0;
  if (below_.tried && above_.tried) {
    const double from = std::log1p(below_.count);
    const double to = std::log1p(above_.count);
    const double share = (aim - below_.excess) / (above_.excess - below_.excess);
    // Stays off the ends of the bracket, where noise in the trials would stall the search.
    guess = std::expm1(from + std::clamp(share, 0.05, 0.95) * (to - from));
  } else {
    guess = (count_ + 1) * std::exp(std::clamp(reach_ * (aim - excess), -2.0, 2.0)) - 1;
    reach_ *= 2;
  }
  return std::clamp(static_cast<int>(std::lround(guess)), below_.count + 1, above_.count - 1);
}

void CountSearch::tried(double excess) {
  const bool met = excess >= window_.low && excess <= window_.high;
  if (excess < window_.low) below_ = {count_, excess, true};
  if (excess > window_.high) above_ = {count_, excess, true};
  --trials_left_;
  done_ = met || trials_left_ <= 0 || above_.count - below_.count <= 1;
  if (!done_) count_ = next_count(excess);
}

}  // namespace mocapress
