// SPDX-License-Identifier: MIT
#include "core/codec/encode/trial_coder.h"

#include <algorithm>
#include <utility>

#include "core/base/byte_cursor.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/encode/mend/end_fit.h"
#include "core/codec/encode/search/size_estimate.h"
#include "core/codec/encode/search/split_search.h"

namespace mocapress {
namespace {

/// Lets a channel that stands still keep all of its coarse samples or none: with a part of them it
/// would move.
Kept with_still_channels_whole(const RankedCoefficients& ranked, Kept kept) {
  const int coarse = ranked.lifting.bands().front().size;
  for (int c = 0; c < ranked.channels(); ++c) {
    int& count = kept[c];
    if (count == 0) continue;
    const auto values = ranked.values.col(c);
    const bool is_still = (values.head(coarse).array() == values(0)).all() &&
                          values.tail(values.size() - coarse).isZero(0);
    if (is_still) count = std::max(count, coarse);
  }
  return kept;
}

}  // namespace

TrialCoder::TrialCoder(const ClipAnalysis& analysis, const EncodeSettings& settings)
    : analysis_(analysis),
      settings_(settings),
      coefficients_(analysis.coefficients(settings.basis)),
      contacts_(contacts_for(analysis, settings)),
      frame_factors_(frame_factors(settings.ranges, analysis.motion().clip.frames())),
      goal_(original_of(analysis), settings.target, settings.weighting, contacts_, frame_factors_,
            settings.limits) {
  const Motion& motion = analysis.motion();
  if (settings.correction) {
    correction_.emplace(motion.skeleton, analysis.original_tracks(), *settings.correction,
                        contacts_, motion.clip.sample_rate_hz);
    correction_ratio_ = settings.correction->ratio.value_or(SplitSearch::kFirst);
  }
  if (settings.method == Method::Annealed || settings.method == Method::ClosedLoop)
    weigh_joints(settings.importance);
}

void TrialCoder::weigh_joints(const Importance& importance) {
  own_model_.reset();
  own_loop_.reset();
  const Motion& motion = analysis_.motion();
  if (!importance.is_even()) {
    own_model_.emplace(motion.skeleton, motion.clip,
                       important_points(motion.skeleton, settings_.weighting, importance));
    if (importance.contacts > 0)
      for (const auto& point : standing_points(motion.skeleton, analysis_.original_tracks(),
                                               contacts_, importance.contacts))
        own_model_->add(point);
  }
  if (!correction_) return;
  if (!own_model_) own_model_ = analysis_.model(settings_.weighting);
  for (const auto& response : correction_->responses(motion.clip, analysis_.original_tracks()))
    own_model_->add(response);
}

const ErrorModel& TrialCoder::model() const {
  return own_model_ ? *own_model_ : analysis_.model(settings_.weighting);
}

const ClosedLoop& TrialCoder::loop() {
  if (!own_model_ && frame_factors_.size() == 0)
    return analysis_.closed_loop(settings_.basis, settings_.weighting);
  // With this power the mean error of a range is about as many times smaller as its factor says
  // (mocapress-range-study).
  constexpr double kPower = 3.6;
  if (!own_loop_)
    own_loop_.emplace(coefficients_, analysis_.motion().clip, model(),
                      frame_factors_.array().pow(kPower).matrix());
  return *own_loop_;
}

CompressedClip TrialCoder::empty_clip() const {
  const Motion& motion = analysis_.motion();
  return {.skeleton = motion.skeleton,
          .sample_rate_hz = motion.clip.sample_rate_hz,
          .frames = motion.clip.frames(),
          .basis = settings_.basis,
          .coding = settings_.coding};
}

Trial TrialCoder::code(const Kept& chosen) {
  const Kept kept = with_still_channels_whole(basis().ranked, chosen);
  Trial trial{.compressed = empty_clip()};
  CompressedClip& compressed = trial.compressed;
  if (uses_rle(compressed.coding)) {
    std::vector<std::byte> words = code_signals(basis().ranked, basis().scales, kept);
    if (correction_) append_correction(words, compressed);
    compressed.motion = mocapress::pack(words, compressed.coding);
  } else {
    finish(quantise_kept(basis().ranked, basis().scales, kept, 1), TrialBytes::Coded, compressed);
  }
  return trial;
}

Trial TrialCoder::without_bytes(const ClosedLoop::Result& result) const {
  return {.compressed = empty_clip(),
          .count = static_cast<int>((result.coded.values.array() != 0).count()),
          .scale = result.coded.scale,
          .eps_cm = result.eps_cm,
          .bit_price = result.bit_price,
          .growth = result.growth,
          .iterations = result.sweeps,
          .complete = result.complete};
}

Trial TrialCoder::code(ClosedLoop::Result result, TrialBytes bytes) const {
  Trial trial = without_bytes(result);
  CompressedClip& compressed = trial.compressed;
  if (bytes != TrialBytes::Estimated) {
    finish(std::move(result.coded), bytes, compressed);
    return trial;
  }
  compressed.likely_bytes = estimated_bytes(result.coded, signal_neighbours(compressed));
  compressed.known = std::make_shared<const KnownMotion>(
      std::move(result.coded), analysis_.motion().clip.channels + result.errors.cast<double>());
  return trial;
}

/// Adds the IK correction that the quantised channels need, and codes both if asked to.
void TrialCoder::finish(QuantisedSignals coded, TrialBytes bytes,
                        CompressedClip& compressed) const {
  if (correction_) {
    const Clip reconstructed{compressed.sample_rate_hz, reconstruct(coded, coefficients_.lifting)};
    DifferenceFit lacking = correction_->select(
        reconstructed, correction_ratio_, settings_.basis,
        [&](double step) { return step_of(step_exponent_for(step, coded.scale), coded.scale); });
    QuantisedSignals differences{coded.scale, {}, std::move(lacking.values)};
    for (const double step : lacking.steps)
      differences.step_exponent.push_back(step_exponent_for(step, coded.scale));
    append(differences, coded);
    compressed.correction = correction_->correction();
  }
  if (bytes == TrialBytes::Coded)
    set_motion(std::move(coded), compressed);
  else
    compressed.known = std::make_shared<const KnownMotion>(std::move(coded));
}

/// Fits the correction to the motion as it will be decoded.
void TrialCoder::append_correction(std::vector<std::byte>& words,
                                   CompressedClip& compressed) const {
  const Motion& motion = analysis_.motion();
  ByteReader reader(words);
  const Clip reconstructed{
      motion.clip.sample_rate_hz,
      read_signals(reader, settings_.basis, motion.clip.frames(), motion.skeleton.channel_count())};
  const DifferenceFit lacking =
      correction_->select(reconstructed, correction_ratio_, settings_.basis, word_step);
  const auto differences = code_steps(lacking.values, lacking.steps);
  words.insert(words.end(), differences.begin(), differences.end());
  compressed.correction = correction_->correction();
}

void TrialCoder::pack(Trial& trial) const {
  set_motion(trial.compressed.known, trial.compressed);
}

void TrialCoder::mend_ends(Trial& trial) const {
  const Motion& motion = analysis_.motion();
  const int rows = frames_at_ends(motion.clip.frames());
  if (!codes_ends(settings_) || rows == 0) return;
  fit_ends(settings_, trial, motion.skeleton, still_channels(motion.clip), goal_,
           motion.clip.channels.topRows(rows), motion.clip.channels.bottomRows(rows));
}

void TrialCoder::measure(Trial& trial) const {
  trial.achieved = settings_.target.kind == Target::Kind::CoefficientRatio
                       ? static_cast<double>(coefficients_.total()) / std::max(trial.count, 1)
                       : goal_.achieved(trial.compressed);
  trial.excess = goal_.excess(trial.achieved);
}

void TrialCoder::drop_correction(QuantisedSignals& coded) const {
  const int channels = coefficients_.channels();
  coded.values.conservativeResize(Eigen::NoChange, channels);
  coded.step_exponent.resize(channels);
}

Footskate TrialCoder::footskate_of(const Clip& decoded) const {
  return measure_footskate(contacts_, analysis_.original_tracks(),
                           landmark_tracks(analysis_.motion().skeleton, decoded),
                           decoded.sample_rate_hz);
}

Observer<ClosedLoopProgress> Passes::next() {
  return [this, pass = begin()](const ClosedLoopProgress& p) {
    return should_continue(observer_,
                           EncodeProgress{.pass = pass, .iteration = p.sweep, .eps_cm = p.eps_cm});
  };
}

const std::vector<ContactSpan>& contacts_for(const ClipAnalysis& analysis,
                                             const EncodeSettings& settings) {
  return settings.contacts ? *settings.contacts : analysis.contacts();
}

Original original_of(const ClipAnalysis& analysis) {
  return Original(analysis.motion(),
                  [from = &analysis]() -> const Eigen::MatrixXd& { return from->original_body(); });
}

}  // namespace mocapress
