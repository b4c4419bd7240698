// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QListWidget;
class QPushButton;

namespace mocapress {

/// The clips of a study: a list that takes dropped files and folders, and its buttons.
class StudyClips : public QWidget {
  Q_OBJECT

 public:
  explicit StudyClips(QWidget* parent = nullptr);

  void setClips(const QStringList& paths);

 signals:
  void addFilesRequested();
  void addFolderRequested();
  void dropped(const QStringList& paths);
  void removeRequested(const QStringList& paths);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void removeSelected();

  QListWidget* list_;
  QPushButton* remove_;
};

}  // namespace mocapress
