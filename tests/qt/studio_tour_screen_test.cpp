// SPDX-License-Identifier: GPL-3.0-or-later
// A working session in the real window, with a picture of each step in the build folder. Needs an X
// display with OpenGL (Xvfb will do).
#include <gtest/gtest.h>

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QTranslator>
#include <QTreeView>
#include <cstdio>
#include <filesystem>
#include <set>

#include "app/studio/batch_memory.h"
#include "app/studio/batch_window.h"
#include "app/studio/help.h"
#include "app/studio/main_window.h"
#include "app/studio/sample_clip.h"
#include "app/studio/screenshot.h"
#include "core/formats/motion_file.h"
#include "widgets/models/batch_queue_model.h"
#include "widgets/models/library_tree.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/preset_chooser.h"
#include "widgets/panels/preset_editor.h"
#include "widgets/panels/target_control.h"
#include "widgets/timeline/contact_strip.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr int kPatience = 60'000;  // ms

// Each picture is kept at the guide's width too. In resources/guide compare.png is view-wipe,
// inspect session-3-heat-map, curve session-3-rate-distortion and pinned pinned-side-by-side; the
// README's studio.png is library.
constexpr int kGuideWidth = 900;

QString picturePath(const QString& name) {
  const QDir folder(QStringLiteral(MOCAPRESS_BINARY_DIR "/pictures"));
  folder.mkpath(QStringLiteral("guide"));
  return folder.filePath(name + QStringLiteral(".png"));
}

int differing(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y);
  return count;
}

/// How many colours there are to see: of an empty or grey area hardly any.
std::size_t coloursIn(const QImage& picture, const QRect& area) {
  std::set<QRgb> colours;
  for (int y = area.top(); y < area.bottom(); y += 2)
    for (int x = area.left(); x < area.right(); x += 2) colours.insert(picture.pixel(x, y));
  return colours.size();
}

/// Of about that hue, whatever the light.
int pixelsNear(const QImage& picture, const QRect& area, const QColor& colour) {
  int count = 0;
  for (int y = area.top(); y < area.bottom(); ++y)
    for (int x = area.left(); x < area.right(); ++x) {
      const QColor seen = picture.pixelColor(x, y);
      const int away = std::abs(seen.hsvHue() - colour.hsvHue());
      count += seen.hsvSaturation() > 100 && std::min(away, 360 - away) < 8;
    }
  return count;
}

/// A window at work.
class Studio {
 public:
  Studio() {
    window_.resize(1440, 900);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }

  MainWindow* operator->() { return &window_; }

  template <typename Act>
  void settleAfter(Act act) {
    QSignalSpy settled(&window_.session(), &Session::settled);
    act();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.session().busy(); }, kPatience));
  }

  void open(const QString& path) {
    settleAfter([&] { window_.files().open(path); });
  }

  /// Once the 3D view has drawn what was done last.
  QImage picture(const QString& name) {
    QSignalSpy captured(window_.views().viewport, &Viewport::captured);
    window_.views().viewport->capture();
    EXPECT_TRUE(captured.count() > 0 || captured.wait(kPatience));
    QTest::qWait(150);
    EXPECT_TRUE(writeScreenshot(window_, picturePath(name)));
    QImage picture(picturePath(name));
    // As the guide takes it.
    picture.scaledToWidth(kGuideWidth, Qt::SmoothTransformation)
        .save(picturePath(QStringLiteral("guide/") + name));
    return picture;
  }

  QRect areaOf(const QWidget* widget) {
    return {widget->mapTo(&window_, QPoint()), widget->size()};
  }

 private:
  MainWindow window_;
};

class StudioTour : public testing::Test {
 protected:
  StudioTour() {
    QSettings().clear();
    // English has plural forms too: the pictures are to be shown.
    EXPECT_TRUE(english_.load(QStringLiteral(":/i18n/mocapress_en.qm")));
    QCoreApplication::installTranslator(&english_);
  }
  ~StudioTour() override {
    QCoreApplication::removeTranslator(&english_);
    QSettings().clear();
  }
  QTranslator english_;
  QTemporaryDir directory_;
};

