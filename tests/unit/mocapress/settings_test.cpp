// SPDX-License-Identifier: MIT
#include "core/mocapress/settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/methods/compression_method.h"
#include "core/metrics/distortion.h"
#include "core/mocapress/encode_settings.h"
#include "core/mocapress/settings_json.h"
#include "resources/samples/generator/samples.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

using testing::HasSubstr;

Settings unusual_preset() {
  return {.name = "Böss, \"held\"",
          .method = "annealed",
          .coding = Coding::Rle16,
          .weighting = Weighting::JointOrigins,
          .target = {Target::Kind::Size, 12345},
          .seed = 0xffffffffffffffff,
          .effort = Effort::Best,
          .importance = {.factors = {{"feet", 4}, {"lhand", 0.5}}, .contacts = 20},
          .promises = {.hand_degrees = 2.5, .root_cm = 0.1},
          .track_error = 0.0125,
          .correction = CorrectionSettings{.ratio = 12.5,
                                           .effectors = {"lhand", "rhand"},
                                           .solver = IkSolver::CyclicDescent,
                                           .at = CorrectAt::Contacts},
          .contacts = std::vector<ContactSetting>{{"lhand", 3, 9}, {"rhand end", 0, 1}},
          .ranges = {{3, 9, 2.5}, {20, 20, 100}}};
}

