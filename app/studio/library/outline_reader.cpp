// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/outline_reader.h"

#include "app/studio/library/project.h"

namespace mocapress {

void OutlineReader::add(const QString& key) {
  unread_.push_back(key);
  readNext();
}

void OutlineReader::readNext() {
  if (reading_.busy()) return;
  const ProjectClip* clip = nullptr;
  QString key;
  while (!clip && !unread_.empty()) {
    key = unread_.front();
    unread_.pop_front();
    clip = project_->find(key);
  }
  if (!clip) return;
  const auto finish = [this, key](const ClipOutline& outline, const QString& trouble) {
    emit read(key, outline, trouble);
    readNext();
  };
  reading_.start([path = clip->path, skeleton = clip->skeleton, reading = clip->reading](
                     const Job&) { return readOutline(path, skeleton, reading); },
                 [finish](const ClipOutline& outline) { finish(outline, {}); },
                 [finish](const QString& message) { finish({}, message); });
}

}  // namespace mocapress
