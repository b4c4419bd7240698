// SPDX-License-Identifier: MIT
#include "core/base/path_kind.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/support/own_process.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

class PathKindTest : public testing::Test {
 protected:
  PathKindTest() { fs::create_directories(folder_); }
  ~PathKindTest() override { fs::remove_all(folder_); }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("path-kind-" + std::to_string(getpid()));
};

TEST_F(PathKindTest, TellsFilesFoldersAndOthersApart) {
  write_text(folder_ / "a.txt", "a");
  ASSERT_EQ(::mkfifo((folder_ / "fifo").c_str(), 0600), 0);
  EXPECT_EQ(path_kind(folder_ / "a.txt"), PathKind::File);
  EXPECT_EQ(path_kind(folder_), PathKind::Folder);
  EXPECT_EQ(path_kind(folder_ / "fifo"), PathKind::Other);
}

TEST_F(PathKindTest, OnlyWhatTheSystemDoesNotFindIsAbsent) {
  write_text(folder_ / "a.txt", "a");
  fs::create_symlink("nowhere", folder_ / "dangling");
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_FALSE(is_there(folder_ / "b.txt"));
  EXPECT_FALSE(is_there(folder_ / "a.txt/below"));
  EXPECT_FALSE(is_there(folder_ / "dangling"));
  EXPECT_THROW(is_there(folder_ / "loop"), InputError);
  EXPECT_THROW(is_there(folder_ / std::string(300, 'x')), InputError)
      << "longer than a name may be";
}

TEST_F(PathKindTest, ARealPathHasItsLinksResolved) {
  write_text(folder_ / "a.txt", "a");
  fs::create_symlink("a.txt", folder_ / "link");
  EXPECT_EQ(real_path(folder_ / "link"), fs::canonical(folder_) / "a.txt");
  EXPECT_EQ(real_path(folder_ / "b.txt"), std::nullopt);
}

TEST_F(PathKindTest, AFolderThatMayNotBeEnteredHidesNothing) {
  fs::create_directory(folder_ / "closed");
  write_text(folder_ / "closed/a.txt", "a");
  fs::permissions(folder_, fs::perms::all);
  fs::permissions(folder_ / "closed", fs::perms::none);
  const std::string said = test::in_own_process([&]() -> std::string {
    if (!test::become_ordinary_user()) return test::kSkip;
    return is_there(folder_ / "closed/a.txt") ? "there" : "absent";
  });
  fs::permissions(folder_ / "closed", fs::perms::owner_all);
  if (said == test::kSkip) GTEST_SKIP() << "cannot become an ordinary user here";
  EXPECT_EQ(said, "threw: " + (folder_ / "closed/a.txt").string() +
                      ": cannot be looked at: Permission denied");
}

TEST_F(PathKindTest, OneFileHasManyNames) {
  write_text(folder_ / "a.txt", "a");
  write_text(folder_ / "b.txt", "a");
  fs::create_symlink("a.txt", folder_ / "link");
  EXPECT_TRUE(is_same_file(folder_ / "a.txt", folder_ / "link"));
  EXPECT_FALSE(is_same_file(folder_ / "a.txt", folder_ / "b.txt"));
  EXPECT_FALSE(is_same_file(folder_ / "none", folder_ / "none"));
}

}  // namespace
}  // namespace mocapress
