// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/library_model.h"

#include <QDateTime>
#include <QGuiApplication>
#include <QLocale>

#include "widgets/models/display_names.h"
#include "widgets/models/library_columns.h"
#include "widgets/models/number_text.h"
#include "widgets/models/sentence.h"

namespace mocapress {

Staleness staleness(const std::string& source, const std::string& settings,
                    const std::string& source_now, const std::string& settings_now) {
  if (source.empty()) return Staleness::Unknown;
  if (source != source_now) return Staleness::Source;
  return settings == settings_now ? Staleness::None : Staleness::Settings;
}

QString clipKey(const QString& path, const std::optional<std::string>& take) {
  return take ? path + QLatin1Char('\n') + QString::fromStdString(*take) : path;
}

QString LibraryEntry::name() const {
  const QString file = path.sliced(path.lastIndexOf(QLatin1Char('/')) + 1);
  return take
             ? LibraryModel::tr("%1: %2", "take of a file").arg(file, QString::fromStdString(*take))
             : file;
}

QStringList notesOf(const LibraryEntry& entry) {
  QStringList notes = entry.notes;
  if (entry.outcome && entry.outdated != Staleness::Source)
    for (const QString& note : entry.outcome->warnings)
      if (!notes.contains(note)) notes << note;
  return notes;
}

QString outcomeText(const LibraryEntry& entry) {
  // A missing clip still shows its numbers; its state says that it is missing.
  if (!entry.trouble.isEmpty() && !entry.missing) return LibraryModel::tr("Cannot be read");
  if (!entry.outcome && entry.missing && entry.frames == 0) return {};
  if (!entry.outcome)
    return entry.frames == 0 ? LibraryModel::tr("Reading…")
                             : LibraryModel::tr("%Ln frame(s)", nullptr, entry.frames);
  return LibraryModel::tr("%1, %2").arg(ratioText(entry.outcome->ratio),
                                        lengthText(entry.outcome->eps_cm));
}

RowState stateOf(const LibraryEntry& entry) {
  if (entry.missing || !entry.trouble.isEmpty()) return RowState::Bad;
  if (entry.review.verdict != Verdict::None) {
    if (entry.stale != Staleness::None) return RowState::Doubtful;
    return entry.review.verdict == Verdict::Approved ? RowState::Good : RowState::Bad;
  }
  if (!entry.failure.isEmpty()) return RowState::Bad;
  if (!entry.outcome) return RowState::Plain;
  return entry.outdated != Staleness::None || !entry.outcome->met ? RowState::Doubtful
                                                                  : RowState::Plain;
}

QColor colourOf(RowState state, const QPalette& palette) {
  const bool dark = palette.color(QPalette::Base).lightness() < 128;
  switch (state) {
    case RowState::Good:
      return dark ? QColor(0x6c, 0xc6, 0x7f) : QColor(0x1e, 0x7a, 0x34);
    case RowState::Bad:
      return dark ? QColor(0xff, 0x8a, 0x80) : QColor(0xb3, 0x26, 0x1e);
    case RowState::Doubtful:
      return dark ? QColor(0xf0, 0xb4, 0x4c) : QColor(0x92, 0x5a, 0x00);
    case RowState::Plain:
      break;
  }
  return palette.color(QPalette::Text);
}

bool wantsReview(const LibraryEntry& entry) {
  return !entry.missing && entry.trouble.isEmpty() &&
         (entry.review.verdict == Verdict::None || entry.stale != Staleness::None);
}

bool isMissed(const LibraryEntry& entry) {
  return entry.missing || !entry.trouble.isEmpty() || !entry.failure.isEmpty() ||
         (entry.outcome && !entry.outcome->met);
}

namespace {

/// Adds the visibility of errors, provided the outcome is still that of the clip.
QString withSight(const QString& state, const LibraryEntry& entry) {
  if (!entry.outcome || !entry.outcome->sight || entry.outdated != Staleness::None) return state;
  const QString sight = sightText(*entry.outcome->sight, entry.outcome->limits.distance_m);
  // A narrow list cuts the end off, so a met target, the least important fact, comes last.
  const bool is_news = entry.review.verdict != Verdict::None || !entry.outcome->met;
  return (is_news ? QStringList{state, sight} : QStringList{sight, state})
      .join(LibraryModel::tr(", "));
}

}  // namespace

QString stateText(const LibraryEntry& entry) {
  // A stale verdict already says that the file is missing.
  if (const QString verdict = verdictText(entry.review.verdict, entry.stale); !verdict.isEmpty())
    return entry.stale == Staleness::None ? withSight(verdict, entry) : verdict;
  if (entry.missing) return LibraryModel::tr("! file missing");
  if (!entry.failure.isEmpty()) return LibraryModel::tr("! cannot be compressed");
  if (!entry.outcome) return {};
  if (entry.outdated != Staleness::None)
    return LibraryModel::tr("! %1").arg(displayName(entry.outdated));
  return withSight(
      entry.outcome->met ? LibraryModel::tr("target met") : LibraryModel::tr("! target missed"),
      entry);
}

QString displayName(Staleness staleness) {
  switch (staleness) {
    case Staleness::Missing:
      return LibraryModel::tr("file missing");
    case Staleness::Source:
      return LibraryModel::tr("file changed");
    case Staleness::Settings:
      return LibraryModel::tr("settings changed");
    case Staleness::Unknown:
      return LibraryModel::tr("files not known");
    case Staleness::None:
      break;
  }
  return {};
}

QString verdictText(Verdict verdict, Staleness stale) {
  if (verdict == Verdict::None) return {};
  const bool approved = verdict == Verdict::Approved;
  if (stale == Staleness::None)
    return approved ? LibraryModel::tr("✓ approved") : LibraryModel::tr("✕ rejected");
  return (approved ? LibraryModel::tr("✓ stale: %1") : LibraryModel::tr("✕ stale: %1"))
      .arg(displayName(stale));
}

QString reviewerText(const ClipReview& review) {
  const QDateTime time = QDateTime::fromString(QString::fromStdString(review.time), Qt::ISODate);
  if (review.verdict == Verdict::None || !time.isValid()) return {};
  return QString::fromStdString(review.reviewer) + LibraryModel::tr(", ") +
         QLocale().toString(time.toLocalTime(), QLocale::ShortFormat);
}

QString sumText(const LibraryModel& model, const std::vector<int>& rows) {
  std::size_t now = 0, before = 0;
  int waiting = 0;
  bool changed = false;
  for (const int row : rows) {
    const LibraryEntry& entry = model.entry(row);
    const bool is_known = entry.outcome && entry.outdated == Staleness::None;
    if (!is_known) ++waiting;
    if (is_known) now += entry.outcome->motion_bytes;
    before += entry.bytes_before.value_or(is_known ? entry.outcome->motion_bytes : 0);
    changed = changed || entry.bytes_before;
  }
  const auto bytes = [](std::size_t sum) {
    return QLocale().toString(static_cast<qulonglong>(sum));
  };
  const QString clips = LibraryModel::tr("%Ln clip(s)", "selected", static_cast<int>(rows.size()));
  if (waiting == 0 && changed)
    return LibraryModel::tr("%1: %2 bytes, %3 before").arg(clips, bytes(now), bytes(before));
  if (waiting == 0) return LibraryModel::tr("%1: %2 bytes").arg(clips, bytes(now));
  const QString waits = LibraryModel::tr("%L1 not compressed yet").arg(waiting);
  return changed ? LibraryModel::tr("%1: %2 bytes before, %3").arg(clips, bytes(before), waits)
                 : LibraryModel::tr("%1: %2").arg(clips, waits);
}

void LibraryModel::setEntries(std::vector<LibraryEntry> entries) {
  beginResetModel();
  entries_ = std::move(entries);
  rows_.clear();
  endResetModel();
}

int LibraryModel::rowOf(const QString& key) const {
  if (rows_.isEmpty())
    for (int row = rowCount() - 1; row >= 0; --row) rows_.insert(entry(row).key(), row);
  return rows_.value(key, -1);
}

void LibraryModel::setEntry(const LibraryEntry& entry) {
  const int row = rowOf(entry.key());
  if (row < 0) {
    beginInsertRows({}, rowCount(), rowCount());
    entries_.push_back(entry);
    rows_.insert(entry.key(), rowCount() - 1);
    endInsertRows();
    return;
  }
  entries_[static_cast<std::size_t>(row)] = entry;
  tellOf(row, row);
}

void LibraryModel::tellOf(int first, int last) {
  emit dataChanged(index(first, 0), index(last, kLibraryColumns - 1));
}

void LibraryModel::replace(const std::map<int, LibraryEntry>& entries) {
  if (entries.empty()) return;
  for (const auto& [row, entry] : entries) {
    LibraryEntry& old = entries_[static_cast<std::size_t>(row)];
    if (old.key() != entry.key()) rows_.clear();
    old = entry;
  }
  tellOf(entries.begin()->first, entries.rbegin()->first);
}

void LibraryModel::insert(int row, const std::vector<LibraryEntry>& entries) {
  if (entries.empty()) return;
  beginInsertRows({}, row, row + static_cast<int>(entries.size()) - 1);
  entries_.insert(entries_.begin() + row, entries.begin(), entries.end());
  rows_.clear();
  endInsertRows();
}

int LibraryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

int LibraryModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kLibraryColumns;
}

