// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/shared_name.h"

#include <QFontMetrics>
#include <algorithm>
#include <utility>

namespace mocapress {

SharedName sharedName(const QStringList& names) {
  if (names.size() < 2) return {};
  const QString& first = names.front();
  SharedName shared{first.size(), first.size()};
  qsizetype shortest = first.size();
  for (const QString& name : names) {
    shortest = std::min(shortest, name.size());
    const auto [a, b] = std::mismatch(first.begin(), first.end(), name.begin(), name.end());
    const auto [c, d] = std::mismatch(first.rbegin(), first.rend(), name.rbegin(), name.rend());
    shared.start = std::min<qsizetype>(shared.start, a - first.begin());
    shared.end = std::min<qsizetype>(shared.end, c - first.rbegin());
  }
  while (shared.start > 0 && first[shared.start - 1].isDigit()) --shared.start;
  while (shared.end > 0 && first[first.size() - shared.end].isDigit()) --shared.end;
  shared.end = std::min(shared.end, shortest - shared.start);
  return shared;
}

QString shortened(const QString& name, const SharedName& shared, const QFontMetrics& metrics,
                  int width) {
  const auto fits = [&](const QString& text) { return metrics.horizontalAdvance(text) <= width; };
  if (fits(name)) return name;
  const QString dots = QStringLiteral("…");
  const auto without = [&](qsizetype start, qsizetype end) {
    const QString rest = name.right(end);
    // A shared file extension is dropped without dots.
    return (start > 1 ? dots : name.left(start)) + name.mid(start, name.size() - start - end) +
           (end < 2                             ? rest
            : rest.startsWith(QLatin1Char('.')) ? QString()
                                                : dots);
  };
  const QString from_start = without(shared.start, 0);
  if (fits(from_start)) return from_start;
  return metrics.elidedText(without(shared.start, shared.end), Qt::ElideMiddle, width);
}

}  // namespace mocapress
