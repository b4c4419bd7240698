// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the losses when the studio is killed. Its window is used at random (see
// studio_at_random.cpp), killed at a random instant and started again; the state found by the next
// start is compared with the journal of all actions. Exit status 0: only edits of the last seconds
// were lost, the project in use was found, and no other project lost anything.
//
//   mocapress-kill-study [--kills 100] [--seed N] [--within 2] [--window-time]
//
// --within: seconds of edits that a kill may lose. --window-time: counts only time in which the
// window ran, for machines so loaded that it may stall.
#include <unistd.h>

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <map>
#include <optional>
#include <random>
#include <string_view>
#include <vector>

#include "app/studio/library/project.h"
#include "core/base/error.h"
#include "core/formats/motion_file.h"
#include "tests/qt/studio_at_random.h"
#include "tests/support/test_motion.h"

namespace mocapress::test {
namespace {

constexpr int kClips = 8;
constexpr int kFrames = 120;
constexpr int kLongestRun = 6000;       // ms from the start of the window to its kill
constexpr int kLongestStart = 120'000;  // ms
constexpr int kKillsAtStart = 10;       // share of kills during the start: one in this many

const QDir kRoot(QStringLiteral("/"));

/// A project's state at an instant.
struct State {
  qint64 t = 0;  // ms
  QString path;
  QByteArray text;  // as read and written again
  bool operator==(const State& other) const { return path == other.path && text == other.text; }
};

/// Actions of one process until its kill.
struct Run {
  std::vector<State> states;  // the first is the state found at the start
  std::size_t saved = 0;      // index of the last state reported as saved
  QString title;              // title at the start
  std::vector<qint64> beats;
  std::map<QString, QByteArray> left;  // other projects, as they were left
  std::optional<State> intended;       // project to which it was about to switch
  bool naming = false;                 // the switch gives the project a name
};

QByteArray readAgain(const QByteArray& text) {
  return projectText(parseProject(text, kRoot), kRoot);
}

bool isUnnamed(const QString& path) {
  return path.contains(QStringLiteral("/data/projects/"));
}

bool isEmpty(const State& state) {
  return parseProject(state.text, kRoot).clips.empty();
}

std::vector<QJsonObject> readJournal(const QString& path) {
  std::vector<QJsonObject> records;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return records;
  for (const QByteArray& line : file.readAll().split('\n'))
    if (const QJsonObject record = QJsonDocument::fromJson(line).object(); !record.isEmpty())
      records.push_back(record);
  return records;
}

/// Reads the run's journal; unset if it was killed before it found a project. `left`: projects left
/// earlier.
std::optional<Run> runOf(const QString& path, const std::map<QString, QByteArray>& left) {
  Run run;
  run.left = left;
  for (const QJsonObject& record : readJournal(path)) {
    const QString what = record[QStringLiteral("what")].toString();
    const auto t = static_cast<qint64>(record[QStringLiteral("t")].toDouble());
    const QString file = record[QStringLiteral("path")].toString();
    const auto is = [&](const char* word) { return what == QLatin1String(word); };
    if (is(journal::kBeat)) {
      run.beats.push_back(t);
    } else if (is(journal::kSaved)) {
      if (!run.states.empty()) run.saved = run.states.size() - 1;
    } else if (is(journal::kNew) || is(journal::kOpen) || is(journal::kSaveAs)) {
      run.naming = is(journal::kSaveAs);
      const auto known = run.left.find(file);
      run.intended = State{t, file, known == run.left.end() ? QByteArray() : known->second};
      if (is(journal::kNew)) run.intended->text = projectText({}, kRoot);
      if (is(journal::kSaveAs)) run.intended->text = run.states.back().text;
    } else {
      if (run.states.empty()) {
        run.title = record[QStringLiteral("title")].toString();
      } else if (const State& before = run.states.back(); before.path != file) {
        const bool is_gone = isEmpty(before) || run.naming;
        if (!isUnnamed(before.path) || !is_gone) run.left[before.path] = before.text;
      }
      run.left.erase(file);
      run.states.push_back(
          {t, file, readAgain(record[QStringLiteral("text")].toString().toUtf8())});
      run.intended.reset();
      run.naming = false;
    }
  }
  return run.states.empty() ? std::nullopt : std::optional(run);
}

/// The time that the window ran between two instants, as it may stall on a loaded machine.
qint64 windowTime(const Run& run, qint64 from, qint64 to) {
  qint64 time = 0;
  qint64 before = from;
  for (const qint64 beat : run.beats) {
    if (beat <= from || beat > to) continue;
    time += std::min<qint64>(beat - before, 2 * kBeatTime);
    before = beat;
  }
  return time;
}

class Study {
 public:
  Study(QString folder, unsigned seed, int within_ms, bool window_time)
      : folder_(std::move(folder)),
        journal_(QDir(folder_).filePath(QStringLiteral("journal.jsonl"))),
        random_(seed),
        within_(within_ms),
        window_time_(window_time) {
    for (const char* below : {"clips", "data", "named"})
      QDir(folder_).mkpath(QString::fromLatin1(below));
    for (int i = 0; i < kClips; ++i)
      write_motion(QStringLiteral("%1/clips/%2.bvh").arg(folder_).arg(i).toStdU16String(),
                   smooth_motion(kFrames, static_cast<unsigned>(i)));
  }

