// SPDX-License-Identifier: MIT
#include "core/batch/batch_difference.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace mocapress::batch_difference_test {
namespace {

using enum ClipChange;

BatchRow row_of(const std::string& output, std::size_t bytes, double max_cm, double times_noticed) {
  BatchRow row;
  row.output = output;
  row.measured = Measurement{.motion_bytes = bytes,
                             .body = {.surface = {.max = {.cm = max_cm}}},
                             .seen = Seen{times_noticed, 0, "velocity of rhand"}};
  return row;
}

BatchRows rows_of(std::vector<BatchRow> rows) {
  return [rows = std::move(rows)](const auto& visit) {
    for (const BatchRow& row : rows) visit(row);
  };
}

BatchDifference difference(std::vector<BatchRow> before, std::vector<BatchRow> after) {
  return difference_of(rows_of(std::move(before)), rows_of(std::move(after)), 0.01);
}

std::vector<ClipChange> changes(const BatchRow& before, const BatchRow& after) {
  const BatchDifference found = difference({before}, {after});
  return found.changed.empty() ? std::vector<ClipChange>() : found.changed.front().changes;
}

TEST(BatchDifference, TellsWhatGotLargerWorseAndNewlyVisible) {
  const BatchRow walk = row_of("walk", 1000, 2, 0.5);
  EXPECT_EQ(changes(walk, row_of("walk", 1020, 2, 0.5)), std::vector{Larger});
  EXPECT_EQ(changes(walk, row_of("walk", 900, 2.1, 0.5)), (std::vector{Worse, Smaller}));
  EXPECT_EQ(changes(walk, row_of("walk", 1000, 2, 1.5)), std::vector{NewlyVisible});
  EXPECT_EQ(changes(row_of("walk", 1000, 2, 1.5), row_of("walk", 1000, 2, 3)),
            std::vector{NewlyVisible});
  EXPECT_EQ(changes(row_of("walk", 1000, 2, 3), walk), std::vector{NoLongerSeen});
}

TEST(BatchDifference, IgnoresSmallChanges) {
  const BatchRow walk = row_of("walk", 1000, 2, 0.5);
  EXPECT_TRUE(changes(walk, row_of("walk", 1009, 2.01, 0.6)).empty());
  EXPECT_EQ(difference({walk}, {row_of("walk", 1009, 2.01, 0.6)}).bytes_after, 1009u);
}

TEST(BatchDifference, TakesErrorsBelowAHundredthOfAMillimetreForTheSame) {
  EXPECT_TRUE(changes(row_of("still", 100, 0, 0), row_of("still", 100, 2e-7, 0)).empty());
  EXPECT_EQ(changes(row_of("still", 100, 0, 0), row_of("still", 100, 0.01, 0)), std::vector{Worse});
}

TEST(BatchDifference, ComparesMeanErrorsInOneWeightingOnly) {
  BatchRow before = row_of("walk", 1000, 2, 0.5);
  before.preset.weighting = Weighting::JointOrigins;
  before.measured->eps_bone_ends_cm = 0.8;
  before.measured->eps_joint_origins_cm = 0.4;
  BatchRow after = before;
  after.preset.weighting = Weighting::BoneEnds;
  EXPECT_TRUE(changes(before, after).empty());
}

TEST(BatchDifference, TellsFailuresAndClipsThatOneLacks) {
  const BatchRow walk = row_of("walk", 1000, 2, 0.5);
  BatchRow failed{.output = "walk"};
  failed.error = "no file";
  EXPECT_EQ(changes(walk, failed), std::vector{Failed});
  EXPECT_EQ(changes(failed, walk), std::vector{Done});
  EXPECT_TRUE(changes(failed, failed).empty());
  EXPECT_EQ(difference({walk}, {}).changed.front().changes, std::vector{Gone});
  BatchRow unlike = walk;  // measured, and found to decode to something else
  unlike.error = "it decodes to another motion";
  EXPECT_EQ(difference({walk}, {unlike}).changed.front().after->reason, unlike.error);
  EXPECT_EQ(difference({walk}, {unlike}).changed.front().before->reason, "velocity of rhand");
  EXPECT_EQ(difference({}, {walk}).changed.front().changes, std::vector{Added});
}

TEST(BatchDifference, PutsTheGravestFirst) {
  const BatchRow a = row_of("a", 1000, 2, 0.5), b = row_of("b", 1000, 2, 0.5),
                 c = row_of("c", 1000, 2, 0.5);
  const BatchDifference found = difference(
      {a, b, c}, {row_of("a", 500, 2, 0.5), row_of("b", 1000, 2, 3), row_of("c", 2000, 2, 0.5)});
  ASSERT_EQ(found.changed.size(), 3u);
  EXPECT_EQ(found.changed[0].output, "b");
  EXPECT_EQ(found.changed[1].output, "c");
  EXPECT_EQ(found.changed[2].output, "a");
  EXPECT_EQ(found.count(Larger), 1u);
  EXPECT_EQ(found.bytes_before, 3000u);
  EXPECT_EQ(found.bytes_after, 3500u);
}

TEST(BatchDifference, IsOneJsonObject) {
  const Json json =
      to_json(difference({row_of("walk", 1000, 2, 0.5)}, {row_of("walk", 2000, 2, 0.5)}));
  EXPECT_EQ(json["counts"]["larger"], 1);
  EXPECT_EQ(json["changed"][0]["changes"], Json::array({"larger"}));
  EXPECT_EQ(json["changed"][0]["after"]["motion_bytes"], 2000);
  for (const ClipChange change : kClipChanges) EXPECT_EQ(clip_change_named(name(change)), change);
  EXPECT_FALSE(clip_change_named("ugly"));
}

}  // namespace
}  // namespace mocapress::batch_difference_test
