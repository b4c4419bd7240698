// SPDX-License-Identifier: MIT
// Not part of parallel.h, since TBB's headers conflict with those of Qt.
#pragma once

#include <functional>

namespace mocapress {

/// Runs `work`, including its parallel loops, on this thread alone. The other cores stay free for
/// work that somebody waits for.
void on_one_thread(const std::function<void()>& work);

}  // namespace mocapress
