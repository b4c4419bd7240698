// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QUndoCommand>
#include <functional>

#include "app/studio/document/document.h"

namespace mocapress {

/// The first setting in which two differ, as a person would name it.
enum class SettingsField {
  None,
  Preset,
  Target,
  Method,
  Effort,
  Importance,
  Weighting,
  Ends,
  Coding,
  Correction,
  Contacts,
  Slot,
  Other
};
SettingsField firstDifference(const ClipSettings& a, const ClipSettings& b);

/// One step that can be undone. Changes of one setting that follow each other quickly, as while a
/// slider is dragged, are one step.
class SettingsChange : public QUndoCommand {
 public:
  using Apply = std::function<void(const Tuning&)>;

  SettingsChange(Tuning before, Tuning after, Apply apply);

  int id() const override { return static_cast<int>(field_); }
  bool mergeWith(const QUndoCommand* newer) override;
  void undo() override { apply_(before_); }
  void redo() override { apply_(after_); }

 private:
  Tuning before_;
  Tuning after_;
  SettingsField field_;
  Apply apply_;
  QElapsedTimer made_;
};

}  // namespace mocapress
