// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QFontMetrics;

namespace mocapress {

/// The characters that all of several names begin and end with: they tell none from another.
struct SharedName {
  qsizetype start = 0;
  qsizetype end = 0;
};

/// Numbers are not torn: of "walk01" and "walk02" only "walk" is shared.
SharedName sharedName(const QStringList& names);

/// As much of a name as fits: what it shares with its neighbours goes first, then its middle.
QString shortened(const QString& name, const SharedName& shared, const QFontMetrics& metrics,
                  int width);

}  // namespace mocapress
