// SPDX-License-Identifier: MIT
#include "core/codec/format/signal_coder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/codec/format/deflate.h"
#include "core/codec/format/rle16.h"

namespace mocapress {
namespace {

Eigen::VectorXd gains_of(const Lifting& lifting) {
  const std::vector<double> gains = lifting.gains();
  return Eigen::Map<const Eigen::VectorXd>(gains.data(), lifting.length());
}

}  // namespace

std::string_view name(Coding coding) {
  switch (coding) {
    case Coding::Rle16:
      return "rle16";
    case Coding::Deflate:
      return "deflate";
    case Coding::Adaptive:
      return "adaptive";
  }
  return "unknown";
}

Eigen::VectorXd largest_dropped(const RankedCoefficients& ranked, const std::vector<double>& scales,
                                const Kept& kept) {
  const Eigen::VectorXd gains = gains_of(ranked.lifting);
  constexpr double kNothing = 1e-9;  // radians or cm: rounding of the transform
  Eigen::VectorXd dropped = Eigen::VectorXd::Zero(ranked.channels());
  double finest = std::numeric_limits<double>::infinity();
  for (int c = 0; c < ranked.channels(); ++c) {
    const auto signal = static_cast<std::size_t>(c);
    const auto rank = static_cast<std::size_t>(kept[signal]);
    const auto& order = ranked.by_importance[signal];
    if (rank < order.size())
      dropped(c) = std::abs(ranked.values(order[rank], c)) * gains(order[rank]);
    if (dropped(c) > kNothing) finest = std::min(finest, dropped(c) * scales[signal]);
  }
  // A signal kept whole has no error but its rounding, so it needs steps a little finer than the
  // finest of the others, but not the finest possible.
  for (int c = 0; c < ranked.channels() && std::isfinite(finest); ++c)
    if (dropped(c) <= kNothing) dropped(c) = finest / (4 * scales[c]);
  return dropped;
}

std::vector<std::byte> code_signals(const RankedCoefficients& ranked,
                                    const std::vector<double>& scales, const Kept& kept) {
  const Eigen::VectorXd gains = gains_of(ranked.lifting);
  return rle16_encode(gains.asDiagonal() * truncate(ranked, kept),
                      largest_dropped(ranked, scales, kept));
}

double word_step(double step) {
  return std::exp2(std::clamp(std::floor(std::log2(step)), kFinestExponent, 120.0));
}

std::vector<std::byte> code_steps(const Eigen::MatrixXi& values, const Eigen::VectorXd& steps) {
  // rle16_encode() makes steps of half of the largest dropped coefficient, so twice the step is
  // passed.
  return rle16_encode(values.cast<double>() * steps.asDiagonal(), 2 * steps);
}

std::vector<std::byte> pack(const std::vector<std::byte>& words, Coding coding) {
  return coding == Coding::Rle16 ? words : deflate_bytes(words);
}

std::vector<std::byte> unpack(std::span<const std::byte> bytes, Coding coding,
                              std::size_t most_bytes) {
  if (coding == Coding::Rle16) return {bytes.begin(), bytes.end()};
  return inflate_bytes(bytes, most_bytes);
}

}  // namespace mocapress
