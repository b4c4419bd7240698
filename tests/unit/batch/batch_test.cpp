// SPDX-License-Identifier: MIT
#include "core/batch/batch.h"
#include "core/base/utf8_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <set>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/batch/queue_json.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string named(const char* pattern) {
  return output_name(pattern, {"/a/b/walk.one.bvh", "b/slow", {}}, built_in_presets().front());
}

TEST(OutputName, FillsInWhatThePatternNames) {
  EXPECT_EQ(named(kUsualNames), "b/slow/walk.one");
  EXPECT_EQ(named("{folder}/{stem}_{preset}"), "b/slow/walk.one_hero-close-up");
  EXPECT_EQ(named("{stem}.mcpr"), "walk.one");
  EXPECT_EQ(named("{stem}-{type}"), "walk.one-bvh");
  EXPECT_EQ(named("x/{method}-{stem}.v2"), "x/closed-loop-walk.one.v2");
  EXPECT_EQ(output_name(kUsualNames, {"walk.bvh", "", {}}, {}), "walk");
  EXPECT_EQ(output_name("{stem}", {"moves.fbx", "", {}, "Run, fast"}, {}), "moves-run-fast");
}

TEST(OutputName, RefusesWhatIsNoNameInTheFolder) {
  for (const char* pattern : {"../{stem}", "/tmp/{stem}", "{stem", "{sten}", "", "{folder}/", "."})
    EXPECT_THROW(named(pattern), Error) << pattern;
}

TEST(Shards, PutEveryClipIntoExactlyOneWhateverElseIsInTheBatch) {
  constexpr int kShards = 7;
  std::set<int> used;
  for (int clip = 0; clip < 200; ++clip) {
    const BatchItem item{.output = "walks/" + std::to_string(clip)};
    int owners = 0;
    for (int i = 1; i <= kShards; ++i)
      if (Shard{i, kShards}.has(item)) ++owners, used.insert(i);
    EXPECT_EQ(owners, 1) << item.output;
  }
  EXPECT_EQ(used.size(), 7u);
}

TEST(Shards, AreWrittenAsIOfN) {
  EXPECT_EQ(parse_shard("2/8"), (Shard{2, 8}));
  for (const char* text : {"", "2", "0/3", "4/3", "1/0", "a/b", "1/2/3", "-1/2", "1/2 "})
    EXPECT_THROW(parse_shard(text), Error) << text;
}

TEST(ItemList, ReturnsItemsUnchangedAfterReplacingAndErasing) {
  std::vector<BatchItem> kept;
  ItemList list;
  for (std::size_t i = 0; i < 50; ++i) {
    const std::string folder = "/in/" + std::to_string(i / 8) + '/';
    kept.push_back({.input = (i % 7 ? folder : "") + std::string(i, 'x'),
                    .skeleton = i % 3 ? "" : "/s.asf",
                    .output = (i % 2 ? "a/" : "") + std::to_string(i),
                    .preset = 7 * i,
                    .problem = i % 5 ? "" : "no",
                    .review = {static_cast<Verdict>(i % 3), i % 4 ? "" : "a\nnote"}});
    if (i % 3 == 0)
      kept.back().review.notes = {{static_cast<int>(i), {}, "hip", "a\n\"note\"", "", ""}};
    if (i % 2) kept.back().reading = {.cm_per_unit = 0.1 * static_cast<double>(i)};
    list.push_back(kept.back());
  }
  for (const std::size_t index : {std::size_t{46}, std::size_t{0}, std::size_t{20}}) {
    kept[index].skeleton = "/other/longer.asf";
    list.replace(index, kept[index]);
    list.erase(index / 2);
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(index / 2));
    list.shrink();
  }
  ASSERT_EQ(list.size(), kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(list[i], kept[i]) << i;
}

class Sources : public testing::Test {
 protected:
  Sources() {
    fs::remove_all(folder_);
    for (const char* file : {"b.bvh", "a.AMC", "deep/er/c.bvh", "notes.txt", "a.asf"}) {
      fs::create_directories((folder_ / file).parent_path());
      write_text(folder_ / file, "");
    }
  }
  ~Sources() override { fs::remove_all(folder_); }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("walks-" + std::to_string(getpid()));
};

TEST_F(Sources, AreTheClipsBelowAFolderEachOnceWithTheFoldersBetween) {
  for (const std::string& spelt : {utf8(folder_), utf8(folder_) + "/"})
    EXPECT_EQ(find_sources({spelt})[1].folder, utf8(folder_.filename()));
  const auto sources = find_sources({utf8(folder_), utf8(folder_ / "b.bvh")});
  const std::string folder = utf8(folder_.filename());
  ASSERT_EQ(sources.size(), 3u);
  EXPECT_EQ(sources[0], (SourceClip{utf8(folder_ / "a.AMC"), folder, {}}));
  EXPECT_EQ(sources[1], (SourceClip{utf8(folder_ / "b.bvh"), folder, {}}));
  EXPECT_EQ(sources[2],
            (SourceClip{utf8(folder_ / "deep" / "er" / "c.bvh"), folder + "/deep/er", {}}));
}

TEST_F(Sources, AMissingInputIsAClipWithAProblem) {
  const auto sources = find_sources({utf8(folder_ / "none.bvh"), utf8(folder_ / "b.bvh")});
  ASSERT_EQ(sources.size(), 2u);
  EXPECT_THAT(sources[0].problem, HasSubstr("No such file"));
  EXPECT_EQ(sources[1].problem, "");
}

