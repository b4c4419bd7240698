// SPDX-License-Identifier: MIT
// Parallel loops by oneTBB. Debian's build of oneTBB is opaque to the thread sanitizer, which would
// report every loop as a race; under the sanitizer, two plain threads do the work instead.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <exception>
#include <thread>
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

namespace mocapress {

/// Splits [first, end) into ranges of about `grain` elements or more and calls body(first_of_range,
/// end_of_range) for each, on all cores and in any order.
template <typename Index, typename Body>
void parallel_ranges(Index first, Index end, Index grain, const Body& body) {
#ifdef __SANITIZE_THREAD__
  if (end - first <= grain) return end > first ? body(first, end) : void();
  const Index middle = first + (end - first) / 2;
  std::exception_ptr failure;
  std::exception_ptr failure_of_other;
  const auto guarded = [&](Index from, Index to, std::exception_ptr& caught) {
    try {
      body(from, to);
    } catch (...) {
      caught = std::current_exception();
    }
  };
  std::thread other([&] { guarded(middle, end, failure_of_other); });
  guarded(first, middle, failure);
  other.join();
  if (failure) std::rethrow_exception(failure);
  if (failure_of_other) std::rethrow_exception(failure_of_other);
#else
  tbb::parallel_for(tbb::blocked_range<Index>(first, end, static_cast<std::size_t>(grain)),
                    [&](const auto& range) { body(range.begin(), range.end()); });
#endif
}

/// Calls body(index) for each of [first, end), on all cores and in any order.
template <typename Index, typename Body>
void parallel_for(Index first, Index end, const Body& body) {
  parallel_ranges(first, end, Index{1}, [&](Index from, Index to) {
    for (Index i = from; i < to; ++i) body(i);
  });
}

}  // namespace mocapress
