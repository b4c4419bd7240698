// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/library_filter.h"

#include <QLocale>
#include <QMap>
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

/// The first numeric column whose title begins with `title`.
std::optional<LibraryColumn> columnTitled(const QString& title) {
  for (int i = 0; i < kLibraryColumns; ++i) {
    const auto column = static_cast<LibraryColumn>(i);
    if (isNumber(column) && titleOf(column).startsWith(title, Qt::CaseInsensitive)) return column;
  }
  return {};
}

/// Parses a number in the user's notation, or with a decimal point or comma.
std::optional<double> numberIn(QString text) {
  bool is_number = false;
  // The separator in "0.500" cannot be one of thousands, even where the language uses it so.
  const double local = QLocale().toDouble(text, &is_number);
  if (is_number && !text.startsWith(QLatin1Char('0'))) return local;
  const double plain = text.replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&is_number);
  return is_number ? std::optional(plain) : std::nullopt;
}

/// Each unit's size in the units of numberOf().
const QMap<QString, double>& units() {
  static const QMap<QString, double> kUnits = {
      {QStringLiteral("mm"), 0.1},  {QStringLiteral("cm"), 1},   {QStringLiteral("m"), 100},
      {QStringLiteral("ms"), 1e-3}, {QStringLiteral("s"), 1},    {QStringLiteral("min"), 60},
      {QStringLiteral("b"), 1},     {QStringLiteral("kb"), 1e3}, {QStringLiteral("mb"), 1e6},
      {QStringLiteral("%"), 1}};
  return kUnits;
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
  if (!number) return false;
  if (is_met_by_equals && *number == value) return true;
  return is_above ? *number > value : *number < value;
}

void LibraryFilter::setWords(const QString& words) {
  // Up to three words, whose last ones may be a column's title; then a comparison sign, a number
  // and its unit.
  static const QRegularExpression kBound(
      QStringLiteral(
          R"(((?:[^\s<>≤≥]+ ){0,2}[^\s<>≤≥]+) ?([<>≤≥]=?) ?(?:(-?\d[\d.,]*) ?(%1|)(?!\S))?)")
          .arg(units().keys().join(QLatin1Char('|'))),
      QRegularExpression::CaseInsensitiveOption);
  const QString text = words.simplified();
  QString others = text;
  bounds_.clear();
  for (const QRegularExpressionMatch& match : kBound.globalMatch(text)) {
    QString title = match.captured(1);
    std::optional<LibraryColumn> column = columnTitled(title);
    while (!column && title.contains(QLatin1Char(' '))) {
      title = title.section(QLatin1Char(' '), 1);
      column = columnTitled(title);
    }
    if (!column) continue;
    const auto from = match.capturedEnd(1) - title.size();
    const auto length = match.capturedEnd() - from;
    others.replace(from, length, QString(length, QLatin1Char(' ')));
    const QString sign = match.captured(2);
    const bool is_above = sign[0] == QLatin1Char('>') || sign[0] == QChar(u'≥');
    const bool has_equals = sign.size() > 1 || sign[0] == QChar(u'≥') || sign[0] == QChar(u'≤');
    const std::optional<double> number = numberIn(match.captured(3));
    if (!number) continue;  // the number is not typed yet
    const double worth = *column == LibraryColumn::BytesSince
                             ? 0.01  // the column is shown in %
                             : units().value(match.captured(4).toLower(), 1);
    bounds_.push_back({*column, is_above, has_equals, *number * worth});
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
  // The path is searched first: most words match there, and the state's text takes longer to build.
  QString state;
  return std::all_of(words_.begin(), words_.end(), [&](const QString& word) {
    if (entry.path.contains(word, Qt::CaseInsensitive)) return true;
    if (state.isNull())
      state = QStringList{QString::fromStdString(entry.take.value_or("")),
                          entry.outcome ? QString() : outcomeText(entry), stateText(entry),
                          textOf(entry, LibraryColumn::Looping), entry.preset}
                  .join(QLatin1Char(' '));
    return state.contains(word, Qt::CaseInsensitive);
  });
}

bool LibraryFilter::lessThan(const QModelIndex& a, const QModelIndex& b) const {
  return isBefore(clips_->entry(a.row()), clips_->entry(b.row()),
                  static_cast<LibraryColumn>(a.column()));
}

}  // namespace mocapress
