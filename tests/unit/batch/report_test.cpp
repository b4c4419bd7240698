// SPDX-License-Identifier: MIT
#include "core/batch/report.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <sstream>

#include "core/base/utf8_path.h"
#include "core/report/clip_link.h"

namespace mocapress::batch_report_test {
namespace {

using testing::HasSubstr;
using testing::Not;

BatchRow noted_row() {
  BatchRow row;
  row.output = "walk";
  row.preset.name = "Mine";
  row.stamp.source = "aa";
  row.measured = Measurement{};
  row.review = {.verdict = Verdict::Rejected,
                .source_hash = "aa",
                .settings_hash = settings_hash(row.preset, row.reading),
                .notes = {{12, {}, "lfoot", "slides <here>", "ana", "2026-11-27T10:00:00Z"},
                          {40, {}, "", "pops", "", ""}}};
  return row;
}

std::string page_of(const BatchRow& row) {
  std::ostringstream out;
  write_batch_html(out, [&](const auto& visit) { visit(row); }, 0, {}, {});
  return out.str();
}

TEST(BatchReport, ListsNotesOnFramesWithWhoAndWhen) {
  const std::string page = page_of(noted_row());
  EXPECT_THAT(page, HasSubstr("<h2>Notes</h2>"));
  EXPECT_THAT(page, HasSubstr("slides &lt;here&gt;"));
  EXPECT_THAT(page, HasSubstr("2026-11-27T10:00:00Z"));
  EXPECT_THAT(page_of({.output = "walk"}), Not(HasSubstr("<h2>Notes</h2>")));
}

TEST(BatchReport, CountsWhatIsReviewed) {
  EXPECT_THAT(page_of(noted_row()), HasSubstr("1 of 1"));
  EXPECT_THAT(page_of(noted_row()), HasSubstr("0 approved, 1 rejected"));
  BatchRow stale = noted_row();
  stale.review.source_hash = "bb";
  EXPECT_THAT(page_of(stale), Not(HasSubstr("1 of 1")));
}

TEST(BatchReport, AFigureIsRedWhereClipsAreWrong) {
  BatchRow row = noted_row();
  EXPECT_THAT(page_of(row), HasSubstr("<div class=\"tile wrong\"><b>1 of 1</b>"));
  row.review.verdict = Verdict::Approved;
  EXPECT_THAT(page_of(row), Not(HasSubstr("class=\"tile wrong\"")));
  row.measured.reset();
  row.error = "cannot be read";
  EXPECT_THAT(page_of(row), HasSubstr("<div class=\"tile wrong\"><b>1</b><span>failed"));
}

TEST(BatchReport, NotesAreOneFieldOfItsTable) {
  EXPECT_THAT(csv_head(), HasSubstr(",notes,"));
  EXPECT_THAT(to_csv_line(noted_row()),
              HasSubstr("\"frame 13, lfoot: slides <here> (ana, 2026-11-27); frame 41: pops\""));
}

TEST(BatchReport, NotesAreStaleAndLinked) {
  BatchRow row = noted_row();
  row.input = utf8(std::filesystem::absolute("/motion/walk.bvh"));  // on Windows with a drive
  row.review.notes.front().settings_hash = "other";
  const std::string page = page_of(row);
  EXPECT_THAT(page, HasSubstr("the settings changed"));
  EXPECT_THAT(page, HasSubstr(link_text({.clip = row.input}) + "&amp;frame=12&amp;joint=lfoot"));
  EXPECT_THAT(to_csv_line(row), HasSubstr("ana, 2026-11-27; stale: the settings changed)"));
  EXPECT_THAT(to_report_line(row), HasSubstr("\"stale\":\"the settings changed\""));
}

TEST(BatchReport, NotesComeBackFromTheJournal) {
  const auto back = parse_batch_row(to_journal_line(noted_row()));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->review, noted_row().review);
}

}  // namespace
}  // namespace mocapress::batch_report_test
