// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace mocapress {

/// Receives a report from long work and returns whether to go on. After false the work ends soon
/// and returns the best it has, marked incomplete; the caller decides whether to keep it. Called on
/// the thread that does the work. An empty function goes on.
template <typename State>
using Observer = std::function<bool(const State&)>;

template <typename State>
bool should_continue(const Observer<State>& observer, const State& state) {
  return !observer || observer(state);
}

}  // namespace mocapress
