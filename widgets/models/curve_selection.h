// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <QStringList>
#include <vector>

namespace mocapress {

/// The landmarks whose error is drawn, by name, so that the choice survives a change of clip. Each
/// keeps its colour while others come and go.
class CurveSelection {
 public:
  bool contains(const QString& name) const;
  void add(const QString& name);
  void remove(const QString& name);

  /// The landmark's colour; invalid if the landmark is not selected.
  QColor colour(const QString& name) const;

  QStringList names() const;

  bool operator==(const CurveSelection&) const = default;

 private:
  std::vector<QString> slots_;  // index = colour; an empty name is a free colour
};

}  // namespace mocapress
