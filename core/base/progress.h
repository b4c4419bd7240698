// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace mocapress {

/// A report from long work, answered with "go on?". After false the work ends soon and returns the
/// best it has, marked incomplete; whether to keep or drop that is the caller's decision. Called
/// on the thread that does the work. An empty function goes on.
template <typename State>
using Observer = std::function<bool(const State&)>;

template <typename State>
bool should_continue(const Observer<State>& observer, const State& state) {
  return !observer || observer(state);
}

}  // namespace mocapress
