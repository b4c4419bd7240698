// SPDX-License-Identifier: MIT
// A parallel loop that passes on its results one by one and in order, by oneTBB's pipeline. Under
// the thread sanitizer it uses two plain threads, as parallel.h does.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef __SANITIZE_THREAD__
#include "core/base/parallel.h"
#else
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#endif

namespace mocapress {

/// Calls make(index) for each index in [0, count) on all cores, and take(index, made) for its
/// results in the order of the indices, one at a time but not always on the same thread. Only a few
/// results wait at a time. An exception of make(index) is thrown when that index is due in take().
/// After take() returns false, it is not called again.
template <typename Make, typename Take>
void parallel_in_order(std::size_t count, const Make& make, const Take& take) {
  using Made = std::invoke_result_t<const Make&, std::size_t>;
#ifdef __SANITIZE_THREAD__
  const std::size_t most_waiting = 2;
#else
  const auto most_waiting =
      2 * static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
#endif
  struct Result {
    std::optional<Made> made;
    std::exception_ptr failure;
  };
  std::vector<Result> waiting(most_waiting);  // a ring: index modulo its size
  std::atomic<bool> goes_on{true};
  const auto make_one = [&](std::size_t index) {
    Result& result = waiting[index % most_waiting];
    try {
      result.made.emplace(make(index));
    } catch (...) {
      result.failure = std::current_exception();
    }
    return index;
  };
  const auto take_one = [&](std::size_t index) {
    Result result = std::exchange(waiting[index % most_waiting], {});
    if (!goes_on) return;
    if (result.failure) std::rethrow_exception(result.failure);
    if (!take(index, std::move(*result.made))) goes_on = false;
  };
#ifdef __SANITIZE_THREAD__
  for (std::size_t first = 0; goes_on && first < count; first += most_waiting) {
    const std::size_t end = std::min(count, first + most_waiting);
    parallel_for(first, end, make_one);
    for (std::size_t index = first; index < end; ++index) take_one(index);
  }
#else
  std::size_t next = 0;
  const auto begin_one = [&](tbb::flow_control& flow) {
    if (next == count || !goes_on) {
      flow.stop();
      return count;
    }
    return next++;
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(
      most_waiting,
      tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, begin_one) &
          tbb::make_filter<std::size_t, std::size_t>(filter_mode::parallel, make_one) &
          tbb::make_filter<std::size_t, void>(filter_mode::serial_in_order, take_one));
#endif
}

}  // namespace mocapress
