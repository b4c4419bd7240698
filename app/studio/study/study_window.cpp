// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/study/study_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/studio/document/clip_files.h"
#include "app/studio/study/study_session.h"
#include "widgets/models/number_text.h"
#include "widgets/models/sentence.h"
#include "widgets/models/study_rows_model.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/study_results.h"
#include "widgets/plots/rate_plot.h"

namespace mocapress {

namespace {

struct Status {
  Q_DECLARE_TR_FUNCTIONS(mocapress::StudyStatus)
};

constexpr int kFirstEstimate = 3;  // rows measured before the first estimate of the time left

QString asked(const StudySession& session) {
  const int jobs = session.jobs();
  if (jobs == 0) return hintOf(session);
  return Status::tr("%Ln compression(s) to run", nullptr, jobs);
}

QString running(const StudySession& session) {
  const StudyCounts& counts = session.counts();
  const QString so_far = Status::tr("%L1 of %L2").arg(counts.done).arg(counts.jobs);
  const int anew = counts.done - counts.kept;
  if (anew < kFirstEstimate || counts.done == counts.jobs) return so_far;
  const double left = session.elapsedSeconds() / anew * (counts.jobs - counts.done);
  return Status::tr("%1, about %2 left").arg(so_far, clockText(left));
}

/// Counts the rows that could not be measured.
QString blemishes(const StudySession& session) {
  int unread = 0;
  int missed = 0;
  for (const StudyRow& row : session.rows())
    if (!row.measured) ++(row.fingerprint.empty() ? unread : missed);
  QString text;
  if (missed > 0) text += Status::tr(", %Ln out of reach", nullptr, missed);
  if (unread > 0) text += Status::tr(", %Ln of clips that cannot be read", nullptr, unread);
  return text;
}

QString complete(const StudySession& session) {
  const auto rows = static_cast<int>(session.rows().size());
  return Status::tr("%Ln compression(s)%1", nullptr, rows).arg(blemishes(session));
}

}  // namespace

QString statusOf(const StudySession& session) {
  if (session.exporting()) return Status::tr("Writing…");
  switch (session.state()) {
    case StudySession::State::Idle:
      return asked(session);
    case StudySession::State::Running:
      return running(session);
    case StudySession::State::Drawing:
      return Status::tr("Drawing the report…");
    case StudySession::State::Complete:
    case StudySession::State::Opened:
      return complete(session);
    case StudySession::State::Cancelled:
      return Status::tr("Cancelled after %L1 of %L2; the next run continues from there")
          .arg(session.counts().done)
          .arg(session.counts().jobs);
    case StudySession::State::Failed:
      return session.failure();
  }
  return {};
}

QString hintOf(const StudySession& session) {
  const StudySettings& settings = session.settings();
  if (settings.clips.isEmpty()) return Status::tr("Add a clip to study");
  if (settings.methods.isEmpty()) return Status::tr("Check a method to study");
  if (settings.ratios.empty() && settings.errors.empty())
    return Status::tr("Enter a ratio or an error");
  return session.running() ? Status::tr("Measuring…")
                           : Status::tr("Curves appear after the study has run");
}

namespace {

const QString kMethods = QStringLiteral("study/methods");
const QString kRatios = QStringLiteral("study/ratios");
const QString kErrors = QStringLiteral("study/errors");
const QString kIkRatio = QStringLiteral("study/ik-ratio");
const QString kWeighting = QStringLiteral("study/weighting");

QVariantList listOf(const std::vector<double>& numbers) {
  return {numbers.begin(), numbers.end()};
}

std::vector<double> numbersOf(const QVariant& list) {
  std::vector<double> numbers;
  for (const QVariant& entry : list.toList())
    if (const double number = entry.toDouble(); number > 0) numbers.push_back(number);
  return numbers;
}

}  // namespace

StudySettings rememberedStudySettings() {
  const QSettings stored;
  StudySettings settings = usualStudySettings();
  if (!stored.contains(kMethods)) return settings;
  settings.methods = stored.value(kMethods).toStringList();
  settings.ratios = numbersOf(stored.value(kRatios));
  settings.errors = numbersOf(stored.value(kErrors));
  if (const double ik = stored.value(kIkRatio).toDouble(); ik > 0) settings.ik_ratio = ik;
  for (const Weighting weighting : kWeightings)
    if (stored.value(kWeighting) == static_cast<int>(weighting)) settings.weighting = weighting;
  return settings;
}

void remember(const StudySettings& settings) {
  QSettings stored;
  stored.setValue(kMethods, settings.methods);
  stored.setValue(kRatios, listOf(settings.ratios));
  stored.setValue(kErrors, listOf(settings.errors));
  stored.setValue(kIkRatio, settings.ik_ratio.value_or(0));
  stored.setValue(kWeighting, static_cast<int>(settings.weighting));
}

QString studyCache() {
  const QFileInfo program(QCoreApplication::applicationFilePath());
  return QStringLiteral("%1/study-%2")
      .arg(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
      .arg(program.lastModified().toSecsSinceEpoch());
}

namespace {

constexpr QSize kFirstSize(1180, 820);
constexpr QSize kFrame(10, 40);  // a window's frame, with its title
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
  auto* left = new QScrollArea(this);  // scrolls if the screen is low
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
  // The screen may be smaller than that of the last time.
  resize(size().boundedTo(screen()->availableSize() - kFrame));
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
  button->setToolTip(tr("Write the measurements to a file"));
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
  if (session_->rows().empty()) results_->plot()->setWeighting(session_->settings().weighting);
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
    note_->setText(translatedSentence(QString::fromStdString(chosen.error)));
    return;
  }
  note_->setText(
      tr("In the studio: %1, %2, %3.")
          .arg(clipTitle(chosen), seriesTitle(chosen), targetText(chosen.settings.target)));
  emit rowChosen(chosen);
}

void StudyWindow::closeEvent(QCloseEvent* event) {
  session_->cancel();
  remember(session_->settings());
  QSettings().setValue(kGeometry, saveGeometry());
  event->accept();
}

}  // namespace mocapress
