// SPDX-License-Identifier: MIT
#include "core/codec/targeted_encode.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/codec/count_search.h"
#include "core/codec/decoder.h"
#include "core/codec/goal.h"
#include "core/codec/scale_search.h"
#include "core/codec/segmented_encode.h"
#include "core/codec/trial.h"
#include "core/metrics/rate.h"
#include "core/select/annealing.h"

namespace mocapress {
namespace {

/// Searches the number of coefficients that meets the target of one encode() call.
class TargetedEncode {
 public:
  TargetedEncode(const ClipAnalysis& analysis, const EncodeOptions& options,
                 const Observer<EncodeProgress>& observer)
      : analysis_(analysis),
        coefficients_(analysis.coefficients(options.basis)),
        options_(options),
        observer_(observer),
        contacts_(contacts_for(analysis, options)),
        goal_(original_of(analysis), options.target, options.weighting) {
    const Motion& motion = analysis.motion();
    const bool heeds_model =
        options.method == Method::Annealed || options.method == Method::ClosedLoop;
    if (heeds_model && !options.importance.is_even()) emphasise(options.importance);
    if (!options.correction) return;
    correction_.emplace(motion.skeleton, analysis.original_tracks(), *options.correction, contacts_,
                        motion.clip.sample_rate_hz);
    correction_ratio_ = options.correction->ratio.value_or(kUsualCorrectionRatio);
    if (!heeds_model) return;
    if (!own_model_) own_model_ = analysis.model(options.weighting);
    for (const auto& response : correction_->responses(motion.clip, analysis.original_tracks()))
      own_model_->add(response);
  }

  double correction_ratio() const { return correction_ratio_; }

  Trial run() {
    const int guess = count_for(goal_.likely_coefficient_ratio());
    if (correction_ && !options_.correction->ratio) correction_ratio_ = find_split(guess);
    if (options_.method == Method::ClosedLoop) return closed_loop();
    if (options_.target.kind == Target::Kind::CoefficientRatio)
      return attempt(options_.method, guess);
    if (options_.method != Method::Annealed) return search(options_.method, guess, kCheapTrials);
    // Standard selection costs next to nothing and needs about as many coefficients.
    return search(Method::Annealed, search(Method::Standard, guess, kCheapTrials).count,
                  kAnnealings);
  }

  /// Throws TargetMissed unless the trial is as good as was promised; a draft promises nothing.
  /// Coding every coefficient in less space than asked for keeps the promise too.
  void check(const Trial& trial) const {
    if (options_.method == Method::ClosedLoop && options_.effort == Effort::Draft) return;
    const bool by_count = options_.target.kind == Target::Kind::CoefficientRatio &&
                          options_.method != Method::ClosedLoop;  // met by construction
    if (!by_count)
      goal_.require_met(trial.excess, trial.achieved, trial.count == coefficients_.total());
  }

  /// The closed loop at one scale, not weighed against the target.
  ScaleTrial run_at(double scale, const ClosedLoopWork& work,
                    const Eigen::VectorXd& frame_weights) {
    return {code_at(scale, work, frame_weights), loop().finest_scale()};
  }

  Trial coarsen(QuantisedSignals coded, double bound_cm) {
    ErrorBound bound(analysis_.motion().skeleton, analysis_.original_tracks(), bound_cm);
    const double scale = coded.scale;
    drop_correction(coded);
    Trial coarser = trial_of(loop().coarsen(std::move(coded), bound, observe_pass()), true);
    coarser.scale = scale;
    return coarser;
  }

  double split() { return find_split(count_for(goal_.likely_coefficient_ratio())); }

 private:
  static constexpr int kCheapTrials = 24;
  static constexpr int kAnnealings = 10;
  static constexpr double kUsualCorrectionRatio = 16;  // of the paper's video

  /// The order of the coefficients, which only the paper's methods ask for.
  const BasisAnalysis& basis() const { return analysis_.in(options_.basis); }

  /// What errors of the motion cost: some joints more, what a correction makes good less.
  const ErrorModel& model() const {
    return own_model_ ? *own_model_ : analysis_.model(options_.weighting);
  }

