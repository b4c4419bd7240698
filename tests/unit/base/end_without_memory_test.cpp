// SPDX-License-Identifier: MIT
#include "core/base/end_without_memory.h"

#include <gtest/gtest.h>

#include <new>

namespace mocapress {
namespace {

void allocate_in_vain() {
  throw std::bad_alloc();
}

/// Like a JSON value, which allocates in its destructor.
struct Allocating {
  ~Allocating() { allocate_in_vain(); }
};

TEST(EndWithoutMemory, AnAllocationThatFailsInADestructorEndsTheProgramWithAMessage) {
  const auto run = [] {
    end_without_memory_by(3);
    const Allocating value;
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(3),
              "^mocapress: takes more memory than this machine has to give\n$");
}

}  // namespace
}  // namespace mocapress
