// SPDX-License-Identifier: MIT
#include "core/select/annealing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/random.h"

namespace mocapress {
namespace {

/// The signal that `count` more coefficients would add to a channel, cached while it stays valid.
struct Gain {
  int kept = -1;
  int count = 0;
  Eigen::VectorXd signal;
};

/// The vector m of Algorithm 1 (the coefficients that each channel keeps), with all that follows
/// from it.
class Allocation {
 public:
  Allocation(const RankedCoefficients& ranked, const ErrorModel& model, const Kept& start)
      : ranked_(ranked), kept_(start), state_(model), gains_(start.size()) {
    for (int c = 0; c < channels(); ++c)
      state_.add(c, -synthesise(ranked_, c, kept(c), ranked_.per_channel()));
  }

  int channels() const { return static_cast<int>(kept_.size()); }
  int kept(int channel) const { return kept_[channel]; }
  const Kept& all_kept() const { return kept_; }
  double eps() const { return std::sqrt(std::max(state_.squared_eps(), 0.0)); }

  void move(int channel, int count) {
    const int now = kept(channel);
    state_.add(channel, count > 0 ? synthesise(ranked_, channel, now, now + count)
                                  : -synthesise(ranked_, channel, now + count, now));
    kept_[channel] += count;
  }

  /// The channel in which `count` more coefficients lower the error most. `favourite` wins ties.
  int best_channel_for(int count, int favourite) {
    int best = favourite;
    double least = cost(favourite, count);
    for (int c = 0; c < channels(); ++c) {
      const double candidate = cost(c, count);
      if (candidate >= least) continue;
      best = c;
      least = candidate;
    }
    return best;
  }

 private:
  double cost(int channel, int count) {
    if (kept(channel) + count > ranked_.per_channel())
      return std::numeric_limits<double>::infinity();
    return state_.change(channel, gain(channel, count));
  }

  const Eigen::VectorXd& gain(int channel, int count) {
    Gain& gain = gains_[channel];
    if (gain.kept != kept(channel) || gain.count != count)
      gain = {kept(channel), count,
              synthesise(ranked_, channel, kept(channel), kept(channel) + count)};
    return gain.signal;
  }

  const RankedCoefficients& ranked_;
  Kept kept_;
  ErrorState state_;
  std::vector<Gain> gains_;
};

}  // namespace

AnnealingReport anneal(const RankedCoefficients& ranked, const ErrorModel& model, const Kept& start,
                       std::uint64_t seed, const Observer<AnnealingProgress>& observer) {
  constexpr int kFailuresPerStep = 10;  // failures in a row before the step is halved
  Allocation allocation(ranked, model, start);
  Random random(seed);
  AnnealingReport report;
  report.first_eps_cm = allocation.eps();
  const int most = start.empty() ? 0 : *std::ranges::max_element(start);
  const int first_step = most / 2;
  int failures = 0;
  for (int step = first_step; step > 0 && report.complete;) {
    const auto i =
        static_cast<int>(random.below(static_cast<std::uint64_t>(allocation.channels())));
    const int moved = std::min(step, allocation.kept(i));
    int j = i;
    if (moved > 0) {
      allocation.move(i, -moved);
      j = allocation.best_channel_for(moved, i);
      allocation.move(j, moved);
    }
    failures = j == i ? failures + 1 : 0;
    if (failures == kFailuresPerStep) {
      step /= 2;
      failures = 0;
    }
    ++report.iterations;
    report.complete = should_continue(
        observer, AnnealingProgress{report.iterations, step, first_step, allocation.eps()});
  }
  report.kept = allocation.all_kept();
  report.eps_cm = allocation.eps();
  return report;
}

}  // namespace mocapress
