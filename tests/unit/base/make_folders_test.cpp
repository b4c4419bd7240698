// SPDX-License-Identifier: MIT
#include "core/base/make_folders.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

class MakeFoldersTest : public testing::Test {
 protected:
  MakeFoldersTest() { fs::create_directories(folder_); }
  ~MakeFoldersTest() override { fs::remove_all(folder_); }

  const fs::path folder_ =
      fs::path(testing::TempDir()) / ("make-folders-" + std::to_string(getpid()));
};

TEST_F(MakeFoldersTest, MakesAllThatAreMissing) {
  make_folders(folder_ / "a/b/c");
  EXPECT_TRUE(fs::is_directory(folder_ / "a/b/c"));
  make_folders(folder_ / "a/b/c");
  make_folders(folder_ / "a/d/");
  EXPECT_TRUE(fs::is_directory(folder_ / "a/d"));
  make_folders("");
  make_folders(".");
  make_folders("/");
}

TEST_F(MakeFoldersTest, AcceptsALinkToAFolder) {
  fs::create_directory(folder_ / "real");
  fs::create_directory_symlink("real", folder_ / "link");
  make_folders(folder_ / "link/below");
  EXPECT_TRUE(fs::is_directory(folder_ / "real/below"));
}

TEST_F(MakeFoldersTest, WhereAFileIsNoFolderIsMade) {
  write_text(folder_ / "file", "a");
  fs::create_symlink("nowhere", folder_ / "dangling");
  EXPECT_THROW(make_folders(folder_ / "file"), WriteError);
  EXPECT_THROW(make_folders(folder_ / "file/below"), WriteError);
  EXPECT_THROW(make_folders(folder_ / "dangling"), WriteError);
}

}  // namespace
}  // namespace mocapress