std::string complaint(const std::string& text) {
  try {
    parse_presets("mine.json", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Settings, ComesBackFromItsFileAsItWas) {
  std::vector<Settings> presets(built_in_presets().begin(), built_in_presets().end());
  presets.push_back(unusual_preset());
  EXPECT_EQ(parse_presets("", presets_text(presets)), presets);
  EXPECT_EQ(parse_presets("", presets_text({&presets.back(), 1})).front(), presets.back());
}

TEST(Settings, BuiltInPresetsKeepTheirPromisesOnEveryClip) {
  for (const Motion& motion : {samples::walk_clip(), samples::run_clip(), samples::jump_clip()}) {
    const Encoder encoder(motion);
    for (const char* name : {"Hero close-up", "Gameplay", "Crowd"}) {
      const Settings preset = find_preset(name);
      ASSERT_TRUE(preset.promises.any());
      const Encoding encoding = encoder.encode(encode_settings(preset, motion.skeleton));
      EXPECT_NE(encoding.visibility.sight(), Sight::Visible) << name;  // from its own distance
      EXPECT_THAT(broken_promises(preset.promises, motion, encoding.distortion), testing::IsEmpty())
          << name;
    }
  }
}

TEST(Settings, AVisibilityTargetNeedsNoValue) {
  const Settings preset =
      parse_presets("", R"({"name": "a", "target": {"kind": "not-visible"}})").front();
  EXPECT_EQ(preset.target.kind, Target::Kind::Visibility);
  EXPECT_EQ(preset.target.value, 1);
  EXPECT_EQ(parse_presets("", presets_text({&preset, 1})).front(), preset);
  EXPECT_EQ(target_text(preset.target), "not visible");
}

TEST(Settings, MissingKeysGetDefaults) {
  EXPECT_EQ(parse_presets("", R"({"name": "mine"})").front(), Settings{.name = "mine"});
}

TEST(Settings, EveryBuiltInOneIsValidAndFoundByNameAndSlug) {
  ASSERT_EQ(built_in_presets().size(), 5u);
  for (const Settings& preset : built_in_presets()) {
    EXPECT_NO_THROW(check(preset));
    EXPECT_EQ(find_preset(preset.name), preset);
    EXPECT_EQ(find_preset(slug(preset.name)), preset);
  }
  EXPECT_EQ(slug("Hero close-up"), "hero-close-up");
}

TEST(Settings, NeedNoNameAsJson) {
  EXPECT_EQ(settings_from_json("{}"), Settings{});
  EXPECT_EQ(settings_from_json(settings_to_json(unusual_preset())), unusual_preset());
  Settings nameless = unusual_preset();
  nameless.name.clear();
  EXPECT_EQ(settings_from_json(settings_to_json(nameless)), nameless);
}

TEST(Settings, AsJsonThatIsWrongSayWhere) {
  const auto complaint_of = [](const std::string& text) -> std::string {
    try {
      settings_from_json(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(complaint_of("{\n oops}"), HasSubstr("settings:2:2: "));
  EXPECT_THAT(complaint_of(R"({"target": {"kind": "ratio", "value": 0}})"),
              HasSubstr("target that is not above 0"));
  EXPECT_THAT(complaint_of(R"({"speed": 3})"), HasSubstr("\"speed\" is unknown"));
}

TEST(Settings, AFileThatIsWrongIsRefusedWithThePlaceOrTheKey) {
  EXPECT_THAT(complaint("{\n \"name\": \"a\",\n  oops}"), HasSubstr("mine.json:3:3: "));
  EXPECT_THAT(complaint("[]"), HasSubstr("no preset"));
  EXPECT_THAT(complaint("7"), HasSubstr("not a JSON object"));
  EXPECT_THAT(complaint(R"({"method": "annealed"})"), HasSubstr("no \"name\""));
  EXPECT_THAT(complaint(R"({"name": "a", "taget": 1})"), HasSubstr("\"taget\" is unknown"));
  EXPECT_THAT(complaint(R"({"name": "a", "method": 3})"), HasSubstr("\"method\" is not a text"));
  EXPECT_THAT(complaint(R"({"name": "a", "method": "magic"})"), HasSubstr("magic"));
  EXPECT_THAT(complaint(R"({"name": "a", "weighting": "even"})"), HasSubstr("bone-ends"));
  EXPECT_THAT(complaint(R"({"name": "a", "target": {"kind": "error", "value": -1}})"),
              HasSubstr("not above 0"));
  EXPECT_THAT(complaint(R"({"name": "a", "target": {"kind": "size", "value": "big"}})"),
              HasSubstr("\"value\" is not a number"));
  EXPECT_THAT(complaint(R"({"name": "a", "method": "pca", "ik": {}})"),
              HasSubstr("wavelet methods only"));
  EXPECT_THAT(complaint(R"({"name": "a", "coding": "deflate"})"), HasSubstr("closed loop"));
  EXPECT_THAT(complaint(R"({"name": "a", "ik": {"ratio": "some"}})"), HasSubstr("auto"));
  EXPECT_THAT(complaint(R"({"name": "a", "importance_ranges": [{"first_frame": 3}]})"),
              HasSubstr("a first and a last frame"));
  EXPECT_THAT(complaint(R"({"name": "a", "importance_ranges":
                            [{"first_frame": 3, "last_frame": 5, "factor": 0.5}]})"),
              HasSubstr("from 1 to 100"));
  EXPECT_THROW(find_preset("no-such-preset"), InputError);
}

TEST(Settings, HaveOneSetOfDefaultsForAnyClipAndForOne) {
  const EncodeSettings asked = encode_settings({}, test::small_skeleton());
  const EncodeSettings plain;
  EXPECT_EQ(asked.method, plain.method);
  EXPECT_EQ(asked.coding, effective_coding(plain));
  EXPECT_EQ(asked.basis, plain.basis);
  EXPECT_EQ(asked.weighting, plain.weighting);
  EXPECT_EQ(asked.target, plain.target);
  EXPECT_EQ(asked.seed, plain.seed);
  EXPECT_EQ(asked.effort, plain.effort);
  EXPECT_EQ(asked.importance.is_even(), plain.importance.is_even());
  EXPECT_EQ(asked.promises, plain.promises);
  EXPECT_EQ(asked.ends, plain.ends);
  EXPECT_EQ(asked.loop, plain.loop);
  EXPECT_EQ(asked.correction.has_value(), plain.correction.has_value());
  EXPECT_EQ(asked.contacts.has_value(), plain.contacts.has_value());
  EXPECT_EQ(asked.ranges, plain.ranges);
}

TEST(Settings, BecomeThoseOfAClip) {
  const Skeleton skeleton = test::small_skeleton();
  const EncodeSettings options = encode_settings(unusual_preset(), skeleton);
  EXPECT_EQ(options.method, Method::Annealed);
  EXPECT_EQ(options.coding, Coding::Rle16);
  ASSERT_TRUE(options.correction);
  EXPECT_EQ(options.correction->joints,
            (std::vector{skeleton.find("lhand"), skeleton.find("rhand")}));
  EXPECT_EQ(options.correction->ratio, 12.5);
  EXPECT_EQ(options.ranges, unusual_preset().ranges);
  EXPECT_EQ(encode_settings({}, skeleton).coding, Coding::Adaptive);
  Settings other = unusual_preset();
  other.correction->effectors = {"tail"};
  EXPECT_THROW(encode_settings(other, skeleton), Error);
}

}  // namespace
}  // namespace mocapress
