// SPDX-License-Identifier: MIT
// Apart from parallel.h, since TBB's headers conflict with those of Qt.
#pragma once

#include <functional>

namespace mocapress {

/// Runs `work` with the parallel loops in it on this thread alone, for work that must not take the
/// other cores from what someone waits for.
void on_one_thread(const std::function<void()>& work);

}  // namespace mocapress
