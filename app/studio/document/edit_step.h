// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QUndoCommand>
#include <QUndoStack>
#include <functional>
#include <utility>

namespace mocapress {

inline constexpr int kOneStepMs = 1000;  // longest pause within a step made of changes
inline constexpr int kOneNoteMs = 1500;  // longest pause within a step made of typing

/// A step of any undo history, made of two functions. redo() is called once when it is pushed.
class EditStep : public QUndoCommand {
 public:
  /// `name` returns the step's name in the current language. Steps of the same `kind` that follow
  /// each other within `pause_ms` merge, as during a drag or while typing. Steps with an empty kind
  /// never merge.
  EditStep(std::function<QString()> name, std::function<void()> redo, std::function<void()> undo,
           QString kind = {}, int pause_ms = kOneStepMs)
      : QUndoCommand(name()),
        name_(std::move(name)),
        redo_(std::move(redo)),
        undo_(std::move(undo)),
        kind_(std::move(kind)),
        pause_ms_(pause_ms) {
    made_.start();
  }

  QString name() const { return name_(); }

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
  std::function<QString()> name_;
  std::function<void()> redo_, undo_;
  QString kind_;
  int pause_ms_;
  QElapsedTimer made_;
};

/// Names the steps of a history anew after a change of the language. A macro has the name of its
/// first step.
inline void renameSteps(const QUndoStack& history) {
  for (int i = 0; i < history.count(); ++i) {
    const QUndoCommand* const step = history.command(i);
    const QUndoCommand* const named = step->childCount() > 0 ? step->child(0) : step;
    if (const auto* edit = dynamic_cast<const EditStep*>(named))
      const_cast<QUndoCommand*>(step)->setText(edit->name());
  }
}

}  // namespace mocapress
