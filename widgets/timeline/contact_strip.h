// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/contact/footskate.h"

namespace mocapress {

/// The contacts of a clip over time, one lane a foot, each bar coloured by how far the foot slides
/// in it; a click seeks.
class ContactStrip : public QWidget {
  Q_OBJECT

 public:
  explicit ContactStrip(QWidget* parent = nullptr);

  /// `names` of all landmarks, by index.
  void setContacts(std::vector<ContactSpan> contacts, const std::vector<QString>& names,
                   int frames);
  void setFindings(const std::vector<SlideFinding>& findings);
  void setFrame(int frame);

  QSize sizeHint() const override;

 signals:
  void seekRequested(int frame);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  QRectF barOf(const ContactSpan& span) const;
  double xOf(double frame) const;
  int frameAt(double x) const;
  double slideOf(const ContactSpan& span) const;  // cm
  QString describe(const ContactSpan& span) const;

  std::vector<ContactSpan> contacts_;
  std::vector<SlideFinding> findings_;
  std::vector<int> lanes_;  // landmarks
  std::vector<QString> names_;
  int frames_ = 0;
  int frame_ = 0;
  int label_width_ = 0;  // pixels
};

}  // namespace mocapress
