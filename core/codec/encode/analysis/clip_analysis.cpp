// SPDX-License-Identifier: MIT
#include "core/codec/encode/analysis/clip_analysis.h"

#include "core/codec/encode/analysis/form_choice.h"
#include "core/codec/encode/options/encode_settings.h"
#include "core/metrics/visibility.h"
#include "core/motion/body_tracks.h"

namespace mocapress {

BasisAnalysis::BasisAnalysis(const Motion& motion, Basis basis)
    : BasisAnalysis(motion.clip, channel_scales(motion.skeleton), basis) {}

BasisAnalysis::BasisAnalysis(const Clip& columns, const std::vector<double>& comparable,
                             Basis basis)
    : ranked(rank_coefficients(columns, basis)), standard(ranked, comparable), scales(comparable) {}

const RotationForms& ClipAnalysis::chosen_forms() const {
  return forms_.get(Only(), [&] { return std::make_unique<RotationForms>(choose_forms(motion_)); });
}

const ClipAnalysis& ClipAnalysis::in_chosen_forms() const {
  const RotationForms& forms = chosen_forms();
  if (forms == rotation_forms(motion_.skeleton)) return *this;
  return in_chosen_forms_.get(
      Only(), [&] { return std::make_unique<ClipAnalysis>(with_forms(motion_, forms), *this); });
}

const Eigen::MatrixXd& ClipAnalysis::original_tracks() const {
  if (same_) return same_->original_tracks();
  return original_tracks_.get(Only(), [&] {
    // The body tracks begin with the landmark tracks.
    return std::make_unique<Eigen::MatrixXd>(
        original_body().leftCols(3 * std::ssize(landmarks(motion_.skeleton))));
  });
}

const Eigen::MatrixXd& ClipAnalysis::original_body() const {
  if (same_) return same_->original_body();
  return original_body_.get(Only(), [&] {
    return std::make_unique<Eigen::MatrixXd>(body_tracks(motion_.skeleton, motion_.clip));
  });
}

const Jitter& ClipAnalysis::original_jitter() const {
  if (same_) return same_->original_jitter();
  const Eigen::MatrixXd& tracks = original_body();
  return original_jitter_.get(Only(), [&] {
    return std::make_unique<Jitter>(
        jitter_of(motion_.skeleton, tracks, motion_.clip.sample_rate_hz));
  });
}

const std::vector<ContactSpan>& ClipAnalysis::contacts() const {
  if (same_) return same_->contacts();
  const Eigen::MatrixXd* tracks = is_long() ? nullptr : &original_tracks();
  return contacts_.get(Only(), [&] {
    return std::make_unique<std::vector<ContactSpan>>(
        tracks ? find_foot_contacts(motion_.skeleton, *tracks, motion_.clip.sample_rate_hz)
               : find_foot_contacts(motion_));
  });
}

bool ClipAnalysis::is_long() const {
  return motion_.clip.frames() > SegmentPlan().longest;
}

Loop ClipAnalysis::loop() const {
  const Eigen::MatrixXd* tracks = is_long() ? nullptr : &original_tracks();
  return loop_.get({}, [&] {
    return std::make_unique<Loop>(tracks ? find_loop(motion_, *tracks) : find_loop(motion_));
  });
}

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
  // Computed before the lock of closed_loops_ is taken, so that no thread holds two locks.
  const Coefficients& in_basis = coefficients(basis);
  const ErrorModel& errors = model(weighting);
  return closed_loops_.get(std::pair(basis, weighting), [&] {
    return std::make_unique<ClosedLoop>(in_basis, motion_.clip, errors);
  });
}

}  // namespace mocapress
