// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCheckBox>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QVBoxLayout>
#include <chrono>
#include <tuple>

#include "app/studio/batch/batch_memory.h"
#include "app/studio/batch/batch_window.h"
#include "app/studio/compare/pinned_results.h"
#include "app/studio/document/recent_files.h"
#include "app/studio/document/sample_clip.h"
#include "app/studio/study/study_memory.h"
#include "app/studio/study/study_window.h"
#include "app/studio/window/help.h"
#include "app/studio/window/language.h"
#include "app/studio/window/shortcuts_first.h"
#include "app/studio/window/trace.h"
#include "widgets/panels/annealing_panel.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/correction_control.h"
#include "widgets/panels/figures_bar.h"
#include "widgets/panels/footskate_panel.h"
#include "widgets/panels/importance_panel.h"
#include "widgets/panels/joints_panel.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/pinned_panel.h"
#include "widgets/panels/result_panel.h"
#include "widgets/panels/slot_control.h"
#include "widgets/panels/warnings_panel.h"
#include "widgets/plots/channel_graph.h"
#include "widgets/plots/error_graph.h"
#include "widgets/plots/heat_map.h"
#include "widgets/plots/rate_plot.h"
#include "widgets/timeline/timeline.h"
#include "widgets/timeline/transport_bar.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr QSize kFirstSize(1440, 900);
constexpr int kSidebarWidth = 320;
constexpr int kLibraryWidth = 240;
constexpr int kJointsWidth = 400;
constexpr int kBelowHeight = 240;
constexpr std::chrono::milliseconds kSlowOpening{400};  // from here on it is said

QFrame* makeRule(QWidget* parent) {
  auto* rule = new QFrame(parent);
  rule->setFrameShape(QFrame::HLine);
  rule->setFrameShadow(QFrame::Sunken);
  return rule;
}

}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
  setWindowIcon(QIcon(QStringLiteral(":/icons/app.svg")));
  setAcceptDrops(true);
  qApp->installEventFilter(new ShortcutsFirst(this));
  resize(kFirstSize);
  actions_ = makeActions(playback_, undo_->histories(), this);
  actions_.error_scales = error_display_->scales(ErrorQuantity::Distance);
  actions_.angle_scales = error_display_->scales(ErrorQuantity::Angle);
  actions_.in_degrees = error_display_->inDegrees();
  actions_.as_seen = error_display_->asSeen();
  setCentralWidget(makeCentre());
  addDocks();
  recent_ = addMenus(this, actions_, layout_.docks());
  layout_.restore();
  new Presenter(session_, playback_, models_, views_, error_display_, this);
  library_views_ = new LibraryViews(session_, library_, library_panel_, slot_control_, this);
  presets_->setHistory([this] { return session_->history(); });
  preset_views_ = new PresetViews(session_, presets_, views_.compression->presets(), this);
  pinned_ = new PinnedResults(session_, pinned_model_, pinned_panel_, views_.viewport, this);
  pinned_->setMemory([this](const QString& path) { return library_->pinsOf(path); });
  connect(pinned_, &PinnedResults::edited, library_, &Library::setPins);
  inspector_ = new Inspector(session_, playback_, inspection_, error_display_, this);
  // After the presenter: an answer counts once the view has it.
  trace_ = new Trace(session_, views_.viewport, this);
  connectFileActions();
  connectWindowActions();
  connectMessages();
  updateTitle();
  // Keys play and step from the start: no field takes them for text.
  views_.viewport->setFocus();
}

QWidget* MainWindow::makeCentre() {
  auto* centre = new QWidget(this);
  messages_ = new MessageBar(centre);
  views_.warnings = new WarningsPanel(centre);
  views_.viewport = new Viewport(centre);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(messages_);
  column->addWidget(views_.warnings);
  column->addWidget(views_.viewport, 1);
  inspection_.timeline = new Timeline(centre);
  column->addWidget(inspection_.timeline);
  column->addWidget(new TransportBar(playback_, actions_.transport, centre));
  return centre;
}

