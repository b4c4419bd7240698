// SPDX-License-Identifier: GPL-3.0-or-later
// Whole sessions in the real window, with a picture of each step in the build folder.
#include <gtest/gtest.h>

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>
#include <cstdio>
#include <filesystem>

#include "app/studio/batch/batch_window.h"
#include "app/studio/document/clip_files.h"
#include "app/studio/window/screenshot.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/qt/studio_at_work.h"
#include "widgets/models/batch_queue_model.h"
#include "widgets/models/library_tree.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/preset_chooser.h"
#include "widgets/panels/preset_editor.h"
#include "widgets/panels/target_control.h"
#include "widgets/plots/rate_plot.h"
#include "widgets/timeline/contact_strip.h"
#include "widgets/timeline/error_strip.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

using namespace test;

/// Writes the bundled samples and parts of them as in a game's folder.
void writeGame(const QString& folder) {
  const std::filesystem::path samples =
      std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources/samples";
  for (const auto& [sample, below] : {std::pair("human_walk", "locomotion/walks"),
                                      {"human_run", "locomotion/runs"},
                                      {"human_jump", "jumps"}}) {
    const QString path = folder + QLatin1Char('/') + QString::fromLatin1(below);
    QDir().mkpath(path);
    Motion motion = read_motion(samples / (std::string(sample) + ".amc")).motion;
    for (const char* part : {"loop", "start", "stop"}) {
      write_motion(std::filesystem::path(path.toStdU16String()) / (std::string(part) + ".bvh"),
                   motion);
      motion.clip.channels = motion.clip.channels.topRows(3 * motion.clip.frames() / 4).eval();
    }
  }
}

TEST_F(StudioTour, AFolderIsReviewedClipByClip) {
  const QString game = directory_.filePath(QStringLiteral("game"));
  writeGame(game);
  Studio studio;
  studio->library().begin(directory_.filePath(QStringLiteral("data")));
  drop(*studio.operator->(), {QUrl::fromLocalFile(game)});
  LibraryPanel& panel = studio->libraryPanel();
  LibraryTree& tree = *panel.tree();
  const auto& clips = studio->library().project().clips;
  ASSERT_TRUE(QTest::qWaitFor([&] { return clips.size() == 9; }, kPatience));
  ASSERT_EQ(tree.rowCount(), 2) << "jumps, locomotion";
  const auto tune = [&](int row, double ratio) {
    studio.settleAfter([&] { panel.view()->setCurrentIndex(tree.indexOf(row)); });
    EncodeSettings options = studio->session().document().options();
    // A new clip starts with the settings of the one before it.
    if (options.target.kind == Target::Kind::Ratio && options.target.value == ratio) return;
    options.method = Method::ClosedLoop;
    options.target = {Target::Kind::Ratio, ratio};
    studio.settleAfter([&] { studio->session().setOptions(options); });
  };
  for (int row = 0; row < 9; ++row) tune(row, row % 3 == 2 ? 90 : 60);
  studio->library().setVerdict({0}, Verdict::Approved);
  tune(6, 200);                                                // a walk
  studio->actions().error_scales->actions().at(2)->trigger();  // 1 cm
  studio->actions().view.by_error->trigger();
  studio->actions().view.trail->trigger();
  studio->actions().view.trail_poses->actions().front()->trigger();
  studio->playback().seek(300);
  studio->actions().view.reset_camera->trigger();
  studio->findChild<QDockWidget*>(QStringLiteral("heat-map"))->raise();
  runDueEvents();
  const QImage all = studio.picture(QStringLiteral("library"));
  EXPECT_GT(coloursIn(all, studio.areaOf(panel.view())), 12u);
  panel.view()->collapse(tree.indexOf(0).parent());
  panel.filter()->setText(QStringLiteral("approved"));
  EXPECT_EQ(tree.rowCount(), 1);
  EXPECT_GT(differing(all, studio.picture(QStringLiteral("library-approved"))), 3000);
}

