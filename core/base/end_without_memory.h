// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// From now on the program ends with a message and this exit code where memory runs out and the
/// error cannot be handed on, as in destructors: nlohmann's JSON allocates in its own. Without this
/// it aborts.
void end_without_memory_by(int exit_code);

}  // namespace mocapress
