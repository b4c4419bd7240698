// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/encode/encoder.h"
#include "core/mocapress/settings.h"

namespace mocapress {

/// Settings for one skeleton. Throws Error when an effector or another joint that is named is not
/// of it.
EncodeOptions encode_options(const Settings& settings, const Skeleton& skeleton);

}  // namespace mocapress
