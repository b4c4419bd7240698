// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// From now on, the program ends with a message and this exit code if memory runs out where no
/// exception can be thrown, as in destructors (nlohmann's JSON allocates in its own). Otherwise it
/// would abort.
void end_without_memory_by(int exit_code);

}  // namespace mocapress
