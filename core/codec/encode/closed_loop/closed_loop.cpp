// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/closed_loop.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/codec/encode/closed_loop/closed_loop_run.h"

namespace mocapress {
namespace {

constexpr double kLeastMoved = 1e-4;  // least curvature, as a share of the mean: channels that move
                                      // no landmark count this much

}  // namespace

ClosedLoop::ClosedLoop(const Coefficients& transform, const Clip& original, const ErrorModel& model,
                       const Eigen::VectorXd& frame_weights)
    : transform_(transform),
      original_(original),
      model_(model),
      frame_weights_(frame_weights),
      functions_(transform.lifting),
      still_(still_channels(original)),
      curvature_(Eigen::MatrixXf::Zero(original.frames() + ShortFunction::kVector,
                                       model.curvature().cols())) {
  const std::vector<double> gains = transform.lifting.gains();
  gains_ = Eigen::Map<const Eigen::VectorXd>(gains.data(), std::ssize(gains));
  model_curvature_ = model.curvature().cast<float>();
  mean_curvature_ = Eigen::VectorXd::Zero(curvature_.cols());
  if (const Eigen::MatrixXd& curvature = model.curvature(); curvature.size() > 0) {
    const double least = std::max(kLeastMoved * curvature.mean(), 1e-12);
    for (Eigen::Index j = 0; j < curvature.cols(); ++j) {
      curvature_.col(j).head(curvature.rows()) =
          model_curvature_.col(j).cwiseMax(static_cast<float>(least));
      mean_curvature_(j) = curvature.col(j).cwiseMax(least).mean();
    }
  }
  mean_curvature_ = mean_curvature_.cwiseMax(1e-12).eval();
  coefficient_curvature_ = coefficient_curvature(curvature_);
}

Eigen::ArrayXf ClosedLoop::weights_with(const Eigen::VectorXd& further) const {
  if (frame_weights_.size() == 0) return further.cast<float>();
  if (further.size() == 0) return frame_weights_.cast<float>();
  return frame_weights_.cwiseProduct(further).cast<float>();
}

Eigen::MatrixXf ClosedLoop::coefficient_curvature(const Eigen::MatrixXf& curvature) const {
  Eigen::MatrixXf of_coefficients(transform_.per_channel(), curvature.cols());
  parallel_for(Eigen::Index{0}, curvature.cols(), [&](Eigen::Index j) {
    for (int c = 0; c < transform_.per_channel(); ++c)
      of_coefficients(c, j) = functions_[c].dot_of_squares(curvature.col(j).data());
  });
  return of_coefficients;
}

double ClosedLoop::finest_scale() const {
  double largest = 1e-6;
  for (int j = 0; j < transform_.channels(); ++j)
    if (original_.frames() > 0)
      largest =
          std::max(largest, transform_.values.col(j).cwiseProduct(gains_).cwiseAbs().maxCoeff() *
                                std::sqrt(mean_curvature_(j)));
  return 16 * largest / kMostSteps;
}

double likely_scale(const Target& target, std::size_t raw_bytes) {
  // The power law is a rough fit to the study clips.
  const auto for_error = [](double eps_cm) { return 1.8 * std::pow(eps_cm / 0.5, 1.35); };
  const auto for_ratio = [&](double ratio) { return for_error(0.5 * std::pow(ratio / 130, 1.25)); };
  switch (target.kind) {
    case Target::Kind::Error:
      return for_error(target.value);
    case Target::Kind::MaxError:
      return for_error(target.value / 8);
    case Target::Kind::Visibility:
      return for_error(0.1 * target.value);
    case Target::Kind::Ratio:
      return for_ratio(target.value);
    case Target::Kind::Size:
      return for_ratio(static_cast<double>(raw_bytes) / std::max(target.value, 1.0));
    case Target::Kind::CoefficientRatio:
      return for_ratio(2 * target.value);
  }
  return 1;
}

ClosedLoop::Result ClosedLoop::quantise(double scale, ClosedLoopWork work,
                                        const Eigen::VectorXd& frame_weights,
                                        const Observer<ClosedLoopProgress>& observer) const {
  return ClosedLoopRun(*this, scale, frame_weights).run(work, observer);
}

ClosedLoop::Result ClosedLoop::coarsen(Result quantised, ErrorBound& bound,
                                       const Observer<ClosedLoopProgress>& observer) const {
  return ClosedLoopRun(*this, std::move(quantised)).coarsen(bound, observer);
}

ClosedLoop::Result ClosedLoop::quantise_to(double eps_cm, double scale,
                                           const Observer<ClosedLoopProgress>& observer) const {
  constexpr int kMostScales = 3;
  constexpr double kNear = 0.05;   // below this distance only the bit price changes, not the scale
  constexpr double kMostOff = 3;   // limit of the logarithm `off`
  constexpr double kPower = 1.35;  // the scale grows with eps_x to this power
  for (int i = 1;; ++i) {
    ClosedLoopRun run(*this, scale, {});
    const double off = std::clamp(std::log(run.begin_settling() / eps_cm), -kMostOff, kMostOff);
    if (std::abs(off) <= kNear || i == kMostScales) return run.settle(eps_cm, observer);
    scale = std::max(scale * std::exp(-kPower * off), finest_scale());
  }
}

ClosedLoop::Result ClosedLoop::settle(Result settled, double eps_cm,
                                      const Observer<ClosedLoopProgress>& observer) const {
  return ClosedLoopRun(*this, std::move(settled)).settle(eps_cm, observer);
}

}  // namespace mocapress