  void emphasise(const Importance& importance) {
    const Motion& motion = analysis_.motion();
    own_model_.emplace(motion.skeleton, motion.clip,
                       important_weights(motion.skeleton, options_.weighting, importance));
    if (importance.contacts == 0) return;
    for (const auto& point : standing_points(motion.skeleton, analysis_.original_tracks(),
                                             contacts_, importance.contacts))
      own_model_->add(point);
  }

  int count_for(double coefficient_ratio) const {
    const double total = coefficients_.total();
    return static_cast<int>(std::lround(std::clamp(total / coefficient_ratio, 0.0, total)));
  }

  /// The r_IK of the least footskate among those that cost no more than a fifth: of the error where
  /// the size is asked for, of the size where the error is. Where both would follow from r, the
  /// usual one.
  double find_split(int guess) {
    constexpr double kDearest = 1.2;
    if (options_.target.kind == Target::Kind::CoefficientRatio) return kUsualCorrectionRatio;
    correcting_ = false;
    const Split without = measure_split(guess);
    correcting_ = true;
    double found = 0;
    double least_cost = std::numeric_limits<double>::infinity();
    for (const double ratio : {64.0, 45.0, 32.0, 23.0, 16.0, 11.0, 8.0, 5.6, 4.0}) {
      correction_ratio_ = ratio;
      const Split split = measure_split(guess);
      const double dearer = split.price / without.price;
      // Beyond what may be paid the cheapest is best, after all that may be.
      const double cost = dearer <= kDearest ? split.footskate_cm : 1e6 * dearer;
      if (cost >= least_cost) continue;
      found = ratio;
      least_cost = cost;
    }
    return found;
  }

  struct Split {
    double price;  // eps_x in cm, or bytes where eps_x is the target
    double footskate_cm;
  };

  /// With the present r_IK and standard selection.
  Split measure_split(int guess) {
    const Trial trial = search(Method::Standard, guess, kCheapTrials);
    const Motion& motion = analysis_.motion();
    const Clip decoded = decode(trial.compressed);
    const bool size_is_asked =
        options_.target.kind == Target::Kind::Ratio || options_.target.kind == Target::Kind::Size;
    const double price = size_is_asked ? exact_eps(motion.skeleton, analysis_.original_tracks(),
                                                   decoded, options_.weighting)
                                       : static_cast<double>(trial.compressed.motion_bytes());
    return {std::max(price, 1e-9),
            measure_footskate(contacts_, analysis_.original_tracks(),
                              landmark_tracks(motion.skeleton, decoded), decoded.sample_rate_hz)
                .total_cm};
  }

  Trial search(Method method, int first_guess, int most_trials) {
    std::optional<Trial> best;
    CountSearch search(coefficients_.total(), first_guess, goal_.window(), most_trials);
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
    trial.compressed = empty_clip();
    CompressedClip& compressed = trial.compressed;
    if (is_of_words(compressed.coding)) {
      std::vector<std::byte> words = code_signals(basis().ranked, basis().scales, kept);
      if (correction_ && correcting_) append_correction(words, compressed);
      compressed.motion = pack(words, compressed.coding);
    } else {
      finish(quantise_kept(basis().ranked, basis().scales, kept, 1), compressed);
    }
    weigh(trial);
    return trial;
  }

  /// Codes quantised channels, with the correction they need.
  void finish(QuantisedSignals coded, CompressedClip& compressed) const {
    if (correction_ && correcting_) {
      const Clip reconstructed{compressed.sample_rate_hz,
                               reconstruct(coded, coefficients_.lifting)};
      const auto lacking = correction_->select(reconstructed, correction_ratio_, options_.basis);
      append(quantise_kept(lacking.ranked, lacking.scales(), lacking.kept, coded.scale), coded);
      compressed.correction = correction_->correction();
    }
    compressed.motion = pack_adaptive(coded, compressed);
  }

