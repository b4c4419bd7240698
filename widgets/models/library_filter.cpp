// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/library_filter.h"

#include <QRegularExpression>
#include <algorithm>

namespace mocapress {
namespace {

bool isOf(const LibraryEntry& entry, LibraryShow show) {
  switch (show) {
    case LibraryShow::All:
      return true;
    case LibraryShow::NotReviewed:
      return entry.review.verdict == Verdict::None;
    case LibraryShow::ToReview:
      return wantsReview(entry);
    case LibraryShow::Approved:
      return entry.review.verdict == Verdict::Approved;
    case LibraryShow::Rejected:
      return entry.review.verdict == Verdict::Rejected;
    case LibraryShow::Stale:
      return entry.stale != Staleness::None || entry.outdated != Staleness::None;
    case LibraryShow::WithNotes:
      return !entry.review.note.empty() || !entry.review.notes.empty();
    case LibraryShow::WithWarnings:
      return !notesOf(entry).isEmpty();
    case LibraryShow::Visible:
      return entry.outcome && entry.outcome->sight && *entry.outcome->sight != Sight::NotVisible;
    case LibraryShow::Unfinished:
      return entry.wantsEncoding();
    case LibraryShow::Missed:
      return isMissed(entry);
  }
  return true;
}

/// The first column of numbers whose title begins so.
std::optional<LibraryColumn> columnTitled(const QString& title) {
  for (int i = 0; i < kLibraryColumns; ++i) {
    const auto column = static_cast<LibraryColumn>(i);
    if (isNumber(column) && titleOf(column).startsWith(title, Qt::CaseInsensitive)) return column;
  }
  return {};
}

}  // namespace

QString displayName(LibraryShow show) {
  switch (show) {
    case LibraryShow::All:
      return LibraryFilter::tr("All clips");
    case LibraryShow::NotReviewed:
      return LibraryFilter::tr("Not reviewed");
    case LibraryShow::ToReview:
      return LibraryFilter::tr("To review");
    case LibraryShow::Approved:
      return LibraryFilter::tr("Approved");
    case LibraryShow::Rejected:
      return LibraryFilter::tr("Rejected");
    case LibraryShow::Stale:
      return LibraryFilter::tr("Out of date");
    case LibraryShow::WithNotes:
      return LibraryFilter::tr("With notes");
    case LibraryShow::WithWarnings:
      return LibraryFilter::tr("With warnings");
    case LibraryShow::Visible:
      return LibraryFilter::tr("With visible errors");
    case LibraryShow::Unfinished:
      return LibraryFilter::tr("Not compressed yet");
    case LibraryShow::Missed:
      return LibraryFilter::tr("Missed or failed");
  }
  return {};
}

LibraryFilter::LibraryFilter(LibraryModel* clips, QObject* parent)
    : QSortFilterProxyModel(parent), clips_(clips) {
  setSourceModel(clips);
}

bool ColumnBound::matches(const LibraryEntry& entry) const {
  const std::optional<double> number = numberOf(entry, column);
  return number && (is_above ? *number > value : *number < value);
}

void LibraryFilter::setWords(const QString& words) {
  static const QRegularExpression kBound(QStringLiteral("(\\S+?)\\s*([<>])\\s*([\\d.,]*)"));
  QString others = words;
  bounds_.clear();
  for (const QRegularExpressionMatch& match : kBound.globalMatch(words)) {
    const std::optional<LibraryColumn> column = columnTitled(match.captured(1));
    if (!column) continue;
    others.replace(match.capturedStart(), match.capturedLength(),
                   QString(match.capturedLength(), QLatin1Char(' ')));
    bool is_number = false;  // false also while it is typed
    const double value =
        match.captured(3).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&is_number);
    if (is_number) bounds_.push_back({*column, match.captured(2) == QLatin1String(">"), value});
  }
  words_ = others.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  invalidateFilter();
}

void LibraryFilter::setShow(LibraryShow show) {
  show_ = show;
  invalidateFilter();
}

bool LibraryFilter::filterAcceptsRow(int clip, const QModelIndex&) const {
  const LibraryEntry& entry = clips_->entry(clip);
  if (!isOf(entry, show_)) return false;
  for (const ColumnBound& bound : bounds_)
    if (!bound.matches(entry)) return false;
  if (words_.isEmpty()) return true;
  // Most words are in the path; a state takes longer to put together.
  QString state;
  return std::all_of(words_.begin(), words_.end(), [&](const QString& word) {
    if (entry.path.contains(word, Qt::CaseInsensitive)) return true;
    if (state.isNull())
      state = QString::fromStdString(entry.take.value_or("")) + QLatin1Char(' ') +
              (entry.outcome ? stateText(entry) : outcomeText(entry) + stateText(entry));
    return state.contains(word, Qt::CaseInsensitive);
  });
}

bool LibraryFilter::lessThan(const QModelIndex& a, const QModelIndex& b) const {
  return isBefore(clips_->entry(a.row()), clips_->entry(b.row()),
                  static_cast<LibraryColumn>(a.column()));
}

}  // namespace mocapress
