// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 6.3. METHODS.md
// defines the bytes.

#include "core/baselines/quaternion.h"

#include <Eigen/Geometry>

#include "core/baselines/rivals.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/encode/analysis/clip_analysis.h"
#include "core/codec/format/rle16.h"
#include "core/codec/format/signal_coder.h"
#include "core/motion/forward_kinematics.h"
#include "core/select/annealing.h"
#include "core/select/ranking.h"

namespace mocapress {

namespace {

/// The rotation of a quaternion of any length. A quaternion of length 0 gives the identity.
Eigen::Matrix3d rotation_of(const Eigen::RowVector4d& wxyz) {
  constexpr double kLeast = 1e-12;
  const Eigen::Quaterniond q(wxyz(0), wxyz(1), wxyz(2), wxyz(3));
  return q.norm() > kLeast ? q.normalized().toRotationMatrix() : Eigen::Matrix3d::Identity();
}

/// The rotation vectors of small changes to the unit quaternion `wxyz`, one row for each of its
/// components e: a unit of e turns by 2 vec(e q*). Changes of length are ignored, since the decoder
/// corrects them.
Eigen::Matrix<double, 4, 3> turns_of_components(const Eigen::RowVector4d& wxyz) {
  const Eigen::Quaterniond conjugate(wxyz(0), -wxyz(1), -wxyz(2), -wxyz(3));
  Eigen::Matrix<double, 4, 3> turns;
  for (int component = 0; component < 4; ++component) {
    const Eigen::RowVector4d e = Eigen::RowVector4d::Unit(component);
    const Eigen::Quaterniond turned = Eigen::Quaterniond(e(0), e(1), e(2), e(3)) * conjugate;
    turns.row(component) = 2 * turned.vec().transpose();
  }
  return turns;
}

}  // namespace

QuaternionSignals::QuaternionSignals(const Skeleton& skeleton) : skeleton_(skeleton) {
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Joint& joint = skeleton.joint(j);
    JointSignals signals{j, count(), {}, turns(joint)};
    for (std::size_t i = 0; i < joint.channels.size(); ++i)
      if (!is_rotation(joint.channels[i]))
        signals.translations.push_back(skeleton.first_channel(j) + static_cast<int>(i));
    joints_.push_back(std::move(signals));
  }
}

Eigen::MatrixXd QuaternionSignals::of(const Clip& clip) const {
  Eigen::MatrixXd signals(clip.frames(), count());
  for (const JointSignals& of : joints_) {
    signals.middleCols(of.first, std::ssize(of.translations)) =
        clip.channels(Eigen::all, of.translations);
    if (!of.turns) continue;
    const Joint& joint = skeleton_.joint(of.joint);
    const auto values =
        clip.channels.middleCols(skeleton_.first_channel(of.joint), std::ssize(joint.channels));
    Eigen::RowVector4d previous(1, 0, 0, 0);
    for (int t = 0; t < clip.frames(); ++t) {
      const Eigen::Quaterniond q(joint_rotation(joint, values.row(t)));
      const Eigen::RowVector4d wxyz(q.w(), q.x(), q.y(), q.z());
      previous = wxyz.dot(previous) < 0 ? Eigen::RowVector4d(-wxyz) : wxyz;
      signals.block<1, 4>(t, of.quaternion()) = previous;
    }
  }
  return signals;
}

Clip QuaternionSignals::clip_of(const Eigen::MatrixXd& signals, double sample_rate_hz) const {
  Clip clip{sample_rate_hz, Eigen::MatrixXd(signals.rows(), skeleton_.channel_count())};
  for (const JointSignals& of : joints_) {
    const Joint& joint = skeleton_.joint(of.joint);
    const int first = skeleton_.first_channel(of.joint);
    Eigen::RowVectorXd values = Eigen::RowVectorXd::Zero(std::ssize(joint.channels));
    for (Eigen::Index t = 0; t < signals.rows(); ++t) {
      if (of.turns) turn_joint(joint, rotation_of(signals.block<1, 4>(t, of.quaternion())), values);
      for (std::size_t i = 0; i < of.translations.size(); ++i)
        values(of.translations[i] - first) = signals(t, of.first + static_cast<Eigen::Index>(i));
      clip.channels.row(t).segment(first, values.size()) = values;
    }
  }
  return clip;
}

