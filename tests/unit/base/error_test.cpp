// SPDX-License-Identifier: MIT
#include "core/base/error.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

TEST(Error, InputErrorNamesFileLineAndColumn) {
  EXPECT_STREQ(InputError("a.bvh", 3, 7, "no number").what(), "a.bvh:3:7: no number");
}

TEST(Error, InputErrorOfAWholeFileNamesNoLine) {
  EXPECT_STREQ(InputError("a.bvh", 0, 0, "not found").what(), "a.bvh: not found");
}

TEST(Error, WarningNamesItsLine) {
  EXPECT_EQ((Warning{"a.bvh", 12, "one row too many"}.text()), "a.bvh:12: one row too many");
}

}  // namespace
}  // namespace mocapress
