// SPDX-License-Identifier: MIT
#include "core/codec/encode/loop_encode.h"

#include <algorithm>
#include <cmath>

#include "core/codec/encode/search/scale_search.h"
#include "core/metrics/rate.h"

namespace mocapress {

Trial LoopEncode::run(Effort effort) {
  const EncodeSettings& settings = coder_.settings();
  const Clip& original = coder_.analysis().motion().clip;
  const bool is_draft = effort == Effort::Draft;
  const ScaleTrials trials{
      .attempt =
          [this, effort](double scale, ClosedLoopWork work, const Eigen::VectorXd& weights) {
            return attempt(scale, work, weights, effort);
          },
      .coarsen =
          [this](const Trial& trial, const Eigen::VectorXd& bound_cm) {
            Trial coarser = coarsen(
                {.coded = AdaptiveSegments(trial.compressed).next(), .bit_price = trial.bit_price},
                bound_cm);
            coder_.mend_ends(coarser);
            coder_.measure(coarser);
            return coarser;
          },
      .settle = !is_draft && !is_by_worst(settings.target)
                    ? SettleTrial([this](double eps_cm, double scale, const Trial* trial) {
                        return settle(eps_cm, scale, trial);
                      })
                    : SettleTrial()};
  double likely = likely_scale(settings.target, raw_bytes(original));
  if (settings.target.kind == Target::Kind::Visibility && !is_draft)
    likely = balance_joints(likely);
  const bool is_slow = coder_.has_correction() && !is_by_worst(settings.target);
  const ScaleGuess guess{.likely = likely,
                         .finest = [&] { return coder_.loop().finest_scale(); },
                         .dear = is_slow,
                         .corrected = coder_.has_correction()};
  // Trials that are judged by their error alone need no bytes until one is chosen. A draft's size
  // is estimated while it is measured.
  const bool is_plain_draft = is_draft && !coder_.has_correction();
  const bool by_error = settings.target.kind == Target::Kind::Error;
  if (is_plain_draft && settings.size_will_do)
    bytes_ = TrialBytes::Estimated;
  else if (by_error && (effort == Effort::Default || is_plain_draft))
    bytes_ = TrialBytes::Values;
  Trial trial =
      search_scale(guess, settings.target, coder_.goal(), effort, original.frames(), trials);
  if (bytes_ == TrialBytes::Values && !is_plain_draft) coder_.pack(trial);
  bytes_ = TrialBytes::Coded;
  return trial;
}

Trial LoopEncode::run_at(double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights) {
  Trial trial = coder_.code(quantise(scale, work, frame_weights), bytes_);
  trial.scale = scale;
  return trial;
}

Trial LoopEncode::coarsen(ClosedLoop::Result quantised, const Eigen::VectorXd& bound_cm) {
  ErrorBound bound(coder_.analysis().motion(), coder_.settings().weighting, bound_cm);
  const double scale = quantised.coded.scale;
  coder_.drop_correction(quantised.coded);
  Trial coarser =
      coder_.code(coder_.loop().coarsen(std::move(quantised), bound, passes_.next()), bytes_);
  coarser.scale = scale;
  return coarser;
}

/// Weights joints by how soon their errors are noticed. Returns a scale that about meets the target
/// of visibility.
double LoopEncode::balance_joints(double scale) {
  constexpr int kRounds = 4;
  constexpr double kMostStep = 4;
  constexpr double kMost = 1000;
  constexpr double kLeastNoticed = 1e-6;
  Importance importance = coder_.settings().importance;
  importance.joints.resize(
      static_cast<std::size_t>(coder_.analysis().motion().skeleton.joint_count()), 1.0);
  for (int round = 0; round < kRounds; ++round) {
    const Trial trial = run_at(scale, ClosedLoopWork::Compensation, {});
    if (!trial.complete) break;
    const Eigen::ArrayXd noticed =
        coder_.goal().seen(trial.compressed).table.by_joint().max(kLeastNoticed);
    const double mean = std::exp(noticed.log().mean());
    for (std::size_t j = 0; j < importance.joints.size(); ++j) {
      const double step = std::clamp(noticed(j) / mean, 1 / kMostStep, kMostStep);
      importance.joints[j] = std::clamp(importance.joints[j] * step, 1 / kMost, kMost);
    }
    coder_.weigh_joints(importance);
    quantised_.clear();  // computed with other weights
    scale *= std::clamp(std::pow(coder_.settings().target.value / noticed.maxCoeff(), 1.2),
                        1 / kMostStep, kMostStep);
  }
  return scale;
}

Trial LoopEncode::attempt(double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights,
                          Effort effort) {
  const EncodeSettings& settings = coder_.settings();
  const bool is_rough = work == ClosedLoopWork::Rounding;  // its bytes are not needed
  const bool model_will_do =
      (effort == Effort::Draft || is_rough) && settings.target.kind == Target::Kind::Error &&
      settings.importance.is_even() && settings.ranges.empty() && !coder_.has_correction();
  ClosedLoop::Result result = quantise(scale, work, frame_weights);
  Trial trial = model_will_do && is_rough ? coder_.without_bytes(result)
                                          : coder_.code(std::move(result), bytes_);
  trial.scale = scale;
  if (!is_rough) coder_.mend_ends(trial);
  if (model_will_do) {
    trial.achieved = trial.eps_cm;  // the model's estimate is close enough
    trial.excess = coder_.goal().excess(trial.achieved);
  } else {
    coder_.measure(trial);
  }
  return trial;
}

Trial LoopEncode::settle(double eps_cm, double scale, const Trial* trial) {
  Trial settled =
      coder_.code(trial ? settle_again(*trial, eps_cm) : settle_anew(eps_cm, scale), bytes_);
  coder_.mend_ends(settled);
  coder_.measure(settled);
  return settled;
}

ClosedLoop::Result LoopEncode::settle_again(const Trial& trial, double eps_cm) {
  QuantisedSignals coded = trial.compressed.known->coded();
  coder_.drop_correction(coded);
  return coder_.loop().settle(
      {.coded = std::move(coded), .bit_price = trial.bit_price, .growth = trial.growth}, eps_cm,
      passes_.next());
}

ClosedLoop::Result LoopEncode::settle_anew(double eps_cm, double scale) {
  const std::pair key(eps_cm, scale);
  if (const auto found = settled_.find(key); remembers_ && found != settled_.end())
    return found->second;
  ClosedLoop::Result result = coder_.loop().quantise_to(eps_cm, scale, passes_.next());
  if (remembers_ && result.complete) settled_[key] = result;
  return result;
}

/// If asked to remember, keeps the result for each scale that a file can store.
ClosedLoop::Result LoopEncode::quantise(double scale, ClosedLoopWork work,
                                        const Eigen::VectorXd& frame_weights) {
  const std::pair key(file_scale(scale), work);
  const bool remembered = remembers_ && frame_weights.size() == 0;
  if (const auto found = quantised_.find(key); remembered && found != quantised_.end())
    return found->second;
  ClosedLoop::Result result = coder_.loop().quantise(scale, work, frame_weights, passes_.next());
  if (remembered && result.complete) quantised_[key] = result;
  return result;
}

}  // namespace mocapress
