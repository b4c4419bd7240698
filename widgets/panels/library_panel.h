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

/// The clips of the project in their folders, with results and verdicts. A click opens a clip.
class LibraryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryPanel(LibraryModel* model, QWidget* parent = nullptr);

  /// The row of the open clip; -1: none of the list. Emits nothing.
  void setCurrent(int row);

  /// The selected clips, and all clips below selected folders.
  std::vector<int> chosenRows() const;

  /// The presets that can be given to clips.
  void setPresets(const std::vector<Settings>& presets) { presets_ = presets; }

  QTreeView* view() const { return view_; }
  LibraryTree* tree() const { return tree_; }
  QPushButton* removeButton() const { return remove_; }
  QLineEdit* filter() const { return filter_; }
  QComboBox* verdict() const { return verdict_; }
  QLineEdit* note() const { return note_; }

  /// Makes the context menu for the selection.
  QMenu* makeMenu();

  QSize sizeHint() const override { return {230, 400}; }

  /// Rows narrower than this could not be read.
  QSize minimumSizeHint() const override { return {210, 200}; }

 signals:
  void addRequested();
  void addFolderRequested();
  void removeRequested(const QList<int>& rows);
  void openRequested(int row);
  /// A verdict for all selected clips.
  void verdictChosen(const std::vector<int>& rows, mocapress::Verdict verdict);
  void presetChosen(const std::vector<int>& rows, const mocapress::Settings& preset);

  void noteEdited(int row, const QString& note);

  /// Exports these clips as a batch; no rows: all clips.
  void exportRequested(const std::vector<int>& rows);

  /// The user wants to look for missing files.
  void findMissingRequested();

 private:
  void showReview();
  void showMenu(const QPoint& place);
  void showTree();
  void removeChosen();
  void addVerdicts(QMenu* menu, const std::vector<int>& rows);
  std::vector<int> reviewedRows() const;
  int current() const;  // row in the library, -1: none

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
  QString chosen_;           // path of the selected clip, kept while the tree is rebuilt
};

}  // namespace mocapress
