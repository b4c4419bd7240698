// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

class QToolButton;

namespace mocapress {

/// Switches between two settings of one clip, A and B, and shows the result of each. The active one
/// is shown and edited.
class SlotControl : public QWidget {
  Q_OBJECT

 public:
  explicit SlotControl(QWidget* parent = nullptr);

  /// Sets the active one and the summaries of A and B; empty: no result yet. Emits nothing.
  void setSlots(int active, const std::array<QString, 2>& summaries);

  QToolButton* slot(int index) const { return buttons_[static_cast<std::size_t>(index)]; }
  QToolButton* copy() const { return copy_; }

 signals:
  void switchRequested();
  void copyRequested();

 private:
  std::array<QToolButton*, 2> buttons_;
  QToolButton* copy_;
  int active_ = 0;
};

}  // namespace mocapress