TEST_F(StudioTour, SeesTheSampleInEveryWay) {
  Studio studio;
  studio.open(sampleClip());
  studio->playback().seek(studio->session().document().decoded()->distortion->max.frame);
  const ViewActions& view = studio->actions().view;
  QImage before = studio.picture(QStringLiteral("view-overlay"));
  const auto looksDifferent = [&](QAction* action, const char* name) {
    action->trigger();
    const QImage now = studio.picture(QString::fromLatin1(name));
    EXPECT_GT(differing(before, now), 500) << name;
    before = now;
  };
  looksDifferent(view.by_error, "view-by-error");
  looksDifferent(view.mode[1], "view-side-by-side");
  looksDifferent(view.path, "view-path");
  view.path->trigger();
  looksDifferent(view.trail, "view-trail");
  looksDifferent(view.trail_poses->actions().at(2), "view-trail-long");
  view.trail->trigger();
  looksDifferent(view.mode[2], "view-wipe");
  looksDifferent(view.swap, "view-wipe-swapped");
  looksDifferent(view.floor, "view-floor");
}

TEST_F(StudioTour, PinsFourResultsAndSeesThemInEveryWay) {
  Studio studio;
  studio.open(sampleClip());
  QDockWidget* dock = studio->findChild<QDockWidget*>(QStringLiteral("pinned"));
  ASSERT_TRUE(dock);
  dock->raise();
  TargetControl* target = studio->views().compression->target();
  for (const int position : {300, 600, 800, 950}) {
    studio.settleAfter([&] { target->slider()->setValue(position); });
    studio->actions().pin->trigger();
  }
  EXPECT_FALSE(studio->actions().pin->isEnabled());
  studio.settleAfter([&] { target->slider()->setValue(500); });
  const auto& worst = studio->session().document().decoded()->distortion->max;
  studio->playback().seek(worst.frame);
  const QImage overlay = studio.picture(QStringLiteral("pinned-overlay"));
  studio->actions().view.mode[1]->trigger();
  const QImage sides = studio.picture(QStringLiteral("pinned-side-by-side"));
  EXPECT_GT(differing(overlay, sides), 5000);
  const QRect area = studio.areaOf(studio->views().viewport);
  for (const PinnedFigure& pinned : studio->views().viewport->pinned())
    for (const QImage* picture : {&overlay, &sides})
      EXPECT_GT(pixelsNear(*picture, area, pinned.colour), 30)
          << qPrintable(pinned.title.join(QLatin1Char(' ')));
}

TEST_F(StudioTour, TheGhostTrailFollowsWhileItPlays) {
  Studio studio;
  studio.open(sampleClip());
  QSignalSpy frames(&studio->playback(), &Playback::frameChanged);
  const auto play = [&](const char* what) {
    frames.clear();
    QElapsedTimer clock;
    clock.start();
    studio->actions().transport.play->trigger();
    QTest::qWait(1000);
    studio->actions().transport.play->trigger();
    const double played = 1e3 * double(frames.count()) / double(clock.elapsed());
    constexpr int kSteps = 100;
    clock.restart();
    for (int frame = 0; frame < kSteps; ++frame) studio->views().viewport->setFrame(frame);
    std::printf("%s: %.0f pictures a second by software, %.2f ms of the GUI thread each\n", what,
                played, double(clock.elapsed()) / kSteps);
    EXPECT_GT(frames.count(), 5);
  };
  play("without a trail");
  studio->actions().view.trail->trigger();
  studio->actions().view.trail_poses->actions().at(2)->trigger();
  play("with 8 + 8 poses");
}

TEST_F(StudioTour, TheWipeWorksWhileItPlays) {
  Studio studio;
  studio.open(sampleClip());
  studio->actions().view.mode[2]->trigger();
  studio->actions().transport.play->trigger();
  QSignalSpy frames(&studio->playback(), &Playback::frameChanged);
  QWindow* scene = nullptr;
  for (QWindow* window : QGuiApplication::allWindows())
    if (window->inherits("mocapress::Scene")) scene = window;
  ASSERT_TRUE(scene);
  const int middle = scene->width() / 2;
  QTest::mousePress(scene, Qt::LeftButton, {}, {middle, 100});
  for (int x = middle; x > middle / 2; x -= 10) {
    QTest::mouseMove(scene, {x, 100});
    QTest::qWait(10);
  }
  QTest::mouseRelease(scene, Qt::LeftButton, {}, {middle / 2, 100});
  EXPECT_TRUE(studio->playback().playing());
  EXPECT_GT(frames.count(), 5);
  EXPECT_NEAR(studio->views().viewport->options().divider, 0.25, 0.03);
}

