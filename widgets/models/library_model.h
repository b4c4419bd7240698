// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QHash>
#include <QImage>
#include <QLineF>
#include <QList>
#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/report/review.h"

namespace mocapress {

/// What the last compression of a clip came to.
struct Outcome {
  double ratio = 0;
  double eps_cm = 0;
  double max_cm = 0;
  std::size_t motion_bytes = 0;
  bool met = true;  // the target that was set

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
  std::optional<Outcome> outcome;
  Verdict verdict = Verdict::None;
  QString note;
};

/// The clips of a project, one row each. The text of a row says all that its picture does.
class LibraryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  using QAbstractListModel::QAbstractListModel;

  void setEntries(std::vector<LibraryEntry> entries);

  /// Of the entry with that path, or a new row at the end.
  void setEntry(const LibraryEntry& entry);
  /// New rows at the end, of paths that have none yet.
  void addEntries(const std::vector<LibraryEntry>& entries);

  const LibraryEntry& entry(int row) const { return entries_[static_cast<std::size_t>(row)]; }
  int rowOf(const QString& path) const;  // -1: none

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<LibraryEntry> entries_;
};

/// "25.0 : 1, 0.09 cm", or why there is nothing to say yet.
QString outcomeText(const LibraryEntry& entry);

/// "approved", "target missed" ...; empty where there is nothing to report.
QString stateText(const LibraryEntry& entry);

/// What a library says about its clips, by their paths.
using ClipReviews = QHash<QString, ClipReview>;

}  // namespace mocapress
