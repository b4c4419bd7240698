// SPDX-License-Identifier: MIT
#include "core/feet/contact_spans.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/motion/landmarks.h"
#include "resources/samples/generator/samples.h"

namespace mocapress::contact_spans_test {
namespace {

constexpr double kRate = 120;

/// A landmark that stands at `height` from frame 60 to 179 and is lifted before and after.
Eigen::MatrixXd one_step(double height = 3, int frames = 240) {
  Eigen::MatrixXd tracks = Eigen::MatrixXd::Zero(frames, 3);
  for (int t = 0; t < frames; ++t) {
    const int away = t < 60 ? 60 - t : t > 179 ? t - 179 : 0;
    tracks(t, 0) = t < 60 ? -away * 1.0 : away * 1.0;
    tracks(t, 1) = height + std::min(0.5 * away, 12.0);
  }
  return tracks;
}

TEST(ContactSpans, FindTheStepAndNothingElse) {
  const auto spans = find_contacts(one_step(), kRate, {0});
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_NEAR(spans[0].first_frame, 60, 2);
  EXPECT_NEAR(spans[0].last_frame, 179, 2);
}

TEST(ContactSpans, DoNotDependOnTheHeightOfTheGround) {
  EXPECT_EQ(find_contacts(one_step(3), kRate, {0}), find_contacts(one_step(-250), kRate, {0}));
}

TEST(ContactSpans, IgnoreASingleGlitchBelowTheGround) {
  Eigen::MatrixXd tracks = one_step();
  tracks(20, 1) = -80;
  EXPECT_EQ(find_contacts(tracks, kRate, {0}), find_contacts(one_step(), kRate, {0}));
}

TEST(ContactSpans, HysteresisKeepsASpanWholeWhereNoiseCrossesOneThreshold) {
  Eigen::MatrixXd tracks = one_step();
  for (int t = 60; t < 180; t += 3) tracks(t, 1) += 0.2;  // 24 cm/s up and down
  ContactSettings settings;
  settings.begin_speed = 15;
  EXPECT_EQ(find_contacts(tracks, kRate, {0}, settings).size(), 1u);
}

TEST(ContactSpans, DropWhatIsTooShortAndCloseShortGaps) {
  Eigen::MatrixXd tracks = one_step();
  for (int t = 100; t < 104; ++t) tracks(t, 1) += 8;  // a hop of 33 ms
  EXPECT_EQ(find_contacts(tracks, kRate, {0}).size(), 1u);
  ContactSettings long_only;
  long_only.least_seconds = 2;
  EXPECT_TRUE(find_contacts(tracks, kRate, {0}, long_only).empty());
}

TEST(ContactSpans, APointThatNeverRestsHasNone) {
  Eigen::MatrixXd tracks(200, 3);
  for (int t = 0; t < 200; ++t) tracks.row(t) << 2.0 * t, 4, 0;  // 240 cm/s
  EXPECT_TRUE(find_contacts(tracks, kRate, {0}).empty());
}

TEST(ContactSpans, AClipWithoutFramesHasNone) {
  EXPECT_TRUE(find_contacts(Eigen::MatrixXd(0, 3), kRate, {0}).empty());
}

TEST(FindFootContacts, ALongMotionHasThoseOfItsTracks) {
  const Motion walk = samples::walk_clip();
  Motion longer{walk.skeleton, {walk.clip.sample_rate_hz, {}}};
  longer.clip.channels = walk.clip.channels.replicate(9000 / walk.clip.frames() + 1, 1);
  const std::vector<ContactSpan> contacts = find_foot_contacts(longer);
  EXPECT_GT(contacts.size(), 50u);
  EXPECT_EQ(contacts,
            find_foot_contacts(longer.skeleton, landmark_tracks(longer.skeleton, longer.clip),
                               longer.clip.sample_rate_hz));
}

}  // namespace
}  // namespace mocapress::contact_spans_test
