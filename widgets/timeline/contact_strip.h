// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/feet/footskate.h"
#include "widgets/models/contact_edit.h"
#include "widgets/timeline/time_axis.h"

namespace mocapress {

/// The contacts of a clip over time, with one lane for each foot. A bar's colour tells how far the
/// foot slides. A click seeks, the ends of a bar can be dragged, the right button adds and removes
/// contacts.
class ContactStrip : public QWidget {
  Q_OBJECT

 public:
  explicit ContactStrip(QWidget* parent = nullptr);

  /// `names` has the names of all landmarks, by index.
  void setContacts(std::vector<ContactSpan> contacts, const std::vector<QString>& names,
                   int frames);
  void setFindings(const std::vector<SlideFinding>& findings);
  void setFrame(int frame);
  void setWindow(const FrameWindow& window);

  /// The width in pixels that the names need; setLabelWidth() sets the width that they get.
  int labelWidth() const { return names_width_; }
  void setLabelWidth(int pixels);

  /// Length of an added contact, in frames.
  void setUsualLength(int frames) { usual_length_ = frames; }

  QSize sizeHint() const override;

 signals:
  void seekRequested(int frame);
  void contactsEdited(const std::vector<mocapress::ContactSpan>& contacts);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  /// An end of a contact that the mouse can drag.
  struct Handle {
    int contact;
    SpanEnd end;
  };

  TimeAxis axis() const;
  QRectF barOf(const ContactSpan& span) const;
  std::optional<Handle> handleAt(const QPointF& position) const;
  int contactAt(const QPointF& position) const;   // -1: none
  int laneAt(double y) const;                     // landmark of the lane; -1: none
  double slideOf(const ContactSpan& span) const;  // in cm
  QString describe(const ContactSpan& span) const;

  std::vector<ContactSpan> contacts_;
  std::vector<SlideFinding> findings_;
  std::vector<int> lanes_;  // landmark of each lane
  std::vector<QString> names_;
  int frames_ = 0;
  FrameWindow window_;
  int frame_ = 0;
  int names_width_ = 0;  // pixels that the names need
  int label_width_ = 0;
  int usual_length_ = 30;
  std::optional<Handle> dragged_;
  std::vector<ContactSpan> before_drag_;
};

}  // namespace mocapress
