// SPDX-License-Identifier: GPL-3.0-or-later
// A study's row that is loaded into the studio gives the study's figures.
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>

#include "app/studio/compare/figures.h"
#include "app/studio/document/session.h"
#include "core/formats/motion_file.h"
#include "core/study/run.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

class StudyRowLoading : public testing::Test {
 protected:
  StudyRowLoading() {
    for (const char* name : {"one.bvh", "two.bvh"})
      write_motion(path(name).toStdU16String(), test::smooth_motion(200, name[0]));
  }

  QString path(const char* name) const { return directory_.filePath(QString::fromLatin1(name)); }

  StudyRow rowOf(const char* clip, const char* method,
                 const Target& target = {Target::Kind::Ratio, 8}) const {
    StudyPlan plan;
    plan.clips = {{path(clip).toStdU16String(), {target}}};
    plan.methods = {method};
    plan.settings.weighting = Weighting::JointOrigins;
    plan.settings.seed = 5;
    return run_study(plan).rows.at(0);
  }

  void settleAfter(const std::function<void()>& action) {
    QSignalSpy settled(&session_, &Session::settled);
    action();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  }

  void expectShown(const StudyRow& row) {
    ASSERT_TRUE(document_.original());
    EXPECT_EQ(document_.original()->path.toStdString(), row.clip);
    const ResultFigures figures = *figuresOf(document_);
    EXPECT_NEAR(figures.ratio, row.measured->ratio, 1e-9) << row.settings.method;
    EXPECT_NEAR(figures.eps_cm, row.measured->eps_joint_origins_cm, 1e-6) << row.settings.method;
    EXPECT_EQ(document_.decoded()->method, row.settings.method);
  }

  QTemporaryDir directory_;
  Session session_;
  Document& document_ = session_.document();
};

TEST_F(StudyRowLoading, OpensItsClipWithItsSettings) {
  settleAfter([&] { session_.open(path("one.bvh")); });
  const StudyRow row = rowOf("two.bvh", "annealed");
  settleAfter([&] { session_.openRow(row); });
  expectShown(row);
  EXPECT_FALSE(document_.modified()) << "nothing of the user's would be lost";
}

TEST_F(StudyRowLoading, ChangesTheSettingsOfTheClipThatIsOpen) {
  settleAfter([&] { session_.open(path("one.bvh")); });
  const OriginalPtr before = document_.original();
  for (const char* method : {"haar", "linear", "per-channel", "standard"}) {
    const StudyRow row = rowOf("one.bvh", method);
    settleAfter([&] { session_.openRow(row); });
    expectShown(row);
  }
  EXPECT_EQ(document_.original(), before);
  const StudyRow bound = rowOf("one.bvh", "standard", {Target::Kind::Error, 2});
  settleAfter([&] { session_.openRow(bound); });
  expectShown(bound);
  EXPECT_EQ(document_.options().target, bound.settings.target);
  const int steps = session_.history()->count();
  settleAfter([&] { session_.openRow(bound); });
  EXPECT_EQ(session_.history()->count(), steps) << "nothing was changed";
}

TEST_F(StudyRowLoading, ShowsAComparisonMethodAsIfReadFromAFile) {
  for (const char* clip : {"one.bvh", "two.bvh", "two.bvh"}) {
    const StudyRow row = rowOf(clip, clip[0] == 'o' ? "pca" : "subsample");
    settleAfter([&] { session_.openRow(row); });
    expectShown(row);
    EXPECT_FALSE(document_.decoded()->of_wavelets);
    EXPECT_TRUE(document_.decoded()->distortion);
  }
  EXPECT_TRUE(stateOf(document_).startsWith(QStringLiteral("Frame subsampling")));
  EncodeSettings options = document_.options();
  options.method = Method::Standard;
  settleAfter([&] { session_.setOptions(options); });
  EXPECT_TRUE(document_.decoded()->of_wavelets) << "the settings are wavelets' again";
}

TEST_F(StudyRowLoading, AsksForTheRatioOfATargetTheStudioDoesNotKnow) {
  const StudyRow row = rowOf("one.bvh", "standard", {Target::Kind::CoefficientRatio, 10});
  settleAfter([&] { session_.openRow(row); });
  EXPECT_EQ(document_.options().target.kind, Target::Kind::Ratio);
  EXPECT_NEAR(figuresOf(document_)->ratio, row.measured->ratio, 0.03 * row.measured->ratio);
}

TEST_F(StudyRowLoading, AClipThatIsGoneIsAMessageAndLeavesWhatIsOpen) {
  settleAfter([&] { session_.open(path("one.bvh")); });
  const EncodeSettings before = document_.options();
  StudyRow row = rowOf("two.bvh", "haar");
  row.clip = path("gone.bvh").toStdString();
  QSignalSpy failed(&session_, &Session::openFailed);
  session_.openRow(row);
  ASSERT_TRUE(failed.wait(kPatience));
  EXPECT_EQ(document_.original()->path, path("one.bvh"));
  EXPECT_EQ(document_.options().basis, before.basis);
}

}  // namespace
}  // namespace mocapress
