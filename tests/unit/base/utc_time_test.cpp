// SPDX-License-Identifier: MIT
#include "core/base/utc_time.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace mocapress {
namespace {

TEST(UtcTime, IsWrittenAsIso8601) {
  EXPECT_EQ(utc_text(0), "1970-01-01T00:00:00Z");
  EXPECT_EQ(utc_text(1700000000), "2023-11-14T22:13:20Z");
}

TEST(UtcTime, TheEnvironmentCanFixTheTimeOfReports) {
  const std::string before = std::getenv("SOURCE_DATE_EPOCH");
  ::setenv("SOURCE_DATE_EPOCH", "86400", 1);
  EXPECT_EQ(report_time(), 86400);
  ::setenv("SOURCE_DATE_EPOCH", "no number", 1);
  EXPECT_GT(report_time(), 1700000000);
  ::setenv("SOURCE_DATE_EPOCH", before.c_str(), 1);
}

}  // namespace
}  // namespace mocapress
