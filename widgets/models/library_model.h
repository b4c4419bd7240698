// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QHash>
#include <QImage>
#include <QLineF>
#include <QList>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/metrics/visibility.h"
#include "core/report/review.h"

namespace mocapress {

/// Why a verdict or an outcome is not about a clip as it is now.
enum class Staleness { None, Missing, Source, Settings, Unknown };

/// Compares the hashes of files and settings that something was made from with those of now.
/// Unknown: nobody wrote down from which.
Staleness staleness(const std::string& source, const std::string& settings,
                    const std::string& source_now, const std::string& settings_now);

/// The result of the last compression of a clip, in the studio or in a batch.
struct Outcome {
  double ratio = 0;
  double eps_cm = 0;
  double max_cm = 0;
  std::size_t motion_bytes = 0;
  bool met = true;             // the target that was set
  std::optional<Sight> sight;  // unset: nobody looked
  QStringList warnings;        // of the reader
  std::string source;          // hash of the bytes it was made from
  std::string settings;        // settings_hash() of what it was made by

  bool operator==(const Outcome&) const = default;
};

/// A clip of the library as it is listed.
struct LibraryEntry {
  QString path;
  int frames = 0;  // 0: not read yet
  double sample_rate_hz = 0;
  QList<QLineF> outline;  // a pose in a square from 0 to 1, y down
  QImage skin;            // the same pose, where the clip has a skin
  QString trouble;        // why it could not be read; empty: it could, or was not tried
  QStringList notes;      // what its reader repaired or guessed
  bool missing = false;   // its file is gone
  std::optional<Outcome> outcome;
  Staleness outdated = Staleness::None;  // of the outcome: why it is no longer that of the clip
  ClipReview review;
  Staleness stale = Staleness::None;  // of the verdict
};

/// The clips of a project, one row each. The text of a row says all that its picture does.
class LibraryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  using QAbstractListModel::QAbstractListModel;

  void setEntries(std::vector<LibraryEntry> entries);

  /// Of the entry with that path, or a new row at the end.
  void setEntry(const LibraryEntry& entry);
  /// Replaces these rows, in one change.
  void replace(const std::map<int, LibraryEntry>& entries);

  /// New rows at the end, of paths that have none yet.
  void addEntries(const std::vector<LibraryEntry>& entries);

  const LibraryEntry& entry(int row) const { return entries_[static_cast<std::size_t>(row)]; }
  int rowOf(const QString& path) const;  // -1: none

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<LibraryEntry> entries_;
};

/// The reader's notes on the clip, from when it was read last.
const QStringList& notesOf(const LibraryEntry& entry);

/// "25.0 : 1, 0.09 cm", or why there is nothing to say yet.
QString outcomeText(const LibraryEntry& entry);

/// The most important thing to know of a row: it decides the colour of its state.
enum class RowState { Plain, Good, Bad, Doubtful };

RowState stateOf(const LibraryEntry& entry);

/// "approved", "✓ stale: file changed", "target missed" ...; empty where there is
/// nothing to report.
QString stateText(const LibraryEntry& entry);

/// "file changed" ...; empty: none.
QString displayName(Staleness staleness);

/// "✓ approved", "✕ stale: file changed"; empty without a verdict.
QString verdictText(Verdict verdict, Staleness stale);

/// "Ann, 27.11.26 01:39"; empty where nobody knows.
QString reviewerText(const ClipReview& review);

/// The library's review of a clip.
struct LibraryReview {
  ClipReview review;
  std::string source;    // hash of the clip's files as they are now; empty: not known
  bool missing = false;  // they are gone
};

/// Reviews of all its clips, by their paths.
using ClipReviews = QHash<QString, LibraryReview>;

}  // namespace mocapress
