// SPDX-License-Identifier: MIT
#include "core/codec/encode/search/scale_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/codec/encode/search/count_search.h"

namespace mocapress {
namespace {

/// The trials of one search. Keeps the best: the cheapest that meets the target, or else the
/// nearest to it.
class ScaleSearch {
 public:
  ScaleSearch(const Goal& goal, const Target& target, const AttemptScale& attempt,
              const std::function<double()>& finest)
      : goal_(goal), target_(target), attempt_(attempt), finest_(finest) {}

  /// Returns the excess.
  double try_scale(double scale, ClosedLoopWork work) {
    constexpr double kChance = 0.1;  // typical difference between neighbouring scales
    return tried(attempt_(scale, work, {}), kChance);
  }
  /// Records a trial. `gain`: by how much the excess may still grow at the same scale.
  double tried(Trial trial, double gain = 0.5) {
    ++tried_;
    const double excess = trial.excess;
    const bool complete = trial.complete;
    is_out_of_reach_ = is_out_of_reach_ || falls_short_at_finest(trial, gain);
    if (!best_ || is_better(trial)) best_ = std::move(trial);
    best_->complete = complete;  // false if the search was stopped, whichever trial was the best
    return excess;
  }

  void prefer_cheap() { cheapest_ = true; }
  int tried() const { return tried_; }
  bool may_go_on() const { return !best_ || (best_->complete && !is_out_of_reach_); }
  bool met() const { return best_ && goal_.met(best_->excess); }
  bool is_near(const Trial& trial, double distance) const {
    return goal_.met(trial.excess) && std::abs(trial.excess) < distance;
  }
  bool is_near(double distance) const { return best_ && is_near(*best_, distance); }
  Trial& best() { return *best_; }

 private:
  bool is_better(const Trial& trial) const {
    if (cheapest_ && goal_.met(trial.excess) && goal_.met(best_->excess))
      return price(trial) < price(*best_);
    return !goal_.better(best_->excess, trial.excess);
  }

  /// Returns whether the trial has the finest scale but misses the target by more than `gain`. No
  /// trial will meet the target then.
  bool falls_short_at_finest(const Trial& trial, double gain) const {
    constexpr double kAlike = 1.01;
    return trial.excess < -gain && trial.scale <= kAlike * finest_();
  }

  /// The cost of a trial: its bytes if the target is an error, otherwise its error.
  double price(const Trial& trial) const {
    return is_error(target_) ? static_cast<double>(trial.compressed.motion_bytes()) : trial.eps_cm;
  }

