// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/library_groups.h"

#include <QCoreApplication>
#include <cmath>
#include <limits>

#include "widgets/models/display_names.h"
#include "widgets/models/library_columns.h"
#include "widgets/models/library_filter.h"
#include "widgets/models/number_text.h"

namespace mocapress {
namespace {

struct Groups {
  Q_DECLARE_TR_FUNCTIONS(mocapress::LibraryGroups)
};

constexpr double kLast = std::numeric_limits<double>::infinity();

LibraryColumn columnOf(Grouping grouping) {
  switch (grouping) {
    case Grouping::Ratio:
      return LibraryColumn::Ratio;
    case Grouping::Bytes:
      return LibraryColumn::Bytes;
    case Grouping::Error:
      return LibraryColumn::Error;
    case Grouping::Slide:
      return LibraryColumn::Slide;
    case Grouping::Warned:
      return LibraryColumn::Notes;
    case Grouping::Looping:
      return LibraryColumn::Looping;
    case Grouping::Preset:
      return LibraryColumn::FromPreset;
    case Grouping::Worst:
      return LibraryColumn::Worst;
    case Grouping::Length:
      return LibraryColumn::Length;
    default:
      return LibraryColumn::Clip;
  }
}

bool isLength(LibraryColumn column) {
  return column == LibraryColumn::Error || column == LibraryColumn::Worst ||
         column == LibraryColumn::Slide;
}

QString textOf(double value, LibraryColumn column) {
  if (column == LibraryColumn::Length) return Groups::tr("%1 s").arg(shown(value, 0));
  if (!isLength(column)) return shown(value, 0);
  return value < 1000 ? roundLengthText(value) : lengthText(value);  // roundLengthText(): 3 digits
}

/// The group of a value: from one of 1, 2, 5, 10, 20 ... to the next. `least` is the first bound.
LibraryGroup bandOf(double value, LibraryColumn column, double least) {
  if (value < least) return {Groups::tr("below %1").arg(textOf(least, column)), 0};
  const double decade = std::pow(10, std::floor(std::log10(value)));
  const double step = value < 2 * decade ? 1 : value < 5 * decade ? 2 : 5;
  const double next = step == 2 ? 5 : 2 * step;
  return {Groups::tr("%1 to %2").arg(textOf(step * decade, column), textOf(next * decade, column)),
          step * decade};
}

LibraryGroup groupIn(const LibraryEntry& entry, LibraryColumn column) {
  if (column == LibraryColumn::Notes) {
    const bool any = !notesOf(entry).isEmpty();
    return {any ? displayName(LibraryShow::WithWarnings) : Groups::tr("Without warnings"),
            any ? 0.0 : 1.0};
  }
  if (isNumber(column)) {
    const std::optional<double> value = numberOf(entry, column);
    if (!value) return {Groups::tr("not known"), kLast};
    return bandOf(*value, column, isLength(column) ? 0.01 : 1);
  }
  const QString text = textOf(entry, column);
  return text.isEmpty() ? LibraryGroup{Groups::tr("none"), kLast} : LibraryGroup{text};
}

}  // namespace

QString displayName(Grouping grouping) {
  switch (grouping) {
    case Grouping::Folder:
      return Groups::tr("By folder");
    case Grouping::Verdict:
      return Groups::tr("By verdict");
    case Grouping::Seen:
      return Groups::tr("By visibility");
    case Grouping::None:
      return Groups::tr("As a list");
    case Grouping::Slide:
      return Groups::tr("By slide");
    case Grouping::Worst:
      return Groups::tr("By worst error");
    default:
      return Groups::tr("By %1", "title of a column").arg(titleOf(columnOf(grouping)).toLower());
  }
}

LibraryGroup groupOf(const LibraryEntry& entry, Grouping grouping) {
  switch (grouping) {
    case Grouping::Folder:
      return {entry.path.left(entry.path.lastIndexOf(QLatin1Char('/')))};
    case Grouping::Verdict:
      if (entry.review.verdict == Verdict::None) return {displayName(LibraryShow::NotReviewed)};
      if (entry.stale != Staleness::None) return {displayName(LibraryShow::Stale)};
      return {displayName(entry.review.verdict == Verdict::Approved ? LibraryShow::Approved
                                                                    : LibraryShow::Rejected)};
    case Grouping::Seen:
      if (!entry.outcome || !entry.outcome->sight) return {Groups::tr("not known")};
      return {displayName(*entry.outcome->sight)};
    case Grouping::None:
      return {};
    default:
      return groupIn(entry, columnOf(grouping));
  }
}

}  // namespace mocapress
