// SPDX-License-Identifier: MIT
#include "core/batch/run.h"
#include "core/base/utf8_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>

#include "core/bank/bank_file.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/batch/batch_folder.h"
#include "core/batch/report.h"
#include "core/codec/methods/compared_file.h"
#include "core/report/markup.h"
#include "tests/support/svg_frame.h"
#include "tests/unit/batch/batch_clips.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class BatchRun : public test::BatchTest {
 protected:
  std::vector<BatchRow> rows() const {
    std::vector<BatchRow> all;
    JournalReader(out() / "batch.jsonl").for_each([&](const BatchRow& row) { all.push_back(row); });
    return all;
  }
};

TEST_F(BatchRun, MakesTheFilesOfEveryClipAndMeasuresWhatItWrote) {
  Batch asked = batch();
  asked.formats = {kOutputFormats.begin(), kOutputFormats.end()};
  std::erase(asked.formats, OutputFormat::Review);  // not every build has the viewer
  const BatchOutcome outcome = run(asked);
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.counts.done, 3u);
  EXPECT_EQ(outcome.counts.failed, 0u);
  ASSERT_EQ(rows().size(), 3u);
  for (const BatchRow& row : rows()) {
    ASSERT_TRUE(row.done()) << row.error;
    ASSERT_EQ(row.files.size(), 7u);
    const Motion original = read_motion(row.input).motion;
    const OpenedMcpr opened = open_mcpr(out() / (row.output + ".mcpr"));
    const Distortion found = measure(original.skeleton, original.clip, opened.decoded);
    EXPECT_NEAR(row.measured->eps_bone_ends_cm, found.eps_bone_ends, 1e-9);
    EXPECT_LE(found.eps_bone_ends, 2);
    EXPECT_NEAR(row.measured->max_error_cm, found.max.cm, 1e-9);
    ASSERT_TRUE(row.worst);
    EXPECT_EQ(row.worst->frame, found.worst(row.preset.weighting).frame);
    for (const char* extension : {".bvh", ".amc", ".glb", ".fbx"})
      EXPECT_EQ(read_motion(out() / (row.output + extension)).motion.clip.frames(),
                original.clip.frames());
  }
  EXPECT_EQ(rows()[1].output, "in/one");
}

TEST_F(BatchRun, OneThreadAndManyGiveTheSameBytes) {
  run(batch(), {.jobs = 1});
  const auto by_one = contents(out());
  EXPECT_EQ(by_one.size(), 6u);
  fs::remove_all(out());
  run(batch(), {.jobs = 3});
  EXPECT_EQ(contents(out()), by_one);
}

TEST_F(BatchRun, AFailedClipIsARowWithItsReasonAndTheRestGoesOn) {
  write_text(folder_ / "in/broken.bvh", "HIERARCHY\nnonsense");
  write_motion(folder_ / "in/lonely.amc", test::smooth_motion(20));
  fs::remove(folder_ / "in/lonely.asf");
  Batch asked = batch();
  asked.presets.push_back({.name = "never", .target = {Target::Kind::Error, 1e-12}});
  BatchItem last = asked.items[asked.items.size() - 1];
  last.preset = 1;
  asked.items.replace(asked.items.size() - 1, last);
  const BatchOutcome outcome = run(asked);
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.counts.done, 5u);
  EXPECT_EQ(outcome.counts.failed, 3u);
  EXPECT_THAT(rows()[0].error, HasSubstr("broken.bvh:"));
  EXPECT_THAT(rows()[1].error, HasSubstr("lonely.asf is not beside it"));
  EXPECT_THAT(rows()[4].error, HasSubstr("out of reach"));
  EXPECT_FALSE(fs::exists(out() / "in/broken.mcpr"));
  EXPECT_THAT(read_text(out() / "report.html"), HasSubstr("lonely.asf is not beside it"));
}

TEST_F(BatchRun, CanEndAtTheFirstFailure) {
  write_text(folder_ / "in/broken.bvh", std::string(1 << 20, 'x'));  // the largest goes first
  const BatchOutcome outcome = run(batch(), {.jobs = 1, .keep_going = false});
  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.counts.done, 1u);
}

