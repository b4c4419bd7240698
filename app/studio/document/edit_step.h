// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QUndoCommand>
#include <functional>
#include <utility>

namespace mocapress {

inline constexpr int kOneStepMs = 1000;  // longest pause within a step made of changes
inline constexpr int kOneNoteMs = 1500;  // longest pause within a step made of typing

/// A step of any undo history, made of two functions. redo() is called once when it is pushed.
class EditStep : public QUndoCommand {
 public:
  /// Steps of the same `kind` that follow each other within `pause_ms` merge, as during a drag or
  /// while typing. An empty kind never merges.
  EditStep(const QString& text, std::function<void()> redo, std::function<void()> undo,
           QString kind = {}, int pause_ms = kOneStepMs)
      : QUndoCommand(text),
        redo_(std::move(redo)),
        undo_(std::move(undo)),
        kind_(std::move(kind)),
        pause_ms_(pause_ms) {
    made_.start();
  }

  int id() const override { return 1; }  // equal for all steps: mergeWith() decides by kind
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