QVariant LibraryModel::headerData(int section, Qt::Orientation orientation, int role) const {
  const auto column = static_cast<LibraryColumn>(section);
  if (orientation == Qt::Vertical || section >= kLibraryColumns) return {};
  if (role == Qt::DisplayRole) return titleOf(column);
  if (role == Qt::ToolTipRole) return purposeOf(column);
  if (role == Qt::TextAlignmentRole && isNumber(column))
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const LibraryEntry& shown = entry(index.row());
  const auto column = static_cast<LibraryColumn>(index.column());
  if (role == Qt::DisplayRole) return textOf(shown, column);
  if (role == Qt::TextAlignmentRole && isNumber(column))
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  const bool is_old =
      shown.outdated != Staleness::None &&
      ((column >= LibraryColumn::Ratio && column <= LibraryColumn::Seen) || isOfComparison(column));
  if (role == Qt::ForegroundRole && is_old)
    return QGuiApplication::palette().color(QPalette::PlaceholderText);
  if (role == Qt::AccessibleTextRole && column != LibraryColumn::Clip)
    return titleOf(column) + QLatin1Char(' ') + textOf(shown, column);
  const QString name = shown.name();
  switch (role) {
    case Qt::AccessibleTextRole: {
      QStringList parts = {name, outcomeText(shown), stateText(shown)};
      if (const auto notes = notesOf(shown); !notes.isEmpty())
        parts << tr("%Ln note(s)", nullptr, static_cast<int>(notes.size()));
      parts.removeAll(QString());
      return parts.join(QStringLiteral(", "));
    }
    case Qt::ToolTipRole: {
      QStringList lines = {shown.path,
                           QString::fromStdString(shown.take.value_or(std::string())),
                           translatedSentence(shown.trouble),
                           stateText(shown),
                           translatedSentence(shown.failure),
                           reviewerText(shown.review),
                           QString::fromStdString(shown.review.note)};
      for (const FrameNote& note : shown.review.notes)
        lines << QString::fromStdString(note.joint.empty() ? note.text
                                                           : note.joint + ": " + note.text);
      for (const QString& note : notesOf(shown)) lines << translatedSentence(note);
      lines.removeAll(QString());
      return lines.join(QLatin1Char('\n'));
    }
    default:
      return {};
  }
}

}  // namespace mocapress