/// Exports the 15 study clips through the real window.
void batch(Studio& studio) {
  const QString folder = QStringLiteral(MOCAPRESS_SOURCE_DIR "/../shared/corpus/study");
  if (!QFile::exists(folder)) {
    std::printf("batch left out: %s is not here\n", qPrintable(folder));
    return;
  }
  const QTemporaryDir out;
  studio->actions().batch->trigger();
  auto* window = studio->findChild<BatchWindow*>();
  auto* session = studio->findChild<BatchSession*>();
  ASSERT_TRUE(window && QTest::qWaitForWindowExposed(window));
  BatchQueueModel& queue = *session->queue();
  ASSERT_TRUE(QTest::qWaitFor([&] { return queue.rowCount() == 1; }, kPatience));
  session->addClips({folder});
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        std::vector<int> others;  // the open clip is offered
        for (int row = 0; row < queue.rowCount(); ++row)
          if (queue.clips()[static_cast<std::size_t>(row)].source.folder != "study")
            others.push_back(row);
        queue.remove(others);
        return queue.rowCount() == 15;
      },
      kPatience));
  BatchSettings settings = session->settings();
  settings.folder = out.path();
  session->setSettings(settings);
  emit window->editor()->chooser()->box()->activated(1);  // gameplay: eps_x 0.5 cm
  QElapsedTimer clock;
  clock.start();
  QTest::mouseClick(window->startButton(), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !session->running(); }, 4 * kPatience));
  std::printf("batch of 15 study clips: %.1f s\n", double(clock.elapsed()) / 1e3);
  EXPECT_EQ(session->counts().done, 15u);
  EXPECT_EQ(session->counts().failed, 0u);
  EXPECT_EQ(
      QDir(out.path() + QStringLiteral("/study")).entryList({QStringLiteral("*.mcpr")}).size(), 15);
  runDueEvents();
  EXPECT_TRUE(writeScreenshot(*window, picturePath(QStringLiteral("session-6-batch"))));
  const QImage picture(picturePath(QStringLiteral("session-6-batch")));
  EXPECT_GT(coloursIn(picture, picture.rect()), 60u);
  window->close();
}

