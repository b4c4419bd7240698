// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QFontMetrics;

namespace mocapress {

/// Lengths of the prefix and the suffix that several names share.
struct SharedName {
  qsizetype start = 0;
  qsizetype end = 0;
};

/// Finds the shared prefix and suffix. Numbers stay whole: "walk01" and "walk02" share only "walk".
SharedName sharedName(const QStringList& names);

/// Shortens a name to fit. The shared prefix goes first, then the shared suffix and the middle.
QString shortened(const QString& name, const SharedName& shared, const QFontMetrics& metrics,
                  int width);

}  // namespace mocapress
