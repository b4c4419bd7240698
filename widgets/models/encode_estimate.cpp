// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/encode_estimate.h"

#include <algorithm>
#include <cmath>

namespace mocapress {
namespace {

/// The number of passes that most clips take.
double usualPasses(const EncodeSettings& options) {
  const bool by_bound = is_by_worst(options.target);
  if (options.method == Method::Annealed) return by_bound ? 20 : 8;
  const double default_effort = by_bound ? 20 : 3;
  return options.effort == Effort::Best ? default_effort + 4 : default_effort;
}

double usualSweeps(const EncodeSettings& options) {
  return options.effort == Effort::Best ? 6 : 5;
}

/// Returns shares up to 0.8 unchanged; larger ones approach 1 without reaching it.
double neverQuiteOne(double share) {
  constexpr double kStraight = 0.8;
  if (share <= kStraight) return share;
  return 1 - (1 - kStraight) / (1 + (share - kStraight) / (1 - kStraight));
}

}  // namespace

double passProgress(const EncodeProgress& state) {
  if (state.first_step <= 0) return 0;
  return 1 - std::log2(state.step + 1) / std::log2(state.first_step + 1);
}

EncodeEstimate::EncodeEstimate(const EncodeSettings& options)
    : usual_passes_(usualPasses(options)), pass_length_(usualSweeps(options)) {}

void EncodeEstimate::add(const EncodeProgress& state, double seconds) {
  if (state.pass != pass_) {
    // A clip in segments makes a sweep for each segment: expect as many iterations as the longest
    // earlier pass had.
    pass_length_ = std::max<double>(pass_length_, iterations_);
    pass_ = state.pass;
    iterations_ = 0;
  }
  iterations_ = std::max(iterations_, state.iteration);
  const double of_pass =
      state.first_step > 0 ? passProgress(state) : neverQuiteOne(iterations_ / pass_length_);
  share_ = std::max(share_, neverQuiteOne((pass_ + of_pass) / usual_passes_));
  seconds_ = seconds;
}

std::optional<double> EncodeEstimate::secondsLeft() const {
  constexpr double kEnoughSeconds = 1;
  constexpr double kEnoughShare = 0.05;
  if (seconds_ < kEnoughSeconds || share_ < kEnoughShare) return {};
  return seconds_ * (1 - share_) / share_;
}

}  // namespace mocapress
