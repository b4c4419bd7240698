// SPDX-License-Identifier: MIT
#include "core/formats/clip_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/support/own_process.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class ClipFiles : public testing::Test {
 protected:
  ClipFiles() {
    fs::create_directories(folder_ / "in/sub");
    fs::create_directories(folder_ / "far");
    for (const char* clip : {"in/a.bvh", "in/sub/b.bvh", "far/c.bvh"})
      write_text(folder_ / clip, "");
  }
  ~ClipFiles() override { fs::remove_all(folder_); }

  /// Relative paths of the clips found, with "!" after those with a problem.
  std::vector<std::string> found(const std::optional<FileIdentity>& left_out = {}) const {
    std::vector<std::string> names;
    for (const FoundClip& clip : clips_below(folder_ / "in", left_out))
      names.push_back(clip.path.lexically_relative(folder_ / "in").string() +
                      (clip.problem.empty() ? "" : "!"));
    return names;
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("clips-" + std::to_string(getpid()));
};

TEST_F(ClipFiles, AreFoundBehindLinksAndLoopsEnd) {
  fs::create_symlink("../far", folder_ / "in/linked");
  fs::create_symlink("../far/c.bvh", folder_ / "in/c.bvh");
  fs::create_symlink("..", folder_ / "in/sub/loop");
  fs::create_symlink("sub", folder_ / "in/again");
  EXPECT_THAT(found(),
              testing::UnorderedElementsAre("a.bvh", "c.bvh", "linked/c.bvh", "sub/b.bvh"));
}

TEST_F(ClipFiles, ThatCannotBeReadAreNamedWithTheReason) {
  fs::create_symlink("gone.bvh", folder_ / "in/dangling.bvh");
  fs::create_symlink("gone", folder_ / "in/folder");
  fs::create_symlink("gone.txt", folder_ / "in/notes.txt");
  ASSERT_EQ(mkfifo((folder_ / "in/pipe.bvh").c_str(), 0600), 0);
  EXPECT_THAT(found(), ElementsAre("a.bvh", "dangling.bvh!", "folder!", "pipe.bvh!", "sub/b.bvh"));
}

TEST_F(ClipFiles, AFolderThatCannotBeReadIsNamedAndOthersAreSearched) {
  fs::permissions(folder_ / "in/sub", fs::perms{});
  const std::string said = test::in_own_process([&]() -> std::string {
    if (!test::become_ordinary_user()) return test::kSkip;
    std::string problems;
    for (const FoundClip& clip : clips_below(folder_ / "in"))
      problems += clip.path.filename().string() + " " + clip.problem + "\n";
    return problems;
  });
  fs::permissions(folder_ / "in/sub", fs::perms{0755});
  if (said == test::kSkip) GTEST_SKIP() << "root cannot become another user here";
  EXPECT_THAT(said, HasSubstr("a.bvh \n"));
  EXPECT_THAT(said, HasSubstr("sub Permission denied"));
}

TEST_F(ClipFiles, AreNotFoundInALeftOutFolder) {
  EXPECT_THAT(found(identity_of(folder_ / "in/sub")), ElementsAre("a.bvh"));
}

}  // namespace
}  // namespace mocapress
