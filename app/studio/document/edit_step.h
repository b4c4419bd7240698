// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QUndoCommand>
#include <functional>

namespace mocapress {

inline constexpr int kOneStepMs = 1000;  // between changes that are one step

/// A step that is undone and redone by two functions; redo() is called once when it is pushed.
class EditStep : public QUndoCommand {
 public:
  /// Steps of the same `kind` that follow each other quickly are one; empty: it is always its own.
  EditStep(const QString& text, std::function<void()> redo, std::function<void()> undo,
           QString kind = {});

  int id() const override { return 2000; }  // settings and reviews have smaller ones
  bool mergeWith(const QUndoCommand* newer) override;
  void undo() override { undo_(); }
  void redo() override { redo_(); }

 private:
  std::function<void()> redo_, undo_;
  QString kind_;
  QElapsedTimer made_;
};

}  // namespace mocapress
