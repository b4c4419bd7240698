// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/qt/studio_at_random.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QTimer>
#include <QTreeView>
#include <chrono>
#include <random>

#include "app/studio/window/main_window.h"
#include "app/studio/window/theme.h"
#include "widgets/models/library_tree.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/pinned_panel.h"
#include "widgets/panels/target_control.h"
#include "widgets/viewport/viewport.h"

namespace mocapress::test {
namespace {

constexpr int kShortestPause = 20;  // ms between two actions
constexpr int kLongestPause = 300;

/// Writes each line at once, so that it survives a kill.
class Journal {
 public:
  explicit Journal(const QString& path) : file_(path) {
    file_.open(QIODevice::WriteOnly | QIODevice::Append | QIODevice::Unbuffered);
  }

  void note(const char* what, QJsonObject record = {}) {
    record.insert(QStringLiteral("what"), QLatin1String(what));
    record.insert(QStringLiteral("t"), millisecondsNow());
    file_.write(QJsonDocument(record).toJson(QJsonDocument::Compact) + '\n');
  }

 private:
  QFile file_;
};

class RandomUser : public QObject {
 public:
  RandomUser(MainWindow* window, const QString& folder, unsigned seed)
      : window_(*window),
        library_(window->library()),
        folder_(folder),
        journal_(QDir(folder).filePath(QStringLiteral("journal.jsonl"))),
        random_(seed) {
    connect(&library_, &Library::edited, this, [this] { noteChange(); });
    connect(&library_, &Library::projectChanged, this, [this] { noteChange(); });
    connect(&library_, &Library::saved, this, [this] { journal_.note(journal::kSaved); });
    connect(&beat_, &QTimer::timeout, this, [this] { journal_.note(journal::kBeat); });
    connect(&next_, &QTimer::timeout, this, &RandomUser::act);
    next_.setSingleShot(true);
  }

  void begin() {
    library_.begin(QDir(folder_).filePath(QStringLiteral("data")));
    begun_ = true;
    noteState(journal::kBegun, projectText(library_.project(), QDir(QStringLiteral("/"))));
    beat_.start(kBeatTime);
    next_.start(kShortestPause);
  }

 private:
  int any(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }

  QString anyClip() {
    const QDir clips(QDir(folder_).filePath(QStringLiteral("clips")));
    const QStringList names = clips.entryList({QStringLiteral("*.bvh")}, QDir::Files, QDir::Name);
    return clips.filePath(names[any(static_cast<int>(names.size()))]);
  }

  void noteChange() {
    if (!begun_ || library_.path().isEmpty()) return;  // between two projects there is no state
    const QByteArray text = projectText(library_.project(), QDir(QStringLiteral("/")));
    if (text != text_ || library_.path() != path_) noteState(journal::kState, text);
  }

  void noteState(const char* what, const QByteArray& text) {
    text_ = text;
    path_ = library_.path();
    journal_.note(what, {{QStringLiteral("path"), path_},
                         {QStringLiteral("text"), QString::fromUtf8(text)},
                         {QStringLiteral("title"), window_.windowTitle()}});
  }

  void act() {
    LibraryPanel& panel = window_.libraryPanel();
    const int clips = static_cast<int>(library_.project().clips.size());
    if (clips == 0) {
      addClip();
    } else {
      switch (any(24)) {
        case 0:
          changeProject(journal::kNew, {}, [this] { window_.actions().new_project->trigger(); });
          break;
        case 1:
        case 2:
          openProject();
          break;
        case 3:
        case 4:
          saveAs();
          break;
        case 5:
        case 6:
          addClip();
          break;
        case 7:
          panel.removeButton()->click();
          break;
        case 8:
        case 9:
        case 10:
          panel.view()->setCurrentIndex(panel.tree()->indexOf(any(clips)));
          break;
        case 11:
        case 12:
        case 13:
          choose(panel.verdict());
          break;
        case 14:
        case 15:
        case 16:
          if (panel.note()->isEnabled())
            QTest::keyClicks(panel.note(), QString::number(any(1'000'000)));
          break;
        case 17:
          window_.actions().pin->trigger();
          break;
        case 18:
          emit window_.pinnedPanel().unpinRequested(0);
          break;
        case 19:
          (any(2) ? window_.actions().undo : window_.actions().redo)->trigger();
          break;
        default: {
          QSlider* slider = window_.views().compression->target()->slider();
          if (slider->isEnabled()) slider->setValue(any(slider->maximum()));
        }
      }
    }
    next_.start(kShortestPause + any(kLongestPause - kShortestPause));
  }

  void choose(QComboBox* box) {
    if (!box->isEnabled()) return;
    box->setCurrentIndex(any(box->count()));
    emit box->activated(box->currentIndex());
  }

  void addClip() {
    const QString path = anyClip();
    library_.add({path});
    LibraryPanel& panel = window_.libraryPanel();
    const int last = static_cast<int>(library_.project().clips.size()) - 1;
    panel.view()->setCurrentIndex(panel.tree()->indexOf(last));
  }

  void openProject() {
    const std::vector<FormerProject> former = library_.formerProjects();
    if (former.empty()) return;
    const QString path =
        former[static_cast<std::size_t>(any(static_cast<int>(former.size())))].path;
    changeProject(journal::kOpen, path, [&] { window_.projects().open(path); });
  }

  void saveAs() {
    const QString path = QStringLiteral("%1/named/%2-%3.mocapress")
                             .arg(folder_)
                             .arg(millisecondsNow())
                             .arg(any(1000));
    changeProject(journal::kSaveAs, path, [&] { library_.saveAs(path); });
  }

  template <typename Act>
  void changeProject(const char* what, const QString& path, Act change) {
    journal_.note(what, {{QStringLiteral("path"), path}});
    change();
    for (const QMessageBox* box : window_.findChildren<QMessageBox*>())
      if (box->isVisible()) box->button(QMessageBox::Discard)->click();
  }

  MainWindow& window_;
  Library& library_;
  QString folder_;
  Journal journal_;
  std::mt19937 random_;
  QTimer beat_, next_;
  bool begun_ = false;
  QString path_;     // path in the last noted state
  QByteArray text_;  // text in the last noted state
};

}  // namespace

qint64 millisecondsNow() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

int useStudioAtRandom(int argc, char** argv, const QString& folder, unsigned seed) {
  prepareViewport();
  QApplication application(argc, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("mocapress-tests"));
  QCoreApplication::setApplicationName(QStringLiteral("Mocapress"));
  QApplication::setStyle(new StudioStyle);
  MainWindow window;
  RandomUser user(&window, folder, seed);
  window.show();
  user.begin();
  return QApplication::exec();
}

}  // namespace mocapress::test
