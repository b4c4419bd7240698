// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/leaving.h"

#include <QWidget>

#include "app/studio/document/clip_files.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "app/studio/library/project_files.h"

namespace mocapress {

Leaving::Leaving(Session* session, ClipFiles* files, Library* library, ProjectFiles* projects,
                 QWidget* window)
    : QObject(window),
      session_(session),
      files_(files),
      library_(library),
      projects_(projects),
      window_(window) {}

bool Leaving::mayClose() {
  if (!may_lose_clip_ && session_->document().modified()) {
    files_->leave([this] {
      may_lose_clip_ = true;
      may_lose_clip_ = window_->close();
    });
    return false;
  }
  if (!may_lose_project_ && !library_->end()) {
    projects_->askToQuit([this] {
      may_lose_clip_ = may_lose_project_ = true;
      window_->close();
    });
    return false;
  }
  return true;
}

}  // namespace mocapress
