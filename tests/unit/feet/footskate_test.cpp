// SPDX-License-Identifier: MIT
#include "core/feet/footskate.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mocapress::footskate_test {
namespace {

constexpr double kRate = 120;
const std::vector<ContactSpan> kContacts = {{0, 10, 39}, {0, 60, 89}};

Eigen::MatrixXd still() {
  return Eigen::MatrixXd::Constant(100, 3, 7.0);
}

/// Tracks that slide steadily in x and z through frames [first, last], by `cm` in all.
Eigen::MatrixXd slid(Eigen::MatrixXd tracks, int first, int last, double cm) {
  for (int t = first + 1; t < tracks.rows(); ++t) {
    const double share = std::min(1.0, double(t - first) / (last - first));
    tracks(t, 0) += 0.6 * cm * share;
    tracks(t, 2) += 0.8 * cm * share;
  }
  return tracks;
}

TEST(Footskate, AStillFootHasNone) {
  const Footskate footskate = measure_footskate(kContacts, still(), still(), kRate);
  EXPECT_EQ(footskate.total_cm, 0);
  EXPECT_TRUE(footskate.findings.empty());
}

TEST(Footskate, FindsAPlantedSlideWithItsPlaceSizeAndSpeed) {
  const Footskate footskate =
      measure_footskate(kContacts, still(), slid(still(), 70, 80, 5), kRate);
  EXPECT_NEAR(footskate.total_cm, 5, 1e-9);
  ASSERT_EQ(footskate.findings.size(), 1u);
  EXPECT_EQ(footskate.findings[0].span, kContacts[1]);
  EXPECT_NEAR(footskate.findings[0].worst_speed_cm_s, 0.5 * kRate, 1e-6);
  EXPECT_GT(footskate.findings[0].worst_frame, 70);
  EXPECT_LE(footskate.findings[0].worst_frame, 80);
}

TEST(Footskate, FindsADriftWhosePathIsNoLonger) {
  Eigen::MatrixXd trembling = still();
  for (int t = 0; t < 100; ++t) trembling(t, 0) += t % 2 == 0 ? 0.5 : 0.0;
  const Footskate footskate =
      measure_footskate(kContacts, trembling, slid(still(), 60, 89, 3), kRate);
  EXPECT_EQ(footskate.total_cm, 0);
  ASSERT_EQ(footskate.findings.size(), 2u);
  EXPECT_EQ(footskate.findings[0].slid_cm, 0);
  EXPECT_GT(footskate.drift_worst_cm, 2);
}

/// Feet once counted as sliding 12.8 cm in nine seconds, though they only trembled by 2.5 mm.
TEST(Footskate, DriftDoesNotSumTrembling) {
  Eigen::MatrixXd trembling = still();
  for (int t = 0; t < 100; ++t) trembling(t, 0) += t % 2 == 0 ? 0.25 : 0.0;
  const Footskate footskate = measure_footskate(kContacts, still(), trembling, kRate);
  EXPECT_NEAR(footskate.total_cm, 2 * 29 * 0.25, 1e-9);
  EXPECT_NEAR(footskate.drift_worst_cm, 0.25, 1e-9);
  EXPECT_NEAR(footskate.drift_total_cm, 0.5, 1e-9);
  const Footskate slides = measure_footskate(kContacts, still(), slid(still(), 70, 80, 5), kRate);
  EXPECT_NEAR(slides.drift_worst_cm, 5, 1e-9);
  EXPECT_NEAR(slides.findings.at(0).drift_cm, 5, 1e-9);
  // A foot that stands beside the original's place does not drift.
  EXPECT_EQ(
      measure_footskate(kContacts, still(), (still().array() + 3).matrix(), kRate).drift_worst_cm,
      0);
}

TEST(Footskate, CountsOnlyWhatHappensInContact) {
  EXPECT_EQ(measure_footskate(kContacts, still(), slid(still(), 42, 55, 9), kRate).total_cm, 0);
}

TEST(Footskate, SubtractsTheOriginalsOwnSliding) {
  const Eigen::MatrixXd original = slid(still(), 10, 39, 2);
  const Footskate footskate =
      measure_footskate(kContacts, original, slid(original, 10, 39, 3), kRate);
  EXPECT_NEAR(footskate.total_cm, 3, 1e-9);
  EXPECT_EQ(measure_footskate(kContacts, original, still(), kRate).total_cm, 0);
}

TEST(Footskate, IgnoresHeight) {
  Eigen::MatrixXd lifted = still();
  for (int t = 10; t < 40; ++t) lifted(t, 1) += t % 2;
  EXPECT_EQ(measure_footskate(kContacts, still(), lifted, kRate).total_cm, 0);
}

TEST(Footskate, ListsTheWorstFirst) {
  const Eigen::MatrixXd decoded = slid(slid(still(), 12, 30, 1), 62, 80, 4);
  const Footskate footskate = measure_footskate(kContacts, still(), decoded, kRate);
  ASSERT_EQ(footskate.findings.size(), 2u);
  EXPECT_GT(footskate.findings[0].slid_cm, footskate.findings[1].slid_cm);
  EXPECT_EQ(footskate.findings[0].span.first_frame, 60);
}

TEST(Footskate, IsTheSameInBlocks) {
  const Eigen::MatrixXd decoded = slid(slid(still(), 12, 30, 3), 70, 80, 5);
  const Footskate whole = measure_footskate(kContacts, still(), decoded, kRate);
  for (const int length : {1, 7, 33, 75}) {
    FootskateMeter meter(kContacts, kRate);
    for (int first = 0; first < 100; first += length) {
      const int count = std::min(length, 100 - first);
      meter.add(first, still().middleRows(first, count), decoded.middleRows(first, count));
    }
    const Footskate in_blocks = meter.footskate();
    EXPECT_EQ(in_blocks.total_cm, whole.total_cm);
    EXPECT_EQ(in_blocks.drift_total_cm, whole.drift_total_cm);
    ASSERT_EQ(in_blocks.findings.size(), 2u);
    EXPECT_EQ(in_blocks.findings[0].worst_frame, whole.findings[0].worst_frame);
    EXPECT_EQ(in_blocks.findings[1].worst_speed_cm_s, whole.findings[1].worst_speed_cm_s);
  }
}

TEST(SlidePerContact, IsNothingWithoutContacts) {
  EXPECT_FALSE(slide_per_contact({}, 0).has_value());
}

TEST(SlidePerContact, CountsContactsThatDidNotSlide) {
  const Footskate footskate{.total_cm = 6,
                            .findings = {{.span = {}, .slid_cm = 4}, {.span = {}, .slid_cm = 2}}};
  const auto slide = slide_per_contact(footskate, 3);
  ASSERT_TRUE(slide.has_value());
  EXPECT_DOUBLE_EQ(slide->mean_cm, 2);
  EXPECT_DOUBLE_EQ(slide->worst_cm, 4);
}

TEST(SlidePerContact, IsZeroWhereNothingSlid) {
  const auto slide = slide_per_contact({}, 5);
  ASSERT_TRUE(slide.has_value());
  EXPECT_EQ(slide->mean_cm, 0);
  EXPECT_EQ(slide->worst_cm, 0);
}

}  // namespace
}  // namespace mocapress::footskate_test
