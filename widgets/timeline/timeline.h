// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>
#include <vector>

#include "core/feet/footskate.h"
#include "widgets/timeline/time_axis.h"

class QAction;
class QScrollBar;

namespace mocapress {

class ByteStrip;
class ContactStrip;
class ErrorStrip;
class NoteStrip;
class PoseStrip;
class SightStrip;
class TimeRuler;

/// The strips below the 3D view, aligned with each other. The wheel zooms about the mouse; with
/// Shift it scrolls. A scroll bar is shown while only a part of the clip is visible. Each strip can
/// be folded away.
class Timeline : public QWidget {
  Q_OBJECT

 public:
  explicit Timeline(QWidget* parent = nullptr);

  TimeRuler* ruler() const { return ruler_; }

  /// Adds commands on the chosen range to the strips' menus, after a strip's own commands.
  void addRangeActions(const QList<QAction*>& actions);
  ErrorStrip* errors() const { return errors_; }
  SightStrip* sight() const { return sight_; }
  ByteStrip* bytes() const { return bytes_; }
  NoteStrip* notes() const { return notes_; }
  ContactStrip* contacts() const { return contacts_; }
  PoseStrip* poses() const { return poses_; }

  /// A checkable action for each strip, checked while the strip is unfolded. The choice is saved.
  const QList<QAction*>& foldActions() const { return folds_; }
  QScrollBar* scroll() const { return scroll_; }

  /// Sets the clip's frames per second.
  void setRate(double sample_rate_hz);

  /// Calls ContactStrip::setContacts() and reserves equal room for names in all strips.
  void setContacts(std::vector<ContactSpan> contacts, const std::vector<QString>& names,
                   int frames);

  /// Scrolls to the frame if it is out of view.
  void setFrame(int frame);

  /// Zooms out to the whole clip.
  void showAll();

  /// Zooms to these frames, with some around them if the range is short.
  void showRange(const FrameRange& range);

  const FrameWindow& window() const { return window_; }

 signals:
  void seekRequested(int frame);

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void setWindow(double first, double length);
  TimeAxis axis() const;
  int labelWidth() const;
  void offerFold(QWidget* strip, const QString& id, const QString& name);

  TimeRuler* ruler_;
  ErrorStrip* errors_;
  SightStrip* sight_;
  ByteStrip* bytes_;
  NoteStrip* notes_;
  ContactStrip* contacts_;
  PoseStrip* poses_;
  QList<QAction*> folds_;
  QScrollBar* scroll_;
  int frames_ = 0;
  double sample_rate_hz_ = 120;
  FrameWindow window_;
};

}  // namespace mocapress