TEST_F(BatchRun, NeverOverwritesWhatItDidNotWriteUnlessTold) {
  fs::create_directories(out() / "in");
  write_text(out() / "in/one.mcpr", "somebody's");
  EXPECT_EQ(run(batch()).counts.failed, 1u);
  EXPECT_EQ(read_text(out() / "in/one.mcpr"), "somebody's");
  EXPECT_THAT(rows()[1].error, HasSubstr("not overwritten"));
  EXPECT_EQ(run(batch(), {.resumed = true}).counts.failed, 1u);
  EXPECT_EQ(read_text(out() / "in/one.mcpr"), "somebody's");
  EXPECT_EQ(run(batch(), {.overwrite = true}).counts.failed, 0u);
  EXPECT_NE(read_text(out() / "in/one.mcpr"), "somebody's");
}

TEST_F(BatchRun, NeverWritesOverItsOwnSourceEvenWhenToldToOverwrite) {
  const std::string before = read_text(folder_ / "in/one.bvh");
  Batch asked = batch();
  asked.formats = {OutputFormat::Bvh};
  BatchControl control;
  const auto outcome = run_batch_in(folder_, asked, {.overwrite = true}, control);
  EXPECT_EQ(outcome.counts.failed, 2u);  // the .amc does not fail
  EXPECT_EQ(read_text(folder_ / "in/one.bvh"), before);
}

TEST_F(BatchRun, NeverWritesOverTheSourceOfAnotherClip) {
  write_motion(folder_ / "in/more/one.bvh", test::smooth_motion(60, 4));
  const std::string before = read_text(folder_ / "in/one.bvh");
  Batch asked{.presets = batch().presets, .formats = {OutputFormat::Bvh}};
  add_items(asked, find_sources({utf8(folder_ / "in/more")}), 0, "{stem}");
  add_items(asked, find_sources({utf8(folder_ / "in/one.bvh")}), 0, "elsewhere");
  BatchControl control;
  const auto outcome = run_batch_in(folder_ / "in", asked, {.overwrite = true}, control);
  EXPECT_EQ(outcome.counts.failed, 1u);
  EXPECT_EQ(read_text(folder_ / "in/one.bvh"), before);
}

TEST_F(BatchRun, AClipThatTakesTooLongFailedAndMayBeDoneAgain) {
  const BatchOutcome outcome = run(batch(), {.clip_seconds = 1e-9});
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.counts.failed, 3u);
  EXPECT_EQ(rows()[0].error, "took longer than 1e-09 s");
  EXPECT_FALSE(fs::exists(out() / "in/one.mcpr"));
  EXPECT_EQ(run(batch(), {.resumed = true, .clip_seconds = 3600}).counts.failed, 0u);
}

TEST_F(BatchRun, AJournalInUseSaysWhoHasItAndIsTakenOverFromAnotherComputerAlone) {
  run(batch());
  const auto resumed = [&](bool take_over) -> std::string {
    try {
      run(batch(), {.resumed = true, .take_over = take_over});
      return "done";
    } catch (const WriteError& error) {
      return error.what();
    }
  };
  AppendedFile other(out() / "batch.jsonl");
  const std::string process = "process " + std::to_string(getpid()) + ", since 20";
  EXPECT_THAT(resumed(false), HasSubstr("another run is using it: "));
  EXPECT_THAT(resumed(true), HasSubstr(process)) << "this computer knows that it runs";
  std::string text = read_text(out() / "batch.jsonl");
  const std::size_t at = text.find("\"host\":\"") + 8;
  text.replace(at, text.find('"', at) - at, "elsewhere");
  other.replace([&](StagedFile& file) { file.write(text); });
  EXPECT_THAT(resumed(false), HasSubstr("on elsewhere, process"));
  EXPECT_THAT(resumed(false), HasSubstr("taken over"));
  EXPECT_EQ(resumed(true), "done");
}

TEST_F(BatchRun, PutsWhatTheViewerShowsBesideTheReport) {
  Batch asked = batch();
  asked.formats = {OutputFormat::Mcpr, OutputFormat::Review};
  fs::create_directories(out());
  {
    // Not run_batch_in(), which builds without the viewer refuse.
    Journal journal(out() / "batch.jsonl", asked, {}, Journal::Start::New);
    BatchControl control;
    run_batch(asked, out(), journal, {}, control);
  }
  ASSERT_EQ(rows().size(), 3u);
  for (const BatchRow& row : rows()) {
    ASSERT_EQ(row.files.size(), 2u) << row.error;
    EXPECT_EQ(row.files[1].name, row.output + ".review.js");
    EXPECT_THAT(read_text(out() / row.files[1].name),
                testing::StartsWith("mocapressReview(\"" + row.output + "\", \""));
  }
}

