// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/tool_windows.h"

#include "app/studio/batch/batch_memory.h"
#include "app/studio/batch/batch_window.h"
#include "app/studio/document/clip_files.h"
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

/// Where the open clip is on the curves of the study.
void ToolWindows::showHere() {
  const Document& document = session_->document();
  std::optional<CurvePoint> here;
  if (document.original() && document.decoded() && document.decoded()->distortion)
    here = {document.decoded()->ratio,
            document.decoded()->distortion->eps(study_session_->weighting())};
  study_->setHere(document.original() ? document.original()->path : QString(), here);
}

void ToolWindows::makeBatch() {
  batch_ = new BatchWindow(new BatchSession(batchMemory(), presets_, window_), window_);
  BatchSession* session = batch_->session();
  session->setReviews(library_->reviews());
  connect(library_, &Library::currentChanged, session,
          [this, session] { session->setReviews(library_->reviews()); });
  connect(batch_, &BatchWindow::openRequested, files_,
          [this](const QString& path) { files_->open(path); });
}

void ToolWindows::showBatch() {
  if (!batch_) makeBatch();
  bringToFront(batch_);
  if (const OriginalPtr& original = session_->document().original())
    batch_->offerClip(original->path);
}

void ToolWindows::exportClips(const std::vector<int>& rows) {
  if (!batch_) makeBatch();
  bringToFront(batch_);
  batch_->session()->addTuned(library_->tuned(rows), library_->project().character);
}

void ToolWindows::close() {
  if (study_) study_->close();
  if (batch_) batch_->close();
}

}  // namespace mocapress
