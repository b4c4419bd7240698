// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/codec/encode/closed_loop/error_bound.h"
#include "core/codec/encode/options/target.h"
#include "core/codec/format/quantised_signals.h"
#include "core/select/error_model.h"
#include "core/wavelet/synthesis.h"

namespace mocapress {

/// Work of a closed loop, each value including the ones before. Rounding rounds coefficients to
/// steps. Compensation lets channels make up for each other's errors once. Sweeps change single
/// coefficients and, last, those of all channels together.
enum class ClosedLoopWork { Rounding, Compensation, Sweeps };

struct ClosedLoopProgress {
  int sweep = 0;
  double eps_cm = 0;  // by the quadratic model, frames weighted as asked
};

/// Decides quantisation and the trade between channels together, by their effect on eps_x.
///
/// The further a channel moves the body, the finer is its step (ENCODER.md, stage 3). A channel
/// that stands still in the original is coded as one value and stays still. Then the loop changes
/// single coefficients: it weighs the change of eps_x^2, given the errors of all others, against
/// the bits saved. A knee can thus make up for an error of the hip. Const and safe to use from
/// several threads at a time; the result is deterministic.
class ClosedLoop {
 public:
  /// The transform, the clip and the model must outlive this object. Squared errors of each frame
  /// count by its weight, in all runs; without weights all frames count alike. The price of a bit
  /// is multiplied by the largest weight, so that bits have their usual price in the frames of that
  /// weight.
  ClosedLoop(const Coefficients& transform, const Clip& original, const ErrorModel& model,
             const Eigen::VectorXd& frame_weights = {});

  struct Result {
    QuantisedSignals coded;
    double eps_cm = 0;  // by the quadratic model, frames weighted as asked
    int sweeps = 0;
    bool complete = true;  // false: the observer stopped it
    // Price of a bit in the last sweep, in squared steps of error; set by settle() and coarsen().
    // settle() also sets growth: log(eps_x after that sweep / eps_x before it).
    double bit_price = 0;
    double growth = 0;
    Eigen::MatrixXf errors;  // set by quantise(): decoded minus original, frames x channels
  };

  /// Quantises in steps that move the landmarks by about `scale` cm. Each frame's errors count by
  /// its weight times that of this loop; without weights all frames count alike.
  Result quantise(double scale, ClosedLoopWork work = ClosedLoopWork::Sweeps,
                  const Eigen::VectorXd& frame_weights = {},
                  const Observer<ClosedLoopProgress>& observer = {}) const;

  /// Drops more and more coefficients, the cheapest first, while the bound holds. Ends near the
  /// bound, when a sweep saves little more. The price of a bit rises from sweep to sweep; for an
  /// input that was coarsened before, it starts at a fraction of its last price.
  Result coarsen(Result quantised, ErrorBound& bound,
                 const Observer<ClosedLoopProgress>& observer = {}) const;

  /// Finds an encoding whose eps_x, by the quadratic model, is `eps_cm` or up to kSettled less. It
  /// starts from `scale`, and then adjusts the price of a bit.
  Result quantise_to(double eps_cm, double scale,
                     const Observer<ClosedLoopProgress>& observer = {}) const;

  /// Continues from a result of quantise_to(), settle() or quantise() with sweeps whose eps_x is
  /// close to `eps_cm`: sweeps again with adjusted prices of a bit.
  Result settle(Result settled, double eps_cm,
                const Observer<ClosedLoopProgress>& observer = {}) const;

  static constexpr double kSettled = 0.006;  // share of eps_x

  /// The finest usable scale; at a finer one the largest coefficients would overflow.
  double finest_scale() const;

 private:
  friend class ClosedLoopRun;

  /// The weights of this loop times further ones; either may be empty.
  Eigen::ArrayXf weights_with(const Eigen::VectorXd& further) const;

  /// Sums the square of each coefficient's synthesis function, weighted by the curvature:
  /// coefficients x channels.
  Eigen::MatrixXf coefficient_curvature(const Eigen::MatrixXf& curvature) const;

  const Coefficients& transform_;
  const Clip& original_;
  const ErrorModel& model_;
  Eigen::VectorXd frame_weights_;  // empty: all alike
  ShortFunctions functions_;
  std::vector<bool> still_;  // channels that stand still in the original
  Eigen::VectorXd gains_;
  // The model's curvature, raised where it is zero.
  Eigen::MatrixXf curvature_;
  Eigen::MatrixXf model_curvature_;        // the model's own curvature: frames x channels
  Eigen::MatrixXf coefficient_curvature_;  // all frames weighted alike
  Eigen::VectorXd mean_curvature_;
};

/// A first guess at the scale that meets a target, for a clip of `raw_bytes`.
double likely_scale(const Target& target, std::size_t raw_bytes);

}  // namespace mocapress