  const Goal& goal_;
  const Target& target_;
  const AttemptScale& attempt_;
  const std::function<double()>& finest_;
  bool cheapest_ = false;
  bool is_out_of_reach_ = false;
  std::optional<Trial> best_;
  int tried_ = 0;
};

ClosedLoopWork work_of(Effort effort) {
  return effort == Effort::Draft ? ClosedLoopWork::Compensation : ClosedLoopWork::Sweeps;
}

constexpr double kPowerOfScale = 1.35;  // the scale grows with the error to this power

/// To correct an excess, the scale is multiplied by exp(excess) to this power.
double power_of_scale(const Target& target) {
  return is_error(target) ? kPowerOfScale : 1.7;
}

/// Predicts, from a rough trial's excess, how much coarser the scale is at which `work` meets the
/// target. The ratio of a rough trial's error or bytes to those of `work` differs little from clip
/// to clip (measured on corpus/train).
double coarser_after_rough_trial(double excess, const Target& target, ClosedLoopWork work,
                                 bool corrected) {
  const bool by_error = is_error(target);
  const bool swept = work == ClosedLoopWork::Sweeps;
  const double more = by_error ? (swept ? -0.575 : -0.32) : (swept ? 0.17 : 0.06);  // logarithms
  const double unmended = by_error && corrected ? 0.12 : 0;
  return std::exp(power_of_scale(target) * std::clamp(excess - more - unmended, -3.0, 3.0));
}

/// Excess at which the search may stop, because coarsening gains more than further trials.
double near_enough(const ScaleGuess& guess, const Target& target) {
  return guess.dear && target.kind == Target::Kind::MaxError ? 0.15 : 0.02;
}

/// Tries scales until the target is met. CountSearch needs a count that grows as the scale gets
/// finer. It is (kLength / scale)^kPower, to which 1 / error and bytes are about proportional.
void seek(const ScaleGuess& guess, const Goal& goal, double first_scale, double near_enough,
          ClosedLoopWork work, ScaleSearch& trials) {
  constexpr double kLength = 1e6;  // maps scales to counts, cm
  constexpr double kPower = 0.7;
  constexpr double kNear = 0.02;  // a trial this close ends the search at once
  constexpr int kFew = 2;
  constexpr int kMany = 4;
  constexpr int kManyMore = 6;  // after so many trials, any that meets the target will do
  constexpr int kMost = 12;
  constexpr double kBeside = 0.01;
  const auto count_of = [](double scale) {
    // A clip without frames has a NaN scale.
    return static_cast<int>(std::fmin(std::fmax(std::pow(kLength / scale, kPower), 1), 1e9));
  };
  // The results of neighbouring scales differ by chance as much as by scale, so a narrow window may
  // stay empty.
  const auto will_do = [&] {
    return trials.is_near(kNear) ||
           (trials.is_near(near_enough) && trials.tried() >= (guess.dear ? kFew : kMany)) ||
           (trials.met() && trials.tried() >= kManyMore);
  };
  CountSearch search(count_of(guess.finest()), count_of(first_scale), goal.window(), kMost);
  while (!search.done() && trials.may_go_on() && !will_do()) {
    const double scale = kLength / std::pow(std::max(search.count(), 1), 1 / kPower);
    search.tried(trials.try_scale(scale, work));
  }
  // The search may have closed in on a jump of the excess. Scales beside it may meet the target by
  // chance.
  const double middle = trials.best().scale;
  for (int i = 1; i <= kMost && trials.may_go_on() && !trials.met(); ++i) {
    const int steps_away = i % 2 == 0 ? -(i / 2) : (i + 1) / 2;
    trials.try_scale(middle * (1 + kBeside * steps_away), work);
  }
}

/// Settles a trial at the first scale, then settles it again with a corrected aim until it is near
/// the target.
void settle(const ScaleTrials& trials, const Target& target, double first_scale,
            ScaleSearch& search) {
  constexpr int kMost = 8;  // trials of one or two sweeps each, far cheaper than those of seek()
  constexpr double kFar = 0.05;  // a logarithm
  const bool by_error = target.kind == Target::Kind::Error;
  const double near = by_error ? 0.01 : 0.02;  // close enough; bytes differ more by chance
  double middle = 0;                           // middle of the range that is close enough
  if (by_error) middle = near / 4;
  if (target.kind == Target::Kind::Size) middle = -near / 2;
  const double power = power_of_scale(target) / kPowerOfScale;
  const auto settle_at = [&](double scale, double aim_cm) {
    return by_error ? trials.settle(aim_cm, scale, nullptr)
                    : trials.attempt(scale, ClosedLoopWork::Sweeps, {});
  };
  double aim_cm = target.value;
  Trial trial = settle_at(first_scale, aim_cm);
  if (!by_error) aim_cm = trial.eps_cm;
  search.tried(trial);
  for (int i = 1; i < kMost && search.may_go_on() && !search.is_near(trial, near); ++i) {
    if (trial.eps_cm <= 0) break;  // nothing moves
    const double coarser = power * (trial.excess - middle);
    const double before_cm = std::exchange(aim_cm, trial.eps_cm * std::exp(coarser));
    // A trial this far off (such as with joints of more importance) needs another scale, not only
    // another bit price.
    const bool is_far = std::abs(std::log(aim_cm / before_cm)) > kFar;
    trial =
        is_far ? settle_at(by_error ? trial.scale : trial.scale * std::exp(kPowerOfScale * coarser),
                           aim_cm)
               : trials.settle(aim_cm, trial.scale, &trial);
    search.tried(trial);
  }
}

/// Tries a few more scales at which the target should just be met, and keeps the cheapest: results
/// differ by chance.
void try_harder(const Target& target, ClosedLoopWork work, ScaleSearch& trials) {
  constexpr int kTrials = 4;
  constexpr double kAside = 0.003;  // distance between the scales tried
  trials.prefer_cheap();
  double scale = trials.best().scale;
  for (int i = 0; i < kTrials && trials.may_go_on(); ++i) {
    const double excess = trials.try_scale(scale, work);
    scale *= std::exp(power_of_scale(target) * excess - kAside);
  }
}

/// Settles trials at a few scales beside the best trial's, and keeps the cheapest.
void settle_beside(const ScaleTrials& trials, const Target& target, ScaleSearch& search) {
  search.prefer_cheap();
  const double scale = search.best().scale;
  for (const double coarser : {0.92, 0.96, 1.04, 1.08})
    if (search.may_go_on()) settle(trials, target, coarser * scale, search);
}

/// Tries larger scales with more weight on the frames that exceed the bound. Replaces `best` if the
/// result is smaller.
void hold_worst_frames(const Goal& goal, int frames, ClosedLoopWork work,
                       const AttemptScale& attempt, Trial& best) {
  constexpr int kRounds = 10;
  constexpr double kLeastStep = 1.04;
  for (double step = 1.3; step > kLeastStep;) {
    const double scale = step * best.scale;
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(frames);
    bool held = false;
    for (int round = 0; round < kRounds && !held; ++round) {
      Trial trial = attempt(scale, work, weights);
      best.complete = trial.complete;
      if (!trial.complete) return;
      // More weight takes more bytes: a trial that is no smaller already is given up.
      if (trial.compressed.motion_bytes() >= best.compressed.motion_bytes()) break;
      held = goal.met(trial.excess);
      if (!held) {
        goal.raise_where_exceeded(trial.compressed, weights);
        continue;
      }
      best = std::move(trial);
    }
    if (!held) step = std::sqrt(step);
  }
}

/// Coarsens the best trial until its errors come close to the bound. Coarsening does not see the IK
/// correction, which changes the errors, so each frame gets a bound of its own, adjusted in each
/// round by the errors that were measured with the correction.
void approach_bound(const Goal& goal, const Target& target, int frames, const CoarsenTrial& coarsen,
                    Trial& best) {
  constexpr int kMost = 24;
  constexpr int kMostInVain = 6;
  constexpr double kNear = 0.01;
  constexpr double kAlike = 0.005;    // share of the bytes by which a nearer trial may be larger
  constexpr double kRounding = 1e-4;  // between the coarsened and the decoded motion
  constexpr double kMostWider = 1.1;  // limit of widening a frame's bound in one round
  constexpr double kTighter = 0.6;    // exponent on the excess when tightening every bound
  constexpr double kMostTighter =
      0.012;  // limit of that tightening once the bound has held, as few frames exceed it then
  constexpr double kWidest = 2;         // times the target
  constexpr Eigen::Index kBeside = 16;  // frames reached by a change at one of them
  const Eigen::VectorXd asked_cm = goal.bounds(frames);
  Eigen::VectorXd bound_cm = (1 - kRounding) * asked_cm;
  int in_vain = 0;  // rounds without a gain
  bool has_held = false;
  for (int i = 0; i < kMost && in_vain < kMostInVain; ++i) {
    Trial coarser = coarsen(best, bound_cm);
    best.complete = coarser.complete;
    if (!coarser.complete) return;
    const bool met = goal.met(coarser.excess);
    const bool is_near = met && coarser.excess <= kNear;
    const Eigen::ArrayXd room =
        (1 - kNear / 2) * target.value /
        goal.worst_of_frames(coarser.compressed).array().max(1e-9 * target.value);
    for (Eigen::Index t = 0; t < frames; ++t) {
      const Eigen::Index first = std::max<Eigen::Index>(t - kBeside, 0);
      const Eigen::Index end = std::min<Eigen::Index>(t + kBeside + 1, frames);
      bound_cm(t) *= std::min(room.segment(first, end - first).minCoeff(), met ? kMostWider : 1);
    }
    const double tighter = kTighter * std::min(coarser.excess, 0.0);
    bound_cm *= std::exp(has_held ? std::max(tighter, -kMostTighter) : tighter);
    has_held = has_held || met;
    bound_cm = bound_cm.cwiseMin(kWidest * asked_cm);
    const double bytes = static_cast<double>(coarser.compressed.motion_bytes()) /
                         static_cast<double>(best.compressed.motion_bytes());
    const bool gets_near = is_near && best.excess > kNear;
    const bool is_better = met && bytes < (gets_near ? 1 + kAlike : 1);
    in_vain = is_better || !has_held ? 0 : in_vain + 1;
    if (is_better) best = std::move(coarser);
    if (is_near && best.excess <= kNear) return;
  }
}

}  // namespace

Trial search_scale(const ScaleGuess& guess, const Target& target, const Goal& goal, Effort effort,
                   int frames, const ScaleTrials& trials) {
  const ClosedLoopWork work = work_of(effort);
  // If a rough trial is this much too coarse, its prediction falls short, so another rough trial
  // follows. It costs a quarter of a trial with sweeps.
  constexpr double kFarTooCoarse = -3;
  constexpr int kMostRough = 4;
  double first_scale = guess.likely;
  for (int i = 0; i < kMostRough; ++i) {
    const Trial rough = trials.attempt(first_scale, ClosedLoopWork::Rounding, {});
    if (!rough.complete) return rough;
    first_scale *= coarser_after_rough_trial(rough.excess, target, work, guess.corrected);
    if (!(rough.excess < kFarTooCoarse)) break;
  }
  if (effort == Effort::Draft) return trials.attempt(first_scale, work, {});
  constexpr double kSettledNear = 0.02;
  ScaleSearch search(goal, target, trials.attempt, guess.finest);
  if (trials.settle) settle(trials, target, first_scale, search);
  if (!search.is_near(kSettledNear))
    seek(guess, goal, trials.settle ? search.best().scale : first_scale, near_enough(guess, target),
         work, search);
  if (effort == Effort::Best && search.met()) {
    if (trials.settle)
      settle_beside(trials, target, search);
    else
      try_harder(target, work, search);
  }
  if (is_by_worst(target) && search.may_go_on()) {
    if (!guess.dear) hold_worst_frames(goal, frames, work, trials.attempt, search.best());
    if (target.kind == Target::Kind::MaxError && search.may_go_on())
      approach_bound(goal, target, frames, trials.coarsen, search.best());
  }
  return std::move(search.best());
}

}  // namespace mocapress
