// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace mocapress {

/// How long a closed loop may look for something smaller. The others know one effort only.
enum class Effort {
  Draft,    // while a slider moves: about the target, which is not promised
  Default,  // the target is met
  Best,     // a few per cent smaller, for some ten times the time
};

/// "draft", "default", "best".
std::string_view name(Effort effort);

}  // namespace mocapress
