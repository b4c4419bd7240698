// SPDX-License-Identifier: MIT
// Checks the command line's reports with another program.
#include <gmock/gmock.h>

#include <filesystem>

#include "core/base/file.h"
#include "core/batch/queue_json.h"
#include "core/report/review_page.h"
#include "tests/support/svg_frame.h"
#include "tests/system/command.h"
#include "tests/system/sample_clips.h"

namespace mocapress::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class ReportFiles : public CommandLine {
 protected:
  ReportFiles() { write_sample_clips(file("clips"), 3); }

  /// The complaints of libxml2 about a page; empty: it is well-formed.
  static std::string complaints(const std::filesystem::path& page) {
    const Outcome outcome = run_program({"xmllint", "--noout", page.string()});
    return outcome.exit_code == 0 ? outcome.err : "not well-formed: " + outcome.err;
  }

  static bool has_xmllint() {
    return run_program({"sh", "-c", "command -v xmllint > /dev/null"}).exit_code == 0;
  }
};

TEST_F(ReportFiles, BatchReportsAreWellFormedAndPicturesFillTheirFrames) {
  const Outcome outcome = mocapress(
      {"batch", file("clips").string(), "-o", file("out").string(), "--target-error", "0.5"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(misfit(read_text(file("out") / "report.html")), "");
  for (const json& row : json::parse(read_text(file("out") / "report.json")))
    EXPECT_LE(row["eps_x_cm"], 0.5);
  if (!has_xmllint()) GTEST_SKIP() << "needs xmllint";
  EXPECT_EQ(complaints(file("out") / "report.html"), "");
}

TEST_F(ReportFiles, StudyReportsAreWellFormedAndPicturesFillTheirFrames) {
  const Outcome outcome = mocapress({"study", file("clips").string(), "-o", file("out").string(),
                                     "--methods", "standard,per-channel", "--ratios", "10,40"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = read_text(file("out") / "report.html");
  EXPECT_THAT(page, HasSubstr("class=\"scene\""));
  EXPECT_EQ(misfit(page), "");
  for (const json& row : json::parse(read_text(file("out") / "rows.json"))) {
    EXPECT_TRUE(row["footskate_mean_cm"].is_number());
    EXPECT_LE(row["footskate_mean_cm"], row["footskate_worst_cm"]);
    EXPECT_LE(row["footskate_worst_cm"], row["footskate_cm"]);
  }
  if (!has_xmllint()) GTEST_SKIP() << "needs xmllint";
  EXPECT_EQ(complaints(file("out") / "report.html"), "");
}

TEST_F(ReportFiles, ReviewPagesNeedABuildWithTheViewer) {
  const std::filesystem::path page = file("page.html");
  const std::filesystem::path script = file("out") / "clip_100.review.js";
  for (const Outcome& outcome :
       {mocapress({"compress", file("clips") / "clip_100.bvh", "--review", page}),
        mocapress({"batch", file("clips"), "-o", file("out"), "--review"})}) {
    EXPECT_EQ(outcome.exit_code, has_review_viewer() ? 0 : 2) << outcome.err;
    if (!has_review_viewer()) {
      EXPECT_THAT(outcome.err, HasSubstr("built without the viewer of review pages"));
    }
  }
  for (const std::filesystem::path& made : {page, script, file("out") / "report.html"})
    EXPECT_EQ(std::filesystem::exists(made), has_review_viewer()) << made;
  if (has_review_viewer() && has_xmllint()) {
    EXPECT_EQ(complaints(file("out") / "report.html"), "");
  }
}

TEST_F(ReportFiles, QueueReportsHaveItsVerdictsAndNotes) {
  Batch batch{.presets = {{.name = "rough", .target = {Target::Kind::Error, 2}}}};
  add_items(batch, find_sources({file("clips").string()}), 0, kUsualNames);
  BatchItem item = batch.items[1];
  item.review = {Verdict::Approved, "with \"quotes\" & <tags>"};
  batch.items.replace(1, item);
  const std::string queue = write("queue.json", queue_text(batch));
  const Outcome outcome = mocapress({"batch", queue, "-o", file("out").string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json rows = json::parse(read_text(file("out") / "report.json"));
  EXPECT_TRUE(rows[0]["verdict"].is_null());
  EXPECT_EQ(rows[1]["verdict"], "approved");
  EXPECT_EQ(rows[1]["note"], item.review.note);
  EXPECT_THAT(read_text(file("out") / "report.csv"),
              HasSubstr(",approved,\"with \"\"quotes\"\" & <tags>\","));
  if (!has_xmllint()) GTEST_SKIP() << "needs xmllint";
  EXPECT_EQ(complaints(file("out") / "report.html"), "");
}

}  // namespace
}  // namespace mocapress::test
