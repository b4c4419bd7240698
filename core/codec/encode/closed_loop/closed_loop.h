// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/codec/encode/closed_loop/error_bound.h"
#include "core/codec/encode/options/target.h"
#include "core/codec/format/quantised_signals.h"
#include "core/select/error_model.h"
#include "core/wavelet/synthesis.h"

namespace mocapress {

/// How much work a closed loop does: coefficients are rounded to steps, then channels make up for
/// each other once, then sweeps change single coefficients and, last, those of all channels.
enum class ClosedLoopWork { Rounding, Compensation, Sweeps };

struct ClosedLoopProgress {
  int sweep = 0;
  double eps_cm = 0;  // by the quadratic model, frames weighted as asked
};

/// Quantisation and the trade between channels decided together, by what they do to eps_x.
///
/// A channel's step is in inverse proportion to how far the channel moves the landmarks. A channel
/// that stands still in the original is coded as one value, and nothing moves it. After that
/// the loop changes single coefficients. It weighs what a change costs in eps_x^2, given the errors
/// of all others, against the bits that it saves. So a knee makes up for an error of the hip. Const
/// and safe to use from several threads at a time; the outcome is always the same.
class ClosedLoop {
 public:
  /// All must outlive this.
  ClosedLoop(const Coefficients& transform, const Clip& original, const ErrorModel& model);

  struct Result {
    QuantisedSignals coded;
    double eps_cm = 0;  // by the quadratic model, frames weighted as asked
    int sweeps = 0;
    bool complete = true;  // false: the observer ended it
    // Of what was settled or coarsened: what a bit was worth in the last sweep, in squared steps of
    // error. Of what was settled, by which logarithm eps_x grew in it, too.
    double bit_price = 0;
    double growth = 0;
    Eigen::MatrixXf errors;  // of quantise(): decoded minus original, frames x channels
  };

  /// Quantises in steps that move the landmarks by about `scale` cm. Each frame's errors count by
  /// its weight; without weights all frames count alike.
  Result quantise(double scale, ClosedLoopWork work = ClosedLoopWork::Sweeps,
                  const Eigen::VectorXd& frame_weights = {},
                  const Observer<ClosedLoopProgress>& observer = {}) const;

  /// Drops more and more of what was quantised, the cheapest first, as long as the bound holds. All
  /// frames count alike. It ends near the bound, where a sweep saves little more. What was
  /// coarsened before goes on from a part of its price.
  Result coarsen(Result quantised, ErrorBound& bound,
                 const Observer<ClosedLoopProgress>& observer = {}) const;

  /// Seeks what leaves that eps_x by the quadratic model, or up to kSettled less: near `scale`, and
  /// then by what a bit is worth. All frames count alike.
  Result quantise_to(double eps_cm, double scale,
                     const Observer<ClosedLoopProgress>& observer = {}) const;

  /// The same for what was settled before, at an eps_x near to that.
  Result settle(Result settled, double eps_cm,
                const Observer<ClosedLoopProgress>& observer = {}) const;

  static constexpr double kSettled = 0.006;  // of eps_x

  /// The finest scale: with a finer one the largest coefficients would not fit.
  double finest_scale() const;

 private:
  friend class ClosedLoopRun;

  /// |synthesis function|^2 weighted by a curvature, coefficients x channels.
  Eigen::MatrixXf coefficient_curvature(const Eigen::MatrixXf& curvature) const;

  const Coefficients& transform_;
  const Clip& original_;
  const ErrorModel& model_;
  ShortFunctions functions_;
  std::vector<bool> still_;  // channels that stand still in the original
  Eigen::VectorXd gains_;
  // Of the model, nowhere zero; and zeros for so many frames that vectors may go beyond the last.
  Eigen::MatrixXf curvature_;
  Eigen::MatrixXf model_curvature_;        // as it is: frames x channels
  Eigen::MatrixXf coefficient_curvature_;  // all frames alike
  Eigen::VectorXd mean_curvature_;
};

/// A first guess at the scale that meets a target for a clip of so many bytes.
double likely_scale(const Target& target, std::size_t raw_bytes);

}  // namespace mocapress
