// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QColor>
#include <QHash>
#include <QImage>
#include <QLineF>
#include <QList>
#include <QPalette>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/batch/batch_difference.h"
#include "core/metrics/visibility.h"
#include "core/motion/loop.h"
#include "core/report/review.h"

namespace mocapress {

/// The reason why a verdict or an outcome no longer applies to a clip.
enum class Staleness { None, Missing, Source, Settings, Unknown };

/// Compares the hashes of the files and settings behind a result with today's. Unknown: the result
/// has no hashes.
Staleness staleness(const std::string& source, const std::string& settings,
                    const std::string& source_now, const std::string& settings_now);

/// The result of a clip's last compression, in the studio or in a batch.
struct Outcome {
  double ratio = 0;
  double eps_cm = 0;
  double max_cm = 0;
  std::size_t motion_bytes = 0;
  bool met = true;                 // the result met its target
  std::optional<Sight> sight;      // unset: not judged
  std::optional<double> slide_cm;  // total slide of the feet in all contacts; unset: no contacts
  QStringList warnings;            // from the reader, and about the character
  std::string source;              // hash of the bytes it was made from
  std::string settings;            // settings_hash() of the settings it was made with
  std::optional<int> worst_frame;  // frame of max_cm; unset: the project is older and does not say
  std::string worst_point;         // landmark of max_cm
  SightLimits limits;              // limits by which `sight` was judged

  bool operator==(const Outcome&) const = default;
};

/// Identifies a clip of a library: its path and, in a file with several animations, its take.
QString clipKey(const QString& path, const std::optional<std::string>& take);

/// A clip as the library lists it.
struct LibraryEntry {
  QString path;
  std::optional<std::string> take;  // set: the animation of a file with several
  bool is_compressed = false;       // a .mcpr
  int frames = 0;                   // 0: not read yet
  double sample_rate_hz = 0;
  QList<QLineF> outline;  // a pose in a square from 0 to 1, y down
  QImage skin;            // the same pose, where the clip has a skin
  QString trouble;        // why it could not be read; empty: it could, or nobody tried
  QStringList notes;      // what its reader repaired or guessed
  bool missing = false;   // its file is gone
  Loop loop = Loop::None;
  QString preset;  // preset that the settings came from; empty: none
  QString
      failure;  // why it could not be compressed by its settings; empty: it could, or nobody tried
  std::optional<Outcome> outcome;
  std::optional<std::size_t> bytes_before;  // bytes with its earlier settings
  std::optional<ClipDifference> since;      // since an earlier batch; unset: nothing to compare
  Staleness outdated = Staleness::None;     // why the outcome no longer applies to the clip
  ClipReview review;
  Staleness stale = Staleness::None;  // why the verdict no longer applies to the clip

  QString key() const { return clipKey(path, take); }

  /// The name shown for the clip: "walk.bvh", "moves.fbx: Run".
  QString name() const;

  /// True if the clip could be compressed and its result is not known.
  bool wantsEncoding() const {
    return frames > 0 && !is_compressed && !missing && trouble.isEmpty() && failure.isEmpty() &&
           (!outcome || outdated != Staleness::None);
  }
};

/// The clips of a project, one row each, with the columns of LibraryColumn. The accessible text of
/// the first column says what its picture shows.
class LibraryModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  void setEntries(std::vector<LibraryEntry> entries);

  /// Replaces the entry with the same key, or adds a row at the end.
  void setEntry(const LibraryEntry& entry);
  /// Replaces several rows and emits one change.
  void replace(const std::map<int, LibraryEntry>& entries);

  /// Inserts rows before `row`.
  void insert(int row, const std::vector<LibraryEntry>& entries);

  const LibraryEntry& entry(int row) const { return entries_[static_cast<std::size_t>(row)]; }
  int rowOf(const QString& key) const;  // -1: none

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void tellOf(int first, int last);

  std::vector<LibraryEntry> entries_;
  mutable QHash<QString, int> rows_;  // key to row; empty: rebuilt by the next rowOf()
};

/// The notes on a clip: those of its reader, and those of its last compression, such as on its
/// character, unless its file has changed since.
QStringList notesOf(const LibraryEntry& entry);

/// The result as "25.0 : 1, 0.09 cm", or the reason why there is none yet.
QString outcomeText(const LibraryEntry& entry);

/// The most important fact about a row, which decides the colour of its state.
enum class RowState { Plain, Good, Bad, Doubtful };

RowState stateOf(const LibraryEntry& entry);

/// The colour of a state: dark enough on white, bright enough on black.
QColor colourOf(RowState state, const QPalette& palette);

/// True if the clip has no verdict or a stale one, and its file is there to be reviewed.
bool wantsReview(const LibraryEntry& entry);

/// True if the clip missed its target, or cannot be read or compressed.
bool isMissed(const LibraryEntry& entry);

/// The clip's state, as "approved", "✓ stale: file changed" or "target missed"; empty where there
/// is nothing to report.
QString stateText(const LibraryEntry& entry);

/// Names a staleness, such as "file changed"; empty for None.
QString displayName(Staleness staleness);

/// The verdict as "✓ approved" or "✕ stale: file changed"; empty without a verdict.
QString verdictText(Verdict verdict, Staleness stale);

/// The reviewer and time as "Ann, 27.11.26 01:39"; empty when the reviewer is unknown.
QString reviewerText(const ClipReview& review);

/// Sums up sizes with the present and the earlier settings: "12 clips: 41,200 bytes, 51,800
/// before".
QString sumText(const LibraryModel& model, const std::vector<int>& rows);

/// The library's review of a clip.
struct LibraryReview {
  ClipReview review;
  std::string source;    // hash of the clip's files today; empty: unknown
  bool missing = false;  // the files are gone
};

/// Reviews of all clips of the library, by clipKey().
using ClipReviews = QHash<QString, LibraryReview>;

}  // namespace mocapress