  void weigh(Trial& trial) const {
    const CompressedClip& compressed = trial.compressed;
    trial.achieved = options_.target.kind == Target::Kind::CoefficientRatio
                         ? static_cast<double>(coefficients_.total()) / std::max(trial.count, 1)
                         : goal_.achieved(compressed);
    trial.excess = goal_.excess(trial.achieved);
  }

  CompressedClip empty_clip() const {
    const Motion& motion = analysis_.motion();
    return {.skeleton = motion.skeleton,
            .sample_rate_hz = motion.clip.sample_rate_hz,
            .frames = motion.clip.frames(),
            .basis = options_.basis,
            .coding = options_.coding};
  }

  const ClosedLoop& loop() {
    if (!own_model_) return analysis_.closed_loop(options_.basis, options_.weighting);
    if (!own_loop_) own_loop_.emplace(coefficients_, analysis_.motion().clip, *own_model_);
    return *own_loop_;
  }

  Trial closed_loop() {
    const ScaleTrials trials{
        .attempt =
            [this](double scale, const ClosedLoopWork& work, const Eigen::VectorXd& weights) {
              return attempt_scale(scale, work, weights);
            },
        .coarsen =
            [this](const Trial& trial, double bound_cm) {
              Trial coarser = coarsen(AdaptiveSegments(trial.compressed).next(), bound_cm);
              weigh(coarser);
              return coarser;
            }};
    const ScaleGuess guess{
        .likely = likely_scale(options_.target, raw_bytes(analysis_.motion().clip)),
        .finest = [&] { return loop().finest_scale(); }};
    return search_scale(guess, options_.target, goal_, options_.effort,
                        analysis_.motion().clip.frames(), trials);
  }

  Trial attempt_scale(double scale, const ClosedLoopWork& work,
                      const Eigen::VectorXd& frame_weights) {
    const bool model_will_do = options_.effort == Effort::Draft &&
                               options_.target.kind == Target::Kind::Error && !own_model_;
    const bool is_rough = !work.compensate;  // its coding is not asked for
    Trial trial = code_at(scale, work, frame_weights, !model_will_do || !is_rough);
    if (model_will_do) {
      trial.achieved = trial.eps_cm;  // near enough, and there already
      trial.excess = goal_.excess(trial.achieved);
    } else {
      weigh(trial);
    }
    return trial;
  }

  Trial code_at(double scale, const ClosedLoopWork& work, const Eigen::VectorXd& frame_weights,
                bool with_bytes = true) {
    Trial trial = trial_of(loop().quantise(scale, work, frame_weights, observe_pass()), with_bytes);
    trial.scale = scale;
    return trial;
  }

  /// It is made anew for what is coarser.
  void drop_correction(QuantisedSignals& coded) const {
    const int channels = coefficients_.channels();
    coded.values.conservativeResize(Eigen::NoChange, channels);
    coded.fineness.resize(static_cast<std::size_t>(channels));
  }

  Observer<ClosedLoopProgress> observe_pass() {
    return [this, pass = pass_++](const ClosedLoopProgress& p) {
      return go_on(observer_,
                   EncodeProgress{.pass = pass, .iteration = p.sweep, .eps_cm = p.eps_cm});
    };
  }

  Trial trial_of(ClosedLoop::Result result, bool with_bytes) {
    Trial trial{.compressed = empty_clip(),
                .count = static_cast<int>((result.coded.values.array() != 0).count()),
                .eps_cm = result.eps_cm,
                .iterations = result.sweeps,
                .complete = result.complete};
    if (with_bytes) finish(std::move(result.coded), trial.compressed);
    return trial;
  }

  /// What is corrected is the motion as it will be decoded.
  void append_correction(std::vector<std::byte>& words, CompressedClip& compressed) const {
    const Motion& motion = analysis_.motion();
    ByteReader reader(words);
    const Clip reconstructed{motion.clip.sample_rate_hz,
                             read_signals(reader, options_.basis, motion.clip.frames(),
                                          motion.skeleton.channel_count())};
    const auto lacking = correction_->select(reconstructed, correction_ratio_, options_.basis);
    const auto differences = code_signals(lacking.ranked, lacking.scales(), lacking.kept);
    words.insert(words.end(), differences.begin(), differences.end());
    compressed.correction = correction_->correction();
  }