QWidget* MainWindow::makeSidebar() {
  auto* sidebar = new QWidget(this);
  slot_control_ = new SlotControl(sidebar);
  views_.compression = new CompressionPanel(sidebar);
  views_.result = new ResultPanel(sidebar);
  views_.annealing = new AnnealingPanel(sidebar);
  auto* column = new QVBoxLayout(sidebar);
  column->setContentsMargins(10, 2, 10, 10);
  column->setSpacing(12);
  column->addWidget(slot_control_);
  column->addWidget(views_.compression);
  column->addWidget(makeRule(sidebar));
  column->addWidget(views_.result);
  column->addWidget(makeRule(sidebar));
  column->addWidget(views_.annealing, 1);
  auto* scroll = new QScrollArea(this);  // where the screen is low
  scroll->setWidget(sidebar);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(sidebar->minimumSizeHint().width() +
                          scroll->verticalScrollBar()->sizeHint().width());
  return scroll;
}

void MainWindow::addDocks() {
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  library_panel_ = new LibraryPanel(clips_, this);
  undo_->setLibraryPanel(library_panel_);
  QDockWidget* library = layout_.addLeft(library_panel_, QStringLiteral("library"), tr("Library"));
  QDockWidget* sidebar =
      layout_.addRight(makeSidebar(), QStringLiteral("compression"), tr("Compression"));
  views_.importance = new ImportancePanel(this);
  QDockWidget* importance =
      layout_.addRight(views_.importance, QStringLiteral("importance"), tr("Importance"));
  tabifyDockWidget(sidebar, importance);
  sidebar->raise();
  connect(views_.compression, &CompressionPanel::importanceRequested, importance, [importance] {
    importance->show();
    importance->raise();
  });
  views_.joints = new JointsPanel(models_.joints, this);
  QDockWidget* joints = layout_.addBelow(views_.joints, QStringLiteral("joints"), tr("Joints"));
  views_.footskate = new FootskatePanel(models_.slides, this);
  QDockWidget* footskate =
      layout_.addBelow(views_.footskate, QStringLiteral("footskate"), tr("Footskate"));
  tabifyDockWidget(joints, footskate);
  pinned_panel_ = new PinnedPanel(pinned_model_, this);
  tabifyDockWidget(footskate,
                   layout_.addBelow(pinned_panel_, QStringLiteral("pinned"), tr("Pinned")));
  joints->raise();
  views_.graph = new ErrorGraph(this);
  QDockWidget* graph =
      layout_.addBelow(views_.graph, QStringLiteral("error-over-time"), tr("Error over time"));
  inspection_.heat_map = new HeatMap(this);
  inspection_.channel = new ChannelGraph(this);
  inspection_.curve = new RatePlot(this);
  QDockWidget* before = graph;
  for (const auto& [panel, id, title] :
       {std::tuple<QWidget*, const char*, QString>(inspection_.heat_map, "heat-map",
                                                   tr("Heat map")),
        {inspection_.channel, "channel", tr("Channel")},
        {inspection_.curve, "rate-distortion", tr("Rate-distortion")}}) {
    QDockWidget* dock = layout_.addBelow(panel, QString::fromLatin1(id), title);
    tabifyDockWidget(before, dock);
    before = dock;
  }
  graph->raise();
  inspection_.figures = new FiguresBar(this);
  statusBar()->addWidget(inspection_.figures, 1);
  statusBar()->setSizeGripEnabled(false);
  resizeDocks({library, sidebar}, {kLibraryWidth, kSidebarWidth}, Qt::Horizontal);
  const int rest = kFirstSize.width() - kLibraryWidth - kSidebarWidth - kJointsWidth;
  resizeDocks({joints, graph}, {kJointsWidth, rest}, Qt::Horizontal);
  resizeDocks({joints, graph}, {kBelowHeight, kBelowHeight}, Qt::Vertical);
}

