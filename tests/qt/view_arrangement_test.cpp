// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/view_arrangement.h"

#include <gtest/gtest.h>

#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"
#include "widgets/viewport/trails.h"

namespace mocapress {
namespace {

constexpr auto kModes = {ViewMode::Overlay, ViewMode::SideBySide, ViewMode::Wipe};

TEST(ViewArrangement, ShowsALoneFigureWholeAndSolidWhateverIsChosen) {
  for (const ViewMode mode : kModes)
    for (const bool blinking : {false, true})
      EXPECT_EQ(
          arrange({.mode = mode, .swapped = true, .blinking = blinking}, false, true).original,
          Placement());
}

TEST(ViewArrangement, OverlaysTheGhostOfTheOriginalOrSwappedOfTheCompressed) {
  const Arrangement plain = arrange({}, true, false);
  EXPECT_TRUE(plain.original.ghost);
  EXPECT_FALSE(plain.compressed.ghost);
  const Arrangement swapped = arrange({.swapped = true}, true, false);
  EXPECT_FALSE(swapped.original.ghost);
  EXPECT_TRUE(swapped.compressed.ghost);
}

TEST(ViewArrangement, WipesAtTheDividerWithoutGapOrOverlap) {
  for (const double share : {0.0, 0.3, 0.5, 1.0})
    for (const bool swapped : {false, true}) {
      const Arrangement wipe =
          arrange({.mode = ViewMode::Wipe, .swapped = swapped, .divider = share}, true, false);
      const Pane& left = (swapped ? wipe.compressed : wipe.original).pane;
      const Pane& right = (swapped ? wipe.original : wipe.compressed).pane;
      EXPECT_EQ(left.from, -1);
      EXPECT_EQ(left.to, right.from);
      EXPECT_EQ(right.to, 1);
      EXPECT_EQ(wipe.dividerAt(), left.to);
      EXPECT_GT(left.to, -1);  // the divider can be dragged back
      EXPECT_LT(left.to, 1);
      EXPECT_EQ(left.shift, 0);
    }
}

TEST(ViewArrangement, SetsFiguresSideBySideInHalvesThatCentreThem) {
  const Arrangement sides = arrange({.mode = ViewMode::SideBySide}, true, false);
  EXPECT_EQ(sides.panes, 2);
  for (const Pane& pane : {sides.original.pane, sides.compressed.pane})
    EXPECT_FLOAT_EQ(pane.shift, (pane.from + pane.to) / 2);
  const Arrangement swapped = arrange({.mode = ViewMode::SideBySide, .swapped = true}, true, false);
  EXPECT_EQ(swapped.original.pane, sides.compressed.pane);
  EXPECT_EQ(swapped.compressed.pane, sides.original.pane);
}

TEST(ViewArrangement, GivesEveryPinnedFigureAPaneOfItsOwnSideBySide) {
  for (int pinned = 0; pinned <= kMostPinned; ++pinned) {
    const Arrangement sides = arrange({.mode = ViewMode::SideBySide}, true, false, pinned);
    EXPECT_EQ(sides.panes, 2 + pinned);
    std::vector<Pane> panes = {sides.original.pane, sides.compressed.pane};
    for (const Placement& each : sides.pinned) {
      EXPECT_TRUE(each.shown);
      panes.push_back(each.pane);
    }
    EXPECT_EQ(panes.front().from, -1);
    EXPECT_EQ(panes.back().to, 1);
    for (std::size_t i = 0; i < panes.size(); ++i) {
      EXPECT_EQ(panes[i].from, i == 0 ? -1 : panes[i - 1].to);
      EXPECT_FLOAT_EQ(panes[i].to - panes[i].from, 2.0f / static_cast<float>(sides.panes));
      EXPECT_FLOAT_EQ(panes[i].shift, (panes[i].from + panes[i].to) / 2);
    }
  }
}

TEST(ViewArrangement, PinnedFiguresAreInTheOverlayButNotInAWipeNorBlinking) {
  const auto shown = [](const ViewOptions& options) {
    return arrange(options, true, false, 1).pinned.front().shown;
  };
  EXPECT_TRUE(shown({.mode = ViewMode::Overlay}));
  EXPECT_TRUE(arrange({}, true, false, 1).pinned.front().ghost);
  EXPECT_FALSE(arrange({.mode = ViewMode::SideBySide}, true, false, 1).pinned.front().ghost);
  EXPECT_FALSE(shown({.mode = ViewMode::Wipe}));
  EXPECT_FALSE(shown({.mode = ViewMode::Overlay, .blinking = true}));
}

TEST(ViewArrangement, BlinkingShowsOneAtATimeInTheSamePlace) {
  for (const ViewMode mode : kModes)
    for (const bool turn : {false, true}) {
      const Arrangement blink = arrange({.mode = mode, .blinking = true}, true, turn);
      EXPECT_EQ(blink.original.shown, !turn);
      EXPECT_EQ(blink.compressed.shown, turn);
      EXPECT_EQ(blink.original.pane, blink.compressed.pane);
      EXPECT_FALSE(blink.original.ghost || blink.compressed.ghost);
    }
}

TEST(ViewArrangement, AloneHidesTheOriginalInEveryMode) {
  for (const ViewMode mode : kModes) {
    const Arrangement alone = arrange({.mode = mode, .alone = true}, true, false);
    EXPECT_FALSE(alone.original.shown);
    EXPECT_EQ(alone.compressed, Placement());
    EXPECT_EQ(alone.panes, 1);
  }
}

TEST(JointPath, ReachesAsFarAsItSaysAndGoesThroughNow) {
  const Motion motion = test::smooth_motion(300);
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  for (const int frame : {0, 3, 150, 299}) {
    const std::vector<Capsule> path = jointPath(tracks, 2, frame, 60, 1);
    ASSERT_FALSE(path.empty());
    const QVector3D now = landmarkAt(tracks, frame, 2);
    bool through_now = false;
    bool begins = false;
    bool ends = false;
    for (const Capsule& piece : path) {
      through_now |= piece.start == now;
      begins |= piece.end == landmarkAt(tracks, std::max(0, frame - 60), 2) || frame == 0;
      ends |= piece.end == landmarkAt(tracks, std::min(299, frame + 60), 2) || frame == 299;
      EXPECT_LE(piece.end_radius, piece.start_radius);
      EXPECT_GT(piece.end_radius, 0);
    }
    EXPECT_TRUE(through_now && begins && ends) << frame;
  }
}

TEST(FootDiscs, LieUnderTheFeetThatStandNow) {
  const Motion motion = test::smooth_motion(60);
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  const std::vector<ContactSpan> contacts = {{4, 10, 20}, {7, 15, 30}};
  EXPECT_TRUE(footDiscs(contacts, {}, tracks, 9, 5).empty());
  EXPECT_EQ(footDiscs(contacts, {}, tracks, 10, 5).size(), 1u);
  const std::vector<Capsule> both = footDiscs(contacts, {{contacts[1], 5, 9, 17}}, tracks, 18, 5);
  ASSERT_EQ(both.size(), 2u);
  const QVector3D foot = landmarkAt(tracks, 18, 7);
  EXPECT_EQ(both[1].start, QVector3D(foot.x(), 0, foot.z()));
  EXPECT_NE(both[0].start_tint, both[1].start_tint);  // the second slides
  EXPECT_TRUE(footDiscs(contacts, {}, tracks, 31, 5).empty());
}

}  // namespace
}  // namespace mocapress
