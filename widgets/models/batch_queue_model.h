// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
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

/// Where the files of a batch go, and which; and what is put on its clips.
struct BatchSettings {
  QString character;  // path of a mesh for every clip; empty: each has its own
  QString folder;     // empty: not chosen yet
  QString names = QString::fromUtf8(kUsualNames);
  std::vector<OutputFormat> formats = {OutputFormat::Mcpr};
  std::optional<runtime::BankForm> bank;
  bool learn = false;  // of a packed bank; another form leaves it as it was chosen
  bool overwrite = false;

  bool learns() const { return learn && bank == runtime::BankForm::Packed; }

  bool operator==(const BatchSettings&) const = default;
};

/// A clip in the queue and how far it is.
struct QueuedClip {
  enum class State { Waiting, Working, Done, Failed };

  SourceClip source;
  std::string skeleton;         // .asf; empty: beside the .amc
  ReadOptions reading = {};     // import options of the library
  std::optional<Settings> own;  // locked: the common preset does not reach it
  ClipReview review = {};       // of the library
  std::string files = {};       // hash of its files, as the library knows them; empty: it does not
  bool missing = false;         // they are gone
  bool left_out = false;        // it stays in the queue and is not exported
  State state = State::Waiting;
  ClipProgress progress;                // while working
  std::optional<Measurement> measured;  // when done, by the file that was read back
  std::string error;                    // when failed
  std::vector<std::string> warnings;    // when it has ended: what its reader repaired or guessed
};

/// The clips of a batch, the preset they have in common, and what became of each.
class BatchQueueModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Clip, Lock, Preset, Review, State, Ratio, Eps, Max, Columns };

  /// 0 to 1 while the clip is being worked on, else invalid.
  static constexpr int kProgressRole = Qt::UserRole;
  static constexpr int kStateRole = Qt::UserRole + 1;  // int of QueuedClip::State

  using QAbstractTableModel::QAbstractTableModel;

  const std::vector<QueuedClip>& clips() const { return clips_; }
  const Settings& common() const { return common_; }
  const Settings& presetOf(int row) const;

  /// Another queue in the place of this one.
  void replace(const Settings& common, const std::vector<QueuedClip>& clips);

  /// What a clip has comes of its preset: one that gets another is waiting again.
  void setCommon(const Settings& preset);
  void setOwn(const std::vector<int>& rows, const std::optional<Settings>& preset);
  void setOwn(const std::map<int, std::optional<Settings>>& by_row);

  void setReading(int row, const ReadOptions& reading);

  /// A clip that is rejected is left out from then on, one that no longer is comes back. What is
  /// said of other clips than these stays.
  void setReviews(const ClipReviews& reviews);
  void setLeftOut(const std::vector<int>& rows, bool left_out);

  /// Those that are not there yet.
  void add(const std::vector<QueuedClip>& clips);

  /// Each at its row, as remove() took them.
  void insert(const std::map<int, QueuedClip>& clips);
  void remove(std::vector<int> rows);

  /// Of a running batch, whose indices are rows.
  void setProgress(int row, const ClipProgress& progress);
  void setEnded(int row, const std::optional<Measurement>& measured, const std::string& error,
                const std::vector<std::string>& warnings = {});

  /// Clips that were being worked on are waiting again.
  void stopWorking();
  /// All of them, for they go somewhere else, or by another name.
  void waitAgain();

  /// Of those that are not left out.
  int count(QueuedClip::State state) const;

  /// Verdicts that are not about the files or the settings that would be exported.
  int countStale() const;
  int countLeftOut() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 signals:
  /// Clips or settings, which are worth keeping; not progress.
  void edited();

  /// The user ticked a clip, or took its tick away.
  void includeToggled(int row, bool included);

 private:
  void wait(int row);
  void changed(int row);
  QString stateText(const QueuedClip& clip) const;
  Staleness staleVerdict(int row) const;
  QString reviewText(int row) const;
  QString toolTip(int row, int column) const;
  QVariant figure(const QueuedClip& clip, int row, int column) const;

  Settings common_ = built_in_presets()[1];
  std::vector<QueuedClip> clips_;
};

/// "eps_x 0.5 cm", in the language and with the decimal sign of the user.
QString batchTargetText(const Target& target);

}  // namespace mocapress
