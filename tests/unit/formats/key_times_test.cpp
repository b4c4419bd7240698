// SPDX-License-Identifier: MIT
#include "core/formats/key_times.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/base/error.h"

namespace mocapress {
namespace {

/// Keys at these frames of a rate, starting at 2.5 s.
std::vector<double> keys(double rate_hz, const std::vector<int>& frames) {
  std::vector<double> times;
  for (const int frame : frames) times.push_back(2.5 + frame / rate_hz);
  return times;
}

TEST(KeyTimes, FindsTheRateAtWhichKeysWereMade) {
  const std::vector<int> frames = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  for (const double rate : {24.0, 25.0, 30.0, 31.25, 60.0, 120.0, 240.0}) {
    const SampleTimes times = sample_times("f", keys(rate, frames), 30, {}, 1);
    EXPECT_NEAR(times.rate_hz, rate, 1e-9);
    EXPECT_EQ(times.frames, 10);
    EXPECT_EQ(times.at(3), 2.5 + 3 / times.rate_hz);
    EXPECT_EQ(times.warning, "");
  }
  EXPECT_EQ(sample_times("f", keys(30000.0 / 1001, frames), 30000.0 / 1001, {}, 1).rate_hz,
            30000.0 / 1001);
}

TEST(KeyTimes, KeepTheStatedRateWhereKeysAreSparse) {
  const SampleTimes times = sample_times("f", keys(30, {0, 10, 20}), 30, {}, 1);
  EXPECT_EQ(times.rate_hz, 30);
  EXPECT_EQ(times.frames, 21);
  EXPECT_EQ(times.warning,
            "keys lie unevenly: 3 of 21 frames carry keys; frames between are interpolated");
  EXPECT_EQ(sample_times("f", keys(48, {0, 3, 10}), 30, {}, 1).rate_hz, 48);
}

/// The same times rounded to milliseconds, as many programs write them.
std::vector<double> in_milliseconds(std::vector<double> times) {
  for (double& time : times) time = std::round(1000 * time) / 1000;
  return times;
}

TEST(KeyTimes, AreNotTakenForDenserOnesWhereTheyLieALittleOff) {
  std::vector<int> frames(91);
  std::iota(frames.begin(), frames.end(), 0);
  for (const double rate : {24.0, 25.0, 30.0, 50.0, 60.0, 90.0, 120.0, 240.0})
    for (const auto stated : {std::optional<double>(), std::optional(rate)}) {
      const SampleTimes times =
          sample_times("f", in_milliseconds(keys(rate, frames)), stated, {}, 1);
      EXPECT_EQ(times.rate_hz, rate);
      EXPECT_EQ(times.frames, 91);
      EXPECT_EQ(times.warning, "");
    }
  // Keys with gaps, a little off their frames: 3 of 101 frames.
  EXPECT_EQ(sample_times("f", in_milliseconds(keys(30, {0, 31, 100})), {}, {}, 1).rate_hz, 30);
}

/// A second node's key next to the first one's would mean 480 frames a second.
TEST(KeyTimes, MayBeLateByTwoMilliseconds) {
  for (const auto stated : {std::optional<double>(), std::optional(30.0)}) {
    std::vector<double> late = keys(30, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    late.insert(late.begin() + 6, late[5] + 1.0 / 480);
    const SampleTimes times = sample_times("f", late, stated, {}, 1);
    EXPECT_EQ(times.rate_hz, 30);
    EXPECT_EQ(times.frames, 11);
    EXPECT_GE(times.near_s, 1.0 / 480);
    EXPECT_EQ(times.warning, "");
  }
}

TEST(KeyTimes, KeepDenseRatesThatKeysWereMadeAt) {
  EXPECT_EQ(sample_times("f", keys(500, {0, 1, 2, 3, 4, 5, 6, 7}), {}, {}, 1).rate_hz, 500);
  // Every third key is missing.
  EXPECT_EQ(sample_times("f", keys(240, {0, 1, 3, 4, 6, 7, 9, 10}), {}, {}, 1).rate_hz, 240);
}

TEST(KeyTimes, SayWhichKeysAreNotFrames) {
  const SampleTimes times = sample_times("f", {0, 0.0123, 0.047, 0.1}, 60, {}, 1);
  EXPECT_EQ(times.rate_hz, 60);
  EXPECT_EQ(times.frames, 7);
  EXPECT_EQ(times.warning.find("keys lie unevenly: 2 of 7"), 0u);
}

TEST(KeyTimes, GiveTheRateThatIsAskedFor) {
  const SampleTimes times = sample_times("f", keys(30, {0, 1, 2, 3}), 30, 60, 1);
  EXPECT_EQ(times.rate_hz, 60);
  EXPECT_EQ(times.frames, 7);
  EXPECT_EQ(times.warning, "");
}

TEST(KeyTimes, OneKeyIsOneFrame) {
  EXPECT_EQ(sample_times("f", {3}, {}, {}, 1).frames, 1);
  EXPECT_EQ(sample_times("f", {3}, {}, {}, 1).rate_hz, 30);
}

TEST(KeyTimes, RefuseWhatIsTooLongForAClip) {
  EXPECT_THROW(sample_times("f", {0, 1e9}, 30, {}, 1), InputError);
}

TEST(KeyTimes, MergeInOrderWithoutRepetition) {
  EXPECT_EQ(merged_times({1, 2, 4}, {5, 2, 3, 1.000001}), (std::vector<double>{1, 2, 3, 4, 5}));
}

}  // namespace
}  // namespace mocapress