TEST_F(Sources, BelowAFolderLeaveTheOutputsOut) {
  fs::create_directories(folder_ / "out");
  write_text(folder_ / "out/made.bvh", "");
  const std::string outputs = utf8(folder_ / "deep/../out");
  EXPECT_EQ(find_sources({utf8(folder_)}).size(), 4u);
  EXPECT_EQ(find_sources({utf8(folder_)}, outputs).size(), 3u);
  EXPECT_EQ(find_sources({utf8(folder_ / "out")}, outputs).size(), 1u) << "asked for by name";
}

TEST_F(Sources, ImpossibleNamesMakeItemsWithAProblem) {
  Batch batch{.presets = {{.name = "p"}}};
  add_items(batch, {{"in/..bvh", "in", {}}, {"in/a.bvh", "in", {}}}, 0, kUsualNames);
  EXPECT_THAT(batch.items[0].problem, HasSubstr("in/..bvh: its output's name"));
  EXPECT_EQ(batch.items[1].problem, "");
  EXPECT_THROW(add_items(batch, {}, 0, "{nothing}"), Error);
}

TEST_F(Sources, WithAProblemTakeNoNameFromOthers) {
  Batch batch{.presets = {{.name = "p"}}};
  add_items(batch, {{"a", "in", "cannot be read"}, {"a.bvh", "in", {}}}, 0, kUsualNames);
  mark_collisions(batch);
  EXPECT_EQ(batch.items[0].problem, "cannot be read");
  EXPECT_EQ(batch.items[1].problem, "");
  EXPECT_EQ(batch.items[1].output, "in/a");
}

TEST_F(Sources, ThatWouldBeWrittenToOnePlaceAreToldApart) {
  Batch batch{.presets = {{.name = "p"}}};
  add_items(batch, {{"x/walk.bvh", "", {}}, {"y/walk.bvh", "", {}}, {"z/walk.bvh", "", {}}}, 0,
            "{stem}");
  mark_collisions(batch);
  EXPECT_EQ(batch.items[0].problem, "");
  EXPECT_THAT(batch.items[1].problem, HasSubstr("as x/walk.bvh is"));
  EXPECT_NE(batch.items[2].problem, "");
  std::set<std::string> outputs;
  for (const BatchItem item : batch.items) outputs.insert(item.output);
  EXPECT_EQ(outputs.size(), 3u);
}

TEST(OutputName, EqualStemsDifferByTypeInThePattern) {
  Batch batch{.presets = {built_in_presets()[1]}};
  const std::vector<SourceClip> sources = {{"a/walk.bvh", "a", {}}, {"a/walk.amc", "a", {}}};
  add_items(batch, sources, 0, "{folder}/{stem}-{type}");
  mark_collisions(batch);
  EXPECT_TRUE(batch.items[1].problem.empty());
  EXPECT_EQ(batch.items[0].output, "a/walk-bvh");
  EXPECT_EQ(batch.items[1].output, "a/walk-amc");
  Batch colliding{.presets = batch.presets};
  add_items(colliding, sources, 0, kUsualNames);
  mark_collisions(colliding);
  EXPECT_NE(colliding.items[1].problem.find("{type}"), std::string::npos);
}

TEST(Queue, ComesBackFromItsFileAsItWas) {
  Batch batch{.presets = {built_in_presets().begin(), built_in_presets().end()},
              .formats = {OutputFormat::Bvh, OutputFormat::Mcpr},
              .reading = {.sample_rate_hz = 60.0,
                          .bvh_root = TranslationConvention::Replaces,
                          .character = "hero.glb"},
              .writing = {.cm_per_unit = 2.54, .up = UpAxis::Z},
              .bank = runtime::BankForm::Packed,
              .learn = true};
  batch.items = {{.input = "/a/ü \"x\".bvh", .output = "a/x", .preset = 2},
                 {.input = "/b.amc",
                  .skeleton = "/c.asf",
                  .output = "b",
                  .preset = 0,
                  .review = {Verdict::Rejected, "slides"},
                  .reading = ReadOptions{.sample_rate_hz = 30, .up = UpAxis::Z}}};
  const Batch read = parse_queue("", queue_text(batch));
  EXPECT_EQ(read.presets, batch.presets);
  EXPECT_EQ(read.formats, batch.formats);
  EXPECT_EQ(read.bank, batch.bank);
  EXPECT_EQ(read.learn, batch.learn);
  EXPECT_TRUE(read.items == batch.items);
  EXPECT_EQ(read.reading, batch.reading);
  EXPECT_EQ(read.writing, batch.writing);
}

TEST(Queue, RefusesInvalidQueuesAndOutputsOutsideTheFolder) {
  const Batch batch{.presets = {{.name = "p"}}, .items = {{.input = "i", .output = "../o"}}};
  EXPECT_THROW(parse_queue("", queue_text(batch)), InputError);
  for (const char* text : {"", "{}", "[]", R"({"mocapress_queue": 1})",
                           R"({"mocapress_queue": 1, "presets": [], "formats": ["exe"]})",
                           R"({"mocapress_queue": 1, "presets": [], "formats": ["mcpr"],
                               "bank": "raw", "clips": []})",
                           R"({"mocapress_queue": 1, "presets": [], "formats": ["bvh"],
                               "bank": "packed", "clips": []})",
                           R"({"mocapress_queue": 1, "presets": [], "formats": ["mcpr"],
                               "bank": "cooked", "learn": true, "clips": []})",
                           R"({"mocapress_queue": 1, "presets": [], "formats": [],
                               "clips": [{"input": "a", "output": "b", "preset": 0}]})"})
    EXPECT_THROW(parse_queue("", text), InputError) << text;
}

}  // namespace
}  // namespace mocapress
