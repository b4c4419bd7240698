// SPDX-License-Identifier: MIT
#include "core/batch/journal.h"
#include "core/base/utf8_path.h"

#include <gmock/gmock.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "tests/unit/batch/batch_clips.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// A header without the time its run began, which changes every second.
nlohmann::json without_since(const std::string& header) {
  nlohmann::json json = nlohmann::json::parse(header);
  json.at("run").erase("since");
  return json;
}

class JournalTest : public test::BatchTest {
 protected:
  static BatchRow row(const Batch& batch, std::size_t index) {
    BatchRow row;
    row.index = index;
    row.input = batch.items[index].input;
    row.output = batch.items[index].output;
    row.preset = batch.presets[0];
    row.formats = {OutputFormat::Mcpr, OutputFormat::Csv};
    row.reading = {.sample_rate_hz = 59.94, .bvh_root = TranslationConvention::Adds};
    row.writing = {.cm_per_unit = 2.54, .up = UpAxis::Z};
    row.stamp = {123, 456, "abc", "ab"};
    row.joints = 8;
    row.measured = Measurement{.frames = 7,
                               .eps_bone_ends_cm = 0.1,
                               .seen = Seen{0.5, 0, "slide of lfoot at frame 3: 0.5 cm"},
                               .contacts = 2,
                               .footskate_cm = 3,
                               .slide = SlidePerContact{1.5, 2, 0.5, 0.75},
                               .encode_seconds = 2};
    row.files = {{"in/one.mcpr", 12, "0f"}};
    row.warnings = {"a, \"warning\""};
    row.review = {Verdict::Approved, "fine\nas it is"};
    row.worst = WorstPose{.frame = 3,
                          .landmark = "head",
                          .point = 1,
                          .off_cm = 0.251,
                          .ground_cm = -1.5,
                          .facing = Eigen::Vector3d::UnitX(),
                          .bones = {{0, 1, 2.5, 1.25}},
                          .original = {{0, 1, 2}, {3, 4, 5.25}},
                          .decoded = {{0, 1, 2}, {3, 4, 5.5}}};
    row.sights = {{"", "0012"}, {"lfoot", "0002"}};
    return row;
  }

  const fs::path path_ = folder_ / "batch.jsonl";
};

TEST_F(JournalTest, ARowComesBackAsItWas) {
  const BatchRow written = row(batch(), 1);
  const auto read = parse_batch_row(to_journal_line(written));
  ASSERT_TRUE(read);
  EXPECT_EQ(to_journal_line(*read), to_journal_line(written));
  EXPECT_EQ(to_report_line(*read), to_report_line(written));
  EXPECT_EQ(read->preset, written.preset);
  EXPECT_EQ(read->stamp, written.stamp);
  EXPECT_EQ(read->files, written.files);
  EXPECT_EQ(read->measured, written.measured);
  EXPECT_EQ(read->review, written.review);
  EXPECT_EQ(read->worst->decoded[1].z(), 5.5);
  EXPECT_EQ(read->worst->off_cm, 0.251);
  EXPECT_EQ(read->sights, written.sights);
}

TEST_F(JournalTest, IncompleteRowsDoNotCount) {
  const std::string line = to_journal_line(row(batch(), 0));
  for (std::size_t length = 0; length < line.size(); length += 7)
    EXPECT_FALSE(parse_batch_row(line.substr(0, length)));
  EXPECT_FALSE(parse_batch_row("[]"));
}

TEST_F(JournalTest, APoseThatPointsOutsideItsPointsIsNone) {
  BatchRow wrong = row(batch(), 0);
  wrong.worst->bones[0].to = 2;
  EXPECT_FALSE(parse_batch_row(to_journal_line(wrong)));
  wrong = row(batch(), 0);
  wrong.worst->decoded.pop_back();
  EXPECT_FALSE(parse_batch_row(to_journal_line(wrong)));
}

TEST_F(JournalTest, CutOffAtAnyByteKeepsTheWholeRowsAndCanBeAppendedTo) {
  const Batch all = batch();
  {
    Journal journal(path_, all, {}, Journal::Start::New);
    journal.append(row(all, 0));
    journal.append(row(all, 1));
  }
  const std::string whole = read_text(path_);
  const std::size_t first = whole.find('\n', whole.find('\n') + 1) + 1;  // after the first row
  for (const std::size_t size : {whole.size() - 1, whole.size() - 9, first + 1, first}) {
    write_text(path_, whole.substr(0, size));
    {
      Journal journal(path_, all, {}, Journal::Start::Resume);
      EXPECT_TRUE(journal.find(0));
      EXPECT_EQ(journal.find(1).has_value(), size == whole.size() - 1);
      journal.append(row(all, 2));
    }
    EXPECT_EQ(JournalReader(path_).rows(), size == whole.size() - 1 ? 3u : 2u);
  }
}

