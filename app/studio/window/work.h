// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/studio/compare/pinned_results.h"
#include "app/studio/document/preset_shelf.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "widgets/models/library_model.h"
#include "widgets/models/pinned_model.h"

namespace mocapress {

/// The user's work, with its undo histories. A window shows it. When the language changes, another
/// window replaces that one and shows the same work.
class Work : public QObject {
 public:
  explicit Work(QObject* parent = nullptr) : QObject(parent) {
    presets.setHistory([this] { return session.history(); });
    pinned.setMemory([this](const QString& clip) { return library.pinsOf(clip); });
    connect(&pinned, &PinnedResults::edited, &library, &Library::setPins);
  }

  /// Emits the signals of all changes, for a window that was made after them.
  void announce() {
    library.announce();
    session.announce();
  }

  Session session{this};
  LibraryModel clips{this};
  Library library{&session, &clips, this};
  PresetShelf presets{PresetShelf::usualFile(), this};
  PinnedModel pinned_model{this};
  PinnedResults pinned{&session, &pinned_model, this};
};

}  // namespace mocapress
