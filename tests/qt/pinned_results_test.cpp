// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/pinned_results.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>
#include <map>

#include "app/studio/document/session.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/models/pinned_model.h"
#include "widgets/panels/pinned_panel.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

EncodeSettings standardAt(double ratio) {
  return {.method = Method::Standard, .target = {Target::Kind::Ratio, ratio}};
}

class Pinning : public testing::Test {
 protected:
  Pinning() {
    results_.showIn(&panel_, &viewport_);
    session_.setOptions(standardAt(10));
    open("walk.bvh", 1);
  }

  void open(const char* name, unsigned seed) {
    const QString path = directory_.filePath(QString::fromLatin1(name));
    write_motion(path.toStdU16String(), test::smooth_motion(120, seed));
    settleAfter([&] { session_.open(path); });
  }

  template <typename Act>
  void settleAfter(Act act) {
    QSignalSpy settled(&session_, &Session::settled);
    act();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  }

  void tune(double ratio) {
    settleAfter([&] { session_.setOptions(standardAt(ratio)); });
  }

  QTemporaryDir directory_;
  Session session_;
  PinnedModel model_;
  PinnedPanel panel_{&model_};
  Viewport viewport_;
  PinnedResults results_{&session_, &model_};
};

TEST_F(Pinning, AResultStaysAsItWasWhileOthersAreTried) {
  EXPECT_TRUE(results_.canPin());
  QTest::mouseClick(panel_.pinButton(), Qt::LeftButton);
  const DecodedPtr pinned = session_.document().decoded();
  EXPECT_FALSE(panel_.pinButton()->isEnabled()) << "it is pinned";
  tune(40);
  EXPECT_TRUE(panel_.pinButton()->isEnabled());
  ASSERT_EQ(model_.rowCount(), 1);
  EXPECT_DOUBLE_EQ(model_.entries()[0].ratio, pinned->ratio);
  EXPECT_DOUBLE_EQ(model_.entries()[0].max_cm, pinned->distortion->worst(Weighting::Surface).cm);
  ASSERT_EQ(viewport_.pinned().size(), 1u);
  EXPECT_EQ(viewport_.pinned()[0].tracks, pinned->tracks);
  EXPECT_EQ(viewport_.pinned()[0].title[0], model_.entries()[0].name);
}

TEST_F(Pinning, FourHaveColoursOfTheirOwnAndAFifthHasNoRoom) {
  for (const double ratio : {15.0, 20.0, 30.0, 40.0}) {
    tune(ratio);
    results_.pinCurrent();
  }
  tune(50);
  EXPECT_FALSE(results_.canPin());
  results_.pinCurrent();
  ASSERT_EQ(model_.rowCount(), 4);
  QSet<QRgb> colours;
  for (const PinnedEntry& entry : model_.entries()) colours.insert(entry.colour.rgb());
  EXPECT_EQ(colours.size(), 4);
  // A freed colour is used again.
  const QColor freed = model_.entries()[1].colour;
  results_.unpin(1);
  results_.pinCurrent();
  EXPECT_EQ(model_.entries()[3].colour, freed);
}

TEST_F(Pinning, OneIsMadeCurrentAndThatIsUndone) {
  results_.pinCurrent();
  // The two steps differ in kind, since quick steps of one kind merge.
  EncodeSettings other = standardAt(10);
  other.weighting = Weighting::JointOrigins;
  settleAfter([&] { session_.setOptions(other); });
  other.target.value = 40;
  settleAfter([&] { session_.setOptions(other); });
  panel_.view()->setCurrentIndex(model_.index(0, 0));
  settleAfter([&] { QTest::mouseClick(panel_.makeCurrentButton(), Qt::LeftButton); });
  EXPECT_DOUBLE_EQ(session_.document().options().target.value, 10);
  settleAfter([&] { session_.history()->undo(); });
  EXPECT_DOUBLE_EQ(session_.document().options().target.value, 40);
}

TEST_F(Pinning, NamesAreEdited) {
  results_.pinCurrent();
  EXPECT_FALSE(model_.setData(model_.index(0, 0), QStringLiteral("  "), Qt::EditRole));
  EXPECT_TRUE(model_.setData(model_.index(0, 0), QStringLiteral("hero"), Qt::EditRole));
  EXPECT_EQ(model_.index(0, 0).data().toString(), QStringLiteral("hero"));
  EXPECT_EQ(viewport_.pinned()[0].title[0], QStringLiteral("hero"));
}

TEST_F(Pinning, NoTwoHaveOneName) {
  EncodeSettings other = standardAt(10);
  results_.pinCurrent();
  other.weighting = Weighting::JointOrigins;
  settleAfter([&] { session_.setOptions(other); });
  results_.pinCurrent();
  ASSERT_EQ(model_.rowCount(), 2);
  EXPECT_NE(model_.entries()[0].name, model_.entries()[1].name);
}

