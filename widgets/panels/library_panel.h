// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QWidget>
#include <utility>
#include <vector>

#include "core/mocapress/settings.h"
#include "widgets/models/library_model.h"

class QComboBox;
class QLineEdit;
class QMenu;
class QPushButton;
class QTreeView;

namespace mocapress {

class ElidedLabel;
class EncodingBar;
class LibraryModel;
class LibraryTree;
class ReviewBar;

/// Lists the clips of the project in groups, with results and verdicts. A click opens a clip. A
/// button and the context menu of the header choose columns and order.
class LibraryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryPanel(LibraryModel* model, QWidget* parent = nullptr);

  /// Sets the row of the open clip; -1: the open clip is not in the list. Emits nothing.
  void setCurrent(int row);

  /// The selected clips, and all clips below selected folders.
  std::vector<int> chosenRows() const;

  /// The rows of the clips that are visible in the list now, from top to bottom.
  std::vector<int> rowsInSight() const;

  /// Sets the presets that can be given to clips.
  void setPresets(const std::vector<Settings>& presets) { presets_ = presets; }

  /// Tells whether there are settings to paste.
  void setCanPaste(bool can_paste) { can_paste_ = can_paste; }

  /// The label with the total bytes of the selected clips.
  ElidedLabel* sum() const { return sum_; }

  QTreeView* view() const { return view_; }
  LibraryTree* tree() const { return tree_; }
  QPushButton* removeButton() const { return remove_; }
  QLineEdit* filter() const { return filter_; }
  QComboBox* shownBox() const { return shown_; }
  QComboBox* groupingBox() const { return grouping_; }

  /// The columns with their widths and positions, the sort order (without a comparison), and the
  /// grouping.
  QByteArray arrangement() const;

  /// Restores what arrangement() returned; other bytes change nothing.
  void arrange(const QByteArray& arrangement);

  /// Makes the menu that chooses the columns, and what clips are sorted by.
  QMenu* makeColumnMenu();

  /// Shows or hides the columns of a comparison with an earlier batch. While they are shown, clips
  /// are sorted by what changed.
  void showComparison(bool shown);

  QComboBox* verdict() const { return verdict_; }
  QLineEdit* note() const { return note_; }
  ReviewBar* reviewed() const { return reviewed_; }
  EncodingBar* encoding() const { return encoding_; }

  /// The next clip in the order shown, after the open one and then from the top, that waits for a
  /// verdict; -1: none.
  int nextToReview() const;

  /// Makes the context menu for the selection.
  QMenu* makeMenu();

  QSize sizeHint() const override { return {230, 400}; }

  /// The width at which all columns are visible beside the clips.
  int wholeWidth() const { return sizeHint().width() + columnsWidth(); }

  /// The size below which rows cannot be read, with room for the first two columns.
  QSize minimumSizeHint() const override;

 signals:
  void addRequested();
  void addFolderRequested();
  void removeRequested(const QList<int>& rows);
  void openRequested(int row);
  /// The user chose a verdict for these clips.
  void verdictChosen(const std::vector<int>& rows, mocapress::Verdict verdict);
  void presetChosen(const std::vector<int>& rows, const mocapress::Settings& preset);

  void copySettingsRequested(int row);
  void pasteSettingsRequested(const std::vector<int>& rows);
  void pasteImportanceRequested(const std::vector<int>& rows);
  void putCharacterRequested(const std::vector<int>& rows);
  void takeCharacterOffRequested(const std::vector<int>& rows);

  void noteEdited(int row, const QString& note);

  /// The user wants to export these clips as a batch; no rows: all clips.
  void exportRequested(const std::vector<int>& rows);

  void arrangementChanged();

  /// The user wants to search for the clips whose files are gone.
  void findMissingRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeHead();
  void fitColumns();
  bool isSortedByComparison() const;
  void noteArrangement();
  int columnsWidth() const;  // of all visible columns but the clips' own
  void addOrders(QMenu* menu);
  void noteSelection();
  QSet<QString> keysOf(const std::vector<int>& rows) const;
  void showReview();
  void showSum();
  void addSettings(QMenu* menu, const std::vector<int>& rows);
  void showMenu(const QPoint& place);
  void showTree();
  void removeChosen();
  void addVerdicts(QMenu* menu, const std::vector<int>& rows);
  std::vector<int> reviewedRows() const;
  int current() const;  // row in the library, -1: none

  LibraryModel* model_;
  LibraryTree* tree_;
  QLineEdit* filter_;
  QComboBox* shown_;
  QComboBox* grouping_;
  QTreeView* view_;
  ElidedLabel* sum_;
  EncodingBar* encoding_;
  ReviewBar* reviewed_;
  QPushButton* add_;
  QPushButton* remove_;
  QComboBox* verdict_;
  QLineEdit* note_;
  std::vector<Settings> presets_;
  bool can_paste_ = false;
  // The user's own order: the column to sort by (-1: the library's order) and the direction.
  std::pair<int, Qt::SortOrder> own_sort_{-1, Qt::AscendingOrder};
  QSet<QString> collapsed_;  // paths of folders
  // Restored when the tree was rebuilt:
  QString chosen_;          // key of the current clip
  QSet<QString> selected_;  // keys of the selected clips
  int scrolled_ = 0;
};

}  // namespace mocapress
