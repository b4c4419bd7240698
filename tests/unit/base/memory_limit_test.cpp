// SPDX-License-Identifier: MIT
#include "core/base/memory_limit.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress {
namespace {

class MemoryLimit : public testing::Test {
 protected:
  ~MemoryLimit() override { set_memory_limit(kUsualMemoryLimit); }

  static std::string refusal(std::uint64_t bytes) {
    try {
      require_memory("walk.fbx", bytes);
      return "may be read";
    } catch (const InputError& error) {
      return error.what();
    }
  }
};

TEST_F(MemoryLimit, RefusesWhatTakesMoreAndNamesTheFile) {
  set_memory_limit(5 << 20);
  EXPECT_EQ(refusal(5 << 20), "may be read");
  EXPECT_EQ(refusal((5 << 20) + 1),
            "walk.fbx: takes some 6 MiB of memory, but the limit (--memory) is 5 MiB");
}

TEST_F(MemoryLimit, IsTwoGibibytesUntilItIsSet) {
  EXPECT_EQ(memory_limit(), std::uint64_t{2} << 30);
  EXPECT_GT(half_of_the_memory(), std::uint64_t{64} << 20);
}

TEST_F(MemoryLimit, AFailedAllocationNamesTheFile) {
  try {
    naming_what_takes_memory("walk.fbx", []() -> int { throw std::bad_alloc(); });
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "walk.fbx: takes more memory than this machine has to give");
  }
}

TEST_F(MemoryLimit, HoldsForTheBytesOfAFileItself) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("large-" + std::to_string(getpid()) + ".bvh");
  write_text(file, std::string(2000, 'x'));
  set_memory_limit(1999);
  EXPECT_THROW(read_text(file), InputError);
  set_memory_limit(2000);
  EXPECT_EQ(read_text(file).size(), 2000u);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace mocapress