  /// Starts the studio, uses it and kills it. False: the state found differs from the one left.
  bool kill(int number) {
    QFile::remove(journal_);
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start(QCoreApplication::applicationFilePath(),
                  {QStringLiteral("--child"), folder_, QString::number(random_())});
    if (!process.waitForStarted()) return fail("cannot be started");
    const bool at_start = std::uniform_int_distribution(0, kKillsAtStart - 1)(random_) == 0;
    if (!at_start && !waitForStart(process)) return fail("did not start");
    QThread::msleep(std::uniform_int_distribution<unsigned long>(0, kLongestRun)(random_));
    if (process.state() != QProcess::Running) return fail("ended by itself");
    const qint64 killed = millisecondsNow();
    ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
    process.waitForFinished(-1);

    std::optional<Run> run = runOf(journal_, {});
    if (!run) return true;  // killed before it found anything
    if (last_) {
      if (!isAsLeft(*run)) return false;
      run = runOf(journal_, last_->left);
    }
    std::printf("kill %d: %zu states, %zu projects\n", number, run->states.size(),
                run->left.size() + 1);
    std::fflush(stdout);
    states_ += run->states.size();
    killed_ = killed;
    last_ = std::move(run);
    return keepsOthers();
  }

  void report(int kills) const {
    std::printf(
        "%d kills, %zu states: the oldest edit that was lost was made %.2f s before its kill\n",
        kills, states_, static_cast<double>(oldest_lost_) / 1e3);
  }

 private:
  bool waitForStart(const QProcess& process) const {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < kLongestStart) {
      if (QFile file(journal_); file.open(QIODevice::ReadOnly) && file.readLine().endsWith('\n'))
        return true;
      if (process.state() != QProcess::Running) return false;
      QThread::msleep(10);
    }
    return false;
  }

  bool fail(const char* what) const {
    std::fprintf(stderr, "The studio %s.\n", what);
    return false;
  }

  /// Compares the state found by a start with the actions of the process before it.
  bool isAsLeft(const Run& next) {
    const State& found = next.states.front();
    const QString name = isUnnamed(found.path) ? QStringLiteral("Unnamed Project")
                                               : QFileInfo(found.path).completeBaseName();
    if (!next.title.contains(name))
      return disagree("its title does not name the project", found, last_->states.back());
    return isInUse(found);
  }

  /// Checks that other projects' files are as they were left.
  bool keepsOthers() const {
    for (const auto& [path, text] : last_->left) try {
        const QByteArray now = projectText(readProject(path), kRoot);
        if (now != text)
          return disagree("a project that was left is another", {0, path, now}, {0, path, text});
      } catch (const Error& error) {
        return disagree(error.what(), {}, {0, path, text});
      }
    return true;
  }

