// SPDX-License-Identifier: GPL-3.0-or-later
// Presets and importances in the real window. Needs an X display with OpenGL (Xvfb is enough).
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "app/studio/batch/batch_window.h"
#include "app/studio/document/clip_files.h"
#include "app/studio/window/main_window.h"
#include "app/studio/window/screenshot.h"
#include "tests/qt/patience.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/factor_control.h"
#include "widgets/panels/importance_panel.h"
#include "widgets/panels/preset_chooser.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

class Tuning : public testing::Test {
 protected:
  Tuning() {
    QSettings().clear();
    window_.resize(1440, 900);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
    settleAfter([&] { window_.files().open(sampleClip()); });
  }
  ~Tuning() override { QSettings().clear(); }

  template <typename Act>
  void settleAfter(Act act) {
    QSignalSpy settled(&window_.session(), &Session::settled);
    act();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.session().busy(); }, kPatience));
  }

  void picture(const char* name) {
    QSignalSpy captured(window_.views().viewport, &Viewport::captured);
    window_.views().viewport->capture();
    EXPECT_TRUE(captured.count() > 0 || captured.wait(kPatience));
    runDueEvents();
    const QDir folder(QStringLiteral(MOCAPRESS_BINARY_DIR "/pictures"));
    folder.mkpath(QStringLiteral("."));
    EXPECT_TRUE(writeScreenshot(window_, folder.filePath(QString::fromLatin1(name))));
  }

  MainWindow window_;
  Document& document_ = window_.session().document();
};

TEST_F(Tuning, APresetThatPlantsFeetIsChosenAndItsImportanceSeen) {
  const double before = document_.decoded()->footskate->total_cm;
  QComboBox* box = window_.views().compression->presets()->box();
  const int index = box->findText(QStringLiteral("Planted feet"));
  ASSERT_GE(index, 0);
  settleAfter([&] {
    box->setCurrentIndex(index);
    emit box->activated(index);
  });
  EXPECT_LT(document_.decoded()->footskate->total_cm, 0.5 * before);
  window_.views().compression->importance()->click();
  ImportancePanel* importance = window_.views().importance;
  EXPECT_TRUE(importance->isVisible());
  EXPECT_EQ(importance->contacts()->value(), 20);
  settleAfter([&] { importance->part(BodyPart::Hands)->slider()->setValue(750); });
  importance->drawer()->click();
  picture("tuning-importance.png");
  EXPECT_EQ(box->currentText(), QStringLiteral("Planted feet, modified"));
  window_.findChild<QDockWidget*>(QStringLiteral("compression"))->raise();
  picture("tuning-preset.png");
  settleAfter([&] { window_.actions().undo->trigger(); });
  settleAfter([&] { window_.actions().undo->trigger(); });
  EXPECT_EQ(box->currentText(), QStringLiteral("Gameplay"));
}

TEST_F(Tuning, TheLibraryIsExportedEachClipByItsOwnSettings) {
  EncodeSettings options = document_.options();
  options.target = {Target::Kind::MaxError, 1};
  settleAfter([&] { window_.session().setOptions(options); });
  window_.actions().export_library->trigger();
  auto* batch = window_.findChild<BatchWindow*>();
  ASSERT_TRUE(batch);
  const BatchQueueModel* queue = batch->session()->queue();
  const auto tuned = [&] {
    for (const QueuedClip& clip : queue->clips())
      if (QString::fromStdString(clip.source.path) == sampleClip()) return clip.own.has_value();
    return false;
  };
  ASSERT_TRUE(QTest::qWaitFor(tuned, kPatience));
  EXPECT_EQ(queue->clips().back().own->target, options.target);
  batch->close();
}

TEST_F(Tuning, TheOpenClipIsOfferedToTheBatchWithItsOwnSettings) {
  EncodeSettings options = document_.options();
  options.ranges = {{10, 20, 3}};
  settleAfter([&] { window_.session().setOptions(options); });
  window_.actions().batch->trigger();
  auto* batch = window_.findChild<BatchWindow*>();
  ASSERT_TRUE(batch);
  const BatchQueueModel* queue = batch->session()->queue();
  ASSERT_TRUE(QTest::qWaitFor([&] { return queue->rowCount() == 1; }, kPatience));
  ASSERT_TRUE(queue->clips()[0].own);
  EXPECT_EQ(queue->clips()[0].own->ranges, options.ranges);
  batch->close();
}

}  // namespace
}  // namespace mocapress
