// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/codec/encode/correction_encoder.h"

namespace mocapress {

/// What people read for the values of the file format.
QString displayName(Method method);
QString displayName(Coding coding);
QString displayName(Weighting weighting);
QString displayName(CorrectAt at);

}  // namespace mocapress
