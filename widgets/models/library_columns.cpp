// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/library_columns.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <utility>

#include "widgets/models/display_names.h"
#include "widgets/models/number_text.h"

namespace mocapress {
namespace {

struct Columns {
  Q_DECLARE_TR_FUNCTIONS(mocapress::LibraryColumns)
};

QString nameOf(Loop loop) {
  switch (loop) {
    case Loop::Repeats:
      return Columns::tr("loop, last pose repeats the first");
    case Loop::Follows:
      return Columns::tr("loop");
    case Loop::None:
      break;
  }
  return {};
}

QStringView nameIn(const QString& path) {
  return QStringView(path).mid(path.lastIndexOf(QLatin1Char('/')) + 1);
}

/// The relative growth of the clip's bytes since the earlier batch. Unset if either compression
/// failed or is missing.
std::optional<double> moreBytes(const LibraryEntry& entry) {
  const std::optional<ClipDifference>& since = entry.since;
  if (!since || !since->before->done || !since->after->done || since->before->bytes == 0) return {};
  return static_cast<double>(since->after->bytes) / static_cast<double>(since->before->bytes) - 1;
}

/// The growth of the clip's error since the earlier batch, in cm. Also unset if the two errors have
/// different weightings.
std::optional<double> moreError(const LibraryEntry& entry) {
  const std::optional<ClipDifference>& since = entry.since;
  if (!since || !since->before->done || !since->after->done ||
      since->before->weighting != since->after->weighting)
    return {};
  return since->after->eps_cm - since->before->eps_cm;
}

/// Ranks the clip's gravest change: the graver, the larger the number. Unset: no change.
std::optional<double> gravity(const LibraryEntry& entry) {
  if (!entry.since || entry.since->changes.empty()) return {};
  return -static_cast<double>(entry.since->changes.front());
}

/// Formats the value with a sign, or 0 if it is smaller than `least`.
template <typename Text>
QString signedText(double value, double least, const Text& text) {
  if (std::abs(value) < least) return text(0.0);
  return (value < 0 ? QStringLiteral("−") : QStringLiteral("+")) + text(std::abs(value));
}

QString changesText(const LibraryEntry& entry) {
  QStringList names;
  if (entry.since)
    for (const ClipChange change : entry.since->changes) names << displayName(change);
  return names.join(Columns::tr(", "));
}

}  // namespace

std::optional<double> numberOf(const LibraryEntry& entry, LibraryColumn column) {
  const std::optional<Outcome>& outcome = entry.outcome;
  switch (column) {
    case LibraryColumn::Notes:
      return static_cast<double>(notesOf(entry).size());
    case LibraryColumn::Looping:
      return static_cast<double>(entry.loop);
    case LibraryColumn::Length:
      if (entry.frames == 0 || entry.sample_rate_hz <= 0) return {};
      return entry.frames / entry.sample_rate_hz;
    case LibraryColumn::Review:
      return static_cast<double>(entry.review.verdict) + (entry.stale == Staleness::None ? 0 : 0.5);
    case LibraryColumn::BytesSince:
      return moreBytes(entry);
    case LibraryColumn::ErrorSince:
      return moreError(entry);
    case LibraryColumn::Since:
      return gravity(entry);
    default:
      break;
  }
  if (!outcome) return {};
  switch (column) {
    case LibraryColumn::Ratio:
      return outcome->ratio;
    case LibraryColumn::Bytes:
      return static_cast<double>(outcome->motion_bytes);
    case LibraryColumn::Error:
      return outcome->eps_cm;
    case LibraryColumn::Worst:
      return outcome->max_cm;
    case LibraryColumn::Slide:
      return outcome->slide_cm;
    case LibraryColumn::Seen:
      if (outcome->sight) return static_cast<double>(*outcome->sight);
      return {};
    default:
      return {};
  }
}

QString titleOf(LibraryColumn column) {
  switch (column) {
    case LibraryColumn::Clip:
      return Columns::tr("Clip");
    case LibraryColumn::Ratio:
      return Columns::tr("Ratio");
    case LibraryColumn::Bytes:
      return Columns::tr("Bytes");
    case LibraryColumn::Error:
      return Columns::tr("Error");
    case LibraryColumn::Worst:
      return Columns::tr("Worst");
    case LibraryColumn::Slide:
      return Columns::tr("Slide");
    case LibraryColumn::Seen:
      return Columns::tr("Eye");
    case LibraryColumn::Review:
      return Columns::tr("Verdict");
    case LibraryColumn::Notes:
      return Columns::tr("Warnings");
    case LibraryColumn::Looping:
      return Columns::tr("Loop");
    case LibraryColumn::Length:
      return Columns::tr("Length");
    case LibraryColumn::FromPreset:
      return Columns::tr("Preset");
    case LibraryColumn::BytesSince:
      return Columns::tr("Bytes since");
    case LibraryColumn::ErrorSince:
      return Columns::tr("Error since");
    case LibraryColumn::Since:
      return Columns::tr("Changes since");
  }
  return {};
}

QString purposeOf(LibraryColumn column) {
  switch (column) {
    case LibraryColumn::Clip:
      return Columns::tr("Clip, with its result and verdict");
    case LibraryColumn::Ratio:
      return Columns::tr("Compression ratio of the motion");
    case LibraryColumn::Bytes:
      return Columns::tr("Bytes of the compressed motion");
    case LibraryColumn::Error:
      return Columns::tr("Error of the whole clip, eps_x");
    case LibraryColumn::Worst:
      return Columns::tr("The largest error of any point at any frame");
    case LibraryColumn::Slide:
      return Columns::tr("Path of feet that stand in the original, summed over all contacts");
    case LibraryColumn::Seen:
      return Columns::tr("Visibility of errors");
    case LibraryColumn::Review:
      return Columns::tr("Verdict of the review");
    case LibraryColumn::Notes:
      return Columns::tr("Places that were repaired or guessed when the clip was read");
    case LibraryColumn::Looping:
      return Columns::tr("Kind of loop, if the clip is one");
    case LibraryColumn::Length:
      return Columns::tr("Length of the clip in seconds");
    case LibraryColumn::FromPreset:
      return Columns::tr("Preset of the clip's settings");
    case LibraryColumn::BytesSince:
      return Columns::tr("Bytes that it has more than in the batch that is compared");
    case LibraryColumn::ErrorSince:
      return Columns::tr("Error that it has more than in the batch that is compared");
    case LibraryColumn::Since:
      return Columns::tr("Changes since the batch that is compared, the gravest first");
  }
  return {};
}

QString textOf(const LibraryEntry& entry, LibraryColumn column) {
  const std::optional<Outcome>& outcome = entry.outcome;
  switch (column) {
    case LibraryColumn::Clip:
      return entry.name();
    case LibraryColumn::Ratio:
      return outcome ? ratioText(outcome->ratio) : QString();
    case LibraryColumn::Bytes:
      return outcome ? QLocale().toString(static_cast<qulonglong>(outcome->motion_bytes))
                     : QString();
    case LibraryColumn::Error:
      return outcome ? lengthText(outcome->eps_cm) : QString();
    case LibraryColumn::Worst:
      return outcome ? lengthText(outcome->max_cm) : QString();
    case LibraryColumn::Slide:
      return outcome && outcome->slide_cm ? lengthText(*outcome->slide_cm) : QString();
    case LibraryColumn::Seen:
      return outcome && outcome->sight ? displayName(*outcome->sight) : QString();
    case LibraryColumn::Review:
      return verdictText(entry.review.verdict, entry.stale);
    case LibraryColumn::Notes: {
      const auto count = notesOf(entry).size();
      return count > 0 ? QLocale().toString(count) : QString();
    }
    case LibraryColumn::Looping:
      return nameOf(entry.loop);
    case LibraryColumn::Length:
      return entry.frames > 0 && entry.sample_rate_hz > 0
                 ? Columns::tr("%1 s").arg(shownFigure(entry.frames / entry.sample_rate_hz))
                 : QString();
    case LibraryColumn::FromPreset:
      return entry.preset;
    case LibraryColumn::BytesSince: {
      const auto more = moreBytes(entry);
      const auto percent = [](double share) {
        return Columns::tr("%1 %").arg(shown(100 * share, 1));
      };
      return more ? signedText(*more, 0.0005, percent) : QString();
    }
    case LibraryColumn::ErrorSince: {
      const auto more = moreError(entry);
      return more ? signedText(*more, 0.001, lengthText) : QString();
    }
    case LibraryColumn::Since:
      return changesText(entry);
  }
  return {};
}

bool isNumber(LibraryColumn column) {
  return (column >= LibraryColumn::Ratio && column <= LibraryColumn::Slide) ||
         column == LibraryColumn::Notes || column == LibraryColumn::Length ||
         column == LibraryColumn::BytesSince || column == LibraryColumn::ErrorSince;
}

bool isOfComparison(LibraryColumn column) {
  return column >= LibraryColumn::Since;
}

QString displayName(ClipChange change) {
  switch (change) {
    case ClipChange::Failed:
      return Columns::tr("failed");
    case ClipChange::NewlyVisible:
      return Columns::tr("newly visible");
    case ClipChange::Worse:
      return Columns::tr("worse");
    case ClipChange::Larger:
      return Columns::tr("larger");
    case ClipChange::Gone:
      return Columns::tr("gone");
    case ClipChange::Added:
      return Columns::tr("added");
    case ClipChange::Done:
      return Columns::tr("no longer failed");
    case ClipChange::NoLongerSeen:
      return Columns::tr("no longer visible");
    case ClipChange::Better:
      return Columns::tr("better");
    case ClipChange::Smaller:
      return Columns::tr("smaller");
  }
  return {};
}

bool isBefore(const LibraryEntry& a, const LibraryEntry& b, LibraryColumn column) {
  if (column == LibraryColumn::FromPreset) return a.preset < b.preset;
  if (column == LibraryColumn::Clip) {
    const int order = nameIn(a.path).compare(nameIn(b.path), Qt::CaseInsensitive);
    if (order != 0) return order < 0;
    return std::pair(a.path, a.take) < std::pair(b.path, b.take);
  }
  return numberOf(a, column) < numberOf(b, column);  // unset values are less than all others
}

}  // namespace mocapress