TEST_F(BatchRun, EveryReportSaysWhichProgramMadeItAndWhen) {
  run(batch());
  for (const char* name : {"report.csv", "report.json", "report.html"}) {
    EXPECT_THAT(read_text(out() / name), HasSubstr("Mocapress "));
    // Time fixed by the tests.
    EXPECT_THAT(read_text(out() / name), HasSubstr("2023-11-14T22:13:20Z"));
  }
}

BatchRow seen_row(std::size_t index, double times_noticed) {
  BatchRow row;
  row.index = index;
  row.output = "walks/take_" + std::to_string(1000 + index);
  row.preset = built_in_presets()[1];
  row.measured =
      Measurement{.frames = 300,
                  .sample_rate_hz = 60,
                  .ratio = 80,
                  .seen = Seen{times_noticed, 0.5,
                               "velocity of rtoes at frame 66: 4.31 cm/s, noticed from 2.4 cm/s"}};
  row.sights = {{"", std::string(300, '2')}, {"rtoes", std::string(300, '2')}};
  row.warnings = {row.output + ".bvh:" + std::to_string(index) + ": the unit is guessed"};
  return row;
}

TEST(BatchReport, ThousandsOfClipsMakeASmallPageMostVisibleErrorsFirst) {
  const BatchRows rows = [](const auto& visit) {
    for (std::size_t i = 0; i < 3000; ++i) visit(seen_row(i, i == 1234 ? 9 : 2));
  };
  std::ostringstream out;
  write_batch_html(out, rows, 0, {"Mocapress 1", "2026-11-26T14:05:00Z"});
  const std::string page = out.str();
  EXPECT_LT(page.size(), 2'000'000u);
  EXPECT_LT(page.find("clips with visible errors"), page.find("clips done"));
  const auto count = [&](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = page.find(text, at)) != page.npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count("the unit is guessed"), 1u);
  for (const char* filter : {"any visibility", "any verdict", "with warnings", "max over, cm",
                             "ratio below", "show all", "sort(column(\"visibility\"))"})
    EXPECT_GT(count(filter), 0u) << filter;
  if (const char* folder = std::getenv("MOCAPRESS_PICTURES"))  // for those who look at pages
    write_text(std::filesystem::path(folder) / "batch-3000.html", page);
  EXPECT_EQ(count("visible errors over time"), 24u);
  EXPECT_LT(page.find("take_2234: visible errors"), page.find("take_1000: visible errors"));
}

TEST(BatchReport, ThousandsOfClipsAndTheLargestViewerStayBelowThreeMegabytes) {
  const BatchRows rows = [](const auto& visit) {
    for (std::size_t i = 0; i < 3000; ++i) {
      BatchRow row = seen_row(i, 2);
      row.formats = {OutputFormat::Mcpr, OutputFormat::Review};
      row.files = {{row.output + ".mcpr", 3000, "1"}, {row.output + ".review.js", 9000, "2"}};
      visit(row);
    }
  };
  const auto page = [&](std::span<const std::byte> viewer) {
    std::ostringstream out;
    write_batch_html(out, rows, 0, {"Mocapress 1", "2026-11-26T14:05:00Z"}, {}, viewer);
    return out.str();
  };
  const std::vector<std::byte> viewer(kLargestViewer, std::byte{7});
  const std::string with_viewer = page(viewer);
  EXPECT_LT(with_viewer.size(), 3'000'000u);
  EXPECT_THAT(with_viewer, HasSubstr("id=\"review\""));
  EXPECT_THAT(page({}), Not(HasSubstr("review\"")));
  // A name that two parts of the script declare would end it before it began.
  static const std::regex kDeclared("\n(?:const|let|function) (\\w+)");
  const std::string script = with_viewer.substr(with_viewer.rfind("<script>"));
  std::set<std::string> names;
  for (std::sregex_iterator i(script.begin(), script.end(), kDeclared), end; i != end; ++i)
    EXPECT_TRUE(names.insert((*i)[1]).second) << (*i)[1];
  EXPECT_THAT(names, testing::IsSupersetOf({"heads", "told"}));
}

