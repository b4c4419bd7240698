// SPDX-License-Identifier: MIT
#include "core/batch/gate.h"

#include <gtest/gtest.h>

#include "core/formats/value_repair.h"

namespace mocapress::gate_test {
namespace {

BatchRow seen_row(double times_noticed) {
  BatchRow row;
  row.stamp.source = "aa";
  row.measured = Measurement{.seen = Seen{times_noticed, 0, ""}};
  return row;
}

bool is_refused(const BatchRow& row, const std::vector<Gate>& gates) {
  return refusal(row, gates).has_value();
}

/// A row whose review is of the same bytes and settings.
BatchRow reviewed_row(Verdict verdict) {
  BatchRow row = seen_row(0);
  row.review = {.verdict = verdict,
                .source_hash = row.stamp.source,
                .settings_hash = settings_hash(row.preset, row.reading)};
  return row;
}

TEST(Gate, HasAName) {
  for (const Gate gate :
       {Gate::Visible, Gate::Borderline, Gate::Rejected, Gate::Damaged, Gate::Warning})
    EXPECT_EQ(gate_named(name(gate)), gate);
  EXPECT_EQ(gate_named("ugly"), std::nullopt);
}

TEST(Gate, BorderlineRefusesWhatIsVisibleToo) {
  double borderline = 0;
  while (sight_of(borderline) == Sight::NotVisible) borderline += 0.01;
  double visible = borderline;
  while (sight_of(visible) != Sight::Visible) visible += 0.01;
  EXPECT_FALSE(is_refused(seen_row(0), {Gate::Visible, Gate::Borderline}));
  EXPECT_TRUE(is_refused(seen_row(borderline), {Gate::Borderline}));
  EXPECT_FALSE(is_refused(seen_row(borderline), {Gate::Visible}));
  EXPECT_TRUE(is_refused(seen_row(visible), {Gate::Borderline}));
  EXPECT_TRUE(is_refused(seen_row(visible), {Gate::Visible}));
}

TEST(Gate, RejectedRefusesStaleApprovalsToo) {
  EXPECT_FALSE(is_refused(reviewed_row(Verdict::Approved), {Gate::Rejected}));
  EXPECT_FALSE(is_refused(reviewed_row(Verdict::None), {Gate::Rejected}));
  EXPECT_TRUE(is_refused(reviewed_row(Verdict::Rejected), {Gate::Rejected}));
  BatchRow replaced = reviewed_row(Verdict::Approved);
  replaced.stamp.source = "other bytes";
  EXPECT_TRUE(is_refused(replaced, {Gate::Rejected}));
  BatchRow coarser = reviewed_row(Verdict::Approved);
  coarser.preset.target.value *= 2;
  EXPECT_TRUE(is_refused(coarser, {Gate::Rejected}));
}

TEST(Gate, SaysWhyItRefuses) {
  BatchRow row = reviewed_row(Verdict::Rejected);
  row.measured->seen = Seen{100, 0, "velocity of lfoot"};
  row.warnings = {"a.bvh: guessed", "a.bvh: repaired"};
  EXPECT_EQ(refusal(row, {}), std::nullopt);
  EXPECT_EQ(refusal(row, {Gate::Visible, Gate::Rejected}), "visible: velocity of lfoot");
  EXPECT_EQ(refusal(row, {Gate::Rejected}), "rejected");
  EXPECT_EQ(refusal(row, {Gate::Warning}), "warning: a.bvh: guessed");
  row.stamp.source = "other bytes";
  EXPECT_EQ(refusal(row, {Gate::Rejected})->find("stale verdict: "), 0u);
}

TEST(Gate, DamagedRefusesFilesThatLackMotionAndNoGuesses) {
  BatchRow row = seen_row(0);
  row.warnings = {"a.bvh: no unit of length is given: a guess"};
  EXPECT_FALSE(is_refused(row, {Gate::Damaged}));
  EXPECT_TRUE(is_refused(row, {Gate::Warning}));
  row.warnings.push_back("a.bvh: line 9: " + std::string(kTruncated));
  EXPECT_EQ(refusal(row, {Gate::Damaged}), "damaged: " + row.warnings.back());
}

TEST(Gate, RefusesNothingUnaskedAndNoClipThatFailed) {
  BatchRow warned = seen_row(100);
  warned.warnings = {"guessed"};
  EXPECT_FALSE(is_refused(warned, {}));
  EXPECT_TRUE(is_refused(warned, {Gate::Warning}));
  warned.error = "failed";
  EXPECT_FALSE(is_refused(warned, {Gate::Warning, Gate::Visible}));
}

}  // namespace
}  // namespace mocapress::gate_test
