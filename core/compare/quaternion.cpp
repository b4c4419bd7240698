// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 6.3. The bytes:
// METHODS.md.
#include "core/compare/quaternion.h"

#include <Eigen/Geometry>

#include "core/codec/clip_analysis.h"
#include "core/codec/signal_coder.h"
#include "core/compare/joint_rotation.h"
#include "core/motion/forward_kinematics.h"
#include "core/select/annealing.h"

namespace mocapress {
namespace {

/// The signals that stand for a joint's channels: its translations, then w x y z if it turns.
struct JointSignals {
  int joint;
  int first;                      // of the signals
  std::vector<int> translations;  // channels of the clip
  bool turns;

  int quaternion() const { return first + static_cast<int>(translations.size()); }
  int end() const { return quaternion() + (turns ? 4 : 0); }
};

std::vector<JointSignals> signals_of(const Skeleton& skeleton) {
  std::vector<JointSignals> all;
  int next = 0;
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Joint& joint = skeleton.joint(j);
    JointSignals signals{j, next, {}, turns(joint)};
    for (std::size_t i = 0; i < joint.channels.size(); ++i)
      if (!is_rotation(joint.channels[i]))
        signals.translations.push_back(skeleton.first_channel(j) + static_cast<int>(i));
    next = signals.end();
    all.push_back(std::move(signals));
  }
  return all;
}

int signal_count(const std::vector<JointSignals>& all) {
  return all.empty() ? 0 : all.back().end();
}

auto channels_of(const Skeleton& skeleton, int joint, Eigen::MatrixXd& channels) {
  return channels.middleCols(skeleton.first_channel(joint),
                             std::ssize(skeleton.joint(joint).channels));
}

/// Of the two quaternions of each rotation, the one next to that of the frame before.
Eigen::MatrixXd to_signals(const Motion& motion, const std::vector<JointSignals>& all) {
  Eigen::MatrixXd channels = motion.clip.channels;
  Eigen::MatrixXd signals(channels.rows(), signal_count(all));
  for (const JointSignals& of : all) {
    signals.middleCols(of.first, std::ssize(of.translations)) =
        channels(Eigen::all, of.translations);
    if (!of.turns) continue;
    const Joint& joint = motion.skeleton.joint(of.joint);
    const auto values = channels_of(motion.skeleton, of.joint, channels);
    Eigen::RowVector4d previous(1, 0, 0, 0);
    for (Eigen::Index t = 0; t < channels.rows(); ++t) {
      const Eigen::Quaterniond q(joint_rotation(joint, values.row(t)));
      const Eigen::RowVector4d wxyz(q.w(), q.x(), q.y(), q.z());
      previous = wxyz.dot(previous) < 0 ? Eigen::RowVector4d(-wxyz) : wxyz;
      signals.middleCols<4>(of.quaternion()).row(t) = previous;
    }
  }
  return signals;
}

/// A component of a quaternion off by d turns the joint by 2 d vec(e q*) about its own axes; that
/// leaves out what changes the length, which the decoder sets right.
SignalMoves moves_of(const Motion& motion, const std::vector<JointSignals>& all,
                     const Eigen::MatrixXd& signals) {
  SignalMoves moves;
  moves.axes = Eigen::MatrixXd::Zero(signals.rows(), 3 * signals.cols());
  for (const JointSignals& of : all)
    for (int s = of.first; s < of.end(); ++s)
      moves.places.push_back({of.joint, s >= of.quaternion()});
  Pose pose;
  for (Eigen::Index t = 0; t < signals.rows(); ++t) {
    compute_pose(motion.skeleton, motion.clip.channels.row(t), pose);
    for (const JointSignals& of : all) {
      const Joint& joint = motion.skeleton.joint(of.joint);
      const Eigen::Matrix3d world_from_parent =
          joint.parent < 0 ? Eigen::Matrix3d::Identity()
                           : pose.world_from_joint[static_cast<std::size_t>(joint.parent)];
      for (std::size_t i = 0; i < of.translations.size(); ++i)
        moves.axes.block<1, 3>(t, 3 * (of.first + static_cast<Eigen::Index>(i))) =
            world_from_parent.col(axis_of(motion.skeleton.channel_kind(of.translations[i])))
                .transpose();
      if (!of.turns) continue;
      const Eigen::RowVector4d q = signals.middleCols<4>(of.quaternion()).row(t);
      for (int component = 0; component < 4; ++component) {
        const Eigen::RowVector4d e = Eigen::RowVector4d::Unit(component);
        const Eigen::Quaterniond turned = Eigen::Quaterniond(e(0), e(1), e(2), e(3)) *
                                          Eigen::Quaterniond(q(0), -q(1), -q(2), -q(3));
        moves.axes.block<1, 3>(t, 3 * (of.quaternion() + Eigen::Index{component})) =
            2 * (world_from_parent * joint.joint_from_axes * turned.vec()).transpose();
      }
    }
  }
  return moves;
}

/// As channel_scales(): a component turns the bone by about twice as much as it is off.
std::vector<double> scales_of(const Skeleton& skeleton, const std::vector<JointSignals>& all) {
  const std::vector<double> of_channels = channel_scales(skeleton);
  std::vector<double> scales;
  for (const JointSignals& of : all) {
    scales.insert(scales.end(), of.translations.size(), 1.0);
    if (!of.turns) continue;
    const Joint& joint = skeleton.joint(of.joint);
    int rotation = skeleton.first_channel(of.joint);
    for (const ChannelKind kind : joint.channels) {
      if (is_rotation(kind)) break;
      ++rotation;
    }
    scales.insert(scales.end(), 4, 2 * of_channels[static_cast<std::size_t>(rotation)]);
  }
  return scales;
}

class QuaternionCoder : public DetailCoder {
 public:
  QuaternionCoder(const Motion& motion, Weighting weighting)
      : QuaternionCoder(motion, weighting, signals_of(motion.skeleton)) {}