void MainWindow::connectFileActions() {
  connect(actions_.open, &QAction::triggered, files_, &ClipFiles::chooseClip);
  connect(actions_.open_sample, &QAction::triggered, files_,
          [this] { files_->open(sampleClip()); });
  connect(actions_.choose_skeleton, &QAction::triggered, files_, &ClipFiles::chooseSkeleton);
  connect(actions_.compare, &QAction::triggered, files_, &ClipFiles::chooseOriginal);
  connect(actions_.save, &QAction::triggered, files_, &ClipFiles::save);
  connect(actions_.save_as, &QAction::triggered, files_, &ClipFiles::saveAs);
  connect(actions_.export_motion, &QAction::triggered, files_, &ClipFiles::exportMotion);
  connect(actions_.import_options, &QAction::triggered, files_, &ClipFiles::chooseImportOptions);
  connect(actions_.quit, &QAction::triggered, this, &QWidget::close);
  connect(actions_.add_clips, &QAction::triggered, library_views_, &LibraryViews::addClips);
  connect(actions_.add_folder, &QAction::triggered, library_views_, &LibraryViews::addFolder);
  connect(actions_.new_project, &QAction::triggered, projects_, &ProjectFiles::startNew);
  connect(actions_.open_project, &QAction::triggered, projects_, &ProjectFiles::choose);
  connect(actions_.save_project, &QAction::triggered, projects_, &ProjectFiles::saveAs);
  connect(actions_.switch_slot, &QAction::triggered, session_, &Session::switchSlot);
  connect(actions_.copy_slot, &QAction::triggered, session_, &Session::copyToOtherSlot);
  connect(recent_.files, &QMenu::aboutToShow, files_,
          [this] { files_->fillRecentMenu(recent_.files); });
  connect(recent_.projects, &QMenu::aboutToShow, projects_,
          [this] { projects_->fillRecentMenu(recent_.projects); });
  actions_.open_sample->setEnabled(!sampleClip().isEmpty());
}

void MainWindow::connectWindowActions() {
  connectViewActions(actions_.view, views_.viewport);
  connect(actions_.without_ik, &QAction::toggled, &session_->document(), &Document::setUncorrected);
  connect(actions_.hold_feet, &QAction::triggered, views_.compression->correction()->hold(),
          &QCheckBox::toggle);
  connect(actions_.pin, &QAction::triggered, pinned_, &PinnedResults::pinCurrent);
  connect(pinned_, &PinnedResults::canPinChanged, actions_.pin, &QAction::setEnabled);
  actions_.pin->setEnabled(false);
  connect(actions_.next_worst, &QAction::triggered, inspector_,
          [this] { inspector_->showNextWorst(1); });
  connect(actions_.previous_worst, &QAction::triggered, inspector_,
          [this] { inspector_->showNextWorst(-1); });
  connect(actions_.reset_layout, &QAction::triggered, this, [this] { layout_.reset(); });
  connect(actions_.guide, &QAction::triggered, this,
          [this] { (new HelpWindow(tr("Guide"), guideHtml(), this))->show(); });
  connect(actions_.shortcuts, &QAction::triggered, this, [this] {
    (new HelpWindow(tr("Keyboard Shortcuts"), shortcutSheet(*menuBar()), this))->show();
  });
  connectChoices();
  connect(actions_.study, &QAction::triggered, this, &MainWindow::showStudy);
  connect(actions_.batch, &QAction::triggered, this, [this] {
    BatchWindow* batch = showBatch();
    if (const OriginalPtr& original = session_->document().original())
      batch->offerClip(original->path);
  });
  connect(actions_.export_library, &QAction::triggered, this, [this] { exportClips({}); });
  connect(library_panel_, &LibraryPanel::exportRequested, this, &MainWindow::exportClips);
  connect(actions_.about, &QAction::triggered, this, &MainWindow::about);
}

void MainWindow::connectChoices() {
  actions_.themes->actions().at(static_cast<int>(theme_->choice()))->setChecked(true);
  connect(actions_.themes, &QActionGroup::triggered, theme_, [this](const QAction* action) {
    theme_->choose(static_cast<ThemeChoice>(action->data().toInt()));
  });
  for (QAction* action : actions_.languages->actions())
    if (action->data().toString() == chosenLanguage()) action->setChecked(true);
  connect(actions_.languages, &QActionGroup::triggered, this, [this](const QAction* action) {
    chooseLanguage(action->data().toString());
    messages_->showNote(tr("The language changes when Mocapress is started again."));
  });
}

StudyWindow* MainWindow::showStudy() {
  if (!study_) {
    study_session_ = new StudySession(studyCache(), this);
    study_session_->setSettings(rememberedStudySettings());
    study_ = new StudyWindow(study_session_, this);
    study_session_->setReviews(library_->reviews());
    connect(library_, &Library::currentChanged, study_session_,
            [this] { study_session_->setReviews(library_->reviews()); });
    connect(study_, &StudyWindow::rowChosen, files_, &ClipFiles::openRow);
    connect(study_session_, &StudySession::rowsCleared, this, &MainWindow::showHere);
    connect(&session_->document(), &Document::decodedChanged, this, &MainWindow::showHere);
  }
  if (const OriginalPtr& original = session_->document().original())
    study_->offerClip(original->path, rememberedSkeleton(original->path));
  showHere();
  study_->show();
  study_->raise();
  study_->activateWindow();
  return study_;
}