TEST_F(BatchRun, AVerdictIsStaleInEveryReportWhenTheClipOrTheSettingsChanged) {
  Batch asked = batch();
  const auto approve = [&](std::size_t i) {
    BatchItem item = asked.items[i];
    item.review = {.verdict = Verdict::Approved,
                   .reviewer = "ana",
                   .time = "2026-11-26T14:05:00Z",
                   .source_hash = stamp(item, {}).hash,
                   .settings_hash = settings_hash(asked.presets[0], {})};
    asked.items.replace(i, item);
  };
  for (std::size_t i = 0; i < asked.items.size(); ++i) approve(i);
  run(asked);
  for (const BatchRow& row : rows()) EXPECT_EQ(stale_reason(row), std::nullopt);
  EXPECT_THAT(read_text(out() / "report.html"), HasSubstr("approved by ana, 2026-11-26<"));
  write_motion(folder_ / "in/one.bvh", test::smooth_motion(110, 7));
  run(asked, {.overwrite = true, .resumed = true});
  EXPECT_EQ(stale_reason(rows()[1]), "the clip's file changed");
  EXPECT_EQ(stale_reason(rows()[0]), std::nullopt);
  EXPECT_THAT(read_text(out() / "report.html"), HasSubstr("stale: the clip"));
  EXPECT_THAT(read_text(out() / "report.json"), HasSubstr(R"("stale":"the clip's file changed")"));
  EXPECT_THAT(read_text(out() / "report.csv"), HasSubstr(",the clip's file changed,"));
  asked.presets[0].target.value = 3;
  run(asked, {.overwrite = true, .resumed = true});
  EXPECT_EQ(stale_reason(rows()[0]), "the settings changed");
}

TEST_F(BatchRun, WantsToBeToldToResumeOrToBeginAnew) {
  run(batch());
  EXPECT_THROW(run(batch()), WriteError);
  EXPECT_EQ(run(batch(), {.resumed = true}).counts.kept, 3u);
  EXPECT_EQ(run(batch(), {.overwrite = true}).counts.kept, 0u);
}

TEST_F(BatchRun, PutsAllFilesIntoABankByTheNamesOfTheirOutputs) {
  Batch asked = batch();
  for (const auto form : {runtime::BankForm::Packed, runtime::BankForm::Cooked}) {
    asked.bank = form;
    EXPECT_TRUE(run(asked, {.resumed = true}).has_bank);
    const BankFile bank(out() / kBankOfBatch);
    EXPECT_EQ(bank.bank().form, form);
    ASSERT_EQ(bank.clips(), 3u);
    EXPECT_EQ(bank.describe(0).name, "in/more/three");
    EXPECT_TRUE(bank.play(0));
    if (form == runtime::BankForm::Packed) {
      EXPECT_EQ(bank.extract(bank.entry(1)), read_bytes(out() / "in/one.mcpr"));
    }
  }
}

TEST_F(BatchRun, LearnsFromTheClipsOfABankAndTellsNothingWhereThatDoesNotPay) {
  Batch asked = batch();
  asked.bank = runtime::BankForm::Packed;
  run(asked);
  const std::vector<std::byte> plain = read_bytes(out() / kBankOfBatch);
  asked.learn = true;
  bool has_begun = false;  // set when the bank reports that no clip is done
  EXPECT_TRUE(run(asked, {.resumed = true}, [&](const BatchProgress& progress) {
                has_begun = has_begun || (progress.bank && progress.bank->done == 0);
                return true;
              }).has_bank);
  EXPECT_TRUE(has_begun);
  EXPECT_EQ(read_bytes(out() / kBankOfBatch), plain);
}

TEST_F(BatchRun, LearnsWhatABankOfItsFilesWouldLearn) {
  for (int i = 0; i < 60; ++i)
    write_motion(folder_ / ("in/walk_" + std::to_string(100 + i) + ".bvh"),
                 test::smooth_motion(60 + i % 9));
  Batch asked = batch();
  asked.presets.front().target.value = 0.1;
  asked.bank = runtime::BankForm::Packed;
  run(asked);
  const std::uint64_t plain = fs::file_size(out() / kBankOfBatch);
  asked.learn = true;
  run(asked, {.resumed = true});
  EXPECT_LT(fs::file_size(out() / kBankOfBatch), plain);
  const BankFile bank(out() / kBankOfBatch);
  for (std::uint32_t clip = 0; clip < bank.clips(); ++clip) {
    const runtime::BankEntry entry = bank.entry(clip);
    EXPECT_EQ(bank.extract(entry), read_bytes(out() / (std::string(entry.name) + ".mcpr")));
  }
}

TEST_F(BatchRun, LeavesWhatFailedOutOfTheBank) {
  write_text(folder_ / "in/broken.bvh", "HIERARCHY");
  Batch asked = batch();
  asked.bank = runtime::BankForm::Packed;
  EXPECT_EQ(run(asked).counts.failed, 1u);
  EXPECT_EQ(BankFile(out() / kBankOfBatch).clips(), 3u);
}

TEST_F(BatchRun, MakesNoBankWhereItMayNotOrCannot) {
  Batch asked = batch();
  asked.bank = runtime::BankForm::Packed;
  EXPECT_THROW(run(asked, {.shard = {1, 2}}), Error);
  Batch without_files = asked;
  without_files.formats = {OutputFormat::Bvh};
  EXPECT_THROW(run(without_files), Error);
  Batch learning = asked;
  learning.learn = true;
  for (const auto& form :
       {std::optional<runtime::BankForm>(), std::optional(runtime::BankForm::Cooked)}) {
    learning.bank = form;
    EXPECT_THROW(run(learning), Error);
  }
  fs::create_directories(out());
  write_text(out() / kBankOfBatch, "somebody's");
  for (const bool resumed : {false, true})
    EXPECT_THROW(run(asked, {.resumed = resumed}), WriteError);
  EXPECT_EQ(read_text(out() / kBankOfBatch), "somebody's");
}

TEST_F(BatchRun, CancelledAtTheBankLeavesNoneAndMakesItWhenResumed) {
  Batch asked = batch();
  asked.bank = runtime::BankForm::Packed;
  const BatchOutcome stopped =
      run(asked, {}, [](const BatchProgress& progress) { return !progress.bank; });
  EXPECT_FALSE(stopped.complete);
  EXPECT_FALSE(fs::exists(out() / kBankOfBatch));
  const BatchOutcome resumed = run(asked, {.resumed = true});
  EXPECT_EQ(resumed.counts.kept, 3u);
  EXPECT_TRUE(resumed.complete && resumed.has_bank);
}

TEST_F(BatchRun, CancelledAtAnyStepAndResumedIsAsIfUndisturbed) {
  run(batch());
  const auto undisturbed = contents(out());
  for (int steps = 0;; steps += 9) {
    fs::remove_all(out());
    int left = steps;
    const auto first = run(batch(), {.jobs = 2}, [&](const BatchProgress&) { return left-- > 0; });
    if (first.complete) break;
    const auto second = run(batch(), {.jobs = 2, .resumed = true});
    EXPECT_TRUE(second.complete);
    EXPECT_EQ(second.counts.kept, first.counts.done);
    ASSERT_EQ(contents(out()), undisturbed) << "stopped after " << steps;
  }
}

TEST_F(BatchRun, ResumedRedoesWhatChangedAndKeepsTheRest) {
  run(batch());
  write_motion(folder_ / "in/one.bvh", test::smooth_motion(120, 9));  // a different motion
  fs::last_write_time(folder_ / "in/two.amc", fs::file_time_type::clock::now());  // the same bytes
  fs::remove(out() / "in/more/three.mcpr");
  const auto resumed = run(batch(), {.resumed = true});
  EXPECT_EQ(resumed.counts.failed, 0u);
  EXPECT_EQ(resumed.counts.kept, 1u);
  EXPECT_TRUE(fs::exists(out() / "in/more/three.mcpr"));
  Batch finer = batch();
  finer.presets[0].target.value = 1;
  EXPECT_EQ(run(finer, {.resumed = true}).counts.kept, 0u);
  for (const BatchRow& row : rows()) EXPECT_LE(row.measured->eps_bone_ends_cm, 1) << row.error;
}

TEST_F(BatchRun, ResumedJudgesFilesByOtherLimitsAndLeavesThemAsTheyAre) {
  Batch asked = batch();
  run(asked);
  const std::vector<BatchRow> before = rows();
  asked.presets[0].limits.distance_m = 40;
  EXPECT_EQ(run(asked, {.resumed = true}).counts.kept, 3u);
  const std::vector<BatchRow> after = rows();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].files, before[i].files);
    EXPECT_EQ(after[i].measured->encode_seconds, before[i].measured->encode_seconds);
    EXPECT_EQ(after[i].measured->seen.limits, asked.presets[0].limits);
    EXPECT_LT(after[i].measured->seen.times_noticed, before[i].measured->seen.times_noticed);
  }
  EXPECT_THAT(read_text(out() / "report.html"), HasSubstr("from 40 m"));
  asked.presets[0].limits.of(Cue::Place).least = 3;
  run(asked, {.resumed = true});
  EXPECT_EQ(rows()[0].measured->seen.limits, asked.presets[0].limits);
  EXPECT_THAT(read_text(out() / "report.html"), HasSubstr("own limits: place 3 cm or 3 %"));
}

