// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/playback.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

namespace mocapress {
namespace {

class PlaybackTest : public testing::Test {
 protected:
  void passAndTick(double seconds) {
    now_ += seconds;
    playback_.tick();
  }

  double now_ = 1000;
  Playback playback_{[this] { return now_; }};
};

using Playing = PlaybackTest;

TEST_F(Playing, FollowsTheClockAndNotTheTicks) {
  playback_.setClip(1000, 120);
  playback_.play();
  passAndTick(0.5);
  EXPECT_EQ(playback_.frame(), 60);
  for (int i = 0; i < 10; ++i) playback_.tick();
  EXPECT_EQ(playback_.frame(), 60);
  passAndTick(1.0);
  EXPECT_EQ(playback_.frame(), 180);
}

TEST_F(Playing, DoesNotDriftOverALongTime) {
  playback_.setClip(100'000, 119.88);
  playback_.play();
  for (int i = 0; i < 36'000; ++i) passAndTick(1.0 / 60);
  EXPECT_NEAR(playback_.frame(), 600 * 119.88, 1);
}

TEST_F(Playing, LoopsOrStopsAtTheEnd) {
  playback_.setClip(120, 120);
  playback_.play();
  passAndTick(2.25);
  EXPECT_EQ(playback_.frame(), 30);
  playback_.setLoops(false);
  passAndTick(5);
  EXPECT_EQ(playback_.frame(), 119);
  EXPECT_FALSE(playback_.playing());
}

TEST_F(Playing, ALoopThatRepeatsItsFirstPoseIsShownWithoutItsLastFrame) {
  playback_.setClip(121, 120);
  playback_.setRepeatsFirst(true);
  playback_.play();
  passAndTick(119 / 120.0 + 0.001);
  EXPECT_EQ(playback_.frame(), 119);
  passAndTick(1 / 120.0);
  EXPECT_EQ(playback_.frame(), 0);
  playback_.setRange(std::pair(100, 120));
  playback_.seek(119);
  passAndTick(1.5 / 120);
  EXPECT_EQ(playback_.frame(), 120) << "a range is played as it was chosen";
}

TEST_F(Playing, BeginsAgainFromTheEnd) {
  playback_.setClip(120, 120);
  playback_.seek(119);
  playback_.play();
  EXPECT_EQ(playback_.frame(), 0);
  EXPECT_TRUE(playback_.playing());
}

TEST_F(Playing, ChangesSpeedWithoutAJump) {
  playback_.setClip(10'000, 100);
  playback_.play();
  passAndTick(1);
  playback_.setSpeed(0.1);
  EXPECT_EQ(playback_.frame(), 100);
  passAndTick(1);
  EXPECT_EQ(playback_.frame(), 110);
  playback_.setSpeed(4);
  passAndTick(1);
  EXPECT_EQ(playback_.frame(), 510);
}

TEST_F(Playing, SeeksWhilePlayingAndGoesOnFromThere) {
  playback_.setClip(1000, 100);
  playback_.play();
  passAndTick(1);
  playback_.seek(500);
  passAndTick(1);
  EXPECT_EQ(playback_.frame(), 600);
}

TEST_F(Playing, AStepPausesAndStaysInTheClip) {
  playback_.setClip(10, 100);
  playback_.play();
  playback_.step(-1);
  EXPECT_FALSE(playback_.playing());
  EXPECT_EQ(playback_.frame(), 0);
  playback_.step(3);
  EXPECT_EQ(playback_.frame(), 3);
  playback_.step(100);
  EXPECT_EQ(playback_.frame(), 9);
}

TEST_F(Playing, TellsOnlyOfChanges) {
  playback_.setClip(100, 100);
  const QSignalSpy frames(&playback_, &Playback::frameChanged);
  playback_.seek(0);
  EXPECT_EQ(frames.count(), 0);
  playback_.seek(5);
  playback_.seek(5);
  EXPECT_EQ(frames.count(), 1);
}

TEST_F(Playing, NothingPlaysWithoutAClip) {
  playback_.play();
  EXPECT_FALSE(playback_.playing());
  playback_.seek(3);
  EXPECT_EQ(playback_.frame(), 0);
}

TEST_F(Playing, StaysInTheRangeWhereThereIsOne) {
  playback_.setClip(1000, 100);
  playback_.setRange(std::pair(200, 299));
  playback_.play();
  EXPECT_EQ(playback_.frame(), 200);
  passAndTick(0.5);
  EXPECT_EQ(playback_.frame(), 250);
  passAndTick(0.75);
  EXPECT_EQ(playback_.frame(), 225);  // looped
  playback_.setLoops(false);
  passAndTick(5);
  EXPECT_EQ(playback_.frame(), 299);
  EXPECT_FALSE(playback_.playing());
  playback_.setRange(std::nullopt);
  playback_.play();
  passAndTick(0.5);
  EXPECT_EQ(playback_.frame(), 349);
}

TEST_F(Playing, ARangeIsKeptInTheClipAndForgottenWithIt) {
  playback_.setClip(100, 100);
  playback_.setRange(std::pair(90, 400));
  EXPECT_EQ(playback_.range(), (std::pair(90, 99)));
  playback_.setRange(std::pair(-5, -2));
  EXPECT_EQ(playback_.range(), (std::pair(0, 1)));
  playback_.setClip(50, 100);
  EXPECT_FALSE(playback_.range());
}

TEST_F(Playing, ShuttlesEitherWayAndFasterEachTime) {
  playback_.setClip(1000, 100);
  playback_.seek(500);
  playback_.shuttle(-1);
  passAndTick(1);
  EXPECT_EQ(playback_.frame(), 400);
  playback_.shuttle(-1);
  passAndTick(1);
  EXPECT_EQ(playback_.frame(), 200);
  playback_.shuttle(1);  // starts at normal speed after a change of direction
  passAndTick(1);
  EXPECT_EQ(playback_.frame(), 300);
  playback_.pause();
  playback_.play();
  passAndTick(1);
  EXPECT_EQ(playback_.frame(), 400);
}

TEST_F(Playing, BackwardsItLoopsOrStopsAtTheStart) {
  playback_.setClip(100, 100);
  playback_.seek(10);
  playback_.shuttle(-1);
  passAndTick(0.2);
  EXPECT_EQ(playback_.frame(), 90);
  playback_.setLoops(false);
  passAndTick(2);
  EXPECT_EQ(playback_.frame(), 0);
  EXPECT_FALSE(playback_.playing());
}

}  // namespace
}  // namespace mocapress