SignalMoves QuaternionSignals::moves(const Clip& clip, const Eigen::MatrixXd& signals) const {
  SignalMoves moves;
  moves.axes.resize(signals.rows(), 3 * signals.cols());
  for (const JointSignals& of : joints_)
    for (int s = of.first; s < of.end(); ++s)
      moves.places.push_back({of.joint, s >= of.quaternion()});
  Pose pose;
  for (int t = 0; t < clip.frames(); ++t) {
    compute_pose(skeleton_, clip.channels.row(t), pose);
    const auto set = [&](int signal, const Eigen::Vector3d& in_world) {
      moves.axes.block<1, 3>(t, 3 * static_cast<Eigen::Index>(signal)) = in_world.transpose();
    };
    for (const JointSignals& of : joints_) {
      const Joint& joint = skeleton_.joint(of.joint);
      const Eigen::Matrix3d world_from_parent =
          joint.parent < 0 ? Eigen::Matrix3d::Identity() : pose.world_from_joint[joint.parent];
      int signal = of.first;
      for (const int channel : of.translations)
        set(signal++, world_from_parent.col(axis_of(skeleton_.channel_kind(channel))));
      if (!of.turns) continue;
      const auto of_components = turns_of_components(signals.block<1, 4>(t, signal));
      for (const auto& turn : of_components.rowwise())
        set(signal++, world_from_parent * joint.joint_from_axes * turn.transpose());
    }
  }
  return moves;
}

std::vector<double> QuaternionSignals::scales() const {
  constexpr double kTurnOfComponent = 2;  // radians for a unit of a component, at most
  const std::vector<double> of_channels = channel_scales(skeleton_);
  std::vector<double> scales;
  for (const JointSignals& of : joints_) {
    scales.insert(scales.end(), of.translations.size(), 1.0);
    const int channels = static_cast<int>(skeleton_.joint(of.joint).channels.size());
    for (int c = 0; c < channels && of.turns; ++c) {
      const int channel = skeleton_.first_channel(of.joint) + c;
      if (!is_rotation(skeleton_.channel_kind(channel))) continue;
      scales.insert(scales.end(), 4, kTurnOfComponent * of_channels[channel]);
      break;
    }
  }
  return scales;
}

namespace {

class QuaternionCoder : public DetailCoder {
 public:
  QuaternionCoder(const Motion& motion, Weighting weighting)
      : QuaternionCoder(motion, weighting, QuaternionSignals(motion.skeleton)) {}

  int most_detail() const override { return basis_.ranked.total(); }

  std::vector<std::byte> encode(int detail) const override {
    const Kept start = basis_.standard.keep(detail);
    const Kept kept = anneal(basis_.ranked, model_, start).kept;
    return pack(code_signals(basis_.ranked, basis_.scales, kept), Coding::Deflate);
  }

 private:
  QuaternionCoder(const Motion& motion, Weighting weighting, const QuaternionSignals& quaternions)
      : QuaternionCoder(motion, weighting, quaternions, quaternions.of(motion.clip)) {}
  QuaternionCoder(const Motion& motion, Weighting weighting, const QuaternionSignals& quaternions,
                  const Eigen::MatrixXd& signals)
      : basis_({motion.clip.sample_rate_hz, signals}, quaternions.scales(), Basis::Cubic),
        model_(motion.skeleton, motion.clip, measured_points(motion.skeleton, weighting),
               quaternions.moves(motion.clip, signals)) {}

  BasisAnalysis basis_;
  ErrorModel model_;
};

Clip decode_quaternion(const Skeleton& skeleton, double sample_rate_hz, int frames,
                       std::span<const std::byte> motion) {
  const QuaternionSignals quaternions(skeleton);
  const int count = quaternions.count();
  const std::vector<std::byte> words = unpack(motion, Coding::Deflate, rle16_bound(frames, count));
  ByteReader reader(words);
  const Eigen::MatrixXd signals = read_signals(reader, Basis::Cubic, frames, count);
  reader.expect_end();
  return quaternions.clip_of(signals, sample_rate_hz);
}

}  // namespace

constinit const ComparisonMethod kQuaternion{
    "quaternion", "Quaternion wavelets",
    "Cubic wavelets on unit quaternions, coefficients moved between components by annealing "
    "on the linearised rotation: the paper's section 6.3.",
    &coder_of<QuaternionCoder>, &decode_quaternion};

}  // namespace mocapress
