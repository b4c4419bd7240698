// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QUndoCommand>
#include <functional>
#include <utility>

namespace mocapress {

inline constexpr int kOneStepMs = 1000;  // between changes that are one step
inline constexpr int kOneNoteMs = 1500;  // between keys that are one text

/// The one kind of step there is in every undo history: two functions. redo() is called once when
/// the step is pushed.
class EditStep : public QUndoCommand {
 public:
  /// Steps of the same `kind` that follow each other within `pause_ms`, as while a slider is
  /// dragged or a text is typed, are one. An empty kind: the step is always its own.
  EditStep(const QString& text, std::function<void()> redo, std::function<void()> undo,
           QString kind = {}, int pause_ms = kOneStepMs)
      : QUndoCommand(text),
        redo_(std::move(redo)),
        undo_(std::move(undo)),
        kind_(std::move(kind)),
        pause_ms_(pause_ms) {
    made_.start();
  }

  int id() const override { return 1; }  // all may ask each other; the kind decides
  bool mergeWith(const QUndoCommand* newer) override {
    const auto* step = static_cast<const EditStep*>(newer);
    if (kind_.isEmpty() || kind_ != step->kind_ || made_.elapsed() > pause_ms_) return false;
    redo_ = step->redo_;
    made_.restart();
    return true;
  }
  void undo() override { undo_(); }
  void redo() override { redo_(); }

 private:
  std::function<void()> redo_, undo_;
  QString kind_;
  int pause_ms_;
  QElapsedTimer made_;
};

}  // namespace mocapress
