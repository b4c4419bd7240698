// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/encode/encoder.h"
#include "core/mocapress/settings.h"

namespace mocapress {

/// The settings of an encode of a clip with that skeleton. Throws Error if they name an effector or
/// another joint that the skeleton lacks.
EncodeSettings encode_settings(const Settings& settings, const Skeleton& skeleton);

}  // namespace mocapress
