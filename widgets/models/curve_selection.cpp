// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/curve_selection.h"

#include <algorithm>

#include "widgets/models/colours.h"

namespace mocapress {

bool CurveSelection::contains(const QString& name) const {
  return colour(name).isValid();
}

void CurveSelection::add(const QString& name) {
  if (name.isEmpty() || contains(name)) return;
  const auto free = std::find(slots_.begin(), slots_.end(), QString());
  if (free == slots_.end())
    slots_.push_back(name);
  else
    *free = name;
}

void CurveSelection::remove(const QString& name) {
  std::replace(slots_.begin(), slots_.end(), name, QString());
}

QColor CurveSelection::colour(const QString& name) const {
  const auto slot = std::find(slots_.begin(), slots_.end(), name);
  if (name.isEmpty() || slot == slots_.end()) return {};
  return QColor(
      kCurveColours[static_cast<std::size_t>(slot - slots_.begin()) % kCurveColours.size()]);
}

QStringList CurveSelection::names() const {
  QStringList names;
  for (const QString& slot : slots_)
    if (!slot.isEmpty()) names << slot;
  return names;
}

}  // namespace mocapress
