// SPDX-License-Identifier: MIT
#include "resources/samples/generator/performer.h"

#include <array>
#include <cmath>
#include <map>

#include "core/formats/asf.h"
#include "resources/samples/generator/leg_ik.h"
#include "resources/samples/generator/variation.h"

namespace mocapress::samples {
namespace {

constexpr double kRootNoise = 0.010;   // cm
constexpr double kAnkleNoise = 0.008;  // cm
constexpr double kFootNoise = 0.0004;  // radians

class Performer {
 public:
  Performer(const Choreography& choreography, std::uint64_t seed)
      : choreography_(choreography), random_(seed) {
    for (const auto& [joint, angles] : choreography.posture(0).degrees)
      drifts_.emplace(joint, std::array{Drift(random_), Drift(random_), Drift(random_)});
  }

  Eigen::RowVectorXd frame(double seconds) {
    Posture posture = choreography_.posture(seconds);
    for (auto& [joint, angles] : posture.degrees) {
      const Unrest unrest = unrest_of(joint);
      for (std::size_t axis = 0; axis < 3; ++axis)
        angles(static_cast<Eigen::Index>(axis)) +=
            unrest.drift * drifts_.at(joint)[axis].at(seconds) +
            unrest.noise * sensor_noise(random_);
    }
    const FootState left = trembling(choreography_.left.at(seconds));
    const FootState right = trembling(choreography_.right.at(seconds));
    const Eigen::Vector3d centre = choreography_.centre(seconds) + tremor(kRootNoise);
    posture.root = centre;
    place_feet(posture, left, right);
    if (choreography_.centre_of == Centre::Mass) {
      // The legs, a third of the mass, reach back to the floor: each round leaves a tenth or so.
      constexpr int kRounds = 16;
      for (int i = 0; i < kRounds; ++i) {
        posture.root += centre - centre_of_mass(skeleton_, channels_of(skeleton_, posture));
        place_feet(posture, left, right);
      }
    }
    return channels_of(skeleton_, posture);
  }

  const Skeleton& skeleton() const { return skeleton_; }

 private:
  Eigen::Vector3d tremor(double cm) {
    Eigen::Vector3d noise;
    for (double& coordinate : noise) coordinate = cm * sensor_noise(random_);
    return noise;
  }

  FootState trembling(FootState foot) {
    foot.ankle += tremor(kAnkleNoise);
    foot.yaw += kFootNoise * sensor_noise(random_);
    foot.pitch += kFootNoise * sensor_noise(random_);
    foot.toe_pitch += kFootNoise * sensor_noise(random_);
    return foot;
  }

  static void place_feet(Posture& posture, const FootState& left, const FootState& right) {
    place_foot(posture, Side::Left, left);
    place_foot(posture, Side::Right, right);
  }

  const Choreography& choreography_;
  const Skeleton skeleton_ = human_skeleton();
  Random random_;
  std::map<std::string, std::array<Drift, 3>> drifts_;
};

/// To whole steps of what the .amc is written in.
void round_channels(const Skeleton& skeleton, Clip& clip) {
  constexpr double kStep = 1e-4;
  for (int c = 0; c < skeleton.channel_count(); ++c) {
    const double unit = is_rotation(skeleton.channel_kind(c)) ? in_radians(1) : kAsfCmPerUnit;
    clip.channels.col(c) = (clip.channels.col(c) / (unit * kStep)).array().round() * kStep * unit;
  }
}

}  // namespace

Motion perform(const Choreography& choreography, std::uint64_t seed) {
  Performer performer(choreography, seed);
  Motion motion;
  motion.skeleton = performer.skeleton();
  motion.clip.sample_rate_hz = kSampleRate;
  motion.clip.channels.resize(static_cast<Eigen::Index>(choreography.seconds * kSampleRate),
                              motion.skeleton.channel_count());
  for (int t = 0; t < motion.clip.frames(); ++t)
    motion.clip.channels.row(t) = performer.frame(t / kSampleRate);
  unwrap_angles(motion.skeleton, motion.clip);
  round_channels(motion.skeleton, motion.clip);
  return motion;
}

}  // namespace mocapress::samples