TEST_F(BatchRun, ResumedRedoesEveryClipWhenFilesAreReadOrWrittenOtherwise) {
  Batch asked = batch();
  asked.formats.push_back(OutputFormat::Bvh);
  run(asked);
  const auto redone = [&] {
    const BatchOutcome resumed = run(asked, {.resumed = true});
    EXPECT_EQ(resumed.counts.failed, 0u);
    EXPECT_EQ(run(asked, {.resumed = true}).counts.kept, 3u);  // the new stamps are in the journal
    return resumed.counts.kept == 0;
  };
  asked.reading.sample_rate_hz = 60;
  EXPECT_TRUE(redone());
  for (const BatchRow& row : rows()) EXPECT_EQ(row.measured->sample_rate_hz, 60);
  asked.reading.cm_per_unit = 2.54;
  EXPECT_TRUE(redone());
  asked.reading.up = UpAxis::Z;
  EXPECT_TRUE(redone());
  asked.reading.bvh_root = TranslationConvention::Adds;
  EXPECT_TRUE(redone());
  asked.writing.cm_per_unit = 100;
  EXPECT_TRUE(redone());
}

TEST_F(BatchRun, AClipIsReadByItsOwnOptionsWhereItHasAny) {
  Batch asked = batch();
  asked.reading.sample_rate_hz = 60;
  BatchItem item = asked.items[1];
  item.reading = ReadOptions{.sample_rate_hz = 24};
  asked.items.replace(1, item);
  run(asked);
  EXPECT_EQ(rows()[0].measured->sample_rate_hz, 60);
  EXPECT_EQ(rows()[1].measured->sample_rate_hz, 24);
  EXPECT_EQ(run(asked, {.resumed = true}).counts.kept, 3u);
  item.reading->sample_rate_hz = 25;
  asked.items.replace(1, item);
  EXPECT_EQ(run(asked, {.resumed = true}).counts.kept, 2u);
}

