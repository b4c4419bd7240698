// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeView>
#include <vector>

namespace mocapress {

class BatchQueueModel;

/// The clips of a batch in a table that takes dropped files and folders.
class BatchQueueView : public QTreeView {
  Q_OBJECT

 public:
  explicit BatchQueueView(BatchQueueModel* model, QWidget* parent = nullptr);

  std::vector<int> selectedRows() const;

  /// Tells whether clips may be changed; they may not while a batch runs.
  void setEditable(bool editable) { editable_ = editable; }

 signals:
  void dropped(const QStringList& paths);
  void removeRequested(const std::vector<int>& rows);
  void lockToggled(int row);
  void leaveOutRequested(const std::vector<int>& rows, bool left_out);
  void selectedRowsChanged();
  void openRequested(int row);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void requestLeftOut(bool left_out);
  void fitColumns();

  bool editable_ = true;
};

}  // namespace mocapress
