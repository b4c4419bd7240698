// SPDX-License-Identifier: MIT
#include "core/base/file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"

namespace mocapress {
namespace {

class File : public testing::Test {
 protected:
  File() { std::filesystem::create_directories(folder_); }
  ~File() override { std::filesystem::remove_all(folder_); }
  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(File, ReadsBackWhatWasWritten) {
  write_text(folder_ / "a.txt", "one\ntwo");
  EXPECT_EQ(read_text(folder_ / "a.txt"), "one\ntwo");
}

TEST_F(File, ReplacesAnOldFileAndLeavesNothingBeside) {
  write_text(folder_ / "a.txt", "old and long");
  write_text(folder_ / "a.txt", "new");
  EXPECT_EQ(read_text(folder_ / "a.txt"), "new");
  const auto entries = std::filesystem::directory_iterator(folder_);
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

TEST_F(File, AFailedWriteLeavesTheOldFile) {
  const auto target = folder_ / "folder-in-the-way";
  std::filesystem::create_directories(target / "inside");
  EXPECT_THROW(write_text(target, "new"), WriteError);
  EXPECT_TRUE(std::filesystem::exists(target / "inside"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "folder-in-the-way.part"));
}

TEST_F(File, RefusesAMissingFileAndAFolderByName) {
  EXPECT_THROW(read_text(folder_ / "missing"), InputError);
  EXPECT_THROW(read_bytes(folder_), InputError);
}

}  // namespace
}  // namespace mocapress
