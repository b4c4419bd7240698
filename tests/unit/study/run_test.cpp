// SPDX-License-Identifier: MIT
#include "core/study/run.h"
#include "core/formats/clip_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include "core/base/file.h"
#include "core/codec/methods/comparison_method.h"
#include "core/study/row.h"
#include "core/study/study_folder.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// A test with two clips in a folder of its own.
class Study : public testing::Test {
 protected:
  Study() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write_motion(folder_ / "one.bvh", test::smooth_motion(150, 1));
    write_motion(folder_ / "two.bvh", test::smooth_motion(180, 2));
  }
  ~Study() override { fs::remove_all(folder_); }

  StudyPlan plan() const {
    const std::vector<Target> targets = {
        {Target::Kind::Ratio, 10}, {Target::Kind::Ratio, 20}, {Target::Kind::Error, 2}};
    return {.clips = {{folder_ / "one.bvh", targets}, {folder_ / "two.bvh", targets}},
            .methods = {"annealed", "standard"}};
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("study-" + std::to_string(getpid()));
};

/// The rows without values that depend on the clock.
std::vector<std::string> timeless(std::vector<StudyRow> rows) {
  std::vector<std::string> lines;
  for (StudyRow& row : rows) {
    if (row.measured) row.measured->encode_seconds = 0;
    row.jobs = 0;
    lines.push_back(to_json_line(row));
  }
  return lines;
}

TEST_F(Study, MeasuresEveryClipByEveryMethodAtEveryTargetInThatOrder) {
  const StudyOutcome outcome = run_study(plan());
  EXPECT_TRUE(outcome.complete);
  ASSERT_EQ(outcome.rows.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    const StudyRow& row = outcome.rows[i];
    EXPECT_EQ(row.clip, plan().clips[i / 6].path.string());
    EXPECT_EQ(row.settings.method, plan().methods[i / 3 % 2]);
    EXPECT_TRUE(row.settings.target == plan().clips[0].targets[i % 3]);
    ASSERT_TRUE(row.measured) << row.error;
    EXPECT_TRUE(row.reached()) << to_json_line(row);
    EXPECT_EQ(row.measured->frames, i < 6 ? 150 : 180);
    EXPECT_EQ(row.measured->iterations.has_value(), row.settings.method == "annealed");
  }
}

TEST_F(Study, TellsOfEveryRowOnceAndOneAtATime) {
  std::atomic<int> inside = 0;
  int done = 0;
  int given = 0;
  run_study(
      plan(), {}, [&](const StudyRow&) { ++given; },
      [&](const StudyProgress& progress) {
        EXPECT_EQ(++inside, 1);
        EXPECT_EQ(progress.jobs, 12);
        if (progress.finished) {
          EXPECT_EQ(progress.done, ++done);
        }
        --inside;
        return true;
      });
  EXPECT_EQ(done, 12);
  EXPECT_EQ(given, 12);
}

TEST_F(Study, AFailureIsARowAndStopsNothing) {
  StudyPlan asked = plan();
  write_text(folder_ / "broken.bvh", "HIERARCHY\nnonsense");
  asked.clips.insert(asked.clips.begin(), {folder_ / "broken.bvh", {{Target::Kind::Ratio, 10}}});
  asked.clips[1].targets = {{Target::Kind::Error, 1e-9}, {Target::Kind::Ratio, 10}};
  asked.methods = {"standard", "magic"};
  const StudyOutcome outcome = run_study(asked);
  ASSERT_TRUE(outcome.complete);
  ASSERT_EQ(outcome.rows.size(), 2u + 4u + 6u);
  EXPECT_THAT(outcome.rows[0].error, testing::HasSubstr("broken.bvh:"));
  EXPECT_EQ(outcome.rows[0].fingerprint, "");
  EXPECT_THAT(outcome.rows[2].error, testing::HasSubstr("out of reach"));
  EXPECT_FALSE(outcome.rows[2].measured);
  EXPECT_TRUE(outcome.rows[3].measured);
  EXPECT_THAT(outcome.rows[4].error, testing::HasSubstr("magic"));
}

TEST_F(Study, StopsWhenToldToWithoutTheRowsItDidNotFinish) {
  int finished = 0;
  const StudyOutcome outcome = run_study(plan(), {}, {}, [&](const StudyProgress& progress) {
    return (finished += progress.finished != nullptr) < 3;
  });
  EXPECT_FALSE(outcome.complete);
  EXPECT_GE(outcome.rows.size(), 3u);
  EXPECT_LT(outcome.rows.size(), 12u);
}

TEST_F(Study, AnExceptionOfTheSinkEndsTheRun) {
  int given = 0;
  const auto full_disk = [&](const StudyRow&) {
    ++given;
    throw WriteError("disk full");
  };
  EXPECT_THROW(run_study(plan(), {}, full_disk), WriteError);
  EXPECT_LT(given, 12);
}

TEST_F(Study, GoesOnAfterAStopToTheSameRowsAsWithoutOne) {
  const fs::path at_once = folder_ / "at-once";
  const fs::path stopped = folder_ / "stopped";
  ASSERT_TRUE(run_study_in(at_once, plan()).complete);
  int finished = 0;
  ASSERT_FALSE(run_study_in(stopped, plan(), [&](const StudyProgress& progress) {
                 return (finished += progress.finished != nullptr) < 4;
               }).complete);
  EXPECT_FALSE(fs::exists(stopped / kRowsCsv));
  EXPECT_FALSE(fs::exists(stopped / kReport));
  StudyProgress last;
  const StudyOutcome outcome = run_study_in(stopped, plan(), [&](const StudyProgress& progress) {
    last = progress;
    return true;
  });
  EXPECT_TRUE(outcome.complete);
  EXPECT_GE(last.kept, 4);
  EXPECT_EQ(RowsFile(stopped / kRowsSoFar).rows().size(), 12u);  // none was measured twice
  EXPECT_EQ(timeless(outcome.rows), timeless(run_study_in(at_once, plan()).rows));
  for (const char* file : {kRowsCsv, kRowsJson, kReport}) EXPECT_TRUE(fs::exists(stopped / file));
}

