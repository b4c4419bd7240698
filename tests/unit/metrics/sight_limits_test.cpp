// SPDX-License-Identifier: MIT
#include "core/metrics/sight_limits_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace mocapress::sight_limits_test {
namespace {

TEST(SightLimits, ComeBackFromJson) {
  SightLimits limits;
  limits.distance_m = 2.5;
  limits.of(Cue::Slide).least = 2.1;
  limits.of(Cue::Velocity).share = 0.11;
  EXPECT_EQ(limits_from(to_json(limits, true)), limits);
  EXPECT_EQ(limits_from_text("limits.json", limits_to_text(limits), 2.5), limits);
  EXPECT_EQ(limits_from_text("limits.json", "{}"), SightLimits());
}

TEST(SightLimits, JsonOfChangesHoldsNothingElse) {
  SightLimits limits;
  EXPECT_EQ(dumped(to_json(limits, false)), "{}");
  limits.distance_m = 2;
  limits.of(Cue::Hand).least = 6;
  EXPECT_EQ(dumped(to_json(limits, false)), R"({"distance_m":2.0,"hand":{"least":6.0}})");
}

TEST(SightLimits, AFileWithoutADistanceKeepsTheOneGiven) {
  EXPECT_EQ(limits_from_text("limits.json", limits_to_text({}), 12).distance_m, 12);
  EXPECT_EQ(limits_from_text("limits.json", R"({"distance_m": 3})", 12).distance_m, 3);
}

TEST(SightLimits, TextNamesThoseThatDiffer) {
  SightLimits limits;
  limits.distance_m = 12;
  EXPECT_EQ(limits_text(limits), "built-in limits");
  limits.of(Cue::Velocity) = {3, 0.08};
  limits.of(Cue::Slide).least = 2.1;
  EXPECT_EQ(limits_text(limits), "own limits: velocity 3 cm/s or 8 %, slide 2.1 cm");
}

TEST(SightLimits, PartsOfAFileReplaceBuiltInOnes) {
  const SightLimits limits = limits_from_text("limits.json", R"({"hand": {"least": 6}})");
  EXPECT_EQ(limits.of(Cue::Hand).least, 6);
  EXPECT_EQ(limits.of(Cue::Head), SightLimits().of(Cue::Head));
}

TEST(SightLimits, BadFilesAreRefusedInOneSentence) {
  const auto message = [](const char* text) -> std::string {
    try {
      limits_from_text("limits.json", text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("[]"), "limits.json: what should be limits is not a JSON object");
  EXPECT_EQ(message(R"({"hands": {"least": 6}})"), "limits.json: \"hands\" is unknown");
  EXPECT_EQ(message(R"({"hand": 6})"), "limits.json: \"hand\" is not a JSON object");
  EXPECT_EQ(message(R"({"hand": {"most": 6}})"), "limits.json: \"hand.most\" is unknown");
  EXPECT_EQ(message(R"({"hand": {"least": 0}})"), "limits.json: \"hand.least\" is not above 0");
  EXPECT_EQ(message(R"({"hand": {"least": "6"}})"), "limits.json: \"hand.least\" is not a number");
  EXPECT_EQ(message(R"({"hand": {"share": -1}})"), "limits.json: \"hand.share\" is below 0");
  EXPECT_EQ(message(R"({"distance_m": 0.1})"),
            "limits.json: \"distance_m\" is not from 0.5 to 100");
  EXPECT_TRUE(message("{").starts_with("limits.json:1:"));
}

TEST(SightLimits, LeastErrorsGrowWithTheDistanceAndSharesDoNot) {
  SightLimits limits;
  const double near = limits.noticed_from(Cue::Velocity, 0);
  const double near_head = limits.noticed_from(Cue::Head, 0);
  const double fast = limits.noticed_from(Cue::Velocity, 1000);
  limits.distance_m *= 2;
  EXPECT_EQ(limits.noticed_from(Cue::Velocity, 0), 2 * near);
  EXPECT_EQ(limits.noticed_from(Cue::Head, 0), 2 * near_head);
  EXPECT_EQ(limits.noticed_from(Cue::Velocity, 1000), fast);
}

TEST(SightLimits, UnnoticedDistanceIsWhereTheErrorMeetsItsLimit) {
  SightLimits limits;
  limits.distance_m = limits.unnoticed_from(Cue::Velocity, 10, 6);
  EXPECT_NEAR(limits.noticed_from(Cue::Velocity, 10), 6, 1e-12);
  EXPECT_EQ(limits.unnoticed_from(Cue::Velocity, 100, 6), 0);  // 7 % of 100 cm/s hide it
}

}  // namespace
}  // namespace mocapress::sight_limits_test
