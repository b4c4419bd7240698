// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/study/study_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStandardPaths>
#include <QVBoxLayout>

#include "app/studio/document/clip_files.h"
#include "app/studio/study/study_memory.h"
#include "app/studio/study/study_status.h"
#include "widgets/models/study_rows_model.h"
#include "widgets/panels/study_clips.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/study_results.h"
#include "widgets/plots/rate_plot.h"

namespace mocapress {
namespace {

constexpr QSize kFirstSize(1180, 820);
constexpr int kPanelWidth = 310;
const QString kGeometry = QStringLiteral("study/geometry");

}  // namespace

StudyWindow::StudyWindow(StudySession* session, QWidget* parent)
    : QWidget(parent, Qt::Window),
      session_(session),
      model_(new StudyRowsModel(this)),
      panel_(new StudyPanel(this)),
      results_(new StudyResults(model_, this)),
      export_(makeExportButton()),
      note_(new QLabel(this)) {
  setWindowTitle(tr("Study"));
  results_->addTool(export_);
  note_->setContentsMargins(8, 3, 8, 4);
  note_->setTextFormat(Qt::PlainText);
  auto* right = new QWidget(this);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(results_, 1);
  column->addWidget(note_);
  auto* left = new QScrollArea(this);  // where the screen is low
  left->setWidget(panel_);
  left->setWidgetResizable(true);
  left->setFrameShape(QFrame::NoFrame);
  left->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  left->setMinimumWidth(kPanelWidth);
  auto* halves = new QSplitter(this);
  halves->addWidget(left);
  halves->addWidget(right);
  halves->setStretchFactor(1, 1);
  halves->setChildrenCollapsible(false);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(halves);
  resize(kFirstSize);
  restoreGeometry(QSettings().value(kGeometry).toByteArray());
  connectSession();
  connectPanel();
  panel_->setSettings(session_->settings());
  panel_->setFolder(session_->folder());
  model_->append(session_->rows());
  showProgress();
}

void StudyWindow::connectSession() {
  connect(session_, &StudySession::settingsChanged, this, [this] {
    panel_->setSettings(session_->settings());
    showProgress();
  });
  connect(session_, &StudySession::folderChanged, this,
          [this] { panel_->setFolder(session_->folder()); });
  connect(session_, &StudySession::rowsCleared, model_, &StudyRowsModel::clear);
  connect(session_, &StudySession::rowsAdded, model_, &StudyRowsModel::append);
  connect(session_, &StudySession::progressed, this, &StudyWindow::showProgress);
  connect(session_, &StudySession::exportingChanged, this, &StudyWindow::showProgress);
  connect(session_, &StudySession::addFailed, note_, &QLabel::setText);
  connect(session_, &StudySession::noted, note_, &QLabel::setText);
  connect(session_, &StudySession::exportFailed, note_, &QLabel::setText);
  connect(session_, &StudySession::exported, note_, [this](const QString& path) {
    note_->setText(tr("Wrote %1.").arg(QDir::toNativeSeparators(path)));
  });
}

void StudyWindow::connectPanel() {
  connect(panel_, &StudyPanel::settingsChanged, session_, &StudySession::setSettings);
  connect(panel_, &StudyPanel::runRequested, session_, &StudySession::run);
  connect(panel_, &StudyPanel::cancelRequested, session_, [this] {
    session_->cancel();
    session_->cancelExport();
  });
  connect(panel_, &StudyPanel::folderRequested, this, &StudyWindow::chooseFolder);
  StudyClips* clips = panel_->clips();
  connect(clips, &StudyClips::addFilesRequested, this, &StudyWindow::chooseFiles);
  connect(clips, &StudyClips::addFolderRequested, this, &StudyWindow::chooseClipFolder);
  connect(clips, &StudyClips::dropped, session_, &StudySession::addClips);
  connect(clips, &StudyClips::removeRequested, session_, &StudySession::removeClips);
  connect(results_, &StudyResults::rowChosen, this, &StudyWindow::load);
}

QPushButton* StudyWindow::makeExportButton() {
  auto* button = new QPushButton(tr("&Export"), this);
  button->setToolTip(tr("Write what is measured to a file"));
  auto* menu = new QMenu(button);
  button->setMenu(menu);
  const auto add = [&](const QString& text, const QString& filter, const QString& ending,
                       auto write) {
    connect(menu->addAction(text), &QAction::triggered, this, [=, this] {
      const QString path = exportPath(text, filter, ending);
      if (!path.isEmpty()) write(path);
    });
  };
  add(tr("Rows as CSV…"), tr("Comma-separated values (*.csv)"), QStringLiteral("csv"),
      [this](const QString& path) { session_->exportRows(path); });
  add(tr("Plot as PNG…"), tr("Pictures (*.png)"), QStringLiteral("png"),
      [this](const QString& path) { session_->exportFile(path, results_->plot()->png()); });
  add(tr("Plot as PDF…"), tr("PDF documents (*.pdf)"), QStringLiteral("pdf"),
      [this](const QString& path) { session_->exportFile(path, results_->plot()->pdf()); });
  add(tr("Report as HTML…"), tr("Web pages (*.html)"), QStringLiteral("html"),
      [this](const QString& path) { session_->exportReport(path); });
  return button;
}

QString StudyWindow::exportPath(const QString& title, const QString& filter,
                                const QString& ending) {
  const QString home = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString folder = session_->folder().isEmpty() ? home : session_->folder();
  QString path = QFileDialog::getSaveFileName(
      this, title, QStringLiteral("%1/study.%2").arg(folder, ending), filter);
  if (!path.isEmpty() && QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + ending;
  return path;
}

void StudyWindow::chooseFiles() {
  const QStringList clips = session_->settings().clips;
  const QString folder = clips.isEmpty() ? QString() : QFileInfo(clips.back()).path();
  session_->addClips(QFileDialog::getOpenFileNames(this, tr("Add Clips"), folder,
                                                   tr("Motion (%1)").arg(motionPatterns())));
}

void StudyWindow::chooseClipFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Add All Clips below"));
  if (!folder.isEmpty()) session_->addClips({folder});
}

void StudyWindow::chooseFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Folder of the Study"), session_->folder());
  if (!folder.isEmpty()) session_->setFolder(folder);
}

