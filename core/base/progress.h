// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace mocapress {

/// A function that receives progress reports of long work and returns whether to continue. After
/// false the work ends soon and returns its best result so far, marked incomplete; the caller
/// decides whether to keep that. Called on the thread that does the work. Without a function the
/// work continues.
template <typename State>
using Observer = std::function<bool(const State&)>;

template <typename State>
bool should_continue(const Observer<State>& observer, const State& state) {
  return !observer || observer(state);
}

}  // namespace mocapress