BatchWindow* MainWindow::showBatch() {
  if (!batch_) {
    batch_ = new BatchWindow(new BatchSession(batchMemory(), presets_, this), this);
    BatchSession* session = batch_->session();
    session->setReviews(library_->reviews());
    connect(library_, &Library::currentChanged, session,
            [this, session] { session->setReviews(library_->reviews()); });
    connect(batch_, &BatchWindow::openRequested, files_,
            [this](const QString& path) { files_->open(path); });
  }
  batch_->show();
  batch_->raise();
  batch_->activateWindow();
  return batch_;
}

/// Clips of the library by their own settings; no rows: all of them.
void MainWindow::exportClips(const std::vector<int>& rows) {
  showBatch()->session()->addTuned(library_->tuned(rows));
}

/// Where the open clip is on the curves of the study.
void MainWindow::showHere() {
  const Document& document = session_->document();
  std::optional<CurvePoint> here;
  if (document.original() && document.decoded() && document.decoded()->distortion)
    here = {document.decoded()->ratio,
            document.decoded()->distortion->eps(study_session_->weighting())};
  study_->setHere(document.original() ? document.original()->path : QString(), here);
}

void MainWindow::connectMessages() {
  connect(&session_->document(), &Document::titleChanged, this, &MainWindow::updateTitle);
  slow_opening_.setSingleShot(true);
  slow_opening_.setInterval(kSlowOpening);
  connect(&slow_opening_, &QTimer::timeout, messages_,
          [this] { messages_->showWork(tr("Opening %1…").arg(QFileInfo(opening_).fileName())); });
  connect(session_, &Session::opening, this, [this](const QString& path) {
    opening_ = path;
    slow_opening_.start();
  });
  connect(session_, &Session::opened, &slow_opening_, &QTimer::stop);
  connect(session_, &Session::openFailed, &slow_opening_, &QTimer::stop);
  connect(library_, &Library::projectChanged, this, &MainWindow::updateTitle);
  connect(session_, &Session::opened, messages_, &QWidget::hide);
  connect(session_, &Session::compressFailed, messages_,
          [this](const QString& message, bool out_of_reach) {
            if (!out_of_reach) messages_->showError(message);  // else it is said beside the target
          });
  connect(session_, &Session::saveFailed, messages_,
          [this](const QString& message) { messages_->showError(message); });
  connect(files_, &ClipFiles::openFailed, messages_,
          [this](const QString& message, bool wants_skeleton) {
            messages_->showError(message, wants_skeleton ? actions_.choose_skeleton : nullptr);
          });
  connect(presets_, &PresetShelf::noted, messages_,
          [this](const QString& message) { messages_->showNote(message); });
  connect(library_, &Library::added, this, [this](int row) {
    if (std::exchange(opens_added_, false)) library_->openClip(row);
  });
  connect(library_, &Library::failed, messages_,
          [this](const QString& message) { messages_->showError(message); });
  connect(library_, &Library::noted, this, &MainWindow::keepNote);
  connect(library_, &Library::recovered, this, [this](int clips) {
    keepNote(tr("The last session ended unexpectedly. Its project is here again: %Ln clip(s).",
                nullptr, clips));
  });
  connect(session_, &Session::opened, messages_, [this] {
    if (!kept_note_.isEmpty()) messages_->showNote(std::exchange(kept_note_, {}));
  });
  connect(session_, &Session::openFailed, this, [this] { kept_note_.clear(); });
  connect(files_, &ClipFiles::saved, messages_,
          [this](const QString& name) { messages_->showNote(tr("Saved %1.").arg(name)); });
  connect(files_, &ClipFiles::exported, messages_,
          [this](const QString& name) { messages_->showNote(tr("Exported %1.").arg(name)); });
}

/// Opening the clip of a project takes older messages away, but not this one.
void MainWindow::keepNote(const QString& note) {
  messages_->showNote(note);
  if (library_->currentRow() >= 0) kept_note_ = note;
}

