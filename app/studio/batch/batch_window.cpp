// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/batch/batch_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/studio/batch/batch_session.h"
#include "app/studio/document/clip_files.h"
#include "app/studio/document/preset_shelf.h"
#include "app/studio/document/preset_views.h"
#include "widgets/icons/themed_icon.h"
#include "widgets/models/number_text.h"
#include "widgets/panels/batch_output.h"
#include "widgets/panels/batch_queue_view.h"
#include "widgets/panels/character_choice.h"
#include "widgets/panels/preset_chooser.h"
#include "widgets/panels/preset_editor.h"

namespace mocapress {

namespace {

using State = BatchSession::State;

struct Status {
  Q_DECLARE_TR_FUNCTIONS(mocapress::BatchStatus)
};

QString failedText(std::size_t failed) {
  if (failed == 0) return {};
  return Status::tr(", %Ln failed", nullptr, static_cast<int>(failed));
}

QString leftOutText(const BatchQueueModel& queue) {
  if (queue.countLeftOut() == 0) return {};
  return Status::tr(", %Ln left out", nullptr, queue.countLeftOut());
}

QString warnedText(const BatchQueueModel& queue) {
  const auto warned =
      std::count_if(queue.clips().begin(), queue.clips().end(), [](const QueuedClip& clip) {
        return clip.state == QueuedClip::State::Done && !clip.left_out && !clip.warnings.empty();
      });
  if (warned == 0) return {};
  return Status::tr(", %Ln with warnings", nullptr, static_cast<int>(warned));
}

QString staleText(const BatchQueueModel& queue) {
  const int stale = queue.countStale();
  return stale == 0 ? QString() : Status::tr(", %Ln with a stale verdict", nullptr, stale);
}

QString soFar(const BatchCounts& counts) {
  return Status::tr("%L1 of %L2").arg(counts.done).arg(counts.clips) + failedText(counts.failed);
}

QString atBank(const BankProgress& bank, bool learns) {
  if (bank.clips == 0) return Status::tr("Waiting for another program that is changing the bank…");
  if (bank.done == 0 && learns) return Status::tr("Fitting the coder to the clips of the bank…");
  return Status::tr("Making the bank: %L1 of %L2").arg(bank.done).arg(bank.clips);
}

QString running(const BatchSession& session) {
  if (session.bank()) return atBank(*session.bank(), session.settings().learns());
  const auto left = session.secondsLeft();
  if (!left || session.counts().done == session.counts().clips) return soFar(session.counts());
  return Status::tr("%1, about %2 left").arg(soFar(session.counts()), clockText(*left));
}

QString idle(const BatchSession& session) {
  const BatchQueueModel& queue = *session.queue();
  const int waiting =
      queue.count(QueuedClip::State::Waiting) + queue.count(QueuedClip::State::Failed);
  if (!session.obstacle().isEmpty()) return session.obstacle();
  return Status::tr("%Ln clip(s) to export", nullptr, waiting) + staleText(queue) +
         leftOutText(queue);
}

QString complete(const BatchSession& session) {
  const BatchCounts& counts = session.counts();
  const auto done = static_cast<int>(counts.done - counts.failed);
  return Status::tr("%Ln clip(s) exported and verified", nullptr, done) +
         warnedText(*session.queue()) + staleText(*session.queue()) + failedText(counts.failed) +
         leftOutText(*session.queue());
}

}  // namespace

QString statusOf(const BatchSession& session) {
  switch (session.state()) {
    case State::Idle:
      return idle(session);
    case State::Running:
      return running(session);
    case State::Paused:
      return Status::tr("Paused at %1").arg(soFar(session.counts()));
    case State::Stopping:
      return Status::tr("Stopping after the current clips: %1").arg(soFar(session.counts()));
    case State::Cancelling:
      return Status::tr("Cancelling…");
    case State::Stopped:
      return Status::tr("Stopped at %1; the next start continues from there")
          .arg(soFar(session.counts()));
    case State::Complete:
      return complete(session);
    case State::Failed:
      return session.failure();
  }
  return {};
}

QString startText(const BatchSession& session) {
  if (session.state() == State::Paused) return Status::tr("&Go On");
  if (session.running()) return Status::tr("&Pause");
  const int waiting = session.queue()->count(QueuedClip::State::Waiting);
  const int failed = session.queue()->count(QueuedClip::State::Failed);
  if (waiting == 0 && failed > 0) return Status::tr("&Retry %Ln Failed", nullptr, failed);
  return session.state() == State::Stopped ? Status::tr("&Go On") : Status::tr("&Export");
}

namespace {

constexpr QSize kFirstSize(1180, 660);
constexpr int kSettingsWidth = 320;
constexpr int kSteps = 1000;  // resolution of the progress bar
const QString kGeometry = QStringLiteral("batch/geometry");

QLabel* makeHeading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setWeight(QFont::DemiBold);
  label->setFont(font);
  return label;
}

}  // namespace

