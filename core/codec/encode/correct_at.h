// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace mocapress {

/// The frames at which effectors are brought to where the original has them.
enum class CorrectAt {
  EveryFrame,  // the paper's
  Contacts,    // in contact spans, blended in and out beside them
};

/// "every-frame", "contacts".
std::string_view name(CorrectAt at);

}  // namespace mocapress
