// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/timeline/time_axis.h"

namespace mocapress {

/// A note on a frame or a range, as the strip shows it.
struct TimeNote {
  int frame = 0;
  QString text;        // beside the mark
  QString details;     // the tooltip
  bool stale = false;  // clip or settings have changed since
  std::optional<int> last_frame = {};
};

/// Notes on frames over time. Each has a mark, which is hollow if the note is stale, a line to the
/// end of its range, and as much of its text as fits. A click on a mark chooses the note, the right
/// button edits or removes it. The strip is hidden without notes.
class NoteStrip : public QWidget {
  Q_OBJECT

 public:
  explicit NoteStrip(QWidget* parent = nullptr);

  /// Sets the notes, sorted by frame.
  void setNotes(std::vector<TimeNote> notes);
  void setFrames(int frames);
  void setFrame(int frame);
  void setWindow(const FrameWindow& window);

  /// Sets the width in pixels for the names at the left, shared with the other strips.
  void setLabelWidth(int pixels);
  int labelWidth() const;

  QSize sizeHint() const override { return {200, 18}; }

 signals:
  void seekRequested(int frame);
  void noteChosen(int index);
  void editRequested(int index);
  void removeRequested(int index);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  TimeAxis axis() const;
  int noteAt(double x) const;  // the nearest mark within reach; -1: none

  std::vector<TimeNote> notes_;
  int frames_ = 0;
  FrameWindow window_;
  int frame_ = 0;
  int label_width_ = 0;
};

}  // namespace mocapress
