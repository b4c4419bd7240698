// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/edit_step.h"

#include <utility>

namespace mocapress {

EditStep::EditStep(const QString& text, std::function<void()> redo, std::function<void()> undo,
                   QString kind, int pause_ms)
    : QUndoCommand(text),
      redo_(std::move(redo)),
      undo_(std::move(undo)),
      kind_(std::move(kind)),
      pause_ms_(pause_ms) {
  made_.start();
}

bool EditStep::mergeWith(const QUndoCommand* newer) {
  const auto* step = static_cast<const EditStep*>(newer);
  if (kind_.isEmpty() || kind_ != step->kind_ || made_.elapsed() > pause_ms_) return false;
  redo_ = step->redo_;
  made_.restart();
  return true;
}

}  // namespace mocapress
