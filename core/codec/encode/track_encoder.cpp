// SPDX-License-Identifier: MIT
#include "core/codec/encode/track_encoder.h"

#include <algorithm>
#include <optional>

#include "core/base/parallel.h"
#include "core/codec/decode/decoder.h"

namespace mocapress {
namespace {

/// A track coded as a curve.
struct Curve {
  int step_exponent = 0;
  Eigen::VectorXi values;
  std::size_t bytes = 0;
};

/// Finds curves for tracks of one length that stay within a bound of the tracks.
class CurveFinder {
 public:
  CurveFinder(int frames, double bound)
      : lifting_(Basis::Cubic, frames), bound_(bound), scale_(file_scale(bound)) {
    const std::vector<double> gains = lifting_.gains();
    gains_ = Eigen::Map<const Eigen::VectorXd>(gains.data(), frames);
  }

  float scale() const { return scale_; }
  Basis basis() const { return lifting_.basis(); }

  /// The curve with the fewest bytes; nothing if no step is fine enough.
  std::optional<Curve> find(const std::vector<float>& samples) const;

 private:
  std::optional<Curve> fit(const Eigen::VectorXd& samples, int step_exponent) const;

  Lifting lifting_;
  double bound_;
  float scale_;
  Eigen::VectorXd gains_;
};

std::optional<Curve> CurveFinder::find(const std::vector<float>& samples) const {
  constexpr int kCoarsest = -8;  // half octaves: 16 times the bound
  constexpr int kFinest = 12;    // finer steps do not help: rounding to floats exceeds the bound
  constexpr int kMore =
      3;  // finer steps tried after the first that is within the bound: some take fewer bytes
  const Eigen::VectorXd wanted =
      Eigen::Map<const Eigen::VectorXf>(samples.data(), static_cast<Eigen::Index>(samples.size()))
          .cast<double>();
  std::optional<Curve> best;
  int last = kFinest;
  for (int step_exponent = kCoarsest; step_exponent <= last; ++step_exponent) {
    std::optional<Curve> found = fit(wanted, step_exponent);
    if (!found) continue;
    if (!best) last = std::min(last, step_exponent + kMore);
    if (!best || found->bytes < best->bytes) best = std::move(found);
  }
  return best;
}

/// Rounds coefficients to steps. Where samples are then too far off, shifts their aims the other
/// way and tries again.
std::optional<Curve> CurveFinder::fit(const Eigen::VectorXd& samples, int step_exponent) const {
  constexpr int kCorrections = 12;
  const double step = step_of(step_exponent, scale_);
  Eigen::VectorXd aim = samples;
  Eigen::VectorXd coefficients(samples.size());
  Curve curve{step_exponent, Eigen::VectorXi(samples.size()), 0};
  for (int n = 0; n <= kCorrections; ++n) {
    lifting_.forward({aim.data(), static_cast<std::size_t>(aim.size())},
                     {coefficients.data(), static_cast<std::size_t>(coefficients.size())});
    const Eigen::ArrayXd steps = coefficients.array() * gains_.array() / step;
    if (!(steps.abs().maxCoeff() < kMostSteps)) return std::nullopt;
    curve.values = steps.round().cast<int>();
    const Eigen::VectorXd error =
        decode_signals(curve.values, {static_cast<float>(step)}, basis()).col(0) - samples;
    const double worst = error.cwiseAbs().maxCoeff();
    if (worst <= bound_) {
      curve.bytes = curve_bytes({scale_, {step_exponent}, curve.values}).size();
      return curve;
    }
    if (worst > 8 * bound_) return std::nullopt;
    aim -= error - error.cwiseMax(-0.7 * bound_).cwiseMin(0.7 * bound_);
  }
  return std::nullopt;
}

}  // namespace

CodedTracks encode_tracks(const ScalarTracks& tracks, double bound) {
  CodedTracks coded{tracks, std::vector<bool>(tracks.size()), Basis::Cubic, {}};
  if (tracks.empty() || tracks.front().values.empty()) return coded;
  const auto frames = static_cast<int>(tracks.front().values.size());
  const CurveFinder finder(frames, bound);
  std::vector<std::optional<Curve>> curves(tracks.size());
  parallel_for(std::size_t{0}, tracks.size(), [&](std::size_t t) {
    const std::size_t held = held_bits(tracks[t]);
    constexpr std::size_t kFewBits = 64;  // no curve takes less
    if (held <= kFewBits || tracks[t].steps) return;
    curves[t] = finder.find(tracks[t].values);
    if (curves[t] && 8 * curves[t]->bytes >= held) curves[t].reset();
  });
  coded.curves.scale = finder.scale();
  coded.basis = finder.basis();
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    if (!curves[t]) continue;
    coded.is_curve[t] = true;
    coded.tracks[t].values.clear();
    coded.curves.step_exponent.push_back(curves[t]->step_exponent);
  }
  coded.curves.values.resize(frames, coded.curves.step_exponent.size());
  Eigen::Index column = 0;
  for (const auto& curve : curves)
    if (curve) coded.curves.values.col(column++) = curve->values;
  return coded;
}

std::vector<std::byte> with_tracks(std::span<const std::byte> mcpr, const ScalarTracks& tracks,
                                   double bound) {
  return with_coded_tracks(mcpr, encode_tracks(tracks, bound));
}

}  // namespace mocapress
