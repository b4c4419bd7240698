// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/outline_reader.h"

#include "app/studio/library/project.h"

namespace mocapress {

void OutlineReader::add(const QString& path) {
  unread_.push_back(path);
  readNext();
}

void OutlineReader::readNext() {
  if (reading_.busy()) return;
  const ProjectClip* clip = nullptr;
  QString path;
  while (!clip && !unread_.empty()) {
    path = unread_.front();
    unread_.pop_front();
    clip = project_->find(path);
  }
  if (!clip) return;
  const auto finish = [this, path](const ClipOutline& outline, const QString& trouble) {
    emit read(path, outline, trouble);
    // The runner is busy until its delivery has returned.
    QMetaObject::invokeMethod(this, &OutlineReader::readNext, Qt::QueuedConnection);
  };
  reading_.start([path, skeleton = clip->skeleton, reading = clip->reading](
                     const Job&) { return readOutline(path, skeleton, reading); },
                 [finish](const ClipOutline& outline) { finish(outline, {}); },
                 [finish](const QString& message) { finish({}, message); });
}

}  // namespace mocapress
