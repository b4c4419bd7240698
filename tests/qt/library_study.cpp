// SPDX-License-Identifier: GPL-3.0-or-later
// The time in which the studio takes a folder of many short clips into its library: pieces of 1 to
// 4 s, cut at random from the clips named, as BVH in folders of 100. Prints how long it takes until
// all are listed and until all have their picture, and for how long the window did not answer
// meanwhile: a timer that is due every few milliseconds tells. Then the list, with results that are
// made up for every row, is scrolled, filtered, sorted, grouped and selected: the longest of each
// kind is printed, with the picture that follows. At last clips are opened one after the other, and
// the memory that the program holds is printed on the way. Needs a screen, such as Xvfb's.
//
//   mocapress-library-study CLIP|FOLDER... [--clips 3000] [--seed 16] [--openings 2000]
#include <time.h>

#include <QApplication>
#include <QComboBox>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QLineEdit>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeView>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "app/studio/window/main_window.h"
#include "app/studio/window/theme.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/formats/motion_file.h"
#include "tests/bench/study_clips.h"
#include "widgets/models/library_columns.h"
#include "widgets/panels/library_panel.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr int kBeat = 5;        // ms
constexpr int kInFolder = 100;  // clips

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
    const std::filesystem::path below =
        std::filesystem::path(folder.toStdU16String()) / std::to_string(i / kInFolder);
    std::filesystem::create_directory(below);
    write_motion(below / (std::to_string(count + i) + ".bvh"), piece);
  }
}

/// Processor time of this thread: the clock would also count what else the machine does.
double processorMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e6;
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
    worked_ = processorMilliseconds();
    beat_.start(kBeat);
  }

  void print() {
    std::sort(pauses_.begin(), pauses_.end());
    std::printf(
        "{\"clips\":%d,\"listed_seconds\":%.2f,\"drawn_seconds\":%.2f,\"unreadable\":%d,"
        "\"longest_pause_ms\":%lld,\"pauses_above_50_ms\":%d,\"longest_processor_ms\":%.1f,"
        "\"above_50_processor_ms\":%d}\n",
        clips_, listed_, drawn_, troubled_, static_cast<long long>(pauses_.back()),
        static_cast<int>(
            std::count_if(pauses_.begin(), pauses_.end(), [](qint64 pause) { return pause > 50; })),
        longest_work_, long_works_);
    std::fflush(stdout);
  }

 private:
  void look() {
    pauses_.push_back(since_beat_.restart());
    const double worked = processorMilliseconds();
    longest_work_ = std::max(longest_work_, worked - worked_);
    long_works_ += worked - worked_ > 50 ? 1 : 0;
    worked_ = worked;
    const double now = static_cast<double>(since_start_.elapsed()) / 1000;
    if (model_.rowCount() < clips_) return;
    if (listed_ == 0) listed_ = now;
    for (; read_ < clips_; ++read_) {
      const LibraryEntry& entry = model_.entry(read_);
      if (entry.frames == 0 && entry.trouble.isEmpty()) return;
      troubled_ += entry.trouble.isEmpty() ? 0 : 1;
    }
    drawn_ = now;
    QApplication::exit();  // quit() closes the window
  }

  const LibraryModel& model_;
  const int clips_;
  QTimer beat_;
  QElapsedTimer since_start_;
  QElapsedTimer since_beat_;
  std::vector<qint64> pauses_;  // ms from one beat to the next
  double worked_ = 0;           // ms of processor time at the last beat
  double longest_work_ = 0;     // ms of processor time between two beats
  int long_works_ = 0;          // beats with more than 50 ms of work
  int read_ = 0;
  int troubled_ = 0;
  double listed_ = 0;  // seconds
  double drawn_ = 0;
};

/// A result for every row, as after a night of compressing.
std::map<int, LibraryEntry> madeUpResults(const LibraryModel& model, Random& random) {
  std::map<int, LibraryEntry> entries;
  for (int row = 0; row < model.rowCount(); ++row) {
    LibraryEntry entry = model.entry(row);
    const double eps_cm = 0.05 + random.unit();
    entry.outcome = Outcome{.ratio = 10 + 90 * random.unit(),
                            .eps_cm = eps_cm,
                            .max_cm = 4 * eps_cm,
                            .motion_bytes = 500 + random.below(20000),
                            .sight = static_cast<Sight>(random.below(3)),
                            .slide_cm = random.unit()};
    entry.review.verdict = static_cast<Verdict>(random.below(3));
    entries.emplace(row, entry);
  }
  return entries;
}

/// Does what a user does to the list, and measures each until its picture is drawn.
class ListWork {
 public:
  explicit ListWork(LibraryPanel& panel) : panel_(panel) {}

  void takeAllResults(LibraryModel& model) {
    Random random(1);
    const std::map<int, LibraryEntry> results = madeUpResults(model, random);
    time("all results", [&] { model.replace(results); });
  }

