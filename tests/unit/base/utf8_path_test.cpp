// SPDX-License-Identifier: MIT
#include "core/base/utf8_path.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

TEST(Utf8Path, KeepsEveryLetterBothWays) {
  for (const std::string name : {"walk.bvh", "Łódź/動き 🕺/é.bvh", "a/../b", "", "/"}) {
    EXPECT_EQ(utf8(utf8_path(name)), name);
    EXPECT_EQ(generic_utf8(utf8_path(name)), name);
  }
  EXPECT_EQ(utf8_path("動き.bvh").extension(), ".bvh");
}

TEST(Utf8Path, KeepsBytesThatAreNotUtf8) {
  const std::string bytes = "a\xff\xfe.bvh";
  EXPECT_EQ(utf8(utf8_path(bytes)), bytes) << "POSIX takes any";
}

TEST(Utf8Path, ConvertsNamesThatMayBeLeftOutAndListsOfNames) {
  EXPECT_EQ(utf8_path_if(std::nullopt), std::nullopt);
  EXPECT_EQ(utf8_path_if("é"), utf8_path("é"));
  EXPECT_EQ(utf8_paths({"a", "é"}),
            (std::vector<std::filesystem::path>{utf8_path("a"), utf8_path("é")}));
}

}  // namespace
}  // namespace mocapress