TEST_F(BatchRun, LeavesACharacterOffClipsThatItDoesNotFitAndSaysSo) {
  const fs::path samples = fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples";
  if (!fs::exists(samples / "character.glb")) GTEST_SKIP() << "no sample character";
  for (const char* name : {"human.asf", "human_jump.amc"})
    fs::copy_file(samples / name, folder_ / "in" / name);
  Batch asked = batch();
  asked.reading.character = (samples / "character.glb").string();
  EXPECT_EQ(run(asked).counts.done, 4u);
  for (const BatchRow& row : rows()) {
    EXPECT_TRUE(row.done()) << row.error;
    const bool fits = row.input.ends_with("human_jump.amc");
    const bool says_not =
        std::any_of(row.warnings.begin(), row.warnings.end(), [](const std::string& warning) {
          return warning.find("character.glb: is not put on: the clip has no joint") !=
                 std::string::npos;
        });
    EXPECT_NE(fits, says_not) << row.input;
    EXPECT_EQ(fits, row.measured->body.skin.has_value()) << row.input;
  }
}

TEST_F(BatchRun, ShardsMergedAreAsOneRun) {
  run(batch());
  const auto whole = contents(out());
  fs::remove_all(out());
  for (const int index : {2, 1, 3}) run(batch(), {.shard = {index, 3}});
  const MergedBatch merged = merge_batch({out()}, out());
  EXPECT_EQ(merged.clips, 3u);
  EXPECT_EQ(merged.waiting, 0u);
  const auto together = contents(out());
  for (const auto& [name, text] : whole) EXPECT_EQ(together.at(name), text) << name;
}

TEST_F(BatchRun, ShardsOfDifferentBatchesAreNotMerged) {
  run(batch(), {.shard = {1, 2}});
  Batch other = batch();
  other.items.erase(other.items.size() - 1);
  run(other, {.shard = {2, 2}});
  EXPECT_THROW(merge_batch({out()}, out()), InputError);
  fs::remove(out() / "batch-2-of-2.jsonl");
  const MergedBatch merged = merge_batch({out()}, out());
  EXPECT_GT(merged.waiting, 0u);
}

TEST_F(BatchRun, StoppedAfterCurrentFinishesWhatItBegan) {
  BatchControl control;
  const auto outcome =
      run_batch_in(out(), batch(), {.jobs = 1}, control, [&](const BatchProgress& progress) {
        if (!progress.row) control.stop_after_current();
        return true;
      });
  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.counts.done, 1u);
  EXPECT_EQ(outcome.counts.failed, 0u);
}

