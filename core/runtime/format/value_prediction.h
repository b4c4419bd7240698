// SPDX-License-Identifier: MIT
// Predicts a coefficient's value from those decoded earlier: FORMAT.md, "Prediction of a
// value". Uses integers only, so that every machine decodes the same bits. Based on: Y. V.
// Zakharov, G. P. White and J. Liu, "Low-complexity RLS algorithms using dichotomous coordinate
// descent iterations", 2008 (recursive least squares without inverting a matrix).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "core/runtime/format/mixed_bit.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

/// Number of scales (typical magnitudes) of coefficients, four per octave. kScaleOfOne stands for
/// 1.
inline constexpr int kScales = 64;
inline constexpr int kScaleOfOne = 12;

/// log2(v) in 256ths for v > 0, linear between powers of two.
inline int log2_256(std::uint32_t v) {
  const int digits = static_cast<int>(std::bit_width(v));
  const std::uint32_t mantissa = digits > 9 ? v >> (digits - 9) : v << (9 - digits);
  return 256 * (digits - 1) + static_cast<int>(mantissa & 255);
}

/// 65536 / 2^((scale - kScaleOfOne) / 4), rounded.
extern const std::array<std::int32_t, kScales> kInverseScales;

/// Weights of the features around a coefficient, for the estimate of its magnitude: one set per
/// level. 1024 stands for 1.0. Fitted to corpus/train.
inline constexpr int kScaleFeatures = 18;
inline constexpr int kScaleLevels = 8;
using ScaleWeights = std::array<std::array<std::int16_t, kScaleFeatures>, kScaleLevels>;
extern const ScaleWeights kScaleWeights;

/// Recursive least squares for one signal: predicts a coefficient as a weighted sum of the
/// coefficients around it, and learns the weights. Values are divided by their expected scale, in
/// 64ths.
struct SignalPrediction {
  static constexpr int kTaps = 24;
  static constexpr int kFarthest = 1023;

  void begin();

  /// Predicts from `taps`, of which the first kTaps are used.
  int of(const std::int16_t* taps) const;

  /// Learns from a decoded value: `error` = value - prediction.
  void follow(const std::int16_t* taps, int error);

  std::array<std::int32_t, kTaps * kTaps> products;  // sums of products of two taps, row by row
  std::array<std::int64_t, kTaps> errors;   // for each tap: sum of its products with the error that
                                            // the weights leave
  std::array<std::int32_t, kTaps> weights;  // 16384 = 1.0
  std::int32_t seen;

  static constexpr std::int32_t kMostSeen = 512;  // observations after which all statistics are
                                                  // halved
  static constexpr int kMoves = 3;                // weights updated per observation
  static constexpr std::int64_t kMostLeft = std::int64_t{1}
                                            << 40;  // bound for `errors`, so that hostile bytes
                                                    // cannot overflow them

  void halve();

  /// Updates one weight, and returns the change.
  std::int64_t move_weight(int tap);

  std::int32_t& product(int row, int column) {
    return products[static_cast<std::size_t>(row * kTaps + column)];
  }
};

/// Predicts the error that SignalPrediction leaves, from the same coefficients and from those of
/// more signals. Normalised least mean squares: learns slowly and costs little.
struct RestPrediction {
  static constexpr int kTaps = 56;  // the first ones are those of SignalPrediction
  using Taps = std::array<std::int16_t, kTaps>;

  void begin() { weights.fill(0); }
  int of(const Taps& taps) const;

  /// Learns from a decoded value: `error` = error left by SignalPrediction - prediction.
  void follow(const Taps& taps, int error);

  /// Step size: a weight changes by the step times its tap.
  static std::int16_t step_of(int error, std::int32_t squares) {
    constexpr std::int32_t kRate = 121635;  // 0.116 * 2^20
    return static_cast<std::int16_t>(error * kRate / squares);
  }
  static constexpr std::int32_t kRidge = 58 * 640;  // added to the sum of the taps' squares
  static constexpr std::int32_t kMost = 4 << 20;    // bound for a weight

  std::array<std::int32_t, kTaps> weights;  // 2^20 = 1.0
};

/// Functions of both classes for one instruction set. All instruction sets compute the same
/// integers.
struct PredictionKernels {
  int (*of_signal)(const SignalPrediction&, const std::int16_t* taps);
  void (*signal_follows)(SignalPrediction&, const std::int16_t* taps, int error);
  int (*of_rest)(const RestPrediction&, const RestPrediction::Taps& taps);
  void (*rest_follows)(RestPrediction&, const RestPrediction::Taps& taps, int error);