  Kept choose(Method method, Trial& trial) {
    if (method == Method::PerChannel) return keep_per_channel(basis().ranked, trial.count);
    const Kept standard = basis().standard.keep(trial.count);
    if (method == Method::Standard) return standard;
    const AnnealingReport report = best_annealing(standard);
    trial.iterations = report.iterations;
    trial.complete = report.complete;
    return report.kept;
  }

  /// Where one annealing ends depends on chance by some 10 %. Short clips, whose annealings take
  /// next to no time, get several.
  AnnealingReport best_annealing(const Kept& standard) {
    constexpr int kMost = 8;
    constexpr int kSamples = 80'000;  // of all of them together
    const int annealings = std::clamp(kSamples / std::max(coefficients_.total(), 1), 1, kMost);
    const auto observe = [&](const AnnealingProgress& p) {
      return go_on(observer_, EncodeProgress{pass_, p.iteration, p.step, p.first_step, p.eps_cm});
    };
    AnnealingReport best;
    for (int i = 0; i < annealings && best.complete; ++i, ++pass_) {
      AnnealingReport report =
          anneal(basis().ranked, model(), standard,
                 {.seed = options_.seed + static_cast<std::uint64_t>(i)}, observe);
      if (i > 0 && report.eps_cm >= best.eps_cm)
        best.complete = report.complete;
      else
        best = std::move(report);
    }
    return best;
  }

  const ClipAnalysis& analysis_;
  const Coefficients& coefficients_;
  const EncodeOptions& options_;
  const Observer<EncodeProgress>& observer_;
  std::vector<ContactSpan> contacts_;
  std::optional<CorrectionEncoder> correction_;
  double correction_ratio_ = 0;
  std::optional<ErrorModel> own_model_;  // where importance or a correction change it
  std::optional<ClosedLoop> own_loop_;   // by that
  bool correcting_ = true;               // false: to know the price without
  Goal goal_;
  int pass_ = 0;
};

}  // namespace

const std::vector<ContactSpan>& contacts_for(const ClipAnalysis& analysis,
                                             const EncodeOptions& options) {
  return options.contacts ? *options.contacts : analysis.contacts();
}

TargetedEncoding encode_to_target(const ClipAnalysis& analysis, const EncodeOptions& options,
                                  const Observer<EncodeProgress>& observer) {
  const SegmentLayout layout = even_segments(analysis.motion().clip.frames(), options.segments);
  if (options.method == Method::ClosedLoop && layout.count() > 1)
    return encode_in_segments(analysis, options, layout, observer);
  TargetedEncode targeted(analysis, options, observer);
  Trial trial = targeted.run();
  if (trial.complete) targeted.check(trial);
  return {std::move(trial.compressed), trial.count, targeted.correction_ratio(), trial.iterations,
          trial.complete};
}

ScaleTrial encode_at_scale(const ClipAnalysis& analysis, const EncodeOptions& options, double scale,
                           const ClosedLoopWork& work, const Eigen::VectorXd& frame_weights,
                           const Observer<EncodeProgress>& observer) {
  return TargetedEncode(analysis, options, observer).run_at(scale, work, frame_weights);
}

Trial coarsen_to_bound(const ClipAnalysis& analysis, const EncodeOptions& options,
                       QuantisedSignals coded, double bound_cm,
                       const Observer<EncodeProgress>& observer) {
  return TargetedEncode(analysis, options, observer).coarsen(std::move(coded), bound_cm);
}

double find_correction_split(const ClipAnalysis& analysis, const EncodeOptions& options) {
  return TargetedEncode(analysis, options, {}).split();
}

Original original_of(const ClipAnalysis& analysis) {
  return Original(analysis.motion(), [from = &analysis]() -> const Eigen::MatrixXd& {
    return from->original_tracks();
  });
}

}  // namespace mocapress
