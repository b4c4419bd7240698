// SPDX-License-Identifier: GPL-3.0-or-later
// The batch window beside the studio's. Needs an X display with OpenGL (Xvfb is enough).
#include "app/studio/batch/batch_window.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <cstdlib>

#include "app/studio/window/main_window.h"
#include "app/studio/window/screenshot.h"
#include "core/base/file.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "widgets/models/colours.h"
#include "widgets/panels/batch_output.h"
#include "widgets/panels/batch_queue_view.h"
#include "widgets/panels/character_choice.h"
#include "widgets/panels/preset_chooser.h"
#include "widgets/panels/preset_editor.h"

namespace mocapress {
namespace {

/// Counts pixels near a colour: antialiasing changes most of a text's pixels.
int pixelsOf(QRgb colour, const QImage& picture) {
  constexpr int kNear = 40;
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb seen = picture.pixel(x, y);
      count += std::abs(qRed(seen) - qRed(colour)) < kNear &&
               std::abs(qGreen(seen) - qGreen(colour)) < kNear &&
               std::abs(qBlue(seen) - qBlue(colour)) < kNear;
    }
  return count;
}

/// A picture of the window, which is also saved in the build folder.
QImage pictureOf(const BatchWindow& window, const char* name) {
  runDueEvents();
  const QDir folder(QStringLiteral(MOCAPRESS_BINARY_DIR "/pictures"));
  folder.mkpath(QStringLiteral("."));
  const QString path = folder.filePath(QString::fromLatin1(name));
  EXPECT_TRUE(writeScreenshot(window, path));
  return QImage(path);
}

/// Writes the bundled samples and parts of them as in a game's folder, one of them broken.
void writeClips(const QString& folder) {
  QDir().mkpath(folder);
  const std::filesystem::path samples =
      std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources/samples";
  const std::filesystem::path target = folder.toStdU16String();
  for (const char* name : {"human_walk", "human_run", "human_jump"}) {
    Motion motion = read_motion(samples / (std::string(name) + ".amc")).motion;
    for (const char* part : {"_loop", "_start", "_turn", "_stop"}) {
      write_motion(target / (name + std::string(part) + ".bvh"), motion);
      motion.clip.channels = motion.clip.channels.topRows(3 * motion.clip.frames() / 4).eval();
    }
  }
  write_text(target / "idle_export_failed.bvh", "HIERARCHY\nROOT\n");
}

TEST(BatchWindowOnScreen, ClipsAreDroppedSetUpExportedAndReportedOn) {
  QSettings().clear();
  const QTemporaryDir directory;
  const QString folder = directory.filePath(QStringLiteral("animations"));
  writeClips(folder);
  MainWindow studio;
  studio.show();
  studio.actions().batch->trigger();
  auto* window = studio.findChild<BatchWindow*>();
  auto* session = studio.findChild<BatchSession*>();
  ASSERT_TRUE(window);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window));
  EXPECT_FALSE(window->startButton()->isEnabled());
  pictureOf(*window, "batch-empty.png");

  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(folder)});
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window->view()->viewport(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window->view()->viewport(), &drop);
  ASSERT_TRUE(QTest::qWaitFor([&] { return session->queue()->rowCount() == 13; }, kPatience));

  BatchSettings settings = session->settings();
  settings.folder = directory.filePath(QStringLiteral("compressed"));
  session->setSettings(settings);
  window->output()->format(OutputFormat::Bvh)->click();
  EXPECT_EQ(session->settings().formats.size(), 2u);
  // Two clips get settings of their own, which lock them; then all others change.
  auto* chosen = window->view()->selectionModel();
  for (const int row : {0, 4})
    chosen->select(session->queue()->index(row, 0),
                   QItemSelectionModel::Select | QItemSelectionModel::Rows);
  emit window->editor()->chooser()->box()->activated(0);
  EXPECT_EQ(session->queue()->clips()[4].own, built_in_presets()[0]);
  QTest::keyClick(window, Qt::Key_Escape);
  EXPECT_TRUE(window->view()->selectedRows().empty());
  emit window->editor()->chooser()->box()->activated(1);

  // The character's name is shown, removed by a click and restored by Undo.
  settings = session->settings();
  settings.character = QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/character.glb");
  session->setSettings(settings);
  EXPECT_EQ(window->character()->file()->text(), QStringLiteral("character.glb"));
  pictureOf(*window, "batch-character.png");
  QTest::mouseClick(window->character()->removal(), Qt::LeftButton);
  EXPECT_TRUE(session->settings().character.isEmpty());
  EXPECT_FALSE(window->character()->removal()->isVisible());
  session->undo();
  EXPECT_EQ(window->character()->file()->text(), QStringLiteral("character.glb"));
  session->undo();
  EXPECT_NE(window->character()->file()->text(), QStringLiteral("character.glb"));

  // The option to learn is enabled for packed banks.
  QComboBox* const bank = window->output()->bank();
  bank->setCurrentIndex(bank->findData(static_cast<int>(runtime::BankForm::Packed)));
  emit bank->activated(bank->currentIndex());
  window->output()->learn()->click();
  EXPECT_TRUE(session->settings().learns());
  pictureOf(*window, "batch-bank.png");
  session->undo();
  EXPECT_FALSE(window->output()->learn()->isChecked());
  session->undo();
  EXPECT_FALSE(session->settings().bank);

  // Undo in this window changes the queue and not the studio.
  window->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window));
  emit window->view()->removeRequested({1, 2});
  EXPECT_EQ(session->queue()->rowCount(), 11);
  QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(session->queue()->rowCount(), 13);
  QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(session->queue()->rowCount(), 11);
  QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);

  QTest::mouseClick(window->startButton(), Qt::LeftButton);
  ASSERT_TRUE(session->running());
  ASSERT_TRUE(QTest::qWaitFor([&] { return session->counts().done >= 5; }, kPatience));
  QTest::mouseClick(window->startButton(), Qt::LeftButton);
  EXPECT_TRUE(session->state() == BatchSession::State::Paused || !session->running());
  pictureOf(*window, "batch-running.png");
  QTest::mouseClick(window->startButton(), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !session->running(); }, kPatience));

  EXPECT_EQ(session->counts().failed, 1u);
  EXPECT_TRUE(window->reportButton()->isEnabled());
  EXPECT_TRUE(window->startButton()->text().contains(QLatin1Char('1'))) << "one to retry";
  EXPECT_TRUE(QFile::exists(settings.folder + QStringLiteral("/animations/human_run_turn.bvh")));
  const QImage seen = pictureOf(*window, "batch.png");
  EXPECT_GT(pixelsOf(kCurveColours[2], seen), 100) << "verified";
  EXPECT_GT(pixelsOf(kCurveColours[1], seen), 25) << "failed";
  QSettings().clear();
}

}  // namespace
}  // namespace mocapress