TEST_F(StudioTour, DarkThemeIsDarkEverywhere) {
  Studio studio;
  studio.open(sampleClip());
  studio->actions().themes->actions().at(2)->trigger();
  const QImage dark = studio.picture(QStringLiteral("theme-dark"));
  studio->actions().themes->actions().at(1)->trigger();
  const QImage light = studio.picture(QStringLiteral("theme-light"));
  for (const QPoint& place :
       {QPoint(20, 60), QPoint(700, 12), QPoint(1300, 65), QPoint(900, 300)}) {
    EXPECT_LT(qGray(dark.pixel(place)), 100) << place.x();
    EXPECT_GT(qGray(light.pixel(place)), 150) << place.x();
  }
}

TEST_F(StudioTour, HelpShowsAnIllustratedGuideAndEveryKey) {
  Studio studio;
  const auto shown = [&](QAction* action) {
    action->trigger();
    auto* window = studio->findChildren<HelpWindow*>().last();
    return window->findChild<QTextBrowser*>();
  };
  QTextBrowser* guide = shown(studio->actions().guide);
  EXPECT_GT(guide->toPlainText().size(), 1000);
  EXPECT_GE(guide->toHtml().count(QStringLiteral("<img")), 4);
  for (const char* picture : {"compare", "inspect", "curve", "pinned"})
    EXPECT_GT(QImage(QStringLiteral(":/guide/%1.png").arg(QLatin1String(picture))).width(), 400);
  const QString keys = shown(studio->actions().shortcuts)->toPlainText();
  for (const QAction* action : studio->findChildren<QAction*>()) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    EXPECT_TRUE(keys.contains(key)) << qPrintable(action->text());
  }
}

