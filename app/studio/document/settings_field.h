// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "app/studio/document/document.h"

namespace mocapress {

/// The first setting that differs, as a person would name it.
enum class SettingsField {
  None,
  Preset,
  Target,
  Method,
  Effort,
  Importance,
  Ranges,
  Loop,
  Weighting,
  Distance,
  Limits,
  Ends,
  Coding,
  Correction,
  TrackError,
  Contacts,
  Slot,
  Other
};
SettingsField firstDifference(const ClipSettings& a, const ClipSettings& b);

/// The name of a field in the undo history: "Target".
QString nameOf(SettingsField field);

/// A key for merging the steps of a drag: changes of one number without a change of the target's
/// kind. Empty: the change is always a step of its own.
QString dragOf(const ClipSettings& before, const ClipSettings& after);

}  // namespace mocapress
