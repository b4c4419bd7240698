// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/feet/footskate.h"
#include "widgets/timeline/time_axis.h"

class QScrollBar;

namespace mocapress {

class ContactStrip;
class ErrorStrip;
class SightStrip;

/// The strips below the 3D view, in line with each other. The wheel zooms about the mouse, with
/// Shift it moves along; a scroll bar stands below while a part is in sight.
class Timeline : public QWidget {
  Q_OBJECT

 public:
  explicit Timeline(QWidget* parent = nullptr);

  ErrorStrip* errors() const { return errors_; }
  SightStrip* sight() const { return sight_; }
  ContactStrip* contacts() const { return contacts_; }
  QScrollBar* scroll() const { return scroll_; }

  /// ContactStrip::setContacts(), and leaves the same room for names in all strips.
  void setContacts(std::vector<ContactSpan> contacts, const std::vector<QString>& names,
                   int frames);

  /// Where it is out of sight, the strips move along.
  void setFrame(int frame);

  /// The whole clip is in sight again.
  void showAll();

  const FrameWindow& window() const { return window_; }

 signals:
  void seekRequested(int frame);

 protected:
  void wheelEvent(QWheelEvent* event) override;

 private:
  void setWindow(double first, double length);
  TimeAxis axis() const;
  int labelWidth() const;

  ErrorStrip* errors_;
  SightStrip* sight_;
  ContactStrip* contacts_;
  QScrollBar* scroll_;
  int frames_ = 0;
  FrameWindow window_;
};

}  // namespace mocapress
