// SPDX-License-Identifier: MIT
#include "core/study/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "core/report/markup.h"
#include "core/report/review_page.h"
#include "core/report/scene_svg.h"
#include "core/study/report_tables.h"
#include "core/study/take_picture.h"
#include "tests/support/svg_frame.h"
#include "tests/support/test_motion.h"
#include "tests/unit/study/study_rows.h"

namespace mocapress {
namespace {

using test::point;
using testing::HasSubstr;
using testing::Not;

/// The first mistake in the nesting of tags; empty: none.
std::string imbalance(const std::string& html) {
  static const std::regex kTag("<(/?)([a-zA-Z][a-zA-Z0-9]*)([^<>]*)>");
  std::vector<std::string> open;
  for (std::sregex_iterator tag(html.begin(), html.end(), kTag), end; tag != end; ++tag) {
    const std::string name = (*tag)[2];
    if ((*tag)[3].str().ends_with('/')) continue;
    if ((*tag)[1].length() == 0)
      open.push_back(name);
    else if (open.empty() || open.back() != name)
      return "</" + name + "> closes <" + (open.empty() ? "nothing" : open.back()) + ">";
    else
      open.pop_back();
  }
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

/// Rows of two clips, one of them the paper's, by two methods with known sizes.
std::vector<StudyRow> known_rows() {
  std::vector<StudyRow> rows;
  for (const double ratio : {10.0, 40.0}) {
    const Target target{Target::Kind::Ratio, ratio};
    rows.push_back(point("a/09_01.amc", "annealed", target, ratio, ratio / 50));
    rows.push_back(point("a/09_01.amc", "standard", target, ratio, ratio / 25));
    rows.push_back(point("b/run & <jump>.bvh", "annealed", target, ratio, ratio / 200));
    rows.push_back(point("b/run & <jump>.bvh", "standard", target, ratio, ratio / 100));
  }
  for (StudyRow& row : rows)
    if (row.clip.starts_with("a/")) row.measured->frames = 148, row.measured->raw_bytes = 36704;
  return rows;
}

TEST(Results, FindsThePapersClipByNameAndLength) {
  const Results results(known_rows());
  ASSERT_EQ(results.clips().size(), 2u);
  ASSERT_NE(results.clips()[0].published, nullptr);
  EXPECT_EQ(results.clips()[0].published->title, "Running");
  EXPECT_EQ(results.clips()[1].published, nullptr);
  auto rows = known_rows();
  for (StudyRow& row : rows) row.measured->frames = 149;
  EXPECT_EQ(Results(rows).clips()[0].published, nullptr);
}

TEST(Results, ReadsASizeFromTheCurveUnlessItWasMeasured) {
  auto rows = known_rows();
  const auto at = [&](double eps_cm) {
    const Results results(rows);
    return *results.size_at(results.clips()[0], *results.find_series("annealed"), eps_cm);
  };
  EXPECT_NEAR(at(0.4).ratio, 20, 1e-9);
  EXPECT_FALSE(at(0.4).measured);
  rows.push_back(point("a/09_01.amc", "annealed", {Target::Kind::Error, 0.4}, 21, 0.39));
  EXPECT_EQ(at(0.4).ratio, 21);
  EXPECT_TRUE(at(0.4).measured);
}

TEST(Results, MeanRatioIsGeometricAndSaysOfHowManyClips) {
  const Results results(known_rows());
  const Series& annealed = *results.find_series("annealed");
  // 0.2 cm lies at 10:1 for the first clip and at 40:1 for the second.
  const auto both = results.mean_ratio_at(annealed, 0.2);
  ASSERT_TRUE(both);
  EXPECT_NEAR(both->ratio, 20, 1e-9);
  EXPECT_EQ(both->clips, 2);
  EXPECT_EQ(results.mean_ratio_at(annealed, 0.1)->clips, 1);
  EXPECT_FALSE(results.mean_ratio_at(annealed, 5));
}

TEST(Results, ClipsOfOneNameGoByTheirPaths) {
  const Results results(
      {point("a/walk.bvh", "annealed", {}, 10, 1), point("b/walk.bvh", "annealed", {}, 10, 1)});
  EXPECT_EQ(results.clips()[0].title, "a/walk.bvh");
  EXPECT_EQ(results.clips()[1].title, "b/walk.bvh");
}

TEST(Results, IkMakesASeriesOfItsOwn) {
  auto rows = known_rows();
  StudyRow with_ik = rows[4];  // at 40:1, nearest to the ratio of the table
  with_ik.settings.correction = CorrectionSettings{.ratio = 16};
  rows.push_back(with_ik);
  const Results results(rows);
  ASSERT_EQ(results.series().size(), 3u);
  EXPECT_THAT(results.series()[2].title, HasSubstr("IK 16:1"));
  EXPECT_THAT(footskate_table({}, results), HasSubstr("IK 16:1"));
}

TEST(ReportTables, SetFeetHeldAgainstTheSameSizeWithout) {
  auto rows = known_rows();
  StudyRow without = point("a/09_01.amc", "annealed", {Target::Kind::Ratio, 50}, 50, 0.8);
  without.measured->contacts = 3;
  without.measured->footskate_cm = 10;
  StudyRow with = point("a/09_01.amc", "annealed", {Target::Kind::Ratio, 50}, 50, 0.9);
  with.measured->contacts = 3;
  with.measured->footskate_cm = 1;
  with.measured->knee_speed_ratio = 1.05;
  with.settings.correction = CorrectionSettings{.ratio = 16};
  EXPECT_EQ(held_feet_table({}, Results(rows)), "");
  rows.push_back(without);
  rows.push_back(with);
  const std::string table = held_feet_table({}, Results(rows));
  EXPECT_THAT(table, HasSubstr("-90 %"));
  EXPECT_THAT(table, HasSubstr("1.05 x"));
}

TEST(ReportTables, TellOfSlidingAContactBesideTheTotal) {
  auto rows = known_rows();
  for (StudyRow& row : rows) {
    row.measured->contacts = 4;
    row.measured->footskate_cm = 10;
    row.measured->slide = {2.5, 7.25};
  }
  const std::string table = footskate_table({}, Results(rows));
  EXPECT_THAT(table, HasSubstr("10.0 cm<small> (2.50, 7.25; drift 0.00)</small>"));
}

TEST(ReportTables, TellByHowManyDegreesJointsHeadAndHandsAreTurned) {
  auto rows = known_rows();
  for (StudyRow& row : rows) {
    row.measured->body.angle_rms_degrees = row.settings.target.value / 10;
    row.measured->body.hand = PartTurn{7.25, 9};
  }
  const std::string table = angle_table({}, Results(rows));
  EXPECT_THAT(
      table,
      HasSubstr("Measured at 40:1"));  // 10 and 40 were measured; 40 is nearer to the paper's 30
  EXPECT_THAT(table, HasSubstr("<td>4.00&#176;<small> (&#8211;, 7.25&#176;)</small></td>"));
  EXPECT_THAT(report_html(Results(rows), {}), HasSubstr(table));
}

TEST(ReportTables, CarryVerdictsAndNotesWhereThereAreAny) {
  auto rows = known_rows();
  EXPECT_THAT(clip_table({}, Results(rows)), Not(HasSubstr("verdict")));
  for (StudyRow& row : rows)
    if (row.clip.starts_with("b/")) row.review = {Verdict::Rejected, "the left <foot>"};
  const std::string table = clip_table({}, Results(rows));
  EXPECT_THAT(table, HasSubstr(">rejected</td>"));
  EXPECT_THAT(table, HasSubstr("the left &lt;foot&gt;"));
}

TEST(ReportTables, PutThePapersFiguresBesideTheMeasuredOnes) {
  const std::string sizes = size_table({}, Results(known_rows()));
  EXPECT_THAT(sizes, HasSubstr("Running (09_01)"));
  EXPECT_THAT(sizes, HasSubstr("1.24 (29:1)"));  // the paper's, at 0.58 cm
  // 0.58 cm lies at 29:1 of the known curve: 35.8 KB / 29.
  EXPECT_THAT(sizes, HasSubstr("&#8776; 1.24 (29.0:1)"));
}

TEST(ReportTables, TimeIsAFrameAndBesideThePapers) {
  auto rows = known_rows();
  rows[0].settings.target.value = 30;
  rows[0].measured->iterations = 321;
  rows[0].measured->encode_seconds = 0.148;
  const std::string times = time_table({}, Results(rows));
  EXPECT_THAT(times, HasSubstr("<td>1.00</td><td>321</td>"));
  EXPECT_THAT(times, HasSubstr("254"));
  EXPECT_THAT(times, HasSubstr("496"));
}

TEST(ReportTables, AreEmptyWithoutAnythingToShow) {
  const Results nothing(
      {StudyRow{.clip = "x.bvh", .settings = {.method = "pca"}, .error = "not there"}});
  for (const auto& table :
       {mean_size_table({}, nothing), size_table({}, nothing), time_table({}, nothing),
        footskate_table({}, nothing), clip_table({}, nothing), angle_table({}, nothing)})
    EXPECT_EQ(table, "");
  EXPECT_THAT(failure_table({}, nothing), HasSubstr("not there"));
}

TEST(Report, IsWellFormedAndNeedsNothingElse) {
  auto rows = known_rows();
  rows.push_back(
      {.clip = "c.bvh", .settings = {.method = "annealed"}, .error = "c.bvh: <broken> & gone"});
  const std::string html = report_html(Results(rows), {});
  EXPECT_EQ(imbalance(html), "");
  EXPECT_EQ(test::misfit(html), "");
  for (const char* elsewhere : {"http:", "https:", "//", "url(", "src=", "href=", "@import"})
    EXPECT_THAT(html, Not(HasSubstr(elsewhere)));
  EXPECT_THAT(html, HasSubstr("run &amp; &lt;jump&gt;"));
  EXPECT_THAT(html, HasSubstr("&lt;broken&gt; &amp; gone"));
  for (const char* bad : {">nan", ">inf", "\"nan", " nan", "Lnan", "Mnan"})
    EXPECT_THAT(html, Not(HasSubstr(bad)));
}

TEST(Report, LeadsWithTheMethodThatShipsAndRecommendsWithPresets) {
  std::vector<StudyRow> rows = known_rows();
  for (const double ratio : {30.0, 120.0})
    for (const char* clip : {"a/09_01.amc", "b/run & <jump>.bvh"})
      rows.push_back(point(clip, "closed-loop", {Target::Kind::Ratio, ratio}, ratio, ratio / 150));
  rows.push_back(point("b/run & <jump>.bvh", "annealed", {Target::Kind::Ratio, 120}, 120, 0.6));
  for (StudyRow& row : rows) {
    row.settings.weighting = Weighting::Surface;
    if (row.clip.starts_with("a/")) row.measured->frames = 148;
    row.measured->body.surface.rms = row.measured->eps_bone_ends_cm;
  }
  const std::string html = report_html(Results(rows), {});
  EXPECT_EQ(imbalance(html), "");
  EXPECT_THAT(html, HasSubstr("</b><span>Closed-loop wavelets at "));
  EXPECT_THAT(html, HasSubstr("1.50&#215;</b><span>smaller than Annealed wavelets at equal error"));
  EXPECT_THAT(html, HasSubstr("Use <b>Closed-loop wavelets</b>"));
  EXPECT_LT(html.find("Recommended method"), html.find("Error against compression ratio"));
  EXPECT_THAT(html, HasSubstr(">Gameplay<"));
}

TEST(Report, RecommendsNoMethodWhereTheLeadingOneWasNotMeasured) {
  std::vector<StudyRow> rows;
  for (const double ratio : {20.0, 100.0}) {
    rows.push_back(point("a.bvh", "standard", {Target::Kind::Ratio, ratio}, ratio, ratio / 60));
    rows.push_back(point("a.bvh", "closed-loop", {Target::Kind::Ratio, ratio}, ratio, ratio / 500));
  }
  const std::string html = report_html(Results(rows), {});
  EXPECT_THAT(html, HasSubstr("Use <b>Closed-loop wavelets</b>"));
}

TEST(Report, FailuresAloneMakeAPage) {
  const std::string html = report_html(
      Results({{.clip = "c.bvh", .settings = {.method = "annealed"}, .error = "gone"}}), {});
  EXPECT_EQ(imbalance(html), "");
  EXPECT_THAT(html, HasSubstr("gone"));
}

TEST(Report, ShowsTheWorstFrameOfTheFirstMethod) {
  const std::filesystem::path clip = MOCAPRESS_SOURCE_DIR "/resources/samples/human_walk.amc";
  const StudyPlan plan{.clips = {{clip, {}}}};
  const auto picture = take_picture(plan, clip, {"standard", "annealed"}, 20);
  ASSERT_TRUE(picture);
  ASSERT_EQ(picture->methods.size(), 2u);
  EXPECT_EQ(picture->worst.decoded.size(), 2u);
  const auto off = [](const PosePoints& a, const PosePoints& b) {
    double sum = 0;
    for (std::size_t p = 0; p < a.size(); ++p) sum += (a[p] - b[p]).squaredNorm();
    return sum;
  };
  for (const PicturedFrame& frame : picture->sequence)
    EXPECT_GE(off(picture->worst.original, picture->worst.decoded[0]),
              off(frame.original, frame.decoded[0]));
  const std::string html = report_html(Results(known_rows()), {*picture});
  EXPECT_EQ(imbalance(html), "");
  EXPECT_EQ(test::misfit(html), "");
  EXPECT_THAT(html, Not(HasSubstr("nan ")));
  EXPECT_THAT(html, HasSubstr("frame " + std::to_string(picture->worst.frame + 1) + ","));
  EXPECT_FALSE(picture->methods[1].sights.empty());
  EXPECT_THAT(html, HasSubstr("Annealed wavelets: visible errors over time"));
}

TEST(Report, ShowsAPicturedClipInTheViewerWhereThePageHasIt) {
  const std::filesystem::path clip = MOCAPRESS_SOURCE_DIR "/resources/samples/human_walk.amc";
  auto picture = take_picture({.clips = {{clip, {}}}}, clip, {"standard"}, 20);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->methods[0].review.empty(), !has_review_viewer());
  const std::string name = review_name(*picture, "standard");
  picture->methods[0].review = "mocapressReview(\"" + name + "\", \"Zm9v\", \"Zg==\");";
  constexpr std::byte kViewer[] = {std::byte{'f'}, std::byte{'o'}, std::byte{'o'}};
  const std::string with = report_html(Results(known_rows()), {*picture}, {}, kViewer);
  EXPECT_EQ(test::misfit(with), "");
  const auto viewer = with.find("<script id=\"viewer\" type=\"text/plain\">Zm9v</script>");
  const auto script = with.find(picture->methods[0].review);
  const auto button = with.find("addReviewButton(\"" + name + "\", [");
  EXPECT_LT(viewer, script);
  EXPECT_LT(script, button);
  EXPECT_NE(button, std::string::npos);
  picture->methods[0].review = "";
  EXPECT_THAT(report_html(Results(known_rows()), {*picture}, {}, kViewer),
              Not(HasSubstr("id=\"viewer\"")));
}

TEST(Scene, AFigureAtTheCentreIsDrawnInTheMiddleOfTheSheet) {
  Picture picture;
  picture.bones = {{0, 1, 1, 1}};
  SceneSvg scene(
      picture,
      {.centre = {100, 90, -50}, .facing = Eigen::Vector3d::UnitZ(), .width = 400, .height = 300});
  scene.add_trail({}, "trail");  // nothing to draw
  scene.add_gap({100, 90, -50}, {100, 90, -50}, "here");
  EXPECT_THAT(scene.finish("x"), HasSubstr("M200.0 150.0L200.0 150.0"));
}

TEST(FigureShape, TapersAndGivesTheTrunkMoreThanALimb) {
  const Skeleton skeleton = test::small_skeleton();
  const auto bones = figure_shape(skeleton);
  ASSERT_FALSE(bones.empty());
  const int points = static_cast<int>(landmarks(skeleton).size());
  for (const DrawnBone& bone : bones) {
    EXPECT_GT(bone.to_radius, 0);
    EXPECT_LE(bone.to_radius, bone.from_radius);
    EXPECT_LT(bone.to, points);
  }
  const auto thicker = [](const DrawnBone& a, const DrawnBone& b) {
    return a.from_radius < b.from_radius;
  };
  EXPECT_EQ(std::max_element(bones.begin(), bones.end(), thicker)->from, 0);
}

TEST(Markup, EscapesAndRounds) {
  EXPECT_EQ(escaped("a<b>&\"c"), "a&lt;b&gt;&amp;&quot;c");
  EXPECT_EQ(escaped("a\x1b\n\tb\xc3\xa9"), "a?\n\tb\xc3\xa9");
  EXPECT_EQ(format_significant(0.0512), "0.051");
  EXPECT_EQ(format_significant(3.421), "3.42");
  EXPECT_EQ(format_significant(128.4), "128");
  EXPECT_EQ(format_significant(1234), "1234");
  EXPECT_EQ(format_shortest(0.26), "0.26");
  EXPECT_EQ(format_shortest(30), "30");
}

}  // namespace
}  // namespace mocapress