void MainWindow::updateTitle() {
  const Document& document = session_->document();
  const QString project =
      QStringLiteral("%1 – %2").arg(projects_->title(), QCoreApplication::applicationName());
  // The project is always in its file; what may not be is the compressed clip.
  setWindowTitle(document.title().isEmpty() ? project + QStringLiteral("[*]")
                                            : tr("%1[*] – %2").arg(document.title(), project));
  setWindowModified(document.modified() || library_->stuck());
  actions_.save->setEnabled(document.decoded() != nullptr);
  actions_.save_as->setEnabled(document.decoded() != nullptr);
  actions_.export_motion->setEnabled(document.decoded() != nullptr);
  actions_.import_options->setEnabled(document.original() != nullptr);
  actions_.switch_slot->setEnabled(document.original() != nullptr);
  actions_.copy_slot->setEnabled(document.original() != nullptr);
  actions_.hold_feet->setEnabled(document.original() != nullptr);
  actions_.without_ik->setEnabled(document.decoded() && document.decoded()->uncorrected_tracks);
  actions_.compare->setEnabled(document.decoded() && !document.original());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_close_ && session_->document().modified()) {
    event->ignore();
    files_->leave([this] {
      may_close_ = true;
      may_close_ = close();
    });
    return;
  }
  if (!may_lose_project_ && !library_->end()) {
    event->ignore();
    projects_->askToQuit([this] {
      may_close_ = may_lose_project_ = true;
      close();
    });
    return;
  }
  layout_.remember();
  if (study_) study_->close();
  if (batch_) batch_->close();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  open(paths);
}

void MainWindow::open(const QStringList& paths, const QString& skeleton) {
  QStringList projects, clips;
  for (const QString& path : paths) (isProjectFile(path) ? projects : clips) << path;
  if (projects.isEmpty()) return openClips(clips, skeleton, !session_->document().skeleton());
  const QString project = projects.takeFirst();
  projects_->open(project, [=, this] {
    if (!clips.isEmpty()) openClips(clips, skeleton, library_->currentRow() < 0);
    if (projects.isEmpty()) return;
    QStringList names;
    for (const QString& path : projects) names << QFileInfo(path).fileName();
    keepNote(tr("Left out; only one project is open at a time: %1")
                 .arg(names.join(QStringLiteral(", "))));
  });
}

void MainWindow::openClips(const QStringList& paths, const QString& skeleton, bool opens_first) {
  if (paths.size() == 1 && !QFileInfo(paths[0]).isDir()) return files_->open(paths[0], skeleton);
  QStringList clips, skeletons, folders, others;
  for (const QString& path : paths) {
    const QString kind = QFileInfo(path).suffix().toLower();
    if (QFileInfo(path).isDir())
      folders << path;
    else if (kind == QLatin1String("bvh") || kind == QLatin1String("amc"))
      clips << path;
    else if (kind == QLatin1String("asf"))
      skeletons << path;
    else
      others << QFileInfo(path).fileName();
  }
  if (!others.isEmpty())
    messages_->showNote(
        tr("Left out; the library takes only motions: %1").arg(others.join(QStringLiteral(", "))));
  if (clips.size() == 1 && folders.isEmpty())  // with its skeleton, it may be
    return files_->open(clips[0], skeletons.size() == 1 && clips[0].endsWith(QLatin1String(".amc"),
                                                                             Qt::CaseInsensitive)
                                      ? skeletons[0]
                                      : skeleton);
  opens_added_ = opens_added_ || opens_first;
  for (const QString& folder : folders) library_->addFolder(folder);
  library_->add(clips);
}

void MainWindow::about() {
  QMessageBox::about(
      this, tr("About Mocapress"),
      tr("<h3>Mocapress %1</h3>"
         "<p>Compresses human motion capture clips with wavelets, after Philippe Beaudoin, Pierre "
         "Poulin and Michiel van de Panne, <i>Adapting Wavelet Compression to Human Motion Capture "
         "Clips</i>, Graphics Interface 2007.</p>"
         "<p>The studio is free software under the GNU General Public License, version 3 or later; "
         "the compression library is under the MIT licence.</p>")
          .arg(QCoreApplication::applicationVersion()));
}

}  // namespace mocapress
