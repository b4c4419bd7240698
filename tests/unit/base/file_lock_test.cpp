// SPDX-License-Identifier: MIT
#include "core/base/file_lock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/file.h"
#include "tests/support/own_process.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

class FileLockTest : public testing::Test {
 protected:
  FileLockTest() { write_text(path_, "old"); }
  ~FileLockTest() override { fs::remove(path_); }

  static bool no() { return false; }

  const fs::path path_ =
      fs::path(testing::TempDir()) / ("file-lock-" + std::to_string(getpid()) + ".txt");
};

TEST_F(FileLockTest, OnlyOneHolderHasItAtATime) {
  std::optional<FileLock> first = FileLock::wait_for(path_, no);
  ASSERT_TRUE(first);
  EXPECT_FALSE(FileLock::wait_for(path_, no));
  first.reset();
  EXPECT_TRUE(FileLock::wait_for(path_, no));
}

TEST_F(FileLockTest, AWaiterLocksTheFileThatReplacedTheOldOne) {
  std::optional<FileLock> first = FileLock::wait_for(path_, no);
  const std::optional<FileLock> second = FileLock::wait_for(path_, [&] {
    write_text(path_, "new");
    first.reset();
    return true;
  });
  ASSERT_TRUE(second);
  EXPECT_FALSE(FileLock::wait_for(path_, no));  // the lock is on the file now at the place
}

TEST_F(FileLockTest, WhereThereIsNoFileThereIsNothingToWaitFor) {
  fs::remove(path_);
  const std::optional<FileLock> first = FileLock::wait_for(path_, no);
  EXPECT_TRUE(first);
  EXPECT_TRUE(FileLock::wait_for(path_, no));
}

TEST_F(FileLockTest, SaysThatTheFileSystemHasNoLocks) {
  const auto no_locks = [](int) {
    errno = ENOLCK;
    return -1;
  };
  const std::optional<FileLock> lock = FileLock::wait_for(path_, no, no_locks);
  ASSERT_TRUE(lock);
  ASSERT_TRUE(lock->warning());
  EXPECT_THAT(lock->warning()->text(), testing::HasSubstr("cannot be locked (No locks"));
  EXPECT_FALSE(FileLock::wait_for(path_, no)->warning());
}

TEST_F(FileLockTest, AFileThatCannotBeOpenedIsAnErrorAndNotAbsent) {
  fs::permissions(path_, fs::perms::owner_write);
  const std::string said = test::in_own_process([&]() -> std::string {
    if (!test::become_ordinary_user()) return test::kSkip;
    FileLock::wait_for(path_, no);
    return "taken for absent";
  });
  if (said == test::kSkip) GTEST_SKIP() << "cannot become an ordinary user here";
  EXPECT_EQ(said, "threw: " + path_.string() + ": Permission denied");
}

}  // namespace
}  // namespace mocapress