BatchWindow::BatchWindow(BatchSession* session, QWidget* parent)
    : QWidget(parent, Qt::Window),
      session_(session),
      view_(new BatchQueueView(session->queue(), this)),
      editor_(new PresetEditor(this)),
      character_(new CharacterChoice(this)),
      output_(new BatchOutput(this)),
      whose_(makeHeading({}, this)),
      unlock_(new QPushButton(tr("Use Shared Settings for Selection"), this)),
      start_(new QPushButton(this)),
      stop_(new QPushButton(tr("&Stop after Current"), this)),
      cancel_(new QPushButton(tr("&Cancel"), this)),
      report_(new QPushButton(tr("Open Rep&ort"), this)),
      slurm_(new QPushButton(tr("Slurm Script…"), this)),
      progress_(new QProgressBar(this)),
      status_(new QLabel(this)),
      note_(new QLabel(this)) {
  setWindowTitle(tr("Batch Export"));
  auto* halves = new QSplitter(this);
  halves->addWidget(makeQueue());
  halves->addWidget(makeSettings());
  halves->setStretchFactor(0, 1);
  halves->setChildrenCollapsible(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(halves, 1);
  column->addWidget(makeFoot());
  resize(kFirstSize);
  restoreGeometry(QSettings().value(kGeometry).toByteArray());
  connectSession();
  connectQueue();
  connectPresets();
  editor_->setPresets(session_->presets()->all());
  showOutput();
  showSelection();
  showProgress();
}

QAction* BatchWindow::makeStep(QAction* step, QKeySequence::StandardKey key, const QString& icon,
                               QHBoxLayout* tools) {
  step->setShortcut(key);
  step->setIcon(themedIcon(icon));
  addAction(step);
  auto* button = new QToolButton(this);
  button->setDefaultAction(step);
  button->setAutoRaise(true);
  tools->addWidget(button);
  return step;
}

QWidget* BatchWindow::makeQueue() {
  auto* queue = new QWidget(this);
  auto* files =
      new QPushButton(themedIcon(QStringLiteral("folder-open")), tr("Add &Files…"), queue);
  files->setToolTip(tr("Add motions"));
  auto* folder = new QPushButton(tr("Add Fol&der…"), queue);
  folder->setToolTip(tr("Add every motion below a folder"));
  auto* tools = new QHBoxLayout;
  tools->setContentsMargins(8, 8, 8, 8);
  tools->setSpacing(6);
  tools->addWidget(files);
  tools->addWidget(folder);
  tools->addStretch(1);
  undo_ = makeStep(session_->history().createUndoAction(this, tr("Undo")), QKeySequence::Undo,
                   QStringLiteral("undo"), tools);
  redo_ = makeStep(session_->history().createRedoAction(this, tr("Redo")), QKeySequence::Redo,
                   QStringLiteral("redo"), tools);
  auto* column = new QVBoxLayout(queue);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(tools);
  column->addWidget(view_, 1);
  connect(files, &QPushButton::clicked, this, &BatchWindow::chooseFiles);
  connect(folder, &QPushButton::clicked, this, &BatchWindow::chooseClipFolder);
  connect(session_, &BatchSession::progressed, queue, [this, files, folder] {
    files->setEnabled(!session_->running());
    folder->setEnabled(!session_->running());
  });
  return queue;
}

QWidget* BatchWindow::makeSettings() {
  settings_ = new QWidget(this);
  auto* column = new QVBoxLayout(settings_);
  column->setContentsMargins(12, 12, 12, 12);
  column->setSpacing(8);
  column->addWidget(whose_);
  column->addWidget(editor_);
  column->addWidget(unlock_);
  column->addSpacing(12);
  column->addWidget(makeHeading(tr("Character on all clips"), this));
  column->addWidget(character_);
  column->addSpacing(12);
  column->addWidget(makeHeading(tr("Output"), this));
  column->addWidget(output_);
  column->addStretch(1);
  auto* scroll = new QScrollArea(this);  // scrolls if the screen is low
  scroll->setWidget(settings_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(kSettingsWidth);
  return scroll;
}

QWidget* BatchWindow::makeFoot() {
  progress_->setAccessibleName(tr("Progress of the batch"));
  progress_->setRange(0, kSteps);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(8);
  QFont font = status_->font();
  font.setWeight(QFont::DemiBold);
  status_->setFont(font);
  note_->setTextFormat(Qt::PlainText);
  note_->setForegroundRole(QPalette::PlaceholderText);
  note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  start_->setDefault(true);
  start_->setMinimumWidth(120);
  start_->setToolTip(
      tr("Compress each clip, read the file back, measure it and put it in place. Finished clips "
         "that have not changed are kept."));
  stop_->setToolTip(tr("Finish the clips in progress and start no others"));
  cancel_->setToolTip(tr("Stop the clips in progress and put them back in the queue"));
  report_->setToolTip(
      tr("Open a page with the measurements of every clip and pictures of the worst frames"));
  slurm_->setToolTip(
      tr("Write a script for Slurm's sbatch that compresses this queue on a cluster"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(6);
  buttons->addWidget(start_);
  buttons->addWidget(stop_);
  buttons->addWidget(cancel_);
  buttons->addWidget(note_, 1);
  buttons->addWidget(slurm_);
  buttons->addWidget(report_);
  auto* foot = new QWidget(this);
  auto* column = new QVBoxLayout(foot);
  column->setContentsMargins(12, 10, 12, 12);
  column->setSpacing(8);
  column->addWidget(status_);
  column->addWidget(progress_);
  column->addLayout(buttons);
  return foot;
}

void BatchWindow::connectSession() {
  connect(session_, &BatchSession::settingsChanged, this, &BatchWindow::showOutput);
  connect(session_->presets(), &PresetShelf::changed, this, [this] {
    editor_->setPresets(session_->presets()->all());
    showSelection();
  });
  connect(session_->presets(), &PresetShelf::noted, note_, &QLabel::setText);
  connect(session_, &BatchSession::progressed, this, &BatchWindow::showProgress);
  connect(session_, &BatchSession::noted, note_, &QLabel::setText);
  connect(start_, &QPushButton::clicked, session_, [this] {
    note_->clear();
    if (session_->state() == BatchSession::State::Paused)
      session_->goOn();
    else if (session_->running())
      session_->pause();
    else
      session_->start();
  });
  connect(stop_, &QPushButton::clicked, session_, &BatchSession::stopAfterCurrent);
  connect(cancel_, &QPushButton::clicked, session_, &BatchSession::cancel);
  connect(report_, &QPushButton::clicked, this, [this] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(session_->report()));
    // Shows the path, since nothing tells whether a browser opened.
    note_->setText(tr("Report: %1").arg(QDir::toNativeSeparators(session_->report())));
  });
  connect(slurm_, &QPushButton::clicked, this, &BatchWindow::writeSlurm);
}

void BatchWindow::connectQueue() {
  BatchQueueModel* queue = session_->queue();
  connect(view_, &BatchQueueView::dropped, session_, &BatchSession::addClips);
  connect(view_, &BatchQueueView::removeRequested, session_, &BatchSession::remove);
  connect(view_, &BatchQueueView::leaveOutRequested, session_, &BatchSession::setLeftOut);
  connect(view_, &BatchQueueView::lockToggled, session_, [this, queue](int row) {
    const bool locked = queue->clips()[static_cast<std::size_t>(row)].own.has_value();
    const std::optional<Settings> preset =
        locked ? std::nullopt : std::optional(queue->presetOf(row));
    session_->setOwn({row}, preset);
  });
  connect(view_, &BatchQueueView::selectedRowsChanged, this, &BatchWindow::showSelection);
  connect(view_, &BatchQueueView::openRequested, this, [this, queue](int row) {
    const std::string& path = queue->clips()[static_cast<std::size_t>(row)].source.path;
    emit openRequested(QString::fromStdString(path));
  });
  connect(queue, &BatchQueueModel::edited, this, [this] {
    showSelection();
    showOutput();
  });
  connect(queue, &BatchQueueModel::modelReset, this, &BatchWindow::showSelection);
  connect(output_, &BatchOutput::settingsChanged, session_, &BatchSession::setSettings);
  connect(output_, &BatchOutput::folderRequested, this, &BatchWindow::chooseFolder);
  connect(character_, &CharacterChoice::fileRequested, this, &BatchWindow::chooseCharacter);
  connect(character_, &CharacterChoice::removed, this, [this] { putCharacter({}); });
}

void BatchWindow::connectPresets() {
  connect(editor_, &PresetEditor::presetChanged, this, &BatchWindow::changePreset);
  connect(editor_->chooser(), &PresetChooser::saveRequested, this, &BatchWindow::savePreset);
  connectShelf(editor_->chooser(), session_->presets(), this);
  connect(unlock_, &QPushButton::clicked, this,
          [this] { session_->setOwn(view_->selectedRows(), std::nullopt); });
}

void BatchWindow::chooseFiles() {
  session_->addClips(QFileDialog::getOpenFileNames(this, tr("Add Clips"), {},
                                                   tr("Motion (%1)").arg(motionPatterns())));
}

void BatchWindow::chooseClipFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Add All Clips below"));
  if (!folder.isEmpty()) session_->addClips({folder});
}

void BatchWindow::chooseFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of the Batch"),
                                                           session_->settings().folder);
  if (folder.isEmpty()) return;
  BatchSettings settings = session_->settings();
  settings.folder = folder;
  session_->setSettings(settings);
}

