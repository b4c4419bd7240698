// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QWidget>
#include <vector>

#include "core/mocapress/settings.h"
#include "widgets/models/library_model.h"

class QComboBox;
class QLineEdit;
class QMenu;
class QPushButton;
class QTreeView;

namespace mocapress {

class LibraryModel;
class LibraryTree;

/// The clips of the project below their folders: what each came to, and what the reviewer says. A
/// click opens a clip.
class LibraryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryPanel(LibraryModel* model, QWidget* parent = nullptr);

  /// The clip that is open; -1: none of the list. Emits nothing.
  void setCurrent(int row);

  /// The clips that are selected, and all below selected folders.
  std::vector<int> chosenRows() const;

  /// Those that clips can be given.
  void setPresets(const std::vector<Settings>& presets) { presets_ = presets; }

  QTreeView* view() const { return view_; }
  LibraryTree* tree() const { return tree_; }
  QPushButton* removeButton() const { return remove_; }
  QLineEdit* filter() const { return filter_; }
  QComboBox* verdict() const { return verdict_; }
  QLineEdit* note() const { return note_; }

  /// The context menu of the selection.
  QMenu* makeMenu();

  QSize sizeHint() const override { return {230, 400}; }

  /// In less, rows would say nothing.
  QSize minimumSizeHint() const override { return {210, 200}; }

 signals:
  void addRequested();
  void addFolderRequested();
  void removeRequested(const QList<int>& rows);
  void openRequested(int row);
  /// For all that is selected.
  void verdictChosen(const std::vector<int>& rows, mocapress::Verdict verdict);
  void presetChosen(const std::vector<int>& rows, const mocapress::Settings& preset);

  void noteEdited(int row, const QString& note);

  /// A batch of these clips; none: of all.
  void exportRequested(const std::vector<int>& rows);

  /// Clips whose files are gone are to be looked for.
  void findMissingRequested();

 private:
  void showReview();
  void showMenu(const QPoint& place);
  void showTree();
  void removeChosen();
  void addVerdicts(QMenu* menu, const std::vector<int>& rows);
  std::vector<int> reviewedRows() const;
  int current() const;  // row of the library, -1: none

  LibraryModel* model_;
  LibraryTree* tree_;
  QLineEdit* filter_;
  QTreeView* view_;
  QPushButton* add_;
  QPushButton* remove_;
  QComboBox* verdict_;
  QLineEdit* note_;
  std::vector<Settings> presets_;
  QSet<QString> collapsed_;  // paths of folders
  QString chosen_;           // path of the clip that is, kept while the tree is built anew
};

}  // namespace mocapress