/// The bundled samples and parts of them, as a game's folder may have them.
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
  studio->library().begin(directory_.filePath(QStringLiteral("data/session.mocapress")));
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(game)});
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(studio.operator->(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(studio.operator->(), &drop);
  LibraryPanel& panel = studio->libraryPanel();
  LibraryTree& tree = *panel.tree();
  const auto& clips = studio->library().project().clips;
  ASSERT_TRUE(QTest::qWaitFor([&] { return clips.size() == 9; }, kPatience));
  ASSERT_EQ(tree.rowCount(), 2) << "jumps, locomotion";
  const auto tune = [&](int row, double ratio) {
    studio.settleAfter([&] { panel.view()->setCurrentIndex(tree.indexOf(row)); });
    EncodeOptions options = studio->session().document().options();
    // A clip begins with the settings of the one before it.
    if (options.target.kind == Target::Kind::Ratio && options.target.value == ratio) return;
    options.method = Method::ClosedLoop;
    options.target = {Target::Kind::Ratio, ratio};
    studio.settleAfter([&] { studio->session().setOptions(options); });
  };
  for (int row = 0; row < 9; ++row) tune(row, row % 3 == 2 ? 90 : 60);
  studio->library().setVerdict(0, Verdict::Approved);
  tune(6, 120);  // a walk
  studio->actions().view.by_error->trigger();
  studio->actions().view.trail->trigger();
  studio->actions().view.trail_poses->actions().front()->trigger();
  studio->playback().seek(300);
  studio->actions().view.reset_camera->trigger();
  studio->findChild<QDockWidget*>(QStringLiteral("heat-map"))->raise();
  QTest::qWait(300);
  const QImage all = studio.picture(QStringLiteral("library"));
  EXPECT_GT(coloursIn(all, studio.areaOf(panel.view())), 12u);
  panel.view()->collapse(tree.indexOf(0).parent());
  panel.filter()->setText(QStringLiteral("approved"));
  EXPECT_EQ(tree.rowCount(), 1);
  EXPECT_GT(differing(all, studio.picture(QStringLiteral("library-approved"))), 3000);
}

/// The 15 study clips, through the real window.
void batch(Studio& studio) {
  const QString folder = QStringLiteral(MOCAPRESS_SOURCE_DIR "/../shared/corpus/study");
  if (!QFile::exists(folder)) {
    std::printf("batch left out: %s is not here\n", qPrintable(folder));
    return;
  }
  QFile::remove(batchMemory());
  const QTemporaryDir out;
  studio->actions().batch->trigger();
  auto* window = studio->findChild<BatchWindow*>();
  auto* session = studio->findChild<BatchSession*>();
  ASSERT_TRUE(window && QTest::qWaitForWindowExposed(window));
  session->addClips({folder});
  BatchQueueModel& queue = *session->queue();
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
  QTest::qWait(100);
  EXPECT_TRUE(writeScreenshot(*window, picturePath(QStringLiteral("session-6-batch"))));
  const QImage picture(picturePath(QStringLiteral("session-6-batch")));
  EXPECT_GT(coloursIn(picture, picture.rect()), 60u);
  window->close();
  QFile::remove(batchMemory());
}

/// The whole of it, as an artist would do it.
TEST_F(StudioTour, OpensTunesInspectsEditsComparesUndoesSavesAndIsRecovered) {
  const QString session = directory_.filePath(QStringLiteral("data/session.mocapress"));
  const QString project = directory_.filePath(QStringLiteral("walks.mocapress"));
  std::vector<ContactSpan> edited;
  {
    Studio studio;
    studio->library().begin(session);
    Document& document = studio->session().document();

    studio.open(sampleClip());
    const QImage opened = studio.picture(QStringLiteral("session-1-open"));
    EXPECT_GT(coloursIn(opened, studio.areaOf(studio->views().viewport)), 500u);
    EXPECT_GT(coloursIn(opened, studio.areaOf(studio->inspection().timeline)), 12u);

    QSlider* slider = studio->views().compression->target()->slider();
    studio.settleAfter([&] {
      for (int position = slider->value(); position < 600; position += 25) {
        slider->setValue(position);
        QTest::qWait(5);
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
      QTest::qWait(id == std::string("rate-distortion") ? 2500 : 100);
      const QImage picture = studio.picture(QStringLiteral("session-3-") + QString::fromLatin1(id));
      EXPECT_TRUE(dock->widget()->isVisible());
      EXPECT_GT(coloursIn(picture, studio.areaOf(dock->widget())), 12u) << id;
    }

    ContactStrip* contacts = studio->inspection().timeline->contacts();
    const std::vector<ContactSpan> found = document.contacts();
    ASSERT_GT(found.size(), 1u);
    const TimeAxis axis{2.0 * kStripMargin + contacts->labelWidth(),
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
    EXPECT_EQ(studio->session().tuning().active, 1);
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
  studio.settleAfter([&] { studio->library().openProject(project); });
  EXPECT_EQ(studio->session().document().contacts(), edited);
  EXPECT_EQ(studio->libraryPanel().note()->text(), QStringLiteral("heel of frame 40"));
  const QImage again = studio.picture(QStringLiteral("session-7-again"));
  EXPECT_GT(coloursIn(again, studio.areaOf(studio->views().viewport)), 500u);
}

/// The program itself, killed.
TEST_F(StudioTour, IsThereAgainAfterAKill) {
  const QString program = QStringLiteral(MOCAPRESS_BINARY_DIR "/app/studio/mocapress-studio");
  if (!QFile::exists(program)) GTEST_SKIP() << "mocapress-studio is not built";
  const QString file = directory_.filePath(QStringLiteral("mocapress/Mocapress/session.mocapress"));
  QProcess studio;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("XDG_DATA_HOME"), directory_.path());
  environment.insert(QStringLiteral("XDG_CONFIG_HOME"), directory_.path());
  studio.setProcessEnvironment(environment);
  studio.start(program, {QStringLiteral("--ratio"), QStringLiteral("61"), sampleClip()});
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        QFile written(file);
        return written.open(QIODevice::ReadOnly) && written.readAll().contains("outcome");
      },
      kPatience));
  studio.kill();
  ASSERT_TRUE(studio.waitForFinished(kPatience));

  Studio next;
  QSignalSpy recovered(&next->library(), &Library::recovered);
  next.settleAfter([&] { EXPECT_TRUE(next->library().begin(file)); });
  EXPECT_EQ(recovered.count(), 1);
  EXPECT_DOUBLE_EQ(next->session().document().options().target.value, 61);
  EXPECT_TRUE(next->messages().isVisible());
  next.picture(QStringLiteral("session-8-recovered"));
}

}  // namespace
}  // namespace mocapress
