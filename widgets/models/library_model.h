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
  bool met = true;             // the target was met
  std::optional<Sight> sight;  // unset: not examined
  QStringList warnings;        // the reader's warnings
  std::string source;          // hash of the input's bytes
  std::string settings;        // settings_hash() of the settings

  bool operator==(const Outcome&) const = default;
};

/// A clip as the library lists it.
struct LibraryEntry {
  QString path;
  int frames = 0;  // 0: not read yet
  double sample_rate_hz = 0;
  QList<QLineF> outline;  // a pose scaled to a square from 0 to 1, y down
  QImage skin;            // the same pose with its skin, for a clip that has one
  QString trouble;        // why reading failed; empty: it succeeded or was not tried
  QStringList notes;      // what the reader repaired or guessed
  bool missing = false;   // the file is gone
  std::optional<Outcome> outcome;
  Staleness outdated = Staleness::None;  // why the outcome no longer applies
  ClipReview review;
  Staleness stale = Staleness::None;  // why the verdict no longer applies
};

/// The clips of a project, one row each. A row's text says all that its picture shows.
class LibraryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  using QAbstractListModel::QAbstractListModel;

  void setEntries(std::vector<LibraryEntry> entries);

  /// Replaces the entry with that path, or adds a row at the end.
  void setEntry(const LibraryEntry& entry);
  /// Replaces these rows in one change.
  void replace(const std::map<int, LibraryEntry>& entries);

  /// Adds rows at the end for paths that have none yet.
  void addEntries(const std::vector<LibraryEntry>& entries);

  const LibraryEntry& entry(int row) const { return entries_[static_cast<std::size_t>(row)]; }
  int rowOf(const QString& path) const;  // -1: none

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<LibraryEntry> entries_;
};

/// The reader's notes from the last time the clip was read.
const QStringList& notesOf(const LibraryEntry& entry);

/// "25.0 : 1, 0.09 cm", or the reason why there are no figures yet.
QString outcomeText(const LibraryEntry& entry);

/// The most important fact about a row, which decides the colour of its state.
enum class RowState { Plain, Good, Bad, Doubtful };

RowState stateOf(const LibraryEntry& entry);

/// "approved", "✓ stale: file changed", "target missed"; empty when there is nothing to report.
QString stateText(const LibraryEntry& entry);

/// Names a staleness, such as "file changed"; empty for None.
QString displayName(Staleness staleness);

/// "✓ approved", "✕ stale: file changed"; empty without a verdict.
QString verdictText(Verdict verdict, Staleness stale);

/// "Ann, 27.11.26 01:39"; empty when the reviewer is unknown.
QString reviewerText(const ClipReview& review);

/// A clip's review as the library keeps it.
struct LibraryReview {
  ClipReview review;
  std::string source;    // hash of the clip's files today; empty: unknown
  bool missing = false;  // the files are gone
};

/// Reviews of all clips of the library, by path.
using ClipReviews = QHash<QString, LibraryReview>;

}  // namespace mocapress
