// SPDX-License-Identifier: MIT
#include "core/report/sign_off.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mocapress::test {
namespace {

ClipReview said(Verdict verdict, const char* settings) {
  return {.verdict = verdict,
          .reviewer = "ana",
          .time = "2026-11-28T10:00:00Z",
          .source_hash = "file",
          .settings_hash = settings};
}

SignOff report() {
  SignOff all{.title = "Knights <1>", .stamp = {"Mocapress 1", "2026-11-28T11:00:00Z"}};
  SignOffClip walk{.name = "walk.bvh",
                   .path = "/m/walk.bvh",
                   .sample_rate_hz = 30,
                   .review = said(Verdict::Approved, "now"),
                   .source_hash = "file",
                   .settings_hash = "now"};
  walk.review.notes = {
      {.frame = 15, .joint = "lfoot", .text = "slides, a bit", .settings_hash = "old"}};
  walk.figures = SignOffFigures{.ratio = 25,
                                .bytes = 1200,
                                .eps_cm = 0.2,
                                .max_cm = 1.75,
                                .worst_frame = 60,
                                .worst_point = "rhand",
                                .sight = Sight::Borderline,
                                .limits = {.distance_m = 15}};
  SignOffClip run = walk;
  run.name = "moves.fbx: Run";
  run.path = "/m/moves.fbx";
  run.take = "Run";
  run.review = said(Verdict::Rejected, "old");
  run.figures->max_cm = 3.5;
  SignOffClip idle{.name = "idle.bvh", .path = "/m/idle.bvh", .problem = "is damaged"};
  all.clips = {walk, run, idle};
  return all;
}

TEST(SignOff, CountsOnlyVerdictsThatApply) {
  EXPECT_EQ(count(report()),
            (SignOffCounts{.approved = 1, .rejected = 0, .stale = 1, .waiting = 1}));
  EXPECT_NE(sign_off_html(report()).find("1 of 3 reviewed: 1 approved, 0 rejected; 1 verdicts "
                                         "stale; 1 without a verdict."),
            std::string::npos);
}

TEST(SignOff, PageNamesWorstFramesNotesAndWhatIsStale) {
  for (const ReportMedium medium : {ReportMedium::Screen, ReportMedium::Paper}) {
    const std::string page = sign_off_html(report(), medium);
    EXPECT_NE(page.find("Knights &lt;1&gt;"), page.npos);
    EXPECT_LT(page.find("3.5"), page.find("1.75")) << "the worst frame is first";
    EXPECT_NE(page.find("61, 2.00 s"), page.npos);
    EXPECT_NE(page.find("mocapress://open?clip=/m/walk.bvh&amp;frame=15&amp;joint=lfoot"),
              page.npos);
    EXPECT_NE(page.find("mocapress://open?clip=/m/moves.fbx&amp;take=Run&amp;frame=60"), page.npos);
    EXPECT_NE(page.find("the settings changed"), page.npos);
    EXPECT_NE(page.find("is damaged"), page.npos);
  }
  EXPECT_EQ(sign_off_html(report(), ReportMedium::Paper).find("var("), std::string::npos);
}

TEST(SignOff, LongNamesAndWordsWrapOnAScreen) {
  const std::string page = sign_off_html(report());
  EXPECT_NE(page.find(".signed th[scope=row] { white-space: normal"), page.npos);
  EXPECT_NE(page.find("<section class=\"signed\">"), page.npos);
  EXPECT_NE(page.find("<td class=\"wrap\">ana</td>"), page.npos);
}

TEST(SignOff, PageIsInTheLanguageOfItsReader) {
  SignOff loud = report();
  loud.language = {.code = "fr",
                   .translate = [](const std::string& english) { return "<" + english + ">"; }};
  const std::string page = sign_off_html(loud);
  EXPECT_NE(page.find("<html lang=\"fr\">"), page.npos);
  EXPECT_NE(page.find("&lt;1 of 3 reviewed: 1 approved, 0 rejected&gt;"), page.npos);
  EXPECT_NE(page.find("&lt;the settings changed&gt;"), page.npos);
  EXPECT_NE(page.find("&lt;is damaged&gt;"), page.npos);
  EXPECT_EQ(sign_off_csv(loud), sign_off_csv(report())) << "machines read tables";
}

TEST(SignOff, TableHasARowAClipWithAllFields) {
  const std::string table = sign_off_csv(report());
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
  EXPECT_NE(table.find("\"frame 16, lfoot: slides, a bit (stale: the settings changed)\""),
            table.npos);
  EXPECT_NE(table.find("/m/idle.bvh,,,,,,,,,,,,,,,is damaged,,mocapress://open?clip=/m/idle.bvh,"),
            table.npos);
}

}  // namespace
}  // namespace mocapress::test