  int most_detail() const override { return basis_.ranked.total(); }

  std::vector<std::byte> encode(int detail) const override {
    const Kept start = basis_.standard.keep(detail);
    return code_signals(basis_.ranked, anneal(basis_.ranked, model_, start).kept, Coding::Deflate);
  }

 private:
  QuaternionCoder(const Motion& motion, Weighting weighting, const std::vector<JointSignals>& all)
      : QuaternionCoder(motion, weighting, all, to_signals(motion, all)) {}
  QuaternionCoder(const Motion& motion, Weighting weighting, const std::vector<JointSignals>& all,
                  const Eigen::MatrixXd& signals)
      : basis_({motion.clip.sample_rate_hz, signals}, scales_of(motion.skeleton, all),
               Basis::Cubic),
        model_(motion.skeleton, motion.clip, landmark_weights(motion.skeleton, weighting),
               moves_of(motion, all, signals)) {}

  BasisAnalysis basis_;
  ErrorModel model_;
};

/// Of any length but zero, which stands for no turn.
Eigen::Matrix3d rotation_of(const Eigen::RowVector4d& wxyz) {
  constexpr double kLeast = 1e-12;
  const Eigen::Quaterniond q(wxyz(0), wxyz(1), wxyz(2), wxyz(3));
  return q.norm() > kLeast ? q.normalized().toRotationMatrix() : Eigen::Matrix3d::Identity();
}

class Quaternion : public ComparisonMethod {
 public:
  std::string_view name() const override { return "quaternion"; }
  std::string_view title() const override { return "Quaternion wavelets"; }
  std::string_view note() const override {
    return "Cubic wavelets on unit quaternions, coefficients moved between components by annealing "
           "on the linearised rotation: the paper's section 6.3.";
  }

  std::unique_ptr<DetailCoder> analyse(const Motion& motion, Weighting weighting) const override {
    return std::make_unique<QuaternionCoder>(motion, weighting);
  }

  Clip decode(const Skeleton& skeleton, double sample_rate_hz, int frames,
              std::span<const std::byte> motion) const override {
    const std::vector<JointSignals> all = signals_of(skeleton);
    const Eigen::MatrixXd signals =
        decode_signals(motion, Basis::Cubic, Coding::Deflate, frames, signal_count(all));
    Clip clip{sample_rate_hz, Eigen::MatrixXd::Zero(frames, skeleton.channel_count())};
    for (const JointSignals& of : all) {
      for (std::size_t i = 0; i < of.translations.size(); ++i)
        clip.channels.col(of.translations[i]) =
            signals.col(of.first + static_cast<Eigen::Index>(i));
      if (!of.turns) continue;
      const Joint& joint = skeleton.joint(of.joint);
      auto channels = channels_of(skeleton, of.joint, clip.channels);
      Eigen::RowVectorXd values = Eigen::RowVectorXd::Zero(channels.cols());
      for (int t = 0; t < frames; ++t) {
        turn_joint(joint, rotation_of(signals.middleCols<4>(of.quaternion()).row(t)), values);
        for (Eigen::Index c = 0; c < values.size(); ++c)
          if (is_rotation(joint.channels[static_cast<std::size_t>(c)])) channels(t, c) = values(c);
      }
    }
    return clip;
  }
};

}  // namespace

const ComparisonMethod& quaternion_method() {
  static const Quaternion kMethod;
  return kMethod;
}

}  // namespace mocapress
