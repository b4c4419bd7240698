// SPDX-License-Identifier: MIT
#include "core/codec/clip_analysis.h"

namespace mocapress {

BasisAnalysis::BasisAnalysis(const Motion& motion, Basis basis)
    : ranked(rank_coefficients(motion.clip, basis)), standard(ranked, motion.skeleton) {
  const std::vector<double> of_each = ranked.lifting.gains();
  gains = Eigen::Map<const Eigen::VectorXd>(of_each.data(), ranked.per_channel());
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