  /// Divides values by their scale, in 64ths; `inverse` is from kInverseScales.
  void (*normalise)(const std::array<std::int32_t, RestPrediction::kTaps>& values,
                    std::int32_t inverse, RestPrediction::Taps& taps);
};

/// The kernels of a path; null if the build or the machine does not have it.
const PredictionKernels* prediction_of(mcpr_path path);

inline const PredictionKernels& best_prediction() {
  return *prediction_of(MCPR_PATH_BEST);
}

extern const PredictionKernels kPlainPrediction;
extern const PredictionKernels kAvx2Prediction;  // only in a build with AVX2

/// Bound for `value` in normalised(). Larger values give the same result, but their product with
/// `inverse` might overflow 32 bits.
constexpr std::int32_t largest_normal(std::int32_t inverse) {
  return ((SignalPrediction::kFarthest + 1) << 10) / inverse + 1;
}
inline std::int16_t normalised(std::int32_t value, std::int32_t inverse) {
  const std::int32_t most = largest_normal(inverse);
  return static_cast<std::int16_t>(std::clamp(std::clamp(value, -most, most) * inverse >> 10,
                                              -SignalPrediction::kFarthest,
                                              SignalPrediction::kFarthest));
}

/// 2^30 / (1 + exp(i / 4)), i = 0 ... 64.
extern const std::array<std::int32_t, 65> kLogisticTails;

/// Probability distribution of a value: a logistic distribution around its prediction. Its scale is
/// 0.7 of the mean absolute deviation.
class ExpectedValue {
 public:
  /// `mean` is in 64ths; `deviation`, the mean absolute deviation, in 256ths, > 0.
  ExpectedValue(std::int64_t mean, std::int32_t deviation)
      : mean_(mean), inverse_((1463 << 10) / std::max(deviation, 16)) {}

  /// Log odds of a bit, from this distribution and from one that is half as wide.
  using Opinions = std::array<std::int32_t, 2>;

  /// A probability from each of the two distributions, in units of 2^-30.
  using Shares = std::array<std::int32_t, 2>;
  static constexpr std::int32_t kWhole = 1 << 30;

  /// Probabilities of `value` and above, and of -`value` and below.
  Shares from(std::int64_t value) const {
    return {above(64 * value - 32, 0), above(64 * value - 32, 1)};
  }
  Shares down_from_minus(std::int64_t value) const {
    return {kWhole - above(32 - 64 * value, 0), kWhole - above(32 - 64 * value, 1)};
  }

  /// Mirrors the distribution if the value is negative, so that it then describes magnitudes.
  void fold(bool minus) { mean_ = minus ? -mean_ : mean_; }

  /// Log odds of `part` given `whole`.
  static Opinions opinions(const Shares& part, const Shares& whole) {
    return {log_odds(part[0], whole[0]), log_odds(part[1], whole[1])};
  }

 private:
  /// Probability of values above x (64ths), in units of 2^-30.
  std::int32_t above(std::int64_t x, int half) const {
    constexpr std::int64_t kFarthest = 16 << 8;
    const std::int64_t far = std::clamp<std::int64_t>(
        (x - mean_) * inverse_ >> (half != 0 ? 9 : 10), -kFarthest, kFarthest);
    const auto z = static_cast<std::uint32_t>(far < 0 ? -far : far);
    const std::size_t i = z >> 6;
    const std::int32_t tail =
        i >= 64 ? kLogisticTails[64]
                : kLogisticTails[i] -
                      static_cast<std::int32_t>(
                          static_cast<std::int64_t>(kLogisticTails[i] - kLogisticTails[i + 1]) *
                              (z & 63) >>
                          6);
    return far < 0 ? kWhole - tail : tail;
  }

  /// Log odds of `part` given `whole`; 0 if `whole` is too improbable to tell.
  static std::int32_t log_odds(std::int32_t part, std::int32_t whole) {
    if (whole < 256) return 0;
    const int shift =
        std::max(static_cast<int>(std::bit_width(static_cast<std::uint32_t>(whole))) - 18, 0);
    const std::uint32_t p = (static_cast<std::uint32_t>(part) >> shift << 12) /
                            (static_cast<std::uint32_t>(whole) >> shift);
    return kStretched[std::min<std::uint32_t>(p, 4095)];
  }

  std::int64_t mean_;
  std::int32_t inverse_;
};

inline ExpectedValue::Shares sum(const ExpectedValue::Shares& a, const ExpectedValue::Shares& b) {
  return {a[0] + b[0], a[1] + b[1]};
}
inline ExpectedValue::Shares difference(const ExpectedValue::Shares& a,
                                        const ExpectedValue::Shares& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

}  // namespace mocapress::runtime
