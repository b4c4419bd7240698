// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QLocale>
#include <QStandardPaths>

#include <QTimer>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>

#include "app/studio/library/clip_links.h"
#include "app/studio/library/foreign_lock.h"
#include "app/studio/library/project.h"
#include "app/studio/window/language.h"
#include "app/studio/window/launch_options.h"
#include "app/studio/window/link_receiver.h"
#include "app/studio/window/main_window.h"
#include "app/studio/window/screenshot.h"
#include "app/studio/window/theme.h"
#include "app/studio/window/trace.h"
#include "core/base/kept_memory.h"
#include "core/base/memory_limit.h"
#include "core/baselines/rivals.h"
#include "translations/install.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr auto kSettleTime = std::chrono::milliseconds(1500);  // gives the 3D view time to draw
constexpr int kBadInput = 3;
constexpr int kCannotWrite = 5;

/// The frame with the largest error, or the middle one.
int tellingFrame(MainWindow& window, const Session& session) {
  const DecodedPtr& decoded = session.document().decoded();
  return decoded->distortion ? decoded->distortion->max.frame : window.playback().frames() / 2;
}

/// Takes the screenshot once everything is computed and drawn.
void screenshotAndQuit(MainWindow& window, const QString& path) {
  Session* session = &window.session();
  QObject::connect(session, &Session::settled, &window, [&window, session, path] {
    window.playback().seek(tellingFrame(window, *session));
    window.views().viewport->resetCamera();
    QTimer::singleShot(kSettleTime, &window, [&window, path] {
      QCoreApplication::exit(writeScreenshot(window, path) ? 0 : kCannotWrite);
    });
  });
  const auto give_up = [](const QString& message) {
    std::fprintf(stderr, "%s\n", qPrintable(message));
    QTimer::singleShot(0, [] { QCoreApplication::exit(kBadInput); });  // needs the event loop
  };
  QObject::connect(session, &Session::openFailed, &window,
                   [=](const OpenRequest&, const QString& message) { give_up(message); });
  QObject::connect(session, &Session::compressFailed, &window, give_up);
  QObject::connect(&window.library(), &Library::failed, &window, give_up);
  QObject::connect(&window.library(), &Library::inUse, &window,
                   [=](const QString& project) { give_up(whereOpen(project)); });
  QObject::connect(&window.library(), &Library::projectChanged, &window, [=, &window] {
    if (window.library().currentRow() < 0)
      give_up(window.library().path() + QStringLiteral(": no clip of it is open"));
  });
}

void nameProgram() {
  QCoreApplication::setOrganizationName(QStringLiteral("mocapress"));
  QCoreApplication::setApplicationName(QStringLiteral("Mocapress"));
  QCoreApplication::setApplicationVersion(QStringLiteral(MOCAPRESS_VERSION));
}

/// Sets the language of texts and numbers from here on.
void setLanguage(QCoreApplication& application) {
  const QString chosen = chosenLanguage();
  QLocale::setDefault(chosen.isEmpty() ? QLocale::system() : QLocale(chosen));
  installTranslations(application);
}

/// Answers --help and --version without needing a display.
void say(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  nameProgram();
  setLanguage(application);
  parseLaunchOptions(application);
}

/// From now on, this window opens the links that the user follows.
void receiveLinks(MainWindow& window) {
  auto* receiver = new LinkReceiver(&window);
  QObject::connect(receiver, &LinkReceiver::received, &window, [&window](const QString& link) {
    window.open({link}, {});
    window.setWindowState(window.windowState() & ~Qt::WindowMinimized);
    window.raise();
    window.activateWindow();
  });
}

/// The exit code of the event loop, and the state that the window hands on.
struct Ended {
  int code = 0;
  WindowState state;
};

Ended showFirst(Work& work, const LaunchOptions& options) {
  MainWindow window(&work);
  window.trace().setWriting(options.trace);
  if (!options.screenshot.isEmpty()) screenshotAndQuit(window, options.screenshot);
  EncodeSettings encode = window.session().document().options();
  if (options.ratio) encode.target = {Target::Kind::Ratio, *options.ratio};
  if (options.ik) encode.correction = EncodeCorrection{.ratio = options.ik};
  if (options.ratio || options.ik) window.session().document().setOptions(encode);
  window.show();
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  const bool names_project = std::any_of(options.files.begin(), options.files.end(), isProjectFile);
  bool goes_on = false;
  if (options.screenshot.isEmpty()) {
    if (names_project)
      window.library().beginEmpty(data);
    else
      goes_on = window.library().begin(data);
    receiveLinks(window);
  }
  if (!options.files.isEmpty())
    window.open(options.files, options.skeleton);
  else if (!goes_on || window.library().isOutOfReach())
    window.files().openFirst();
  const int code = QApplication::exec();
  return {code, window.state()};
}

/// Shows the same work in a new window, in the language chosen meanwhile.
Ended showAgain(Work& work, const WindowState& before) {
  MainWindow window(&work);
  window.takeOver(before);
  receiveLinks(window);
  window.show();
  const int code = QApplication::exec();
  return {code, window.state()};
}

int run(int argc, char** argv) {
  if (asksForWords({argv + 1, argv + argc})) say(argc, argv);
  prepareViewport();
  QApplication application(argc, argv);
  nameProgram();
  QGuiApplication::setDesktopFileName(QStringLiteral("org.mocapress.Studio"));
  QApplication::setStyle(new StudioStyle);
  setLanguage(application);
  const LaunchOptions options = parseLaunchOptions(application);
  const bool is_link = options.files.size() == 1 && ClipLinks::isLink(options.files.front());
  if (is_link && options.screenshot.isEmpty() && handOver(options.files.front())) return 0;
  Work work;
  Ended ended = showFirst(work, options);
  while (ended.code == kOtherLanguage) {
    setLanguage(application);
    ended = showAgain(work, ended.state);
  }
  return ended.code;
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  mocapress::keep_freed_memory();
  mocapress::add_rivals();
  mocapress::set_memory_limit(mocapress::half_of_the_memory());
  try {
    return mocapress::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-studio: %s\n", error.what());
    return 1;
  }
}
