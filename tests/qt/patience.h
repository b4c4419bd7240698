// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mocapress {

/// How long a test waits for what must come; only ever waited for when something is broken.
inline constexpr int kPatience = 120'000;  // ms

}  // namespace mocapress
