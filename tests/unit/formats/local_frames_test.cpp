// SPDX-License-Identifier: MIT
#include "core/formats/local_frames.h"

#include <gtest/gtest.h>

namespace mocapress::local_frames_test {
namespace {

LocalTransform turned(double radians) {
  LocalTransform local;
  local.translation = {1, 2, 3};
  local.rotation = Eigen::AngleAxisd(radians, Eigen::Vector3d::UnitX());
  return local;
}

TEST(LocalFrames, StoresAPartThatStaysOnce) {
  const LocalFrames frames(std::vector<LocalTransform>{turned(0), turned(0), turned(1), turned(2)});
  EXPECT_EQ(frames.size(), 4u);
  EXPECT_EQ(frames.translations().size(), 1u);
  EXPECT_EQ(frames.rotations().size(), 4u);
  EXPECT_EQ(frames.scales().size(), 1u);
}

TEST(LocalFrames, APartThatChangesTakesTheRoomReserved) {
  constexpr std::size_t kFrames = 33'000;
  for (const std::size_t still : {std::size_t{1}, std::size_t{100}}) {
    LocalFrames frames;
    frames.reserve(kFrames);
    for (std::size_t t = 0; t < kFrames; ++t)
      frames.push_back(turned(t < still ? 0 : 1e-3 * static_cast<double>(t)));
    EXPECT_EQ(frames.rotations().capacity(), kFrames) << still;
    EXPECT_EQ(frames.scales().size(), 1u);
  }
}

TEST(LocalFrames, GivesEveryFrameBack) {
  std::vector<LocalTransform> given = {turned(0), turned(0), turned(1), turned(0)};
  given[2].scale = {1, 2, 1};
  given[3].translation.z() = 7;
  const LocalFrames frames(given);
  for (std::size_t t = 0; t < given.size(); ++t) {
    EXPECT_EQ(frames[t].translation, given[t].translation);
    EXPECT_EQ(frames[t].rotation.coeffs(), given[t].rotation.coeffs());
    EXPECT_EQ(frames[t].scale, given[t].scale);
  }
}

}  // namespace
}  // namespace mocapress::local_frames_test
