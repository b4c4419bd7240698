// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace mocapress {

/// Runs `work` with the parallel loops in it on this thread alone, for work that must not take the
/// other cores from what someone waits for.
void on_one_thread(const std::function<void()>& work);

}  // namespace mocapress
