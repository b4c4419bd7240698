// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/models/library_entry.h"

class QComboBox;
class QLineEdit;
class QListView;
class QPushButton;

namespace mocapress {

class LibraryModel;

/// The clips of the project: what each came to, and what the reviewer says. A click opens a clip.
class LibraryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryPanel(LibraryModel* model, QWidget* parent = nullptr);

  /// The clip that is open; -1: none of the list. Emits nothing.
  void setCurrent(int row);

  QListView* list() const { return list_; }
  QComboBox* verdict() const { return verdict_; }
  QLineEdit* note() const { return note_; }

  QSize sizeHint() const override { return {230, 400}; }

 signals:
  void addRequested();
  void removeRequested(int row);
  void openRequested(int row);
  void verdictChosen(int row, mocapress::Verdict verdict);
  void noteEdited(int row, const QString& note);

  /// A batch of these clips; none: of all.
  void exportRequested(const std::vector<int>& rows);

 private:
  void showReview();
  void showMenu(const QPoint& place);
  int current() const;

  LibraryModel* model_;
  QListView* list_;
  QPushButton* add_;
  QPushButton* remove_;
  QComboBox* verdict_;
  QLineEdit* note_;
};

}  // namespace mocapress