TEST_F(Pinning, EveryEditIsAStepOfTheClip) {
  QUndoStack& history = *session_.history();
  const int before = history.count();
  results_.pinCurrent();
  const QString first = model_.entries()[0].name;
  results_.rename(0, QStringLiteral("hero"));
  tune(40);
  results_.pinCurrent();
  results_.unpin(0);
  EXPECT_EQ(history.count(), before + 5);
  ASSERT_EQ(model_.rowCount(), 1);
  history.undo();
  ASSERT_EQ(model_.rowCount(), 2);
  EXPECT_EQ(model_.entries()[0].name, QStringLiteral("hero")) << "where it was";
  history.undo();
  EXPECT_EQ(model_.rowCount(), 1);
  settleAfter([&] { history.undo(); });
  history.undo();
  EXPECT_EQ(model_.entries()[0].name, first);
  history.undo();
  EXPECT_EQ(model_.rowCount(), 0);
  history.redo();
  history.redo();
  ASSERT_EQ(model_.rowCount(), 1);
  EXPECT_EQ(model_.entries()[0].name, QStringLiteral("hero"));
}

TEST_F(Pinning, AnotherClipBeginsWithoutPins) {
  results_.pinCurrent();
  open("jump.bvh", 2);
  EXPECT_EQ(model_.rowCount(), 0);
  EXPECT_TRUE(viewport_.pinned().empty());
}

TEST_F(Pinning, AreEncodedAgainWhenTheirClipIsOpenedAgain) {
  std::map<QString, std::vector<Pin>> kept;
  results_.setMemory([&](const QString& path) { return kept[path]; });
  QObject::connect(&results_, &PinnedResults::edited, &results_,
                   [&](const QString& path, const auto& pins) { kept[path] = pins; });
  results_.pinCurrent();
  tune(40);
  results_.pinCurrent();
  results_.rename(0, QStringLiteral("hero"));
  const std::vector<PinnedEntry> before = model_.entries();
  open("jump.bvh", 2);
  EXPECT_EQ(model_.rowCount(), 0);
  open("walk.bvh", 1);
  ASSERT_TRUE(QTest::qWaitFor([this] { return model_.rowCount() == 2; }, kPatience));
  for (std::size_t i = 0; i < 2; ++i) {
    const PinnedEntry& now = model_.entries()[i];
    EXPECT_EQ(now.name, before[i].name);
    EXPECT_EQ(now.colour, before[i].colour);
    EXPECT_DOUBLE_EQ(now.ratio, before[i].ratio);
    EXPECT_DOUBLE_EQ(now.max_cm, before[i].max_cm);
  }
  // A result that is unpinned meanwhile does not come back.
  results_.unpin(0);
  open("jump.bvh", 2);
  open("walk.bvh", 1);
  ASSERT_TRUE(QTest::qWaitFor([this] { return model_.rowCount() == 1; }, kPatience));
  EXPECT_EQ(model_.entries()[0].name, before[1].name);
}

TEST_F(Pinning, AnEnginesResultComesBackWithTheClip) {
  std::map<QString, std::vector<Pin>> kept;
  results_.setMemory([&](const QString& path) { return kept[path]; });
  QObject::connect(&results_, &PinnedResults::edited, &results_,
                   [&](const QString& path, const auto& pins) { kept[path] = pins; });
  results_.pinEngine();
  ASSERT_TRUE(QTest::qWaitFor([this] { return model_.rowCount() == 1; }, kPatience));
  const PinnedEntry before = model_.entries()[0];
  open("jump.bvh", 2);
  open("walk.bvh", 1);
  ASSERT_TRUE(QTest::qWaitFor([this] { return model_.rowCount() == 1; }, kPatience));
  EXPECT_EQ(model_.entries()[0].name, before.name);
  EXPECT_DOUBLE_EQ(model_.entries()[0].max_cm, before.max_cm);
  const EncodeSettings options = session_.document().options();
  results_.makeCurrent(0);
  EXPECT_EQ(session_.document().options().method, options.method) << "no settings of ours make it";
}

TEST_F(Pinning, OneThatCannotBeMadeAnewIsLeftOut) {
  const auto pinOf = [](const char* name, const EncodeSettings& options) {
    return Pin{QString::fromLatin1(name), {}, namedSettings({options, {}, {}}, {})};
  };
  Pin impossible = pinOf("no", standardAt(10));
  impossible.settings.preset.target = {Target::Kind::Size, 1};
  const Pin fine = pinOf("yes", standardAt(20));
  results_.setMemory([&](const QString&) { return std::vector{impossible, fine}; });
  open("jump.bvh", 2);
  ASSERT_TRUE(QTest::qWaitFor([this] { return model_.rowCount() == 1; }, kPatience));
  EXPECT_EQ(model_.entries()[0].name, fine.name);
  EXPECT_TRUE(model_.entries()[0].colour.isValid());
}

TEST_F(Pinning, OnlyAFinalResultIsPinned) {
  session_.setOptions(standardAt(30));
  EXPECT_FALSE(panel_.pinButton()->isEnabled()) << "what is shown is still by other settings";
  results_.pinCurrent();
  EXPECT_EQ(model_.rowCount(), 0);
  QSignalSpy settled(&session_, &Session::settled);
  ASSERT_TRUE(settled.wait(kPatience));
  EXPECT_TRUE(panel_.pinButton()->isEnabled());
}

TEST_F(Pinning, NamesSayTheTargetAndHaveRoom) {
  results_.pinCurrent();
  EXPECT_TRUE(model_.entries()[0].name.contains(QStringLiteral("10:1")));
  panel_.resize(200, 200);
  panel_.show();
  EXPECT_TRUE(QTest::qWaitFor(
      [this] { return panel_.view()->columnWidth(PinnedModel::Name) >= 90; }, kPatience));
}

}  // namespace
}  // namespace mocapress