TEST_F(Study, CompleteRowsGiveTheSameFilesAgain) {
  run_study_in(folder_ / "out", plan());
  const auto texts = [&] {
    std::vector<std::string> all;
    for (const char* file : {kRowsSoFar, kRowsCsv, kRowsJson, kReport})
      all.push_back(read_text(folder_ / "out" / file));
    return all;
  };
  const auto first = texts();
  run_study_in(folder_ / "out", plan());
  EXPECT_EQ(texts(), first);
}

TEST_F(Study, MeasuresAChangedClipAnewAndAMovedOneNot) {
  const std::vector<StudyRow> earlier = run_study(plan()).rows;
  fs::rename(folder_ / "one.bvh", folder_ / "moved.bvh");
  write_motion(folder_ / "two.bvh", test::smooth_motion(180, 3));
  StudyPlan asked = plan();
  asked.clips[0].path = folder_ / "moved.bvh";
  std::vector<std::string> measured;
  const StudyOutcome outcome =
      run_study(asked, earlier, [&](const StudyRow& row) { measured.push_back(row.clip); });
  EXPECT_EQ(measured, std::vector<std::string>(6, (folder_ / "two.bvh").string()));
  EXPECT_EQ(outcome.rows.front().clip, (folder_ / "moved.bvh").string());
  EXPECT_EQ(outcome.rows.front().measured, earlier.front().measured);
}

TEST_F(Study, FindsTheClipsOfAFolderInOrderAndEachOnce) {
  fs::create_directories(folder_ / "deeper");
  write_text(folder_ / "deeper" / "Three.BVH", "");
  write_text(folder_ / "notes.txt", "");
  const auto clips = find_clips({folder_ / "two.bvh", folder_});
  EXPECT_EQ(clips, (std::vector<fs::path>{folder_ / "two.bvh", folder_ / "deeper" / "Three.BVH",
                                          folder_ / "one.bvh"}));
  EXPECT_THROW(find_clips({folder_ / "none.bvh"}), InputError);
  fs::create_directories(folder_ / "empty");
  EXPECT_THROW(find_clips({folder_ / "empty"}), InputError);
}

TEST(StudyPlanTargets, ThePapersTargetsHoldItsTables) {
  const auto has = [](const std::vector<Target>& targets, Target::Kind kind, double value) {
    return std::find(targets.begin(), targets.end(), Target{kind, value}) != targets.end();
  };
  const auto running = paper_targets("somewhere/09_01.amc");
  EXPECT_TRUE(has(running, Target::Kind::Error, 0.58));
  EXPECT_FALSE(has(running, Target::Kind::Error, 0.67));
  EXPECT_TRUE(has(paper_targets("49_02.amc"), Target::Kind::Error, 0.67));
  for (const double ratio : {50, 40, 30, 15, 7}) {
    EXPECT_TRUE(has(running, Target::Kind::Ratio, ratio));
    EXPECT_TRUE(has(paper_targets("other.bvh"), Target::Kind::Ratio, ratio));
  }
  EXPECT_TRUE(has(running, Target::Kind::CoefficientRatio, 30));
}

TEST(StudyPlanTargets, ComparisonMethodsAreNotAskedForACoefficientRatio) {
  const std::vector<Target> targets = {{Target::Kind::CoefficientRatio, 30},
                                       {Target::Kind::Ratio, 30}};
  const StudyPlan plan{.clips = {{"a.bvh", targets}}, .methods = {"annealed"}};
  EXPECT_EQ(jobs_of(plan).size(), 2u);
  for (const ComparisonMethod* method : comparison_methods()) {
    const StudyPlan compared{.clips = plan.clips, .methods = {std::string(method->name)}};
    EXPECT_EQ(jobs_of(compared).size(), 1u) << method->name;
  }
}

TEST_F(Study, KeptWithoutAReportGoesOnLikeAnyOther) {
  const fs::path out = folder_ / "kept";
  ASSERT_TRUE(run_study_kept(out, plan()).complete);
  EXPECT_FALSE(fs::exists(out / kReport));
  EXPECT_EQ(read_rows(out / kRowsSoFar).size(), 12u);
  int kept = 0;
  run_study_in(out, plan(), [&](const StudyProgress& progress) {
    kept = progress.kept;
    return true;
  });
  EXPECT_EQ(kept, 12);
  EXPECT_TRUE(fs::exists(out / kReport));
}

TEST_F(Study, ReportStandsWithoutPicturesOfClipsThatAreGone) {
  const Results results(run_study(plan()).rows);
  const auto with = study_report(plan(), results);
  fs::remove(folder_ / "one.bvh");
  fs::remove(folder_ / "two.bvh");
  const auto without = study_report(plan(), results);
  ASSERT_TRUE(with && without);
  EXPECT_LT(without->size(), with->size());
  EXPECT_NE(without->find("Standard wavelets"), std::string::npos);
}

TEST_F(Study, ReportIsEndedByItsObserver) {
  const Results results(run_study(plan()).rows);
  EXPECT_FALSE(study_report(plan(), results, [](const EncodeProgress&) { return false; }));
}

}  // namespace
}  // namespace mocapress