  bool isInUse(const State& found) {
    const std::vector<State>& states = last_->states;
    if (const auto& intended = last_->intended) {
      const bool is_it = (intended->text.isEmpty() || found.text == intended->text) &&
                         (intended->path.isEmpty() ? !last_->left.contains(found.path)
                                                   : found.path == intended->path);
      if (is_it) return changedTo(found);
    }
    // A project's file is created with the first thing in it.
    if (isUnnamed(found.path) && isUnnamed(states.back().path) && isEmpty(found) &&
        isEmpty(states.back()))
      return true;
    if (found.path != states.back().path)
      return disagree("another project is open", found, states.back());
    std::size_t oldest = last_->saved;
    const auto age = [&](const State& state) {
      return window_time_ ? windowTime(*last_, state.t, killed_) : killed_ - state.t;
    };
    for (std::size_t i = oldest; i < states.size(); ++i)
      if (age(states[i]) > within_) oldest = i;
    for (std::size_t i = states.size(); i-- > 0;) {
      if (!(states[i] == found)) continue;
      if (i + 1 < states.size()) oldest_lost_ = std::max(oldest_lost_, age(states[i + 1]));
      if (i >= oldest) return true;
      std::fprintf(stderr,
                   "It was changed %lld ms before the kill, and the window ran %lld of them.\n",
                   static_cast<long long>(killed_ - states[i + 1].t),
                   static_cast<long long>(windowTime(*last_, states[i + 1].t, killed_)));
      return disagree("it is too old", found, states[oldest]);
    }
    return disagree("it never was so", found, states.back());
  }

  /// Checks a switch to the intended project, which leaves the previous one.
  bool changedTo(const State& found) {
    const State& before = last_->states.back();
    const bool is_gone = isEmpty(before) || last_->naming;
    if (before.path != found.path && !(isUnnamed(before.path) && is_gone))
      last_->left[before.path] = before.text;
    last_->left.erase(found.path);
    return true;
  }

  bool disagree(const char* what, const State& found, const State& expected) const {
    std::fprintf(stderr, "After a kill %s.\nfound %s\n%s\nexpected %s\n%s\n", what,
                 qPrintable(found.path), found.text.constData(), qPrintable(expected.path),
                 expected.text.constData());
    return false;
  }

  QString folder_;
  QString journal_;
  std::mt19937 random_;
  qint64 within_;  // ms
  bool window_time_;
  std::optional<Run> last_;  // last run that found a project
  qint64 killed_ = 0;        // time of its kill
  std::size_t states_ = 0;
  qint64 oldest_lost_ = 0;  // ms between the oldest lost edit and the kill
};

int study(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  QCommandLineParser parser;
  parser.addHelpOption();
  const QCommandLineOption kills(QStringLiteral("kills"), {}, QStringLiteral("N"),
                                 QStringLiteral("100"));
  const QCommandLineOption seed(QStringLiteral("seed"), {}, QStringLiteral("N"),
                                QString::number(std::random_device()()));
  const QCommandLineOption within(QStringLiteral("within"), {}, QStringLiteral("SECONDS"),
                                  QStringLiteral("2"));
  const QCommandLineOption window_time(QStringLiteral("window-time"));
  parser.addOptions({kills, seed, within, window_time});
  parser.process(application);
  QTemporaryDir folder;
  std::printf("seed %s\n", qPrintable(parser.value(seed)));
  Study study(QDir(folder.path()).canonicalPath(), parser.value(seed).toUInt(),
              static_cast<int>(1e3 * parser.value(within).toDouble()), parser.isSet(window_time));
  const int count = parser.value(kills).toInt();
  // The last kill's restart is checked too.
  for (int i = 1; i <= count + 1; ++i)
    if (!study.kill(i)) {
      folder.setAutoRemove(false);
      std::fprintf(stderr, "Its files are in %s.\n", qPrintable(folder.path()));
      return 1;
    }
  study.report(count);
  return 0;
}

}  // namespace
}  // namespace mocapress::test

int main(int argc, char** argv) {
  if (argc == 4 && std::string_view(argv[1]) == "--child")
    return mocapress::test::useStudioAtRandom(
        argc, argv, QString::fromLocal8Bit(argv[2]),
        static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10)));
  return mocapress::test::study(argc, argv);
}
