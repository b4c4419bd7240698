// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the loading of a folder with many short clips into the library: BVH pieces of 1 to 4 s,
// cut at random from the named clips. Prints the times until all are listed and until all have
// their picture, and the longest time that the window did not respond, measured by a timer of a few
// milliseconds. Needs a screen, such as Xvfb's.
//
//   mocapress-library-study CLIP|FOLDER... [--clips 3000] [--seed 16]
#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <vector>

#include "app/studio/window/main_window.h"
#include "app/studio/window/theme.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/formats/motion_file.h"
#include "tests/bench/study_clips.h"
#include "widgets/models/library_model.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr int kBeat = 5;  // ms

void cutClips(const QStringList& sources, int count, unsigned seed, const QString& folder) {
  std::vector<Motion> motions;
  for (const QString& source : sources)
    for (const std::filesystem::path& path : clips_of(source.toStdU16String()))
      motions.push_back(read_motion(path).motion);
  if (motions.empty()) throw Error("no clips to cut from");
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const Motion& from = motions[random.below(motions.size())];
    const int whole = from.clip.frames();
    const int wanted = static_cast<int>((1 + 3 * random.unit()) * from.clip.sample_rate_hz);
    const int frames = std::min(wanted, whole);
    const int first = static_cast<int>(random.unit() * (whole - frames));
    const Motion piece{from.skeleton,
                       {from.clip.sample_rate_hz, from.clip.channels.middleRows(first, frames)}};
    write_motion(
        QStringLiteral("%1/%2.bvh").arg(folder).arg(i, 5, 10, QLatin1Char('0')).toStdU16String(),
        piece);
  }
}

/// Quits the application once all clips have a picture.
class Watch : public QObject {
 public:
  Watch(const LibraryModel& model, int clips) : model_(model), clips_(clips) {
    beat_.setTimerType(Qt::PreciseTimer);
    connect(&beat_, &QTimer::timeout, this, [this] { look(); });
  }

  void start() {
    since_start_.start();
    since_beat_.start();
    beat_.start(kBeat);
  }

  void print() {
    std::sort(pauses_.begin(), pauses_.end());
    std::printf(
        "{\"clips\":%d,\"listed_seconds\":%.2f,\"drawn_seconds\":%.2f,\"unreadable\":%d,"
        "\"longest_pause_ms\":%lld,\"pauses_above_100_ms\":%d}\n",
        clips_, listed_, drawn_, troubled_, static_cast<long long>(pauses_.back()),
        static_cast<int>(std::count_if(pauses_.begin(), pauses_.end(),
                                       [](qint64 pause) { return pause > 100; })));
  }

 private:
  void look() {
    pauses_.push_back(since_beat_.restart());
    const double now = static_cast<double>(since_start_.elapsed()) / 1000;
    if (model_.rowCount() < clips_) return;
    if (listed_ == 0) listed_ = now;
    for (; read_ < clips_; ++read_) {
      const LibraryEntry& entry = model_.entry(read_);
      if (entry.frames == 0 && entry.trouble.isEmpty()) return;
      troubled_ += entry.trouble.isEmpty() ? 0 : 1;
    }
    drawn_ = now;
    QApplication::quit();
  }

  const LibraryModel& model_;
  const int clips_;
  QTimer beat_;
  QElapsedTimer since_start_;
  QElapsedTimer since_beat_;
  std::vector<qint64> pauses_;  // ms from one beat to the next
  int read_ = 0;
  int troubled_ = 0;
  double listed_ = 0;  // seconds
  double drawn_ = 0;
};

int run(int argc, char** argv) {
  prepareViewport();
  QApplication application(argc, argv);
  QApplication::setStyle(new StudioStyle);
  QCommandLineParser parser;
  parser.addOption({QStringLiteral("clips"), {}, QStringLiteral("N"), QStringLiteral("3000")});
  parser.addOption({QStringLiteral("seed"), {}, QStringLiteral("N"), QStringLiteral("16")});
  parser.process(application);
  const QTemporaryDir clips;
  const QTemporaryDir data;
  const int count = parser.value(QStringLiteral("clips")).toInt();
  cutClips(parser.positionalArguments(), count, parser.value(QStringLiteral("seed")).toUInt(),
           clips.path());
  MainWindow window;
  window.show();
  window.library().beginEmpty(data.path());
  Watch watch(*window.findChild<LibraryModel*>(), count);
  QTimer::singleShot(2000, &window, [&] {  // by then the window has been drawn
    watch.start();
    window.library().addFolder(clips.path());
  });
  QApplication::exec();
  watch.print();
  return 0;
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  try {
    return mocapress::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-library-study: %s\n", error.what());
    return 1;
  }
}
