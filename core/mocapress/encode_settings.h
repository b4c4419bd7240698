// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/encode/encoder.h"
#include "core/mocapress/settings.h"

namespace mocapress {

/// Translates settings to an encode of a clip with this skeleton. Throws Error if they name a joint
/// that the skeleton does not have.
EncodeSettings encode_settings(const Settings& settings, const Skeleton& skeleton);

}  // namespace mocapress
