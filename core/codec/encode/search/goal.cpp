// SPDX-License-Identifier: MIT
#include "core/codec/encode/search/goal.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/codec/decode/decoder.h"
#include "core/metrics/distortion.h"
#include "core/metrics/rate.h"

namespace mocapress {

void Original::compare(int first_frame, const Skeleton& skeleton, const Clip& decoded,
                       const Visit& visit) const {
  visit_tracks(skeleton, decoded, [&](int first, const Eigen::MatrixXd& tracks) {
    const int from = first_frame + first;
    const auto count = static_cast<int>(tracks.rows());
    if (tracks_)
      visit(from, tracks_().middleRows(from, count), tracks);
    else
      visit(from, body_tracks(motion_.skeleton, frames_of(motion_, from, count).clip), tracks);
  });
}

void Original::compare(const CompressedClip& compressed, const Visit& visit) const {
  const Skeleton skeleton = compressed.coded_skeleton();
  const Finish finish(compressed);
  visit_decoded(compressed, [&](int first, Uncorrected& block) {
    finish(first, block);
    compare(first, skeleton, block.clip, visit);
  });
}

namespace {

constexpr double kTolerance = 0.02;

}  // namespace

double Goal::achieved(std::size_t motion_bytes, const Comparison& compare) const {
  const Motion& motion = original_.motion();
  const auto measured = [&] {
    DistortionMeter meter(motion.skeleton, motion.clip.frames(), Detail::Means, weighting_,
                          frame_factors_);
    compare([&](int first, const TrackRows& original, const TrackRows& decoded) {
      meter.add(first, original, decoded);
    });
    return meter;
  };
  switch (target_.kind) {
    case Target::Kind::CoefficientRatio:
      return target_.value;  // counted by the encoder
    case Target::Kind::Ratio:
      return compression_ratio(motion.clip, motion_bytes);
    case Target::Kind::Size:
      return static_cast<double>(motion_bytes);
    case Target::Kind::Error:
      return measured().eps();
    case Target::Kind::MaxError:
      return measured().worst().cm;
    case Target::Kind::Visibility:
      return most_noticed(seen(compare));
  }
  return 0;
}

double Goal::most_noticed(const Visibility& seen) const {
  if (frame_factors_.size() == 0) return seen.worst().times_noticed();
  const Eigen::VectorXf worst = seen.table.times_noticed.rowwise().maxCoeff();
  double most = 0;
  for (Eigen::Index t = 0; t < frame_factors_.size(); ++t) {
    const float in_window = worst(seen.table.window_of(static_cast<int>(t)));
    most = std::max(most, frame_factors_(t) * static_cast<double>(in_window));
  }
  return most;
}

Visibility Goal::seen(const Comparison& compare) const {
  const Motion& motion = original_.motion();
  VisibilityMeter meter(motion.skeleton, motion.clip.frames(), motion.clip.sample_rate_hz,
                        contacts_, limits_);
  compare([&](int first, const TrackRows& original, const TrackRows& decoded) {
    meter.add(first, original, decoded);
  });
  return meter.visibility();
}

Visibility Goal::seen(const CompressedClip& compressed) const {
  return seen([&](const Original::Visit& visit) { original_.compare(compressed, visit); });
}

double Goal::achieved(const CompressedClip& compressed) const {
  return achieved(compressed.motion_bytes(), Comparison([&](const Original::Visit& visit) {
                    original_.compare(compressed, visit);
                  }));
}

double Goal::achieved(std::size_t motion_bytes, const std::function<Clip()>& decoded) const {
  return achieved(motion_bytes, Comparison([&](const Original::Visit& visit) {
                    original_.compare(0, original_.motion().skeleton, decoded(), visit);
                  }));
}

double Goal::excess(double achieved) const {
  constexpr double kLeast = 1e-9;  // a perfect reconstruction has no logarithm
  const double quotient = std::max(achieved, kLeast) / std::max(target_.value, kLeast);
  return target_.kind == Target::Kind::Size ? std::log(quotient) : -std::log(quotient);
}

bool Goal::met(double excess) const {
  switch (target_.kind) {
    case Target::Kind::Ratio:
    case Target::Kind::CoefficientRatio:
      return std::abs(std::expm1(-excess)) <= kTolerance;
    case Target::Kind::Size:
      return excess <= 0;
    default:
      return excess >= 0;
  }
}

void Goal::require_met(double excess, double achieved, bool everything_kept) const {
  if (met(excess) || (target_.kind == Target::Kind::Ratio && everything_kept && excess < 0)) return;
  throw TargetMissed(out_of_reach(target_, achieved));
}

void Goal::raise_where_exceeded(const CompressedClip& compressed, Eigen::VectorXd& weights) const {
  constexpr double kMostWeight = 1e4;
  constexpr double kNear = 0.9;  // share of the target
  constexpr double kPower = 4;   // exponent on the excess; the square alone takes many more rounds
  const auto raise = [&](Eigen::Index frame, double excess) {
    if (excess > 1)
      weights(frame) = std::min(weights(frame) * std::pow(excess, kPower), kMostWeight);
  };
  if (target_.kind == Target::Kind::Visibility) {
    const SightTable table = seen(compressed).table;
    const Eigen::VectorXf worst = table.times_noticed.rowwise().maxCoeff();
    for (Eigen::Index t = 0; t < weights.size(); ++t)
      raise(t, factor_at(t) * static_cast<double>(worst(table.window_of(static_cast<int>(t)))) /
                   (kNear * target_.value));
    return;
  }
  const Eigen::VectorXd worst = worst_of_frames(compressed);
  for (Eigen::Index t = 0; t < weights.size(); ++t) raise(t, worst(t) / (kNear * target_.value));
}

EndErrors Goal::ends(const CompressedClip& compressed) const {
  const Skeleton& skeleton = original_.motion().skeleton;
  const PointErrors errors(skeleton, Weighting::Surface);
  EndErrorMeter meter(std::ssize(landmarks(skeleton)));
  original_.compare(compressed, [&](int, const TrackRows& original, const TrackRows& decoded) {
    meter.add(original, decoded, errors.squared(original, decoded) * errors.measured().weights);
  });
  return meter.errors();
}

Eigen::VectorXd Goal::worst_of_frames(const CompressedClip& compressed) const {
  const PointErrors errors(original_.motion().skeleton, weighting_);
  Eigen::VectorXd worst(compressed.frames);
  original_.compare(compressed,
                    [&](int first, const TrackRows& original, const TrackRows& decoded) {
                      worst.segment(first, original.rows()) =
                          errors.squared(original, decoded).rowwise().maxCoeff().cwiseSqrt();
                    });
  if (frame_factors_.size() > 0) worst.array() *= frame_factors_.array();
  return worst;
}

Eigen::VectorXd Goal::bounds(int frames) const {
  Eigen::VectorXd bounds = Eigen::VectorXd::Constant(frames, target_.value);
  if (frame_factors_.size() > 0) bounds.array() /= frame_factors_.array();
  return bounds;
}

bool Goal::better(double excess, double other) const {
  return met(excess) != met(other) ? met(excess) : std::abs(excess) < std::abs(other);
}

CountSearch::Window Goal::window() const {
  switch (target_.kind) {
    case Target::Kind::Ratio:
    case Target::Kind::CoefficientRatio:
      return {-kTolerance / 4, kTolerance / 4};
    case Target::Kind::Size:
      return {-kTolerance / 2, 0};
    default:
      return {0, kTolerance / 2};
  }
}

double Goal::likely_coefficient_ratio() const {
  constexpr double kUsual = 0.45;  // r over the ratio; the paper's section 6.1 gives 0.6
  switch (target_.kind) {
    case Target::Kind::CoefficientRatio:
      return target_.value;
    case Target::Kind::Ratio:
      return kUsual * target_.value;
    case Target::Kind::Size:
      return kUsual * static_cast<double>(raw_bytes(original_.motion().clip)) /
             std::max(target_.value, 1.0);
    default:
      return 15;
  }
}

}  // namespace mocapress