void BatchWindow::chooseCharacter() {
  const QString& now = session_->settings().character;
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Character on All Clips"), now.isEmpty() ? QString() : QFileInfo(now).path(),
      ClipFiles::tr("Characters (*.fbx *.glb *.gltf *.vrm)"));
  if (!path.isEmpty()) putCharacter(path);
}

void BatchWindow::putCharacter(const QString& path) {
  BatchSettings settings = session_->settings();
  settings.character = path;
  session_->setSettings(settings);
}

void BatchWindow::savePreset(const Settings& preset) {
  const Settings named = askForName(preset, this);
  if (!named.name.empty() && session_->presets()->save(named)) changePreset(named);
}

void BatchWindow::writeSlurm() {
  bool accepted = false;
  const int tasks = QInputDialog::getInt(this, tr("Slurm Script"), tr("Tasks of the job array"), 8,
                                         1, 1000, 1, &accepted);
  if (!accepted) return;
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Slurm Script"),
      QDir(session_->settings().folder).filePath(QStringLiteral("batch.sh")),
      tr("Shell scripts (*.sh)"));
  if (!path.isEmpty()) session_->writeSlurm(path, tasks);
}

/// Locks the selected clips to the preset. Without a selection, changes the preset of all clips
/// that are not locked.
void BatchWindow::changePreset(const Settings& preset) {
  const std::vector<int> rows = view_->selectedRows();
  if (rows.empty())
    session_->setCommon(preset);
  else
    session_->setOwn(rows, preset);
}

