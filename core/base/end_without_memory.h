// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// From now on, the program ends with a message and this exit code if memory runs out where no
/// exception can be thrown, for example in a destructor (nlohmann's JSON allocates in its own).
/// Without this call it would abort.
void end_without_memory_by(int exit_code);

}  // namespace mocapress
