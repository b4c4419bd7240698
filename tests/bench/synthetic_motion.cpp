// SPDX-License-Identifier: MIT
#include "tests/bench/synthetic_motion.h"

#include <cmath>
#include <initializer_list>

#include "core/base/random.h"

namespace mocapress::test {
namespace {

constexpr int kFrames = 2000;

/// Adds a limb of joints 20 cm apart, each with `channels` rotation channels.
void add_limb(Skeleton& skeleton, int parent, const std::string& name, double side, double up,
              std::initializer_list<int> rotations) {
  const std::vector<ChannelKind> order = {ChannelKind::RotationZ, ChannelKind::RotationY,
                                          ChannelKind::RotationX};
  int number = 0;
  for (const int count : rotations) {
    Joint joint{.name = name + std::to_string(++number),
                .parent = parent,
                .offset = {number == 1 ? side : 0, up, 0},
                .channels = {order.begin(), order.begin() + count}};
    if (number == static_cast<int>(rotations.size())) joint.end_site = Eigen::Vector3d(0, up, 3);
    parent = skeleton.add(std::move(joint));
  }
}

Skeleton synthetic_skeleton() {
  using enum ChannelKind;
  Skeleton skeleton;
  const int root = skeleton.add(
      {.name = "root",
       .channels = {TranslationX, TranslationY, TranslationZ, RotationZ, RotationY, RotationX}});
  add_limb(skeleton, root, "spine", 0, 15, {3, 3, 3, 3, 3, 3});
  for (const double side : {-1.0, 1.0}) {
    const std::string prefix = side < 0 ? "r" : "l";
    add_limb(skeleton, root, prefix + "leg", 10 * side, -30, {3, 1, 2, 1});
    add_limb(skeleton, skeleton.find("spine3"), prefix + "arm", 18 * side, -14,
             {2, 3, 1, 1, 2, 1, 2});
  }
  return skeleton;
}

Motion build_motion() {
  Motion motion{synthetic_skeleton(), {.sample_rate_hz = 120}};
  motion.clip.channels.resize(kFrames, motion.skeleton.channel_count());
  Random random(1);
  for (Eigen::Index c = 0; c < motion.clip.channels.cols(); ++c) {
    const double size = is_rotation(motion.skeleton.channel_kind(static_cast<int>(c))) ? 0.5 : 40;
    const double pace = 0.01 + 0.05 * random.unit();  // radians per frame
    for (int t = 0; t < kFrames; ++t)
      motion.clip.channels(t, c) =
          size * (std::sin(pace * t) + 0.2 * std::sin(5.3 * pace * t) + 0.002 * random.unit());
  }
  return motion;
}

}  // namespace

const Motion& synthetic_motion() {
  static const Motion kMotion = build_motion();
  return kMotion;
}

}  // namespace mocapress::test
