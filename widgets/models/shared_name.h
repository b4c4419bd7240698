// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QFontMetrics;

namespace mocapress {

/// Lengths of the beginning and the end that several names share, which do not tell them apart.
struct SharedName {
  qsizetype start = 0;
  qsizetype end = 0;
};

/// Numbers stay whole: "walk01" and "walk02" share only "walk".
SharedName sharedName(const QStringList& names);

/// Shortens a name to fit. The part shared with its neighbours goes first, then the middle.
QString shortened(const QString& name, const SharedName& shared, const QFontMetrics& metrics,
                  int width);

}  // namespace mocapress
