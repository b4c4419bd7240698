// SPDX-License-Identifier: MIT
#include "core/base/parallel_in_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace mocapress {
namespace {

TEST(ParallelInOrder, TakesEveryResultOnceInOrder) {
  for (const std::size_t count : {0, 1, 2, 1000}) {
    std::vector<std::size_t> taken;
    parallel_in_order(
        count, [](std::size_t index) { return std::make_unique<std::size_t>(index * index); },
        [&](std::size_t index, std::unique_ptr<std::size_t> made) {
          EXPECT_EQ(*made, index * index);
          taken.push_back(index);
          return true;
        });
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    EXPECT_EQ(taken, all);
  }
}

TEST(ParallelInOrder, MakesOnlyAFewAhead) {
  std::atomic<std::size_t> made{0};
  std::size_t most = 0;
  parallel_in_order(
      10000, [&](std::size_t) { return ++made; },
      [&](std::size_t index, std::size_t) {
        most = std::max(most, made - index);
        return true;
      });
  EXPECT_LE(most, 2U * std::max(1U, std::thread::hardware_concurrency()) + 1);
}

TEST(ParallelInOrder, TakesNothingAfterTheFirstRefusal) {
  std::size_t taken = 0;
  parallel_in_order(
      1000, [](std::size_t index) { return index; },
      [&](std::size_t index, std::size_t) {
        ++taken;
        return index < 10;
      });
  EXPECT_EQ(taken, 11U);
}

TEST(ParallelInOrder, ThrowsWhatTheFirstFailureThrew) {
  std::size_t taken = 0;
  try {
    parallel_in_order(
        1000,
        [](std::size_t index) {
          if (index >= 20) throw std::runtime_error(std::to_string(index));
          return index;
        },
        [&](std::size_t, std::size_t) {
          ++taken;
          return true;
        });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "20");
  }
  EXPECT_EQ(taken, 20U);
  EXPECT_THROW(parallel_in_order(
                   10, [](std::size_t index) { return index; },
                   [](std::size_t, std::size_t) -> bool { throw std::runtime_error("full"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace mocapress
