// SPDX-License-Identifier: MIT
#include "core/codec/clip_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/codec/rle16.h"

namespace mocapress {

BasisAnalysis::BasisAnalysis(const Motion& motion, Basis basis)
    : BasisAnalysis(motion.clip, channel_scales(motion.skeleton), basis) {}

BasisAnalysis::BasisAnalysis(const Clip& signals, const std::vector<double>& comparable,
                             Basis basis)
    : ranked(rank_coefficients(signals, basis)), standard(ranked, comparable), scales(comparable) {
  const std::vector<double> of_each = ranked.lifting.gains();
  gains = Eigen::Map<const Eigen::VectorXd>(of_each.data(), ranked.per_channel());
}

std::vector<std::byte> BasisAnalysis::rle16(const Kept& kept) const {
  constexpr double kNothing = 1e-9;  // radians or cm: the rounding of the transform
  Eigen::VectorXd dropped = Eigen::VectorXd::Zero(ranked.channels());
  double finest = std::numeric_limits<double>::infinity();
  for (int c = 0; c < ranked.channels(); ++c) {
    const auto channel = static_cast<std::size_t>(c);
    const auto rank = static_cast<std::size_t>(kept[channel]);
    const auto& order = ranked.by_importance[channel];
    if (rank < order.size())
      dropped(c) = std::abs(ranked.values(order[rank], c)) * gains(order[rank]);
    if (dropped(c) > kNothing) finest = std::min(finest, dropped(c) * scales[channel]);
  }
  // A channel that is kept whole needs digits a little finer than the finest of the others, for
  // they are all its error, but not the finest there are.
  for (int c = 0; c < ranked.channels() && std::isfinite(finest); ++c)
    if (dropped(c) <= kNothing) dropped(c) = finest / (4 * scales[static_cast<std::size_t>(c)]);
  return rle16_encode(gains.asDiagonal() * truncate(ranked, kept), dropped);
}

ClipAnalysis::ClipAnalysis(Motion motion)
    : motion_(std::move(motion)),
      original_tracks_(landmark_tracks(motion_.skeleton, motion_.clip)) {}

const BasisAnalysis& ClipAnalysis::in(Basis basis) const {
  return bases_.get(basis, [&] { return std::make_unique<BasisAnalysis>(motion_, basis); });
}

const ErrorModel& ClipAnalysis::model(Weighting weighting) const {
  return models_.get(weighting, [&] {
    return std::make_unique<ErrorModel>(motion_.skeleton, motion_.clip, weighting);
  });
}

}  // namespace mocapress
