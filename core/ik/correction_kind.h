// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "core/runtime/format/kinds.h"

namespace mocapress {

/// The solver that turns the joints of a limb.
using IkSolver = runtime::Solver;

/// "cyclic-descent", "nearest-pose".
std::string_view name(IkSolver solver);

/// The frames at which effectors are brought to their original places.
enum class CorrectAt {
  EveryFrame,  // as in the paper
  Contacts,    // in contact spans, blended in and out beside them
};

/// "every-frame", "contacts".
std::string_view name(CorrectAt at);

}  // namespace mocapress