/// Runs a whole session as an artist would.
TEST_F(StudioTour, OpensTunesInspectsEditsComparesUndoesSavesAndIsRecovered) {
  const QString data = directory_.filePath(QStringLiteral("data"));
  const QString project = directory_.filePath(QStringLiteral("walks.mocapress"));
  std::vector<ContactSpan> edited;
  {
    Studio studio;
    studio->library().begin(data);
    Document& document = studio->session().document();

    studio.open(sampleClip());
    const QImage opened = studio.picture(QStringLiteral("session-1-open"));
    EXPECT_GT(coloursIn(opened, studio.areaOf(studio->views().viewport)), 500u);
    EXPECT_GT(coloursIn(opened, studio.areaOf(studio->inspection().timeline)), 12u);

    QSlider* slider = studio->views().compression->target()->slider();
    studio.settleAfter([&] {
      for (int position = slider->value(); position < 700; position += 25) {
        slider->setValue(position);
        runDueEvents();
      }
    });
    EXPECT_GT(document.decoded()->ratio, 50);
    const QImage tuned = studio.picture(QStringLiteral("session-2-tuned"));
    EXPECT_GT(differing(opened, tuned), 2000);

    studio->actions().next_worst->trigger();
    EXPECT_EQ(studio->playback().frame(), document.decoded()->distortion->max.frame);
    studio->actions().view.by_error->trigger();
    for (const char* id : {"rate-distortion", "channel", "heat-map"}) {
      auto* dock = studio->findChild<QDockWidget*>(QString::fromLatin1(id));
      ASSERT_TRUE(dock);
      dock->raise();
      const auto curves_are_drawn = [&] {
        const RatePlot* plot = dock->findChild<RatePlot*>();
        return !plot || (!plot->curves().empty() && plot->curves()[0].line.size() > 1);
      };
      EXPECT_TRUE(QTest::qWaitFor(curves_are_drawn, kPatience));
      const QImage picture = studio.picture(QStringLiteral("session-3-") + QString::fromLatin1(id));
      EXPECT_TRUE(dock->widget()->isVisible());
      EXPECT_GT(coloursIn(picture, studio.areaOf(dock->widget())), 12u) << id;
    }

    ContactStrip* contacts = studio->inspection().timeline->contacts();
    const std::vector<ContactSpan> found = document.contacts();
    ASSERT_GT(found.size(), 1u);
    const int labels =
        std::max(studio->inspection().timeline->errors()->labelWidth(), contacts->labelWidth());
    const TimeAxis axis{2.0 * kStripMargin + labels,
                        static_cast<double>(contacts->width() - kStripMargin), document.frames()};
    const ContactSpan& first = found.front();
    const QPoint end(static_cast<int>(axis.xOf(first.last_frame + 1)), 10);
    studio.settleAfter([&] {
      QTest::mousePress(contacts, Qt::LeftButton, {}, end);
      QMouseEvent move(QEvent::MouseMove, QPointF(end - QPoint(20, 0)), QPointF(), Qt::NoButton,
                       Qt::LeftButton, {});
      QCoreApplication::sendEvent(contacts, &move);
      QTest::mouseRelease(contacts, Qt::LeftButton, {}, end - QPoint(20, 0));
    });
    edited = document.contacts();
    EXPECT_LT(edited.front().last_frame, first.last_frame);
    studio.picture(QStringLiteral("session-4-contact"));

    studio.settleAfter([&] { studio->actions().switch_slot->trigger(); });
    studio.settleAfter([&] { slider->setValue(400); });
    const QImage other = studio.picture(QStringLiteral("session-5-b"));
    EXPECT_EQ(studio->session().document().tuning().active, 1);
    studio.settleAfter([&] { studio->actions().switch_slot->trigger(); });
    EXPECT_GT(document.decoded()->ratio, 50);
    EXPECT_GT(differing(other, studio.picture(QStringLiteral("session-5-a"))), 1000);

    while (document.contacts() == edited && studio->session().history()->canUndo())
      studio.settleAfter([&] { studio->actions().undo->trigger(); });
    EXPECT_EQ(document.contacts(), found);
    studio.picture(QStringLiteral("session-6-undone"));
    studio.settleAfter([&] { studio->actions().redo->trigger(); });
    EXPECT_EQ(document.contacts(), edited);

    batch(studio);

    studio->library().saveAs(project);
    studio->libraryPanel().note()->setText(QString());
    QTest::keyClicks(studio->libraryPanel().note(), QStringLiteral("heel of frame 40"));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          QFile file(project);
          return file.open(QIODevice::ReadOnly) && file.readAll().contains("heel of frame 40");
        },
        kPatience));
    studio->library().end();
  }
  Studio studio;
  studio.settleAfter([&] { studio->library().open(project); });
  EXPECT_EQ(studio->session().document().contacts(), edited);
  EXPECT_EQ(studio->libraryPanel().note()->text(), QStringLiteral("heel of frame 40"));
  const QImage again = studio.picture(QStringLiteral("session-7-again"));
  EXPECT_GT(coloursIn(again, studio.areaOf(studio->views().viewport)), 500u);
}

/// Kills the program itself.
TEST_F(StudioTour, IsThereAgainAfterAKill) {
  const QString program = QStringLiteral(MOCAPRESS_BINARY_DIR "/app/studio/mocapress-studio");
  if (!QFile::exists(program)) GTEST_SKIP() << "mocapress-studio is not built";
  const QString data = directory_.filePath(QStringLiteral("mocapress/Mocapress"));
  QProcess studio;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("XDG_DATA_HOME"), directory_.path());
  environment.insert(QStringLiteral("XDG_CONFIG_HOME"), directory_.path());
  studio.setProcessEnvironment(environment);
  studio.start(program, {QStringLiteral("--ratio"), QStringLiteral("61"), sampleClip()});
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const QDir projects(data + QStringLiteral("/projects"));
        QFile written(projects.filePath(
            projects.entryList({QStringLiteral("*.mocapress")}).value(0, QStringLiteral("none"))));
        return written.open(QIODevice::ReadOnly) && written.readAll().contains("outcome") &&
               QFile::exists(data + QStringLiteral("/recent.json"));
      },
      kPatience));
  studio.kill();
  ASSERT_TRUE(studio.waitForFinished(kPatience));

  Studio next;
  QSignalSpy recovered(&next->library(), &Library::recovered);
  next.settleAfter([&] { EXPECT_TRUE(next->library().begin(data)); });
  EXPECT_EQ(recovered.count(), 1);
  EXPECT_DOUBLE_EQ(next->session().document().options().target.value, 61);
  EXPECT_TRUE(next->messages().isVisible());
  next.picture(QStringLiteral("session-8-recovered"));
}

}  // namespace
}  // namespace mocapress