TEST_F(BatchRun, PausedDoesNothingUntilItMayGoOn) {
  BatchControl control;
  control.pause();
  std::atomic<int> steps = 0;
  BatchOutcome outcome;
  std::thread worker([&] {
    outcome = run_batch_in(out(), batch(), {}, control, [&](const BatchProgress&) {
      ++steps;
      return true;
    });
  });
  EXPECT_TRUE(control.paused());
  EXPECT_EQ(steps, 0);
  control.resume();
  worker.join();
  EXPECT_GT(steps, 0);
  EXPECT_TRUE(outcome.complete);
}

TEST_F(BatchRun, TellsOneAtATimeAndCountsToTheEnd) {
  std::atomic<int> inside = 0;
  std::size_t ended = 0;
  double far = 0;  // bytes
  int begun = 0;
  const BatchOutcome outcome = run(batch(), {.jobs = 2}, [&](const BatchProgress& progress) {
    EXPECT_EQ(++inside, 1);
    ended += progress.row != nullptr;
    EXPECT_EQ(progress.counts.done, ended);
    EXPECT_EQ(progress.counts.clips, 3u);
    EXPECT_GE(progress.clip.fraction, 0);
    EXPECT_LE(progress.clip.fraction, 1);
    const BatchCounts& counts = progress.counts;
    EXPECT_GE(static_cast<double>(counts.bytes_done) + counts.bytes_under_way, far);
    far = static_cast<double>(counts.bytes_done) + counts.bytes_under_way;
    EXPECT_LE(far, static_cast<double>(counts.bytes));
    begun += counts.bytes_under_way > 0;
    --inside;
    return true;
  });
  EXPECT_GT(begun, 3);  // clips count while they are being worked on
  EXPECT_EQ(outcome.counts.bytes_under_way, 0);
  EXPECT_EQ(ended, 3u);
}

TEST_F(BatchRun, LeavesNothingBesideWhatItWrote) {
  write_text(folder_ / "in/broken.bvh", "nonsense");
  run(batch());
  for (const auto& entry : fs::recursive_directory_iterator(out()))
    EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
}

