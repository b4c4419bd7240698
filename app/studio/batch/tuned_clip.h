// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "app/studio/document/named_settings.h"

namespace mocapress {

/// A clip of the library, and what was decided about it.
struct TunedClip {
  QString path;
  QString skeleton;                       // for an .amc; empty: the one beside it
  std::optional<NamedSettings> settings;  // unset: never tuned
  ReadOptions reading = {};               // of its import options
};

}  // namespace mocapress
