// SPDX-License-Identifier: GPL-3.0-or-later
// Models of the study window: displayed values and settings.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <map>
#include <set>
#include <tuple>

#include "core/codec/methods/compression_method.h"
#include "tests/unit/study/study_rows.h"
#include "widgets/models/colours.h"
#include "widgets/models/number_text.h"
#include "widgets/models/rate_curves.h"
#include "widgets/models/study_rows_model.h"
#include "widgets/models/study_settings.h"
#include "widgets/panels/number_fields.h"

namespace mocapress {
namespace {

using Numbers = std::vector<double>;

TEST(NumberList, ReadsWhatItWritesInEveryNotation) {
  const Numbers numbers = {0.1, 0.26, 7, 1500};
  for (const char* name : {"C", "en_US", "de_DE", "fr_FR"}) {
    const QLocale locale((QLatin1String(name)));
    EXPECT_EQ(parseNumbers(numbersText(numbers, locale), locale), numbers) << name;
  }
}

TEST(NumberList, TakesTheSeparatorsPeopleType) {
  EXPECT_EQ(parseNumbers(QStringLiteral(" 7,10; 15  20,"), QLocale::c()), (Numbers{7, 10, 15, 20}));
  EXPECT_EQ(parseNumbers(QStringLiteral("0,5; 1"), QLocale(QLocale::German)), (Numbers{0.5, 1}));
  EXPECT_EQ(parseNumbers(QStringLiteral("7 7 10 7"), QLocale::c()), (Numbers{7, 10}));
  EXPECT_EQ(parseNumbers(QString(), QLocale::c()), Numbers());
}

TEST(NumberList, RefusesWhatIsNoPositiveNumber) {
  for (const char* text : {"7 ten", "0", "-3", "1e999", "nan", "7:1"})
    EXPECT_FALSE(parseNumbers(QLatin1String(text), QLocale::c())) << text;
}

TEST(NumberListEdit, TellsOfNumbersAndKeepsThemWhileATypoStands) {
  NumberListEdit edit;
  edit.setLocale(QLocale::c());
  edit.setNumbers({7, 10});
  QSignalSpy changed(&edit, &NumberListEdit::numbersChanged);
  QTest::keyClicks(&edit, QStringLiteral(" 20"));
  EXPECT_EQ(edit.numbers(), (Numbers{7, 10, 20}));
  const auto told = changed.count();
  QTest::keyClicks(&edit, QStringLiteral(" x"));
  EXPECT_EQ(changed.count(), told);
  emit edit.editingFinished();
  EXPECT_EQ(edit.text(), QStringLiteral("7 10 20"));
}

TEST(StudySettings, BecomeAPlanOfEveryClipAtEveryTarget) {
  StudySettings settings = usualStudySettings();
  settings.clips = {QStringLiteral("one.bvh"), QStringLiteral("two.amc")};
  settings.ratios = {10, 20};
  settings.errors = {0.5};
  settings.ik_ratio = 16;
  settings.weighting = Weighting::JointOrigins;
  const StudyPlan plan = planOf(settings);
  ASSERT_EQ(plan.clips.size(), 2u);
  EXPECT_EQ(plan.clips[1].path, "two.amc");
  EXPECT_EQ(plan.clips[1].targets,
            (std::vector<Target>{
                {Target::Kind::Ratio, 10}, {Target::Kind::Ratio, 20}, {Target::Kind::Error, 0.5}}));
  EXPECT_EQ(plan.settings.weighting, Weighting::JointOrigins);
  EXPECT_EQ(plan.ik_ratios, Numbers{16});
  EXPECT_EQ(jobs_of(plan).size(),
            2 * (settings.methods.size() * 3 + 2u));  // feet are held only for ratios
}

TEST(StudySettings, UsualOnesNameMethodsAndUsualTargets) {
  const StudySettings settings = usualStudySettings();
  for (const QString& method : settings.methods)
    EXPECT_TRUE(find_compression_method(method.toStdString())) << method.toStdString();
  EXPECT_EQ(settings.ratios.size() + settings.errors.size(), usual_targets().size());
}

TEST(SeriesStyle, TellsAllMethodsApart) {
  std::map<std::tuple<QRgb, int, bool, bool>, std::string_view> seen;
  for (const CompressionMethod& compression_method : compression_methods()) {
    const SeriesStyle style = seriesStyle(compression_method.name, false);
    const std::tuple key(style.colour.rgb(), style.shape, style.dashed, style.hollow);
    EXPECT_TRUE(seen.emplace(key, compression_method.name).second)
        << compression_method.name << " as " << seen[key];
  }
  EXPECT_TRUE(seriesStyle("annealed", true).hollow);
}

TEST(SeriesStyle, GivesTheUsualMethodsOfAStudyColoursOfTheirOwn) {
  std::set<QRgb> seen;
  for (const QString& method : usualStudySettings().methods)
    EXPECT_TRUE(seen.insert(seriesStyle(method.toStdString(), false).colour.rgb()).second)
        << method.toStdString();
}

Target ratio(double value) {
  return {Target::Kind::Ratio, value};
}

std::vector<StudyRow> twoClips() {
  return {test::point("a.bvh", "standard", ratio(10), 10, 0.2),
          test::point("a.bvh", "standard", ratio(20), 20, 0.8),
          test::point("a.bvh", "annealed", ratio(10), 10, 0.1),
          test::point("a.bvh", "annealed", ratio(20), 20, 0.4),
          test::point("b.bvh", "standard", ratio(10), 40, 0.2),
          test::point("b.bvh", "standard", ratio(20), 80, 0.8)};
}

TEST(RateCurves, AClipHasItsRowsInTheOrderOfTheMethods) {
  const auto curves = rateCurves(twoClips(), "a.bvh", {});
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].series.method, "annealed");
  EXPECT_EQ(curves[1].series.method, "standard");
  ASSERT_EQ(curves[1].line.size(), 2u);
  EXPECT_EQ(curves[1].line[1].ratio, 20);
  EXPECT_EQ(curves[1].line[1].eps_cm, 0.8);
  ASSERT_EQ(curves[0].points.size(), 2u);
  EXPECT_EQ(curves[0].points[0].row, 2);
  EXPECT_EQ(curves[0].points[1].row, 3);
}

