// SPDX-License-Identifier: MIT
#include "core/codec/clip_analysis.h"

namespace mocapress {

BasisAnalysis::BasisAnalysis(const Motion& motion, Basis basis)
    : BasisAnalysis(motion.clip, channel_scales(motion.skeleton), basis) {}

BasisAnalysis::BasisAnalysis(const Clip& columns, const std::vector<double>& comparable,
                             Basis basis)
    : ranked(rank_coefficients(columns, basis)), standard(ranked, comparable), scales(comparable) {}

ClipAnalysis::ClipAnalysis(Motion motion)
    : motion_(std::move(motion)),
      original_tracks_(landmark_tracks(motion_.skeleton, motion_.clip)),
      contacts_(
          find_foot_contacts(motion_.skeleton, original_tracks_, motion_.clip.sample_rate_hz)) {}

const Coefficients& ClipAnalysis::coefficients(Basis basis) const {
  return coefficients_.get(
      basis, [&] { return std::make_unique<Coefficients>(transform(motion_.clip, basis)); });
}

const BasisAnalysis& ClipAnalysis::in(Basis basis) const {
  return bases_.get(basis, [&] { return std::make_unique<BasisAnalysis>(motion_, basis); });
}

const ErrorModel& ClipAnalysis::model(Weighting weighting) const {
  return models_.get(weighting, [&] {
    return std::make_unique<ErrorModel>(motion_.skeleton, motion_.clip, weighting);
  });
}

const ClosedLoop& ClipAnalysis::closed_loop(Basis basis, Weighting weighting) const {
  // Asked for before: one lock at a time.
  const Coefficients& in_basis = coefficients(basis);
  const ErrorModel& errors = model(weighting);
  return closed_loops_.get(std::pair(basis, weighting), [&] {
    return std::make_unique<ClosedLoop>(in_basis, motion_.clip, errors);
  });
}

}  // namespace mocapress
