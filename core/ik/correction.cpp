// SPDX-License-Identifier: MIT
#include "core/ik/correction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <mutex>

#include "core/base/parallel.h"
#include "core/ik/limb.h"
#include "core/motion/forward_kinematics.h"

namespace mocapress {

namespace {

/// Corrects frames in one thread: holds the limbs, and each limb's effectors as indices into the
/// list of all effectors.
class Corrector {
 public:
  Corrector(const Skeleton& skeleton, const std::vector<Effector>& effectors, IkSolver solver)
      : solver_(solver), limbs_(limbs_of(skeleton, effectors)) {
    for (const Limb& limb : limbs_) {
      places_.emplace_back();
      for (const Effector& effector : limb.effectors()) {
        const auto place = std::ranges::find_if(
            effectors, [&](const Effector& e) { return e.joint == effector.joint; });
        places_.back().push_back(place - effectors.begin());
      }
    }
  }

  void correct(const Eigen::MatrixXd& differences, int frame, Clip& clip,
               CorrectionReport& report) {
    for (std::size_t l = 0; l < limbs_.size(); ++l) {
      Limb& limb = limbs_[l];
      limb.set_frame(clip.channels.row(frame));
      targets_.clear();
      for (std::size_t e = 0; e < places_[l].size(); ++e)
        targets_.push_back(limb.position(static_cast<int>(e)) +
                           differences.block<1, 3>(frame, 3 * places_[l][e]).transpose());
      const IkOutcome outcome = solve(solver_, limb, targets_);
      // Rounds to 32-bit floats as the runtime does, since errors are measured on its values.
      for (int a = 0; a < limb.angle_count(); ++a)
        clip.channels(frame, limb.channel(a)) = static_cast<float>(limb.angles()(a));
      report.worst_miss_cm = std::max(report.worst_miss_cm, outcome.miss_cm);
      report.unreached += outcome.reached ? 0 : 1;
      report.iterations += outcome.iterations;
    }
  }

 private:
  IkSolver solver_;
  std::vector<Limb> limbs_;
  std::vector<std::vector<Eigen::Index>> places_;
  std::vector<Eigen::Vector3d> targets_;
};

}  // namespace

void CorrectionReport::add(const CorrectionReport& other) {
  worst_miss_cm = std::max(worst_miss_cm, other.worst_miss_cm);
  unreached += other.unreached;
  iterations += other.iterations;
}

Eigen::MatrixXd effector_tracks(const Eigen::MatrixXd& landmark_tracks,
                                const std::vector<Effector>& effectors) {
  Eigen::MatrixXd tracks(landmark_tracks.rows(), 3 * std::ssize(effectors));
  for (Eigen::Index e = 0; e < std::ssize(effectors); ++e)
    tracks.middleCols<3>(3 * e) = landmark_tracks.middleCols<3>(3 * effectors[e].joint);
  return tracks;
}

CorrectionReport apply_correction(const Skeleton& skeleton, const std::vector<Effector>& effectors,
                                  IkSolver solver, const Eigen::MatrixXd& differences, Clip& clip) {
  assert(differences.rows() == clip.channels.rows());
  assert(differences.cols() == 3 * std::ssize(effectors));
  CorrectionReport all;
  std::mutex mutex;  // guards the report
  parallel_ranges(0, clip.frames(), 64, [&](int first, int end) {
    Corrector corrector(skeleton, effectors, solver);
    CorrectionReport report;
    for (int t = first; t < end; ++t) corrector.correct(differences, t, clip, report);
    const std::lock_guard lock(mutex);
    all.add(report);
  });
  return all;
}

namespace {

Eigen::Matrix3d local_rotation(const Skeleton& skeleton, int joint, const Clip& clip, int frame) {
  const auto channels = static_cast<Eigen::Index>(skeleton.joint(joint).channels.size());
  return joint_rotation(skeleton.joint(joint),
                        clip.channels.row(frame).segment(skeleton.first_channel(joint), channels));
}

}  // namespace

int knee_of(const Effector& effector) {
  return effector.chain[std::min<std::size_t>(1, effector.chain.size() - 1)];
}

KneeSpeed::KneeSpeed(const Skeleton& skeleton, const std::vector<Effector>& effectors)
    : skeleton_(skeleton), effectors_(effectors) {}

void KneeSpeed::add(const Clip& frames) {
  const bool is_first = last_.empty();
  last_.resize(effectors_.size());
  for (std::size_t e = 0; e < effectors_.size(); ++e)
    for (int t = 0; t < frames.frames(); ++t) {
      const Eigen::Matrix3d now = local_rotation(skeleton_, knee_of(effectors_[e]), frames, t);
      if (t > 0 || !is_first) {
        const double angle = Eigen::AngleAxisd(last_[e].transpose() * now).angle();
        fastest_ = std::max(fastest_, angle * frames.sample_rate_hz);
      }
      last_[e] = now;
    }
}

double fastest_knee(const Skeleton& skeleton, const std::vector<Effector>& effectors,
                    const Clip& clip) {
  KneeSpeed speed(skeleton, effectors);
  speed.add(clip);
  return speed.fastest();
}

}  // namespace mocapress