void BatchWindow::showSelection() {
  const std::vector<int> rows = view_->selectedRows();
  const BatchQueueModel& queue = *session_->queue();
  bool locked = false;
  for (const int row : rows) locked = locked || queue.clips()[static_cast<std::size_t>(row)].own;
  whose_->setText(rows.empty() ? tr("Settings of all clips")
                               : tr("Settings of %Ln selected clip(s)", nullptr,
                                    static_cast<int>(rows.size())));
  whose_->setToolTip(
      tr("Changes made while clips are selected apply to these clips only, and lock them."));
  unlock_->setVisible(locked);
  editor_->setPreset(rows.empty() ? queue.common() : queue.presetOf(rows.front()));
}

void BatchWindow::showOutput() {
  output_->setSettings(session_->settings());
  character_->setPath(session_->settings().character);
  bool wrong = false;
  const QString example = session_->exampleName(&wrong);
  output_->setExample(example, wrong);
}

void BatchWindow::showProgress() {
  const bool running = session_->running();
  const auto state = session_->state();
  start_->setText(startText(*session_));
  start_->setIcon(themedIcon(state == BatchSession::State::Running ? QStringLiteral("pause")
                                                                   : QStringLiteral("play")));
  const bool ending =
      state == BatchSession::State::Stopping || state == BatchSession::State::Cancelling;
  start_->setEnabled(running ? !ending : session_->obstacle().isEmpty());
  stop_->setEnabled(running && !ending);
  cancel_->setEnabled(running && state != BatchSession::State::Cancelling);
  report_->setEnabled(!running && !session_->report().isEmpty());
  slurm_->setEnabled(!running && session_->obstacle().isEmpty());
  settings_->setEnabled(!running);
  view_->setEditable(!running);
  undo_->setEnabled(!running && session_->history().canUndo());
  redo_->setEnabled(!running && session_->history().canRedo());
  progress_->setValue(static_cast<int>(kSteps * session_->fraction()));
  status_->setText(statusOf(*session_));
}

void BatchWindow::offer(const std::vector<TunedClip>& clips) {
  if (session_->queue()->clips().empty()) session_->addTuned(clips);
}

void BatchWindow::closeEvent(QCloseEvent* event) {
  QSettings().setValue(kGeometry, saveGeometry());
  event->accept();
}

/// Escape clears the selection, which shows the settings of all clips.
void BatchWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) view_->clearSelection();
  QWidget::keyPressEvent(event);
}

}  // namespace mocapress
