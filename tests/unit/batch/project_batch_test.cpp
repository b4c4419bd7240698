// SPDX-License-Identifier: MIT
#include "core/batch/project_batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/utf8_path.h"

namespace mocapress {
namespace {

using testing::HasSubstr;

Batch batch_of(const std::string& text) {
  Batch batch{.presets = {built_in_presets()[1]}};
  add_project(batch, "work/hero.mocapress", text, kUsualNames);
  return batch;
}

std::string project(const std::string& clips) {
  return R"({"format": "mocapress-project", "version": 1, "characters": {"aa": "hero.glb"},
             "clips": [)" +
         clips + "]}";
}

/// Paths of clips have the system's separators.
std::string preferred(const char* path) {
  return utf8(std::filesystem::path(path).make_preferred());
}

std::string failure(const std::string& text) {
  try {
    batch_of(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ProjectBatch, GivesEachClipItsOwnSettingsAndTheOthersThePreset) {
  const Batch batch = batch_of(project(
      R"({"path": "walks/a.amc", "skeleton": "../b.asf", "verdict": "approved", "note": "fine",
          "reviewer": "ana", "source_hash": "aa", "reading": {"rate_hz": 30},
          "settings": {"name": "Mine", "target": {"kind": "error", "value": 2},
                       "contact_settings": {"end_height_cm": 5}}},
         {"path": "b.bvh"}, {"path": "../far/c.bvh", "settings": {"seed": 7}})"));
  ASSERT_EQ(batch.items.size(), 3u);
  const BatchItem tuned = batch.items[0];
  EXPECT_EQ(tuned.input, preferred("work/walks/a.amc"));
  EXPECT_EQ(tuned.skeleton, "b.asf");
  EXPECT_EQ(tuned.output, "walks/a");
  EXPECT_EQ(batch.presets[tuned.preset].target.value, 2);
  EXPECT_EQ(tuned.review.reviewer, "ana");
  EXPECT_EQ(tuned.review.source_hash, "aa");
  EXPECT_EQ(tuned.reading->sample_rate_hz, 30);
  EXPECT_EQ(tuned.reading->character, preferred("work/hero.glb"));
  EXPECT_EQ(batch.items[1].reading->character, preferred("work/hero.glb"));
  EXPECT_EQ(batch.items[1].preset, 0u);
  EXPECT_EQ(batch.items[1].output, "b");
  EXPECT_EQ(batch.items[2].output, "far/c");
  EXPECT_EQ(batch.presets[batch.items[2].preset].name, "Project");
}

TEST(ProjectBatch, PutsCharactersOnTheClipsOfTheirRigs) {
  const Batch batch = batch_of(
      R"({"format": "mocapress-project", "version": 1,
          "characters": {"aa": "xbot.glb", "bb": ""},
          "clips": [{"path": "a.bvh", "rig": "aa"}, {"path": "b.bvh", "rig": "bb"},
                    {"path": "c.bvh", "rig": "cc"}, {"path": "d.bvh"}]})");
  EXPECT_EQ(batch.items[0].reading->character, preferred("work/xbot.glb"));
  EXPECT_EQ(batch.items[1].reading, std::nullopt);
  EXPECT_EQ(batch.items[2].reading, std::nullopt);
  EXPECT_EQ(batch.items[3].reading, std::nullopt);
}

TEST(ProjectBatch, PutsTheOnlyCharacterOnClipsWhoseRigIsNotKnownYet) {
  const Batch batch = batch_of(
      R"({"format": "mocapress-project", "version": 1, "characters": {"aa": "xbot.glb"},
          "clips": [{"path": "a.bvh"}, {"path": "b.bvh", "rig": "bb"}]})");
  EXPECT_EQ(batch.items[0].reading->character, preferred("work/xbot.glb"));
  EXPECT_EQ(batch.items[1].reading, std::nullopt);
}

TEST(ProjectBatch, SaysWhatIsWrongWithAProject) {
  EXPECT_THAT(failure("{}"), HasSubstr("hero.mocapress: is not a project"));
  EXPECT_THAT(failure(project(R"({"path": 3})")), HasSubstr("is not a project: "));
  EXPECT_THAT(failure(project("{}")), HasSubstr("has a clip without a path"));
  EXPECT_THAT(failure(R"({"format": "mocapress-project", "version": 99})"), HasSubstr("newer"));
  EXPECT_THAT(failure(project(R"({"path": "a.bvh", "settings": {"tarket": 1}})")),
              HasSubstr("tarket"));
}

}  // namespace
}  // namespace mocapress
