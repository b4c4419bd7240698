// SPDX-License-Identifier: MIT
#include "core/codec/encode/targeted_encode.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/codec/decode/decoder.h"
#include "core/codec/encode/mend/end_fit.h"
#include "core/codec/encode/search/count_search.h"
#include "core/codec/encode/search/goal.h"
#include "core/codec/encode/search/scale_search.h"
#include "core/codec/encode/search/size_estimate.h"
#include "core/codec/encode/search/split_search.h"
#include "core/codec/encode/segmented_encode.h"
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
        goal_(original_of(analysis), options.target, options.weighting, contacts_) {
    const Motion& motion = analysis.motion();
    if (options.correction) {
      correction_.emplace(motion.skeleton, analysis.original_tracks(), *options.correction,
                          contacts_, motion.clip.sample_rate_hz);
      correction_ratio_ = options.correction->ratio.value_or(SplitSearch::kFirst);
    }
    if (options.method == Method::Annealed || options.method == Method::ClosedLoop)
      prepare_model(options.importance);
  }

  double correction_ratio() const { return correction_ratio_; }

  std::optional<double> slide_without_cm() const { return slide_without_cm_; }

  Trial run() {
    if (!correction_ || options_.correction->ratio)
      return run_with(options_.method, options_.effort);
    Trial trial = find_split();
    if (!trial.complete || (split_method() == options_.method && split_effort() == options_.effort))
      return trial;
    slide_without_cm_.reset();  // that of another encode
    return run_with(options_.method, options_.effort);
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
  ScaleTrial run_at(double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights) {
    return {code_at(scale, work, frame_weights), loop().finest_scale()};
  }

  Trial coarsen(ClosedLoop::Result quantised, const Eigen::VectorXd& bound_cm,
                Coarsened coarsened) {
    std::vector<bool> still;
    if (correction_ && coarsened == Coarsened::UncorrectedJoints)
      still = correction_->reached_joints();
    ErrorBound bound(analysis_.motion(), options_.weighting, bound_cm, std::move(still));
    const double scale = quantised.coded.scale;
    drop_correction(quantised.coded);
    Trial coarser = trial_of(loop().coarsen(std::move(quantised), bound, observe_pass()), true);
    coarser.scale = scale;
    return coarser;
  }

  double split() {
    find_split();
    return correction_ratio_;
  }

 private:
  static constexpr int kCheapTrials = 24;
  static constexpr int kAnnealings = 10;

  /// The order of the coefficients, which only the paper's methods ask for.
  const BasisAnalysis& basis() const { return analysis_.in(options_.basis); }

  /// What errors of the motion cost: some joints more, what a correction makes good less.
  const ErrorModel& model() const {
    return own_model_ ? *own_model_ : analysis_.model(options_.weighting);
  }

  void finish_ends(Trial& trial) const {
    const Motion& motion = analysis_.motion();
    const int rows = frames_at_ends(motion.clip.frames());
    if (!codes_ends(options_) || rows == 0) return;
    fit_ends(options_, trial, motion.skeleton, goal_, motion.clip.channels.topRows(rows),
             motion.clip.channels.bottomRows(rows));
  }

  void prepare_model(const Importance& importance) {
    own_model_.reset();
    own_loop_.reset();
    if (!importance.is_even()) emphasise(importance);
    if (!correction_) return;
    const Motion& motion = analysis_.motion();
    if (!own_model_) own_model_ = analysis_.model(options_.weighting);
    for (const auto& response : correction_->responses(motion.clip, analysis_.original_tracks()))
      own_model_->add(response);
  }

  /// Lets joints weigh by how soon their errors are noticed. Returns about the scale at which
  /// nothing is.
  double balance_joints(double scale) {
    constexpr int kRounds = 4;
    constexpr double kMostStep = 4;
    constexpr double kMost = 1000;
    Importance importance = options_.importance;
    importance.joints.resize(static_cast<std::size_t>(analysis_.motion().skeleton.joint_count()),
                             1.0);
    for (int round = 0; round < kRounds; ++round) {
      const Trial trial = code_at(scale, ClosedLoopWork::Compensation, {});
      if (!trial.complete) break;
      const Eigen::ArrayXd noticed = goal_.seen(trial.compressed).table.by_joint();
      const double mean = noticed.max(1e-6).log().mean();
      for (std::size_t j = 0; j < importance.joints.size(); ++j) {
        const double step = std::max(noticed(static_cast<Eigen::Index>(j)), 1e-6) / std::exp(mean);
        importance.joints[j] = std::clamp(
            importance.joints[j] * std::clamp(step, 1 / kMostStep, kMostStep), 1 / kMost, kMost);
      }
      prepare_model(importance);
      scale *= std::clamp(std::pow(options_.target.value / std::max(noticed.maxCoeff(), 1e-6), 1.2),
                          1 / kMostStep, kMostStep);
    }
    quantised_.clear();
    return scale;
  }

  void emphasise(const Importance& importance) {
    const Motion& motion = analysis_.motion();
    own_model_.emplace(motion.skeleton, motion.clip,
                       important_points(motion.skeleton, options_.weighting, importance));
    if (importance.contacts == 0) return;
    for (const auto& point : standing_points(motion.skeleton, analysis_.original_tracks(),
                                             contacts_, importance.contacts))
      own_model_->add(point);
  }

  int count_for(double coefficient_ratio) const {
    const double total = coefficients_.total();
    return static_cast<int>(std::lround(std::clamp(total / coefficient_ratio, 0.0, total)));
  }

  Trial run_with(Method method, Effort effort) {
    const int guess = count_for(goal_.likely_coefficient_ratio());
    if (method == Method::ClosedLoop) return closed_loop(effort);
    if (options_.target.kind == Target::Kind::CoefficientRatio) return attempt(method, guess);
    if (method != Method::Annealed) return search(method, guess, kCheapTrials);
    // Standard selection costs next to nothing and needs about as many coefficients.
    return search(Method::Annealed, search(Method::Standard, guess, kCheapTrials).count,
                  kAnnealings);
  }

  /// Leaves the r_IK of the best split behind, and gives the trial that showed it. What the motion
  /// is quantised to at a scale, or annealed to, does not hang on r_IK and is found once.
  Trial find_split() {
    constexpr int kFinerSteps = 2;
    const bool is_draft = split_effort() == Effort::Draft;
    remembers_ = true;
    Trial best = run_with(split_method(), split_effort());
    if (best.complete) {
      EncodeOptions plain = options_;
      plain.correction.reset();
      TargetedEncode without(analysis_, plain, observer_);
      without.pass_ = pass_;
      const Trial uncorrected = without.run_with(split_method(), split_effort());
      pass_ = without.pass_;
      best.complete = uncorrected.complete;
      if (best.complete) {
        slide_without_cm_ = footskate_of(decode(uncorrected.compressed)).total_cm;
        SplitSearch search(*slide_without_cm_, is_draft ? 0 : kFinerSteps);
        search.tried(split_of(best));
        while (const std::optional<double> ratio = best.complete ? search.next() : std::nullopt) {
          correction_ratio_ = *ratio;
          Trial trial = run_with(split_method(), split_effort());
          const bool complete = trial.complete;
          if (complete && search.tried(split_of(trial))) best = std::move(trial);
          best.complete = complete;
        }
        correction_ratio_ = search.best().ratio;
      }
    }
    remembers_ = false;
    quantised_.clear();
    settled_.clear();
    return best;
  }

  /// Annealing takes too long to be tried many times, except where it is the same each time.
  Method split_method() const {
    const bool once = options_.target.kind == Target::Kind::CoefficientRatio;
    return options_.method == Method::Annealed && !once ? Method::Standard : options_.method;
  }

  /// So does a hard maximum, and what more the best effort does.
  Effort split_effort() const {
    if (is_by_worst(options_.target)) return Effort::Draft;
    return std::min(options_.effort, Effort::Default);
  }

  Split split_of(const Trial& trial) const {
    const bool is_draft = split_effort() == Effort::Draft && options_.method == Method::ClosedLoop;
    const bool met = is_draft || goal_.met(trial.excess) ||
                     options_.target.kind == Target::Kind::CoefficientRatio;
    const bool size_is_asked =
        options_.target.kind == Target::Kind::Ratio || options_.target.kind == Target::Kind::Size;
    const Clip decoded = decode(trial.compressed);
    const double price = size_is_asked
                             ? exact_eps(analysis_.motion().skeleton, analysis_.original_body(),
                                         decoded, options_.weighting)
                             : static_cast<double>(trial.compressed.motion_bytes());
    const Footskate slide = footskate_of(decoded);
    return {correction_ratio_, met ? price : std::numeric_limits<double>::infinity(),
            slide.total_cm, slide.findings.empty() ? 0 : slide.findings.front().slid_cm};
  }

  Footskate footskate_of(const Clip& decoded) const {
    return measure_footskate(contacts_, analysis_.original_tracks(),
                             landmark_tracks(analysis_.motion().skeleton, decoded),
                             decoded.sample_rate_hz);
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
    if (uses_rle(compressed.coding)) {
      std::vector<std::byte> words = code_signals(basis().ranked, basis().scales, kept);
      if (correction_) append_correction(words, compressed);
      compressed.motion = pack(words, compressed.coding);
    } else {
      finish(quantise_kept(basis().ranked, basis().scales, kept, 1), compressed);
    }
    weigh(trial);
    return trial;
  }

  /// Codes quantised channels, with the correction they need.
  void finish(QuantisedSignals coded, CompressedClip& compressed) const {
    if (correction_) {
      const Clip reconstructed{compressed.sample_rate_hz,
                               reconstruct(coded, coefficients_.lifting)};
      DifferenceFit lacking = correction_->select(
          reconstructed, correction_ratio_, options_.basis,
          [&](double step) { return step_of(step_exponent_for(step, coded.scale), coded.scale); });
      QuantisedSignals differences{coded.scale, {}, std::move(lacking.values)};
      for (const double step : lacking.steps)
        differences.step_exponent.push_back(step_exponent_for(step, coded.scale));
      append(differences, coded);
      compressed.correction = correction_->correction();
    }
    if (packs_)
      set_motion(std::move(coded), compressed);
    else
      compressed.known = std::make_shared<const KnownMotion>(std::move(coded));
  }

  /// What a draft shows at once: how large it will be and how it moves.
  void finish_draft(ClosedLoop::Result result, CompressedClip& compressed) const {
    compressed.likely_bytes = estimated_bytes(result.coded, signal_neighbours(compressed));
    compressed.known = std::make_shared<const KnownMotion>(
        std::move(result.coded), analysis_.motion().clip.channels + result.errors.cast<double>());
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

  Trial closed_loop(Effort effort) {
    const ScaleTrials trials{
        .attempt =
            [this, effort](double scale, ClosedLoopWork work, const Eigen::VectorXd& weights) {
              return attempt_scale(scale, work, weights, effort);
            },
        .coarsen =
            [this](const Trial& trial, const Eigen::VectorXd& bound_cm, Coarsened coarsened) {
              Trial coarser = coarsen({.coded = AdaptiveSegments(trial.compressed).next(),
                                       .bit_price = trial.bit_price},
                                      bound_cm, coarsened);
              finish_ends(coarser);
              weigh(coarser);
              return coarser;
            },
        .settle = effort != Effort::Draft && !is_by_worst(options_.target)
                      ? SettleTrial([this](double eps_cm, double scale, const Trial* trial) {
                          return settle(eps_cm, scale, trial);
                        })
                      : SettleTrial()};
    double likely = likely_scale(options_.target, raw_bytes(analysis_.motion().clip));
    if (options_.target.kind == Target::Kind::Visibility && effort != Effort::Draft)
      likely = balance_joints(likely);
    const ScaleGuess guess{.likely = likely,
                           .finest = [&] { return loop().finest_scale(); },
                           .dear = correction_ && !is_by_worst(options_.target),
                           .corrected = correction_.has_value()};
    // Trials that are weighed by their error alone need no bytes but for the one that is chosen.
    // What a draft takes is found while it is measured.
    const bool is_draft = effort == Effort::Draft && !correction_;
    estimates_ = is_draft && options_.size_will_do;
    packs_ = !estimates_ && (options_.target.kind != Target::Kind::Error ||
                             (effort != Effort::Default && !is_draft));
    Trial trial = search_scale(guess, options_.target, goal_, effort,
                               analysis_.motion().clip.frames(), trials);
    if (!packs_ && !is_draft) set_motion(trial.compressed.known, trial.compressed);
    packs_ = true;
    estimates_ = false;
    return trial;
  }

  Trial attempt_scale(double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights,
                      Effort effort) {
    const bool is_rough = work == ClosedLoopWork::Rounding;  // its coding is not asked for
    const bool model_will_do = (effort == Effort::Draft || is_rough) &&
                               options_.target.kind == Target::Kind::Error && !own_model_;
    Trial trial = code_at(scale, work, frame_weights, !model_will_do || !is_rough);
    if (!is_rough) finish_ends(trial);
    if (model_will_do) {
      trial.achieved = trial.eps_cm;  // near enough, and there already
      trial.excess = goal_.excess(trial.achieved);
    } else {
      weigh(trial);
    }
    return trial;
  }

  Trial code_at(double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights,
                bool with_bytes = true) {
    Trial trial = trial_of(quantise(scale, work, frame_weights), with_bytes);
    trial.scale = scale;
    return trial;
  }

  Trial settle(double eps_cm, double scale, const Trial* trial) {
    Trial settled =
        trial_of(trial ? settle_again(*trial, eps_cm) : settle_anew(eps_cm, scale), true);
    settled.scale = settled.compressed.known->coded().scale;
    finish_ends(settled);
    weigh(settled);
    return settled;
  }

  ClosedLoop::Result settle_again(const Trial& trial, double eps_cm) {
    QuantisedSignals coded = trial.compressed.known->coded();
    drop_correction(coded);
    return loop().settle(
        {.coded = std::move(coded), .bit_price = trial.bit_price, .growth = trial.growth}, eps_cm,
        observe_pass());
  }

  /// Once for each error and scale, while splits are compared.
  ClosedLoop::Result settle_anew(double eps_cm, double scale) {
    const std::pair key(eps_cm, scale);
    if (const auto found = settled_.find(key); remembers_ && found != settled_.end())
      return found->second;
    ClosedLoop::Result result = loop().quantise_to(eps_cm, scale, observe_pass());
    if (remembers_ && result.complete) settled_[key] = result;
    return result;
  }

  /// Once for each scale that a file can hold, while splits are compared.
  ClosedLoop::Result quantise(double scale, ClosedLoopWork work,
                              const Eigen::VectorXd& frame_weights) {
    const std::pair key(file_scale(scale), work);
    const bool remembered = remembers_ && frame_weights.size() == 0;
    if (const auto found = quantised_.find(key); remembered && found != quantised_.end())
      return found->second;
    ClosedLoop::Result result = loop().quantise(scale, work, frame_weights, observe_pass());
    if (remembered && result.complete) quantised_[key] = result;
    return result;
  }

  /// It is made anew for what changes.
  void drop_correction(QuantisedSignals& coded) const {
    const int channels = coefficients_.channels();
    coded.values.conservativeResize(Eigen::NoChange, channels);
    coded.step_exponent.resize(static_cast<std::size_t>(channels));
  }

  Observer<ClosedLoopProgress> observe_pass() {
    return [this, pass = pass_++](const ClosedLoopProgress& p) {
      return should_continue(
          observer_, EncodeProgress{.pass = pass, .iteration = p.sweep, .eps_cm = p.eps_cm});
    };
  }

  Trial trial_of(ClosedLoop::Result result, bool with_bytes) {
    Trial trial{.compressed = empty_clip(),
                .count = static_cast<int>((result.coded.values.array() != 0).count()),
                .eps_cm = result.eps_cm,
                .bit_price = result.bit_price,
                .growth = result.growth,
                .iterations = result.sweeps,
                .complete = result.complete};
    if (with_bytes && estimates_)
      finish_draft(std::move(result), trial.compressed);
    else if (with_bytes)
      finish(std::move(result.coded), trial.compressed);
    return trial;
  }

  /// What is corrected is the motion as it will be decoded.
  void append_correction(std::vector<std::byte>& words, CompressedClip& compressed) const {
    const Motion& motion = analysis_.motion();
    ByteReader reader(words);
    const Clip reconstructed{motion.clip.sample_rate_hz,
                             read_signals(reader, options_.basis, motion.clip.frames(),
                                          motion.skeleton.channel_count())};
    const DifferenceFit lacking =
        correction_->select(reconstructed, correction_ratio_, options_.basis, word_step);
    const auto differences = code_steps(lacking.values, lacking.steps);
    words.insert(words.end(), differences.begin(), differences.end());
    compressed.correction = correction_->correction();
  }

  Kept choose(Method method, Trial& trial) {
    if (method == Method::PerChannel) return keep_per_channel(basis().ranked, trial.count);
    Kept standard = basis().standard.keep(trial.count);
    if (method == Method::Standard) return standard;
    const auto known = annealed_.find(trial.count);
    const AnnealingReport report =
        known != annealed_.end() ? known->second : best_annealing(standard);
    if (remembers_) annealed_[trial.count] = report;
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
      return should_continue(observer_,
                             EncodeProgress{pass_, p.iteration, p.step, p.first_step, p.eps_cm});
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
  std::optional<double> slide_without_cm_;
  bool remembers_ = false;  // what splits have in common
  bool packs_ = true;       // trials into bytes
  bool estimates_ = false;  // how many that would be
  std::map<std::pair<float, ClosedLoopWork>, ClosedLoop::Result> quantised_;
  std::map<std::pair<double, double>, ClosedLoop::Result> settled_;  // by error and scale
  std::map<int, AnnealingReport> annealed_;                          // by count
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
  return {std::move(trial.compressed), trial.count,      targeted.correction_ratio(),
          targeted.slide_without_cm(), trial.iterations, trial.complete};
}

ScaleTrial encode_at_scale(const ClipAnalysis& analysis, const EncodeOptions& options, double scale,
                           ClosedLoopWork work, const Eigen::VectorXd& frame_weights,
                           const Observer<EncodeProgress>& observer) {
  return TargetedEncode(analysis, options, observer).run_at(scale, work, frame_weights);
}

Trial coarsen_to_bound(const ClipAnalysis& analysis, const EncodeOptions& options,
                       QuantisedSignals coded, const Eigen::VectorXd& bound_cm, Coarsened coarsened,
                       const Observer<EncodeProgress>& observer) {
  return TargetedEncode(analysis, options, observer)
      .coarsen({.coded = std::move(coded)}, bound_cm, coarsened);
}

double find_correction_split(const ClipAnalysis& analysis, const EncodeOptions& options) {
  return TargetedEncode(analysis, options, {}).split();
}

Original original_of(const ClipAnalysis& analysis) {
  return Original(analysis.motion(),
                  [from = &analysis]() -> const Eigen::MatrixXd& { return from->original_body(); });
}

}  // namespace mocapress
