// SPDX-License-Identifier: MIT
#include "core/base/lock_holder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

namespace mocapress {
namespace {

TEST(LockHolder, ReadsBackFromItsJson) {
  const LockHolder holder = this_process();
  EXPECT_EQ(lock_holder_from(to_json(holder)), holder);
  EXPECT_EQ(holder.process, getpid());
  EXPECT_NE(holder.user, "");
}

TEST(LockHolder, SaysWhoWhereAndSinceWhen) {
  EXPECT_EQ(text(LockHolder{"render3", "ana", 4711, "2026-11-26T14:05:00Z"}),
            "ana on render3, process 4711, since 2026-11-26T14:05:00Z");
}

}  // namespace
}  // namespace mocapress
