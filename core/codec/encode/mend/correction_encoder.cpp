// SPDX-License-Identifier: MIT
#include "core/codec/encode/mend/correction_encoder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/feet/feet.h"
#include "core/ik/solve.h"

namespace mocapress {
namespace {

constexpr double kBlendSeconds = 0.15;  // before and after a contact

// Weights of an effector's squared errors during contacts, relative to those elsewhere. Errors of a
// planted foot are noticed sooner, and sliding sooner still.
constexpr double kPlaceInContact = 4;
constexpr double kStepInContact = 300;

// The weight of a corrected effector's error in the motion, relative to a squared cm of eps_x. With
// a higher weight the motion spends bytes on errors that the correction mends anyway; with a lower
// one the differences need more than their share.
constexpr double kCorrected = 0.02;

std::vector<Effector> effectors_for(const Skeleton& skeleton, const std::vector<int>& joints) {
  if (joints.empty()) return find_feet(skeleton);
  std::vector<Effector> effectors;
  for (const int joint : joints) effectors.push_back(effector_at(skeleton, joint));
  return effectors;
}

/// Returns 1 during the contacts of a joint's origin, falling smoothly to 0 beside them.
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

/// Returns 1 where a contact continues from the previous frame; the step into a contact is no
/// slide.
Eigen::VectorXd steps_in_contact(const Eigen::ArrayXd& contact) {
  Eigen::VectorXd within = Eigen::VectorXd::Zero(contact.size());
  for (Eigen::Index t = 1; t < contact.size(); ++t)
    if (contact(t - 1) == 1 && contact(t) == 1) within(t) = 1;
  return within;
}

}  // namespace

CorrectionEncoder::CorrectionEncoder(const Skeleton& skeleton,
                                     const Eigen::MatrixXd& original_tracks,
                                     const EncodeCorrection& settings,
                                     const std::vector<ContactSpan>& contacts,
                                     double sample_rate_hz)
    : skeleton_(skeleton),
      solver_(settings.solver),
      at_(settings.at),
      effectors_(effectors_for(skeleton, settings.joints)) {
  if (effectors_.empty())
    throw Error("no feet were found on this skeleton: name the joints to be corrected");
  check_effectors(skeleton, effectors_);
  original_ = effector_tracks(original_tracks, effectors_);
  contacts_.resize(original_.rows(), std::ssize(effectors_));
  for (Eigen::Index e = 0; e < std::ssize(effectors_); ++e)
    contacts_.col(e) = window_of(effectors_[e].joint, contacts, original_.rows(), sample_rate_hz);
}

std::vector<PointResponse> CorrectionEncoder::responses(
    const Clip& original, const Eigen::MatrixXd& original_tracks) const {
  std::vector<PointResponse> responses;
  for (LimbResponse& limb : limb_responses(skeleton_, effectors_, solver_, original)) {
    PointResponse& response = responses.emplace_back();
    for (const Effector& effector : limb.effectors) response.joints.push_back(effector.joint);
    response.places = effector_tracks(original_tracks, limb.effectors);
    response.angles = std::move(limb.channels);
    response.turns = std::move(limb.turns);
    response.weights.setConstant(original.frames(), std::ssize(limb.effectors), kCorrected);
    if (at_ == CorrectAt::Contacts) limit_to_contacts(limb.effectors, response);
  }
  return responses;
}

/// Limits a limb's response to contacts; elsewhere the correction leaves points where the motion
/// puts them.
void CorrectionEncoder::limit_to_contacts(const std::vector<Effector>& effectors,
                                          PointResponse& response) const {
  const Eigen::Index points = std::ssize(effectors);
  for (Eigen::Index p = 0; p < points; ++p) {
    const auto joint = effectors[p].joint;
    const auto found =
        std::ranges::find_if(effectors_, [&](const Effector& e) { return e.joint == joint; });
    const auto contact = contacts_.col(found - effectors_.begin()).array();
    response.weights.col(p).array() *= contact;
    for (Eigen::Index a = 0; a < std::ssize(response.angles); ++a)
      response.turns.middleCols(3 * (points * a + p), 3).array().colwise() *= contact;
  }
}

DifferenceFit CorrectionEncoder::select(const Clip& reconstructed, double ratio, Basis basis,
                                        const CodedStep& coded_step) const {
  Clip differences{reconstructed.sample_rate_hz, original_};
  differences.channels -= effector_tracks(landmark_tracks(skeleton_, reconstructed), effectors_);
  if (at_ == CorrectAt::Contacts)
    for (Eigen::Index s = 0; s < differences.channels.cols(); ++s)
      differences.channels.col(s).array() *= contacts_.col(s / 3).array();

  std::vector<FitWeights> weights;
  for (Eigen::Index s = 0; s < differences.channels.cols(); ++s) {
    const auto contact = contacts_.col(s / 3).array();
    const bool up = s % 3 == 1;  // vertical movement is no slide
    weights.push_back({.place = 1 + (kPlaceInContact - 1) * contact,
                       .step = (up ? 0 : kStepInContact) * steps_in_contact(contact)});
  }
  const auto total = static_cast<double>(differences.channels.size());
  const auto count = static_cast<int>(std::lround(std::clamp(total / ratio, 0.0, total)));
  return fit_differences(differences, weights, basis, count, coded_step);
}

}  // namespace mocapress
