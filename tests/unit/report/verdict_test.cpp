// SPDX-License-Identifier: MIT
#include "core/report/verdict.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/batch/row.h"

namespace mocapress::test {
namespace {

const ClipReview kApproved{.verdict = Verdict::Approved,
                           .note = "feet are fine",
                           .reviewer = "ana",
                           .time = "2026-11-26T14:05:00Z",
                           .source_hash = "aa",
                           .settings_hash = "bb",
                           .notes = {{12, {}, "lfoot", "slides", "ana", "2026-11-26T14:05:00Z"},
                                     {40, {}, "", "pops", "", ""}}};

TEST(Verdict, ReadsBackFromItsJson) {
  Json json = {{"other", 1}};
  put(json, kApproved);
  EXPECT_EQ(review_from(json), kApproved);
  EXPECT_EQ(json["reviewed"], "2026-11-26T14:05:00Z");
  EXPECT_EQ(review_from(Json::object()), ClipReview());
}

TEST(Verdict, HoldsForTheReviewedBytesAndSettingsOnly) {
  EXPECT_EQ(stale_reason(kApproved, "aa", "bb"), std::nullopt);
  EXPECT_EQ(stale_reason(kApproved, "a2", "bb"), "the clip's file changed");
  EXPECT_EQ(stale_reason(kApproved, "aa", "b2"), "the settings changed");
  EXPECT_EQ(stale_reason(kApproved, "a2", "b2"), "the clip's file and the settings changed");
}

TEST(Verdict, IsStaleWhereNothingSaysWhatWasReviewed) {
  EXPECT_NE(stale_reason({.verdict = Verdict::Approved}, "aa", "bb"), std::nullopt);
  EXPECT_EQ(stale_reason({.note = "no verdict yet"}, "aa", "bb"), std::nullopt);
}

TEST(Verdict, SettingsHashIgnoresNamesAndPlacesAlone) {
  const Settings settings;
  Settings renamed = settings;
  renamed.name = "Mine";
  Settings finer = settings;
  finer.target.value /= 2;
  ReadOptions with_character;
  with_character.character = "hero.glb";
  ReadOptions in_metres;
  in_metres.cm_per_unit = 100;
  const std::string hash = settings_hash(settings, {});
  EXPECT_EQ(settings_hash(renamed, {}), hash);
  EXPECT_EQ(settings_hash(settings, with_character), hash);
  EXPECT_NE(settings_hash(finer, {}), hash);
  Settings from_afar = settings;
  from_afar.limits.distance_m = 50;
  EXPECT_EQ(settings_hash(from_afar, {}), hash);  // the same bytes
  Settings not_visible = settings;
  Settings not_visible_from_afar = from_afar;
  for (Settings* one : {&not_visible, &not_visible_from_afar})
    one->target = {Target::Kind::Visibility, 1};
  EXPECT_NE(settings_hash(not_visible_from_afar, {}), settings_hash(not_visible, {}));
  EXPECT_NE(settings_hash(settings, in_metres), hash);
}

}  // namespace
}  // namespace mocapress::test
