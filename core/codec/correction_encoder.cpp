// SPDX-License-Identifier: MIT
#include "core/codec/correction_encoder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/select/truncation.h"

namespace mocapress {
namespace {

constexpr double kBlendSeconds = 0.15;  // before and after a contact

std::vector<Effector> effectors_for(const Skeleton& skeleton, const std::vector<int>& joints) {
  if (joints.empty()) return find_feet(skeleton);
  std::vector<Effector> effectors;
  for (const int joint : joints) effectors.push_back(effector_at(skeleton, joint));
  return effectors;
}

/// 1 in the contacts of a joint's origin, falling smoothly to 0 beside them.
Eigen::VectorXd window_of(int joint, const std::vector<ContactSpan>& contacts, Eigen::Index frames,
                          double sample_rate_hz) {
  const double blend = std::max(1.0, kBlendSeconds * sample_rate_hz);  // frames
  Eigen::VectorXd window = Eigen::VectorXd::Zero(frames);
  for (const ContactSpan& span : contacts) {
    if (span.landmark != joint) continue;
    for (Eigen::Index t = 0; t < frames; ++t) {
      const double off = std::max({0.0, static_cast<double>(span.first_frame - t),
                                   static_cast<double>(t - span.last_frame)});
      const double share = std::min(off / blend, 1.0);
      window(t) = std::max(window(t), 0.5 + 0.5 * std::cos(std::numbers::pi * share));
    }
  }
  return window;
}

/// Ranks the coefficients of one signal anew: a foot that stands is seen to be off the sooner.
void prefer_contacts(RankedCoefficients& ranked, int signal, const Eigen::VectorXd& in_contact) {
  constexpr double kInContact = 2;  // times as important
  const auto frames = static_cast<double>(ranked.per_channel());
  auto importance = ranked.importance.col(signal);
  for (const Band& band : ranked.lifting.bands())
    for (int i = 0; i < band.size; ++i) {
      const auto first = static_cast<Eigen::Index>(frames * i / band.size);
      const auto end = static_cast<Eigen::Index>(std::ceil(frames * (i + 1) / band.size));
      importance(band.first + i) *=
          1 + (kInContact - 1) * in_contact.segment(first, end - first).maxCoeff();
    }
  auto& order = ranked.by_importance[static_cast<std::size_t>(signal)];
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return importance(a) > importance(b); });
}

}  // namespace

std::string_view name(CorrectAt at) {
  return at == CorrectAt::EveryFrame ? "every-frame" : "contacts";
}

CorrectionEncoder::CorrectionEncoder(const Skeleton& skeleton,
                                     const Eigen::MatrixXd& original_tracks,
                                     const CorrectionOptions& options,
                                     const std::vector<ContactSpan>& contacts,
                                     double sample_rate_hz)
    : skeleton_(skeleton),
      solver_(options.solver),
      at_(options.at),
      effectors_(effectors_for(skeleton, options.joints)) {
  if (effectors_.empty())
    throw Error("no feet were found on this skeleton: name the joints to be corrected");
  check_effectors(skeleton, effectors_);
  original_ = effector_tracks(original_tracks, effectors_);
  contacts_.resize(original_.rows(), std::ssize(effectors_));
  for (Eigen::Index e = 0; e < std::ssize(effectors_); ++e)
    contacts_.col(e) = window_of(effectors_[static_cast<std::size_t>(e)].joint, contacts,
                                 original_.rows(), sample_rate_hz);
}

CorrectionEncoder::Selection CorrectionEncoder::select(const Clip& reconstructed, double ratio,
                                                       Basis basis) const {
  Clip differences{reconstructed.sample_rate_hz, original_};
  differences.channels -= effector_tracks(landmark_tracks(skeleton_, reconstructed), effectors_);
  if (at_ == CorrectAt::Contacts)
    for (Eigen::Index s = 0; s < differences.channels.cols(); ++s)
      differences.channels.col(s).array() *= contacts_.col(s / 3).array();

  RankedCoefficients ranked = rank_coefficients(differences, basis);
  for (int s = 0; s < ranked.channels(); ++s) prefer_contacts(ranked, s, contacts_.col(s / 3));
  std::vector<double> alike(static_cast<std::size_t>(ranked.channels()), 1.0);
  const double total = ranked.total();
  const auto count = static_cast<int>(std::lround(std::clamp(total / ratio, 0.0, total)));
  Kept kept = StandardOrder(ranked, alike).keep(count);
  return {std::move(ranked), std::move(kept), std::move(alike)};
}

}  // namespace mocapress
