// SPDX-License-Identifier: MIT
#include "core/codec/clip_analysis.h"

#include <cmath>

#include "core/codec/rle16.h"

namespace mocapress {

BasisAnalysis::BasisAnalysis(const Motion& motion, Basis basis)
    : BasisAnalysis(motion.clip, channel_scales(motion.skeleton), basis) {}

BasisAnalysis::BasisAnalysis(const Clip& signals, const std::vector<double>& scales, Basis basis)
    : ranked(rank_coefficients(signals, basis)), standard(ranked, scales) {
  const std::vector<double> of_each = ranked.lifting.gains();
  gains = Eigen::Map<const Eigen::VectorXd>(of_each.data(), ranked.per_channel());
}

std::vector<std::byte> BasisAnalysis::rle16(const Kept& kept) const {
  Eigen::VectorXd dropped = Eigen::VectorXd::Zero(ranked.channels());
  for (int c = 0; c < ranked.channels(); ++c) {
    const auto rank = static_cast<std::size_t>(kept[static_cast<std::size_t>(c)]);
    const auto& order = ranked.by_importance[static_cast<std::size_t>(c)];
    if (rank < order.size())
      dropped(c) = std::abs(ranked.values(order[rank], c)) * gains(order[rank]);
  }
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
