// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/blind_test/blind_test_window.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/studio/document/session.h"
#include "core/formats/motion_file.h"
#include "resources/samples/generator/samples.h"
#include "tests/qt/patience.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

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

// A model observer answers, no person.
TEST_F(BlindTestOfAWalk, KeepsTheTestOfAModelObserverAndTheAnswersOfOneThatWasClosed) {
  start();
  Random draws(5);
  const PsychometricCurve viewer{1.5, 5};
  while (!window.test()->finished()) {
    const BlindTest& test = *window.test();
    const BlindTest::Question question = test.question();
    const bool right =
        draws.unit() < viewer.right(test.levels()[static_cast<std::size_t>(question.level)]);
    window.answer(right == question.x_is_b);
  }
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

TEST(BlindTestWindow, NeedsAnOpenClip) {
  Session session;
  BlindTestWindow window(&session, QString(), nullptr);
  window.prepare();
  EXPECT_FALSE(window.start()->isEnabled());
}

}  // namespace
}  // namespace mocapress
