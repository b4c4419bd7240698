// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/blind_test/blind_test_window.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/studio/document/own_limits.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "app/studio/window/main_window.h"
#include "core/base/file.h"
#include "core/base/path_kind.h"
#include "core/formats/motion_file.h"
#include "core/metrics/sight_limits_json.h"
#include "resources/samples/generator/samples.h"
#include "tests/qt/patience.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

/// Answers as a model observer, no person.
void answerAs(const PsychometricCurve& viewer, BlindTestWindow& window) {
  Random draws(5);
  while (!window.test()->finished()) {
    const BlindTest& test = *window.test();
    const BlindTest::Question question = test.question();
    const bool right =
        draws.unit() < viewer.right(test.levels()[static_cast<std::size_t>(question.level)]);
    window.answer(right == question.x_is_b);
  }
}

/// A blind test of a walk that is open.
struct BlindTestOfAWalk : testing::Test {
  void SetUp() override {
    const QString path = directory.filePath(QStringLiteral("walk.bvh"));
    write_motion(path.toStdU16String(), samples::walk_clip());
    QSignalSpy settled(&session, &Session::settled);
    session.open(path);
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
    window.show();
    window.prepare();
  }
  void start() {
    ASSERT_TRUE(window.start()->isEnabled());
    window.start()->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.test().has_value(); }, kPatience));
  }

  const QTemporaryDir directory;
  const QString file = directory.filePath(QStringLiteral("kept/blind_tests.json"));
  Session session;
  BlindTestWindow window{&session, file, nullptr};
};

TEST_F(BlindTestOfAWalk, KeepsTheTestOfAModelObserverAndTheAnswersOfOneThatWasClosed) {
  start();
  answerAs({1.5, 5}, window);
  EXPECT_FALSE(window.verdict()->text().isEmpty());
  const std::vector<BlindTestRecord> kept = read_blind_tests(file.toStdU16String());
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].clip, "walk.bvh");
  EXPECT_EQ(kept[0].answers.size(), 40u);

  window.prepare();
  start();
  for (int i = 0; i < 3; ++i) window.answer(true);
  window.close();
  const std::vector<BlindTestRecord> both = read_blind_tests(file.toStdU16String());
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[1].answers.size(), 3u);
}

TEST_F(BlindTestOfAWalk, LooksAtEveryFigureByOneCamera) {
  window.beside()->setChecked(true);
  start();
  const QList<Viewport*> views = window.findChildren<Viewport*>();
  ASSERT_EQ(views.size(), 3);
  for (int i = 0; i < 10; ++i) {
    const OrbitCamera::Place first = views[0]->cameraPlace();
    for (const Viewport* view : views) {
      EXPECT_TRUE(view->isVisible());
      EXPECT_EQ(view->cameraPlace().target, first.target);
      EXPECT_EQ(view->cameraPlace().distance, first.distance);
      EXPECT_EQ(view->cameraPlace().azimuth, first.azimuth);
    }
    window.resize(window.size() + QSize(20, 10));  // frames the figures anew
    window.answer(i % 3 == 0);
  }
}

/// The limits in the file, as the next start of the program reads them.
SightLimits limitsOnDisk() {
  const std::filesystem::path path = ownLimitsFile().toStdU16String();
  return is_there(path) ? limits_from_text("limits.json", read_text(path)) : SightLimits();
}

// Through the studio's window, whose menu makes the blind test's.
TEST(BlindTestWindow, OwnLimitsJudgeAllClipsOfTheLibraryUntilBuiltInOnesDo) {
  const QTemporaryDir directory;
  QStringList clips;
  for (const char* name : {"walk.bvh", "other.bvh"}) {
    clips << directory.filePath(QString::fromLatin1(name));
    write_motion(clips.back().toStdU16String(), samples::walk_clip());
  }
  MainWindow studio;
  studio.show();
  const auto settle_after = [&](auto act) {
    QSignalSpy settled(&studio.session(), &Session::settled);
    act();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  };
  for (const QString& clip : clips) settle_after([&] { studio.open({clip}); });
  EncodeSettings seen = studio.session().document().options();
  seen.target = {Target::Kind::Error, 1};
  settle_after([&] { studio.session().setOptions(seen); });
  const auto judged_by = [&](int row) {
    return studio.library().project().clips[static_cast<std::size_t>(row)].outcome->limits.of_cues;
  };
  const auto times_noticed = [&] {
    return studio.session().document().decoded()->visibility->worst().times_noticed();
  };
  const double by_built_in = times_noticed();
  EXPECT_GT(by_built_in, 2) << "visible";

  studio.actions().blind_test->trigger();
  auto& window = *studio.findChild<BlindTestWindow*>();
  EXPECT_FALSE(window.useBuiltInLimits()->isVisible());
  window.start()->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.test().has_value(); }, kPatience));
  answerAs({2.5, 5}, window);
  ASSERT_TRUE(window.useAsLimits()->isEnabled()) << window.verdict()->text().toStdString();
  settle_after([&] { window.useAsLimits()->click(); });
  EXPECT_LT(times_noticed(), by_built_in);
  const auto own = limitsOnDisk().of_cues;
  EXPECT_NE(own, SightLimits().of_cues);
  EXPECT_EQ(own, ownLimits().limits.of_cues);
  EXPECT_EQ(judged_by(1), own);
  EXPECT_NE(judged_by(0), own);
  EXPECT_EQ(outdated(studio.library().project().clips[0]), Staleness::Settings);
  settle_after([&] { studio.library().openClip(0); });
  EXPECT_EQ(judged_by(0), own);
  EXPECT_EQ(outdated(studio.library().project().clips[0]), Staleness::None);

  window.prepare();
  EXPECT_TRUE(window.useBuiltInLimits()->isVisible());
  settle_after([&] { window.useBuiltInLimits()->click(); });
  EXPECT_FALSE(QFileInfo::exists(ownLimitsFile()));
  EXPECT_EQ(judged_by(0), SightLimits().of_cues);
  settle_after([&] { studio.library().openClip(1); });
  EXPECT_DOUBLE_EQ(times_noticed(), by_built_in);
}

TEST(BlindTestWindow, NeedsAnOpenClip) {
  Session session;
  BlindTestWindow window(&session, QString(), nullptr);
  window.prepare();
  EXPECT_FALSE(window.start()->isEnabled());
}

}  // namespace
}  // namespace mocapress
