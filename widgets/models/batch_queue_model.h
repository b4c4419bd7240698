// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QHash>
#include <QSet>
#include <QString>
#include <map>
#include <optional>
#include <vector>

#include "core/batch/batch.h"
#include "core/batch/clip_export.h"
#include "core/batch/row.h"
#include "core/mocapress/settings.h"
#include "widgets/models/library_model.h"

namespace mocapress {

/// Output of a batch: folder, file names, formats, and the character put on its clips.
struct BatchSettings {
  QString character;  // path of a mesh for every clip; empty: each keeps its own
  QString folder;     // empty: not chosen yet
  QString names = QString::fromUtf8(kUsualNames);
  std::vector<OutputFormat> formats = {OutputFormat::Mcpr};
  std::optional<runtime::BankForm> bank;
  bool learn = false;  // whether a packed bank learns its coding; kept but unused for other formats
  bool overwrite = false;

  bool learns() const { return learn && bank == runtime::BankForm::Packed; }

  bool operator==(const BatchSettings&) const = default;
};

/// A clip in the queue and its progress.
struct QueuedClip {
  enum class State { Waiting, Working, Done, Failed };

  SourceClip source;
  std::string skeleton;         // .asf; empty: beside the .amc
  ReadOptions reading = {};     // the library's import options
  std::optional<Settings> own;  // settings of a locked clip; unset: common()
  ClipReview review = {};       // the library's review
  std::string files = {};       // hash of its files as the library knows them; empty: unknown
  bool missing = false;         // the files are gone
  bool left_out = false;        // the clip stays in the queue and is not exported
  State state = State::Waiting;
  ClipProgress progress;                // set while working
  std::optional<Measurement> measured;  // set when done, measured on the file that was read back
  std::string error;                    // set when failed
  std::vector<std::string> warnings;    // set at the end: what the reader repaired or guessed

  QString key() const { return clipKey(QString::fromStdString(source.path), reading.take); }
};

/// The clips of a batch, the preset they share unless locked, and the result of each.
class BatchQueueModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Clip, Lock, Preset, Review, State, Ratio, Eps, Max, Columns };

  /// Role for the progress, 0 to 1, of a clip that is being worked on; invalid for others.
  static constexpr int kProgressRole = Qt::UserRole;
  static constexpr int kStateRole = Qt::UserRole + 1;  // Role for QueuedClip::State as an int.

  using QAbstractTableModel::QAbstractTableModel;

  const std::vector<QueuedClip>& clips() const { return clips_; }
  const Settings& common() const { return common_; }
  const Settings& presetOf(int row) const;

  /// Replaces the whole queue.
  void replace(const Settings& common, const std::vector<QueuedClip>& clips);

  /// Gives a preset to every clip that is not locked. A clip whose preset changes waits again.
  void setCommon(const Settings& preset);
  void setOwn(const std::vector<int>& rows, const std::optional<Settings>& preset);
  void setOwn(const std::map<int, std::optional<Settings>>& by_row);

  void setReading(int row, const ReadOptions& reading);

  /// Sets the reviews of these clips; other clips keep theirs. A newly rejected clip is left out,
  /// and comes back once it is no longer rejected.
  void setReviews(const ClipReviews& reviews);
  void setLeftOut(const std::vector<int>& rows, bool left_out);

  /// Adds the clips that are not in the queue yet.
  void add(const std::vector<QueuedClip>& clips);

  /// Inserts each clip so that it ends up at its row; undoes remove().
  void insert(const std::map<int, QueuedClip>& clips);
  void remove(std::vector<int> rows);

  /// Shows the progress of the clip in `row`. A running batch numbers its clips by row.
  void setProgress(int row, const ClipProgress& progress);
  void setEnded(int row, const std::optional<Measurement>& measured, const std::string& error,
                const std::vector<std::string>& warnings = {});

  /// Sets clips that were being worked on back to waiting.
  void stopWorking();
  /// Sets all clips back to waiting, because the folder or file names have changed.
  void waitAgain();

  /// Counts the clips in a state, without those that are left out.
  int count(QueuedClip::State state) const;

  /// Counts verdicts that were given for other files or settings than those to be exported.
  int countStale() const;
  int countLeftOut() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 signals:
  /// Clips or settings changed and should be saved. Progress and results do not emit this.
  void edited();

  /// The user ticked or unticked a clip.
  void includeToggled(int row, bool included);

 private:
  void wait(int row);
  void changed(int row);
  QString nameOf(const QueuedClip& clip) const;
  QString stateText(const QueuedClip& clip) const;
  QString translated(const QString& sentence) const;
  Staleness staleVerdict(int row) const;
  QString reviewText(int row) const;
  QString toolTip(int row, int column) const;
  QVariant figure(const QueuedClip& clip, int row, int column) const;

  Settings common_ = built_in_presets()[1];
  std::vector<QueuedClip> clips_;
  mutable QHash<QString, QString> translated_;           // key: English sentence
  mutable QHash<QString, QSet<QString>> files_of_name_;  // paths by name; empty: not gathered
};

/// Formats a target as "eps_x 0.5 cm", in the user's language and with its decimal sign.
QString batchTargetText(const Target& target);

}  // namespace mocapress
