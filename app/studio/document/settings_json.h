// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>

#include "app/studio/document/document.h"

namespace mocapress {

QJsonObject toJson(const ClipSettings& settings);

/// What is left out is as usual. Throws Error on a name that is not known.
ClipSettings settingsFrom(const QJsonObject& json);

}  // namespace mocapress