TEST_F(BatchRun, TheReportDrawsTheWorstFramesAndNeedsNothingElse) {
  run(batch());
  const std::string page = read_text(out() / "report.html");
  EXPECT_THAT(page, HasSubstr("<svg"));
  EXPECT_THAT(page, HasSubstr("Worst frames"));
  EXPECT_THAT(page, HasSubstr("in/more/three"));
  EXPECT_THAT(page, Not(HasSubstr("<script src")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_EQ(test::misfit(page), "");
}

TEST_F(BatchRun, PicturesSayWhatTheirCaptionsAndTheBoundSay) {
  run(batch());
  const std::string page = read_text(out() / "report.html");
  for (const BatchRow& row : rows()) {
    const double max_cm = row.measured->max_cm(row.preset.weighting);
    EXPECT_EQ(row.worst->off_cm, max_cm);
    EXPECT_EQ(row.worst->frame, row.measured->worst_frame);
    EXPECT_THAT(page, HasSubstr(">" + format_significant(max_cm) + " cm</text>"));
    EXPECT_THAT(page, HasSubstr("error of " + format_significant(max_cm) + " cm at the "));
  }
}

TEST_F(BatchRun, TheReportDrawsVisibilityByJointAndTime) {
  run(batch());
  const std::string page = read_text(out() / "report.html");
  int seen = 0;
  for (const BatchRow& row : rows()) {
    ASSERT_FALSE(row.sights.empty());
    const Seen& worst = row.measured->seen;
    const bool is_seen = worst.sight() != Sight::NotVisible;
    seen += is_seen;
    EXPECT_EQ(row.sights.size() > 1, is_seen);
    EXPECT_EQ(row.sights[0].sights.find('2') != std::string::npos, worst.sight() == Sight::Visible);
    if (!is_seen) continue;
    EXPECT_THAT(worst.reason, HasSubstr(" of " + row.sights[1].joint + " at frame"));
  }
  EXPECT_GT(seen, 0);
  std::size_t drawn = 0;
  for (auto at = page.find("class=\"sights\""); at != std::string::npos;
       at = page.find("class=\"sights\"", at + 1))
    ++drawn;
  EXPECT_EQ(drawn, static_cast<std::size_t>(seen));
}

TEST_F(BatchRun, EveryReportHasAnglesBesideDistances) {
  run(batch());
  const std::string page = read_text(out() / "report.html");
  EXPECT_THAT(page, HasSubstr("<th>joints</th><th>head</th><th>hands</th>"));
  const std::string table = read_text(out() / "report.csv");
  for (const BatchRow& row : rows()) {
    const BodyFigures& body = row.measured->body;
    EXPECT_GT(body.angle_rms_degrees, 0);
    EXPECT_FALSE(body.head);  // the skeleton has none
    EXPECT_THAT(page, HasSubstr("<td>" + format_significant(body.angle_rms_degrees) +
                                "&#176;</td><td>&#8211;</td><td>" +
                                format_significant(body.hand.value().rms_degrees) + "&#176;</td>"));
    EXPECT_THAT(table, HasSubstr("," + shortest_text(body.angle_rms_degrees) + ","));
  }
}

TEST_F(BatchRun, EveryReportCarriesVerdictsNotesAndWarnings) {
  std::string text = read_text(folder_ / "in/one.bvh");
  write_text(folder_ / "in/one.bvh", text.substr(0, text.rfind('\n', text.size() - 2) + 1));
  Batch asked = batch();
  BatchItem item = asked.items[1];
  item.review = {Verdict::Approved, "a \"good\" <one>"};
  asked.items.replace(1, item);
  run(asked);
  const BatchRow row = rows()[1];
  EXPECT_EQ(row.review, item.review);
  ASSERT_EQ(row.warnings.size(), 1u) << "the clip ends before its last frame";
  EXPECT_THAT(read_text(out() / "report.csv"), HasSubstr(",approved,\"a \"\"good\"\" <one>\","));
  EXPECT_THAT(read_text(out() / "report.json"),
              HasSubstr(R"("verdict":"approved","note":"a \"good\" <one>")"));
  EXPECT_THAT(read_text(out() / "report.html"), HasSubstr("a &quot;good&quot; &lt;one&gt;"));
}

TEST_F(BatchRun, ResumedTellsWhatTheReviewerSaysNow) {
  run(batch());
  Batch asked = batch();
  BatchItem item = asked.items[1];
  item.review = {Verdict::Rejected, "slides"};
  asked.items.replace(1, item);
  EXPECT_EQ(run(asked, {.resumed = true}).counts.kept, 3u);
  EXPECT_EQ(rows()[1].review, item.review);
  EXPECT_THAT(read_text(out() / "report.csv"), HasSubstr(",rejected,slides,"));
}

/// Three clips of 100, 100 and 800 bytes; the first two are done.
BatchCounts at_the_long_one(double share) {
  return {.clips = 3, .done = 2, .bytes = 1000, .bytes_done = 200, .bytes_under_way = 800 * share};
}

TEST(TimeLeft, IsUnsetUntilAClipWasWorkedOnToItsEnd) {
  TimeLeft left;
  left.update({.clips = 3, .bytes = 1000, .bytes_under_way = 50}, 1);
  EXPECT_FALSE(left.seconds());
  left.update(
      {.clips = 3, .done = 1, .kept = 1, .bytes = 1000, .bytes_done = 100, .bytes_kept = 100}, 1);
  EXPECT_FALSE(left.seconds());
  left.update(
      {.clips = 3, .done = 2, .kept = 1, .bytes = 1000, .bytes_done = 200, .bytes_kept = 100}, 2);
  EXPECT_EQ(left.seconds(), 16);
}

TEST(TimeLeft, FallsWithTheProgressOfTheLastLongClip) {
  TimeLeft left;
  left.update(at_the_long_one(0), 2);
  EXPECT_EQ(left.seconds(), 8);
  left.update(at_the_long_one(0.25), 4);
  EXPECT_EQ(left.seconds(), 6);
  left.update(at_the_long_one(0.75), 8);
  EXPECT_EQ(left.seconds(), 2);
}

TEST(TimeLeft, NeverGrowsWhileALongClipSeemsToStandStill) {
  TimeLeft left;
  left.update(at_the_long_one(0.5), 6);
  EXPECT_EQ(left.seconds(), 4);
  left.update(at_the_long_one(0.5), 60);
  EXPECT_EQ(left.seconds(), 4);
}

TEST(TimeLeft, IsToldAnewByEveryClipThatEnds) {
  TimeLeft left;
  left.update({.clips = 3, .done = 1, .bytes = 1000, .bytes_done = 100}, 1);
  EXPECT_EQ(left.seconds(), 9);
  left.update(at_the_long_one(0), 10);
  EXPECT_EQ(left.seconds(), 40);
  left.update({.clips = 3, .done = 3, .bytes = 1000, .bytes_done = 1000}, 50);
  EXPECT_EQ(left.seconds(), 0);
}

}  // namespace
}  // namespace mocapress