  void scroll() {
    QScrollBar* bar = panel_.view()->verticalScrollBar();
    constexpr int kSteps = 200;
    for (int step = 0; step <= kSteps; ++step)
      time("scroll", [&] { bar->setValue(bar->maximum() * step / kSteps); });
    bar->setValue(0);
  }

  void filter() {
    for (const char* words : {"0", "00", "001", "00", "0", "", "v", "vi", "vis", "visible", ""})
      time("filter", [&] { panel_.filter()->setText(QString::fromLatin1(words)); });
    for (int show = panel_.shownBox()->count() - 1; show >= 0; --show)
      time("filter", [&] { panel_.shownBox()->setCurrentIndex(show); });
  }

  void sort() {
    for (int column = 0; column < kLibraryColumns; ++column)
      for (const Qt::SortOrder order : {Qt::AscendingOrder, Qt::DescendingOrder})
        time("sort", [&] { panel_.view()->sortByColumn(column, order); });
    time("sort", [&] { panel_.view()->sortByColumn(-1, Qt::AscendingOrder); });
  }

  void group() {
    for (int grouping = panel_.groupingBox()->count() - 1; grouping >= 0; --grouping)
      time("group", [&] { panel_.groupingBox()->setCurrentIndex(grouping); });
  }

  void select() {
    time("select", [&] { panel_.view()->selectAll(); });
    time("select", [&] { panel_.view()->clearSelection(); });
  }

  /// One after the other, as results of a batch arrive.
  void takeResults(LibraryModel& model) {
    panel_.view()->sortByColumn(static_cast<int>(LibraryColumn::Ratio), Qt::AscendingOrder);
    for (int row = 0; row < std::min(model.rowCount(), 50); ++row)
      time("result", [&] {
        LibraryEntry entry = model.entry(row);
        entry.outcome->ratio = 110 - entry.outcome->ratio;
        model.setEntry(entry);
      });
    panel_.view()->sortByColumn(-1, Qt::AscendingOrder);
  }

  void print() const {
    for (const auto& [kind, longest] : longest_)
      std::printf("{\"work\":\"%s\",\"longest_ms\":%.1f,\"longest_processor_ms\":%.1f}\n",
                  kind.c_str(), longest.first, longest.second);
    std::fflush(stdout);
  }

 private:
  template <typename Act>
  void time(const char* kind, Act act) {
    QElapsedTimer clock;
    clock.start();
    const double before = processorMilliseconds();
    act();
    panel_.view()->viewport()->repaint();
    QApplication::processEvents();
    const double took = static_cast<double>(clock.nsecsElapsed()) / 1e6;
    auto& [longest, longest_worked] = longest_[kind];
    longest = std::max(longest, took);
    longest_worked = std::max(longest_worked, processorMilliseconds() - before);
  }

  LibraryPanel& panel_;
  std::map<std::string, std::pair<double, double>> longest_;  // ms by the clock, of this thread
};

double heldMegabytes() {
  std::ifstream statm("/proc/self/statm");
  long pages = 0, resident = 0;
  statm >> pages >> resident;
  return static_cast<double>(resident) * 4096 / 1e6;
}

/// Opens clips in turn, each as soon as the one before is there.
void openAll(MainWindow& window, int openings) {
  constexpr int kTold = 10;  // times
  Library& library = window.library();
  for (int i = 0; i < openings; ++i) {
    const int row = i % static_cast<int>(library.project().clips.size());
    QEventLoop until_open;
    QObject::connect(&window.session(), &Session::opened, &until_open, &QEventLoop::quit);
    library.openClip(row);
    until_open.exec();
    if ((i + 1) % std::max(openings / kTold, 1) == 0)
      std::printf("{\"openings\":%d,\"held_mb\":%.0f}\n", i + 1, heldMegabytes());
    std::fflush(stdout);
  }
}

int run(int argc, char** argv) {
  prepareViewport();
  QApplication application(argc, argv);
  QApplication::setStyle(new StudioStyle);
  QCommandLineParser parser;
  parser.addOption({QStringLiteral("clips"), {}, QStringLiteral("N"), QStringLiteral("3000")});
  parser.addOption({QStringLiteral("seed"), {}, QStringLiteral("N"), QStringLiteral("16")});
  parser.addOption({QStringLiteral("openings"), {}, QStringLiteral("N"), QStringLiteral("0")});
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
  LibraryPanel& panel = *window.findChild<LibraryPanel*>();
  ListWork work(panel);
  work.takeAllResults(*window.findChild<LibraryModel*>());
  work.scroll();
  work.filter();
  work.sort();
  work.group();
  work.select();
  work.takeResults(*window.findChild<LibraryModel*>());
  work.print();
  openAll(window, parser.value(QStringLiteral("openings")).toInt());
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
