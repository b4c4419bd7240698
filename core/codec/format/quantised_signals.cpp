// SPDX-License-Identifier: MIT
#include "core/codec/format/quantised_signals.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "core/base/parallel.h"
#include "core/codec/format/signal_coder.h"

namespace mocapress {

double QuantisedSignals::step(int signal) const {
  return step_of(step_exponent[signal], scale);
}

float file_scale(double scale) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(scale));
  return std::bit_cast<float>((bits + 0x8000) & 0xFFFF0000);
}

int step_exponent_for(double step, float scale) {
  const double halves = std::ceil(2 * std::log2(scale / step) - 1e-9);
  return static_cast<int>(std::clamp<double>(halves, kLeastStepExponent, kMostStepExponent));
}

QuantisedSignals quantise_kept(const RankedCoefficients& ranked, const std::vector<double>& scales,
                               const Kept& kept, float scale) {
  constexpr double kFinest = 0x1p-17;  // radians or cm: invisible
  const std::vector<double> gains = ranked.lifting.gains();
  const Eigen::VectorXd dropped = largest_dropped(ranked, scales, kept);
  const Eigen::MatrixXd coefficients = truncate(ranked, kept);
  QuantisedSignals coded{.scale = scale,
                         .step_exponent = {},
                         .values = Eigen::MatrixXi(coefficients.rows(), coefficients.cols())};
  for (int s = 0; s < ranked.channels(); ++s) {
    coded.step_exponent.push_back(step_exponent_for(std::max(dropped(s), kFinest), scale));
    const double step = coded.step(s);
    for (Eigen::Index c = 0; c < coefficients.rows(); ++c) {
      const double steps = coefficients(c, s) * gains[c] / step;
      coded.values(c, s) =
          static_cast<int>(std::lround(std::clamp<double>(steps, -kMostSteps, kMostSteps)));
    }
  }
  return coded;
}

void append(const QuantisedSignals& more, QuantisedSignals& to) {
  assert(more.scale == to.scale && more.values.rows() == to.values.rows());
  to.step_exponent.insert(to.step_exponent.end(), more.step_exponent.begin(),
                          more.step_exponent.end());
  to.values.conservativeResize(Eigen::NoChange, to.values.cols() + more.values.cols());
  to.values.rightCols(more.values.cols()) = more.values;
}

Eigen::MatrixXd reconstruct(const QuantisedSignals& coded, const Lifting& lifting) {
  const std::vector<double> gains = lifting.gains();
  const Eigen::Map<const Eigen::VectorXd> gain(gains.data(), lifting.length());
  Eigen::MatrixXd samples(coded.values.rows(), coded.values.cols());
  parallel_for(Eigen::Index{0}, samples.cols(), [&](Eigen::Index s) {
    samples.col(s) = coded.values.col(s).cast<double>() * coded.step(static_cast<int>(s));
    samples.col(s).array() /= gain.array();
    const std::span<double> signal(samples.col(s).data(), static_cast<std::size_t>(samples.rows()));
    lifting.inverse(signal, signal);
  });
  return samples;
}

}  // namespace mocapress
