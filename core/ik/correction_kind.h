// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace mocapress {

/// The solver that turns the joints of a limb. The values are part of the file format.
enum class IkSolver : std::uint8_t {
  CyclicDescent = 1,  // the paper's: one joint after the other, repeatedly
  NearestPose = 2,    // moves the limb least: two bones in closed form, else damped steps
};

/// "cyclic-descent", "nearest-pose".
std::string_view name(IkSolver solver);

/// The frames at which effectors are brought to their original places.
enum class CorrectAt {
  EveryFrame,  // the paper's
  Contacts,    // in contact spans, blended in and out beside them
};

/// "every-frame", "contacts".
std::string_view name(CorrectAt at);

}  // namespace mocapress
