// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "app/studio/document/document.h"

namespace mocapress {

/// The first setting in which two differ, as a person would name it.
enum class SettingsField {
  None,
  Preset,
  Target,
  Method,
  Effort,
  Importance,
  Weighting,
  Ends,
  Coding,
  Correction,
  TrackError,
  Contacts,
  Slot,
  Other
};
SettingsField firstDifference(const ClipSettings& a, const ClipSettings& b);

/// As the undo history names a change of it: "Target".
QString nameOf(SettingsField field);

/// By which steps of a drag are merged: changes of one number, whose target stays of one kind.
/// Empty: every change is a step of its own, however quickly it is made.
QString dragOf(const ClipSettings& before, const ClipSettings& after);

}  // namespace mocapress
