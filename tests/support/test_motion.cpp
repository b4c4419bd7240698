// SPDX-License-Identifier: MIT
#include "tests/support/test_motion.h"

#include <cmath>

#include "core/base/random.h"

namespace mocapress::test {

Skeleton small_skeleton() {
  using enum ChannelKind;
  Skeleton skeleton;
  skeleton.add(
      {.name = "root",
       .channels = {TranslationX, TranslationY, TranslationZ, RotationZ, RotationY, RotationX}});
  const int spine = skeleton.add({.name = "spine",
                                  .parent = 0,
                                  .offset = {0, 20, 0},
                                  .channels = {RotationX, RotationY, RotationZ}});
  for (const double side : {-1.0, 1.0}) {
    const std::string prefix = side < 0 ? "l" : "r";
    const Eigen::Matrix3d turned = axis_rotation(2, 0.4 * side) * axis_rotation(0, 0.2);
    const int upper = skeleton.add({.name = prefix + "upper",
                                    .parent = spine,
                                    .offset = {18 * side, 25, 0},
                                    .joint_from_axes = turned,
                                    .channels = {RotationY, RotationX, RotationZ}});
    const int lower = skeleton.add({.name = prefix + "lower",
                                    .parent = upper,
                                    .offset = {28 * side, 0, 0},
                                    .joint_from_axes = turned,
                                    .channels = {RotationX}});
    skeleton.add({.name = prefix + "hand",
                  .parent = lower,
                  .offset = {25 * side, 0, 0},
                  .channels = {RotationZ, RotationX},
                  .end_site = Eigen::Vector3d(9 * side, 0, 1)});
  }
  return skeleton;
}

Motion smooth_motion(int frames, unsigned seed) {
  Random random(seed);
  Motion motion{small_skeleton(), {}};
  motion.clip.channels.resize(frames, motion.skeleton.channel_count());
  for (int c = 0; c < motion.skeleton.channel_count(); ++c) {
    const double size = is_rotation(motion.skeleton.channel_kind(c)) ? 0.5 : 60;
    auto channel = motion.clip.channels.col(c);
    channel.setConstant(size * (random.unit() - 0.5));
    for (int wave = 0; wave < 4; ++wave) {
      const double hz = 0.2 + 3 * random.unit();
      const double phase = 6.28 * random.unit();
      for (int t = 0; t < frames; ++t)
        channel(t) += size / (1 + hz) * std::sin(6.28 * hz * t / 120 + phase);
    }
  }
  return motion;
}

}  // namespace mocapress::test
