// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/tool_windows.h"

#include "app/studio/batch/batch_window.h"
#include "app/studio/blind_test/blind_test_window.h"
#include "app/studio/document/clip_files.h"
#include "app/studio/document/own_limits.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "app/studio/study/study_window.h"

namespace mocapress {
namespace {

void bringToFront(QWidget* window) {
  window->show();
  window->raise();
  window->activateWindow();
}

}  // namespace

ToolWindows::ToolWindows(Session* session, Library* library, ClipFiles* files, PresetShelf* presets,
                         QWidget* window)
    : QObject(window),
      session_(session),
      library_(library),
      files_(files),
      presets_(presets),
      window_(window) {}

StudyWindow* ToolWindows::showStudy() {
  if (!study_) makeStudy();
  if (const OriginalPtr& original = session_->document().original())
    study_->offerClip(original->path, rememberedSkeleton(original->path));
  showHere();
  bringToFront(study_);
  return study_;
}

void ToolWindows::makeStudy() {
  study_session_ = new StudySession(studyCache(), window_);
  study_session_->setSettings(rememberedStudySettings());
  study_ = new StudyWindow(study_session_, window_);
  study_session_->setReviews(library_->reviews());
  connect(library_, &Library::currentChanged, study_session_,
          [this] { study_session_->setReviews(library_->reviews()); });
  connect(study_, &StudyWindow::rowChosen, files_, &ClipFiles::openRow);
  connect(study_session_, &StudySession::rowsCleared, this, &ToolWindows::showHere);
  connect(&session_->document(), &Document::decodedChanged, this, &ToolWindows::showHere);
}

/// Marks the open clip in the study's plot.
void ToolWindows::showHere() {
  const Document& document = session_->document();
  std::optional<CurvePoint> here;
  if (document.original() && document.decoded() && document.decoded()->distortion)
    here = {document.decoded()->ratio,
            document.decoded()->distortion->eps(study_session_->weighting())};
  study_->setHere(document.original() ? document.original()->path : QString(), here);
}

void ToolWindows::makeBatch() {
  auto* session = new BatchSession(presets_, window_);
  batch_ = new BatchWindow(session, window_);
  session->setReviews(library_->reviews());
  keepWithProject(session);
  connect(session, &BatchSession::exported, library_,
          [this, queue = session->queue()](int row, const BatchStep& step) {
            const QueuedClip& clip = queue->clips()[static_cast<std::size_t>(row)];
            library_->noteExported(QString::fromStdString(clip.source.path), queue->presetOf(row),
                                   clip.reading, step);
          });
  connect(library_, &Library::currentChanged, session,
          [this, session] { session->setReviews(library_->reviews()); });
  connect(batch_, &BatchWindow::openRequested, files_,
          [this](const QString& path) { files_->open(path); });
}

/// Saves each project's batch with the project.
void ToolWindows::keepWithProject(BatchSession* session) {
  const auto recall = [this, session] {
    session->recall(library_->project().batch.value_or(RememberedBatch()));
  };
  recall();
  connect(library_, &Library::entered, session, recall);
  connect(session, &BatchSession::keep, library_,
          [this, session] { library_->setBatch(session->remembered()); });
  library_->setLeaveCheck([session] {
    session->rememberNow();
    return session->running()
               ? tr("The batch of this project is running. Stop it or wait until it ends.")
               : QString();
  });
}

void ToolWindows::showBatch() {
  if (!batch_) makeBatch();
  bringToFront(batch_);
  if (library_->currentRow() >= 0) batch_->offer(library_->tuned({library_->currentRow()}));
}

BlindTestWindow* ToolWindows::showBlindTest() {
  if (!blind_test_) {
    blind_test_ = new BlindTestWindow(session_, BlindTestWindow::usualFile(), window_);
    connect(blind_test_, &BlindTestWindow::limitsChanged, session_, [this] {
      library_->takeOwnLimits();
      EncodeSettings options = session_->document().options();
      options.limits.of_cues = ownLimits().limits.of_cues;
      session_->setOptions(options);
    });
  }
  if (!blind_test_->isVisible()) blind_test_->prepare();
  bringToFront(blind_test_);
  return blind_test_;
}

void ToolWindows::exportClips(const std::vector<int>& rows) {
  if (!batch_) makeBatch();
  bringToFront(batch_);
  batch_->session()->addTuned(library_->tuned(rows));
}

bool ToolWindows::busy() const {
  return (study_session_ && study_session_->running()) ||
         (batch_ && batch_->session()->running()) || (blind_test_ && blind_test_->running());
}

void ToolWindows::close() {
  if (study_) study_->close();
  if (batch_) {
    batch_->session()->rememberNow();
    library_->setLeaveCheck({});  // the library may outlive the window
    batch_->close();
  }
  if (blind_test_) blind_test_->close();
}

}  // namespace mocapress
