// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/encode/encoder.h"
#include "core/mocapress/settings.h"

namespace mocapress {

/// The settings as options for one skeleton. Throws Error if they name an effector or another joint
/// that the skeleton lacks.
EncodeOptions encode_options(const Settings& settings, const Skeleton& skeleton);

}  // namespace mocapress