TEST_F(JournalTest, TheLastRowOfAClipCounts) {
  const Batch all = batch();
  {
    Journal journal(path_, all, {}, Journal::Start::New);
    BatchRow failed = row(all, 0);
    failed.error = "no";
    journal.append(failed);
    journal.append(row(all, 0));
    EXPECT_EQ(JournalReader(path_).rows(), 1u);
  }
  EXPECT_TRUE(Journal(path_, all, {}, Journal::Start::Resume).find(0)->done());
}

TEST_F(JournalTest, ResumedWithOtherClipsDropsWhatIsGoneAndMovesTheRest) {
  Batch all = batch();
  {
    Journal journal(path_, all, {}, Journal::Start::New);
    for (std::size_t i = 0; i < 3; ++i) journal.append(row(all, i));
  }
  all.items.erase(0);
  Journal journal(path_, all, {}, Journal::Start::Resume);
  std::vector<std::size_t> indices;
  JournalReader reader(path_);
  reader.for_each([&](const BatchRow& one) { indices.push_back(one.index); });
  EXPECT_EQ(indices, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(reader.header().clips, 2u);
}

TEST_F(JournalTest, ARunningBatchKeepsOthersOut) {
  const Batch all = batch();
  const Journal journal(path_, all, {}, Journal::Start::New);
  EXPECT_THROW(Journal(path_, all, {}, Journal::Start::Resume), WriteError);
  EXPECT_THROW(Journal(path_, all, {}, Journal::Start::Anew), WriteError);
}

TEST_F(JournalTest, RowsThatCannotBeReadAnyMoreAreAnErrorAndNotFewerRows) {
  const Batch all = batch();
  {
    Journal journal(path_, all, {}, Journal::Start::New);
    journal.append(row(all, 0));
    journal.append(row(all, 1));
  }
  const JournalReader reader(path_);
  std::vector<std::size_t> visited;
  const auto visit = [&](const BatchRow& one) { visited.push_back(one.index); };
  const std::string whole = read_text(path_);
  fs::resize_file(path_, whole.size() - 10);
  EXPECT_THROW(reader.for_each(visit), InputError);
  EXPECT_EQ(visited, std::vector<std::size_t>{0});
  std::ofstream(path_) << std::string(whole.size(), 'x');
  EXPECT_THROW(reader.for_each(visit), InputError);
}

#ifndef _WIN32  // has no file that opens and cannot be read
TEST_F(JournalTest, AReadErrorIsNotTheEnd) {
  try {
    JournalReader reader("/proc/self/mem");  // opens, but its first page cannot be read
    ADD_FAILURE() << "read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr(std::string("cannot be read: ") + std::strerror(EIO)));
  }
}
#endif

TEST_F(JournalTest, ResumedForgetsNoClipOfAFolderThatCannotBeListed) {
  const Batch all = batch();
  {
    Journal journal(path_, all, {}, Journal::Start::New);
    journal.append(row(all, 0));
  }
  const std::string folder = utf8(utf8_path(all.items[0].input).parent_path());
  for (const std::string& spelt : {folder, folder + "/"}) {
    Batch unlisted;
    unlisted.presets = all.presets;
    unlisted.items = {{.input = spelt, .output = "in", .problem = "no"}};
    EXPECT_THROW(Journal(path_, unlisted, {}, Journal::Start::Resume), InputError) << spelt;
    std::size_t rows = 0;
    JournalReader(path_).for_each([&](const BatchRow&) { ++rows; });
    EXPECT_EQ(rows, 1u);
  }
}

TEST_F(JournalTest, ResumedNeverReplacesAFileThatIsNoJournal) {
  const Batch all = batch();
  const std::string foreign = "one line\nand another\n";
  write_text(path_, foreign);
  EXPECT_THROW(Journal(path_, all, {}, Journal::Start::Resume), InputError);
  EXPECT_EQ(read_text(path_), foreign);
}

TEST_F(JournalTest, ResumedWithinTheHeaderBeginsAnew) {
  const Batch all = batch();
  { const Journal journal(path_, all, {}, Journal::Start::New); }
  const std::string header = read_text(path_);
  for (const std::size_t size : {std::size_t{1}, header.size() / 2, header.size() - 1}) {
    write_text(path_, header.substr(0, size));
    { const Journal journal(path_, all, {}, Journal::Start::Resume); }
    EXPECT_EQ(without_since(read_text(path_)), without_since(header));
  }
}

TEST_F(JournalTest, ReadersRefuseAFileWithoutAHeader) {
  write_text(path_, "hello\n");
  EXPECT_THROW(JournalReader reader(path_), InputError);
  EXPECT_THROW(JournalReader reader(folder_ / "none"), InputError);
}

}  // namespace
}  // namespace mocapress
