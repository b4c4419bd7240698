// SPDX-License-Identifier: MIT
#include "core/codec/encoder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/base/error.h"
#include "core/codec/clip_analysis.h"
#include "core/codec/count_search.h"
#include "core/codec/decoder.h"
#include "core/codec/deflate.h"
#include "core/codec/goal.h"
#include "core/select/annealing.h"

namespace mocapress {
namespace {

/// Some number of coefficients, chosen and coded.
struct Trial {
  CompressedClip compressed;
  int count = 0;
  int iterations = 0;
  bool complete = true;
  double achieved = 0;  // the quantity of the target
  double excess = 0;
};

/// Searches the number of coefficients that meets the target of one encode() call.
class TargetedEncode {
 public:
  TargetedEncode(const ClipAnalysis& analysis, const EncodeOptions& options,
                 const Observer<EncodeProgress>& observer)
      : analysis_(analysis),
        basis_(analysis.in(options.basis)),
        options_(options),
        observer_(observer),
        goal_(analysis.motion(), analysis.original_tracks(), options.target, options.weighting) {}

  Trial run() {
    const int guess = count_for(goal_.likely_coefficient_ratio());
    if (options_.target.kind == Target::Kind::CoefficientRatio)
      return attempt(options_.method, guess);
    if (options_.method != Method::Annealed) return search(options_.method, guess, kCheapTrials);
    // Standard selection costs next to nothing and needs about as many coefficients.
    return search(Method::Annealed, search(Method::Standard, guess, kCheapTrials).count,
                  kAnnealings);
  }

  /// Throws TargetMissed unless the trial is as good as was promised. Coding every coefficient in
  /// less space than asked for keeps the promise too.
  void check(const Trial& trial) const {
    const bool everything_kept = trial.count == basis_.ranked.total();
    if (options_.target.kind == Target::Kind::CoefficientRatio || goal_.met(trial.excess) ||
        (options_.target.kind == Target::Kind::Ratio && everything_kept && trial.excess < 0))
      return;
    char text[160];
    std::snprintf(text, sizeof text,
                  "the target of %.4g is out of reach with this method: the nearest is %.4g",
                  options_.target.value, trial.achieved);
    throw TargetMissed(text);
  }

 private:
  static constexpr int kCheapTrials = 24;
  static constexpr int kAnnealings = 10;

  int count_for(double coefficient_ratio) const {
    const double total = basis_.ranked.total();
    return static_cast<int>(std::lround(std::clamp(total / coefficient_ratio, 0.0, total)));
  }

  Trial search(Method method, int first_guess, int most_trials) {
    std::optional<Trial> best;
    CountSearch search(basis_.ranked.total(), first_guess, goal_.window(), most_trials);
    while (!search.done() && (!best || best->complete)) {
      Trial trial = attempt(method, search.count());
      search.tried(trial.excess);
      const bool complete = trial.complete;
      if (!best || !goal_.better(best->excess, trial.excess)) best = std::move(trial);
      best->complete = complete;  // a search cut short is not, whichever trial was the best
    }
    return std::move(*best);
  }

  Trial attempt(Method method, int count) {
    Trial trial;
    trial.count = count;
    const Kept kept = choose(method, trial);
    CompressedClip& compressed = trial.compressed;
    compressed.skeleton = analysis_.motion().skeleton;
    compressed.sample_rate_hz = analysis_.motion().clip.sample_rate_hz;
    compressed.frames = analysis_.motion().clip.frames();
    compressed.basis = options_.basis;
    compressed.coding = options_.coding;
    compressed.motion = basis_.rle16(kept);
    if (options_.coding == Coding::Deflate) compressed.motion = deflate_bytes(compressed.motion);
    trial.achieved = goal_.achieved(compressed.motion.size(), [&] { return decode(compressed); });
    trial.excess = goal_.excess(trial.achieved);
    return trial;
  }

  Kept choose(Method method, Trial& trial) {
    if (method == Method::PerChannel) return keep_per_channel(basis_.ranked, trial.count);
    const Kept standard = basis_.standard.keep(trial.count);
    if (method == Method::Standard) return standard;
    const auto observe = [&](const AnnealingProgress& p) {
      return go_on(observer_, EncodeProgress{pass_, p.iteration, p.step, p.first_step, p.eps_cm});
    };
    const AnnealingReport report = anneal(basis_.ranked, analysis_.model(options_.weighting),
                                          standard, {.seed = options_.seed}, observe);
    ++pass_;
    trial.iterations = report.iterations;
    trial.complete = report.complete;
    return report.kept;
  }

  const ClipAnalysis& analysis_;
  const BasisAnalysis& basis_;
  const EncodeOptions& options_;
  const Observer<EncodeProgress>& observer_;
  Goal goal_;
  int pass_ = 0;
};

}  // namespace

Encoder::Encoder(Motion motion) : analysis_(std::make_unique<ClipAnalysis>(std::move(motion))) {}
Encoder::~Encoder() = default;

const Motion& Encoder::motion() const {
  return analysis_->motion();
}
const Eigen::MatrixXd& Encoder::original_tracks() const {
  return analysis_->original_tracks();
}

Encoding Encoder::encode(const EncodeOptions& options,
                         const Observer<EncodeProgress>& observer) const {
  const auto start = std::chrono::steady_clock::now();
  TargetedEncode targeted(*analysis_, options, observer);
  Trial trial = targeted.run();
  if (trial.complete) targeted.check(trial);

  Encoding encoding;
  encoding.decoded = decode(trial.compressed);
  encoding.distortion = measure(motion().skeleton, original_tracks(), encoding.decoded);
  encoding.compressed = std::move(trial.compressed);
  encoding.compressed.provenance = {options.method, options.weighting, options.seed,
                                    static_cast<float>(encoding.distortion.eps(options.weighting)),
                                    static_cast<float>(encoding.distortion.max.cm)};
  encoding.coefficient_ratio =
      static_cast<double>(motion().clip.channels.size()) / std::max(trial.count, 1);
  encoding.iterations = trial.iterations;
  encoding.complete = trial.complete;
  encoding.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return encoding;
}

}  // namespace mocapress