void StudyWindow::showProgress() {
  const bool busy = session_->running() || session_->exporting();
  const bool unknown = session_->exporting() || session_->state() == StudySession::State::Drawing;
  const StudyCounts& counts = session_->counts();
  panel_->setRunning(busy, session_->jobs() > 0);
  panel_->setProgress(unknown ? 0 : counts.done, unknown ? 0 : std::max(1, counts.jobs));
  panel_->setStatus(statusOf(*session_));
  results_->setHint(hintOf(*session_));
  results_->setComplete(session_->completeClips());
  export_->setEnabled(!session_->rows().empty() && !busy);
}

void StudyWindow::offerClip(const QString& path, const QString& skeleton) {
  StudySettings settings = session_->settings();
  if (!settings.clips.isEmpty() && settings.clips != QStringList{offered_}) return;
  offered_ = path;
  settings.clips = {path};
  settings.skeleton = skeleton;
  session_->setSettings(settings);
}

void StudyWindow::setHere(const QString& path, const std::optional<CurvePoint>& here) {
  results_->setHere(path, here);
}

void StudyWindow::load(int row) {
  const StudyRow& chosen = model_->row(row);
  if (!chosen.measured) {
    note_->setText(QString::fromStdString(chosen.error));
    return;
  }
  note_->setText(tr("In the studio: %1, %2, %3.")
                     .arg(clipTitle(chosen), seriesTitle(chosen), targetText(chosen.target)));
  emit rowChosen(chosen);
}

void StudyWindow::closeEvent(QCloseEvent* event) {
  session_->cancel();
  remember(session_->settings());
  QSettings().setValue(kGeometry, saveGeometry());
  event->accept();
}

}  // namespace mocapress
