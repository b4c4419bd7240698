// SPDX-License-Identifier: MIT
#include "core/base/file_identity.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

class FileIdentityTest : public testing::Test {
 protected:
  FileIdentityTest() {
    fs::create_directories(folder_ / "in");
    write_text(folder_ / "a", "same");
    write_text(folder_ / "b", "same");
    fs::create_symlink("a", folder_ / "link");
    fs::create_hard_link(folder_ / "a", folder_ / "hard");
  }
  ~FileIdentityTest() override { fs::remove_all(folder_); }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("identity-" + std::to_string(getpid()));
};

TEST_F(FileIdentityTest, IsOneForLinksHardLinksAndSpellings) {
  const auto a = identity_of(folder_ / "a");
  ASSERT_TRUE(a);
  for (const char* same : {"link", "hard", "in/../a"}) EXPECT_EQ(identity_of(folder_ / same), a);
  EXPECT_NE(identity_of(folder_ / "b"), a);
  EXPECT_EQ(identity_of(folder_ / "none"), std::nullopt);
}

TEST_F(FileIdentityTest, APathThatCannotBeLookedAtIsNotAbsent) {
  fs::create_symlink("self", folder_ / "self");
  EXPECT_THROW(identity_of(folder_ / "self"), InputError);
}

TEST_F(FileIdentityTest, RefusesToWriteOntoASourceByAnyOfItsNames) {
  for (const char* name : {"a", "link", "hard"})
    EXPECT_THROW(refuse_source(folder_ / name, {folder_ / "b", folder_ / "a"}), WriteError);
  refuse_source(folder_ / "b", {folder_ / "a"});
  refuse_source(folder_ / "new", {folder_ / "a", folder_ / "none"});
}

}  // namespace
}  // namespace mocapress