TEST(RateCurves, AverageIsTheGeometricMeanOverCompleteClipsBeforeThePointsOfAll) {
  const auto one = rateCurves(twoClips(), "", {"a.bvh"});
  ASSERT_EQ(one.size(), 2u);
  EXPECT_NEAR(one[1].line.front().ratio, 10, 1e-9);
  EXPECT_EQ(one[1].points.size(), 4u);
  const auto both = rateCurves(twoClips(), "", {"a.bvh", "b.bvh"});
  EXPECT_NEAR(both[1].line.front().ratio, 20, 1e-9);  // the mean of 10 and 40
  EXPECT_NEAR(both[1].line.back().ratio, 40, 1e-9);
  EXPECT_TRUE(both[0].line.empty()) << "not every clip has it";
  EXPECT_EQ(both[0].points.size(), 2u);
}

TEST(RateCurves, LeaveOutRowsThatWereNotMeasured) {
  std::vector<StudyRow> rows = twoClips();
  rows[2].measured.reset();
  const auto curves = rateCurves(rows, "a.bvh", {});
  EXPECT_EQ(curves[0].points.size(), 1u);
  EXPECT_TRUE(rateCurves({}, "", {}).empty());
}

TEST(StudyRowsModel, GrowsAndSaysWhatARowIs) {
  StudyRowsModel model;
  const QAbstractItemModelTester tester(&model);
  model.append(twoClips());
  StudyRow failed = test::point("c.bvh", "pca", ratio(99), 1, 1);
  failed.measured.reset();
  failed.error = "out of reach";
  model.append({failed});
  ASSERT_EQ(model.rowCount(), 7);
  const auto text = [&](int row, int column) {
    return model.data(model.index(row, column), Qt::DisplayRole).toString();
  };
  EXPECT_EQ(text(0, StudyRowsModel::Clip), QStringLiteral("a"));
  EXPECT_EQ(text(0, StudyRowsModel::Method), QStringLiteral("Standard wavelets"));
  EXPECT_EQ(text(0, StudyRowsModel::Asked), QStringLiteral("10:1"));
  EXPECT_EQ(text(6, StudyRowsModel::Ratio), QStringLiteral("–"));
  EXPECT_TRUE(model.description(6).contains(QStringLiteral("out of reach")));
  EXPECT_TRUE(model.description(0).contains(QLocale().toString(0.2, 'f', 3)));
  EXPECT_GT(model.data(model.index(6, StudyRowsModel::Ratio), StudyRowsModel::SortRole).toDouble(),
            model.data(model.index(5, StudyRowsModel::Ratio), StudyRowsModel::SortRole).toDouble());
  model.clear();
  EXPECT_EQ(model.rowCount(), 0);
}

}  // namespace
}  // namespace mocapress
