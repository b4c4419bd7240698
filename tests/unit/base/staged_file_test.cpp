// SPDX-License-Identifier: MIT
#include "core/base/staged_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/support/own_process.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Temporary = StagedFile::Temporary;
using Existing = StagedFile::Existing;

constexpr uid_t kSomebodyElse = 12345;

/// Runs both ways: with unnamed files, and with named ones as some file systems need.
class StagedFileTest : public testing::TestWithParam<Temporary> {
 protected:
  StagedFileTest() { fs::create_directories(folder_); }
  ~StagedFileTest() override { fs::remove_all(folder_); }

  StagedFile staged(const fs::path& path, std::string_view text) const {
    StagedFile file(path, GetParam());
    file.write(text);
    return file;
  }

  void write(const fs::path& path, std::string_view text) const { staged(path, text).commit(); }

  /// The message of a failure; empty: none.
  std::string failure(const fs::path& path, std::string_view text,
                      Existing existing = Existing::Replace) const {
    try {
      staged(path, text).commit(existing);
      return "";
    } catch (const WriteError& error) {
      return error.what();
    }
  }

  static void put(const fs::path& path, std::string_view text) {
    std::ofstream(path, std::ios::binary) << text;
  }

  static std::string text_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_))
      all.push_back(entry.path().filename());
    std::sort(all.begin(), all.end());
    return all;
  }

  static mode_t mode_of(const fs::path& path) {
    struct stat found;
    return ::stat(path.c_str(), &found) == 0 ? found.st_mode & 07777 : 0;
  }

  /// In a process of its own, makes room scarce by `make_scarce` and replaces an old file by
  /// contents that do not fit.
  std::string overfill(const std::function<bool()>& make_scarce, const std::string& why) const {
    return test::in_own_process([&]() -> std::string {
      if (!make_scarce()) return test::kSkip;
      put(place_, "old");
      const std::string said = failure(place_, std::string(1 << 20, 'x'));
      if (said.find(place_.string()) == said.npos || said.find(why) == said.npos)
        return "said: " + said;
      if (text_of(place_) != "old") return "the old file is gone";
      if (names().size() != 1) return "something is left";
      put(place_, "");
      return failure(place_, "what fits");
    });
  }

  const fs::path folder_ =
      fs::path(testing::TempDir()) /
      ("staged-" + std::to_string(getpid()) + (GetParam() == Temporary::Named ? "-named" : ""));
  const fs::path place_ = folder_ / "walk.mcpr";
};

INSTANTIATE_TEST_SUITE_P(StagedFile, StagedFileTest,
                         testing::Values(Temporary::Unnamed, Temporary::Named),
                         [](const auto& each) {
                           return each.param == Temporary::Named ? "Named" : "Unnamed";
                         });

TEST_P(StagedFileTest, TakesItsPlaceAtTheCommitAndNotBefore) {
  put(place_, "old");
  StagedFile file = staged(place_, "new, ");
  file.write("in pieces");
  EXPECT_EQ(text_of(place_), "old");
  const auto written = file.read_back();
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(written.data()), written.size()),
            "new, in pieces");
  file.commit();
  EXPECT_EQ(text_of(place_), "new, in pieces");
  EXPECT_THAT(names(), ElementsAre("walk.mcpr"));
}

TEST_P(StagedFileTest, ManyTakeTheirPlacesTogether) {
  put(folder_ / "1", "old");
  std::vector<StagedFile> files;
  for (int i = 0; i < 20; ++i)
    files.push_back(staged(folder_ / std::to_string(i), "new " + std::to_string(i)));
  files.push_back(staged("/dev/shm/mocapress-staged-" + std::to_string(getpid()), "elsewhere"));
  EXPECT_EQ(text_of(folder_ / "1"), "old");
  StagedFile::commit_all(files);
  StagedFile::commit_all({});
  EXPECT_EQ(names().size(), 20U);
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(text_of(folder_ / std::to_string(i)), "new " + std::to_string(i));
  const fs::path elsewhere = "/dev/shm/mocapress-staged-" + std::to_string(getpid());
  EXPECT_EQ(text_of(elsewhere), "elsewhere");
  fs::remove(elsewhere);
}

TEST_P(StagedFileTest, NoneOfManyStaysWhereOneFindsItsPlaceTaken) {
  std::vector<StagedFile> files;
  for (const char* name : {"a", "b", "c"}) files.push_back(staged(folder_ / name, "new"));
  put(folder_ / "b", "another's");
  EXPECT_THROW(StagedFile::commit_all(files, Existing::Refuse), WriteError);
  files.clear();
  EXPECT_THAT(names(), ElementsAre("b"));
  EXPECT_EQ(text_of(folder_ / "b"), "another's");
}

TEST_P(StagedFileTest, FilesThatReplacedOthersStayWhereAnotherOfManyFails) {
  put(folder_ / "a", "old");
  std::vector<StagedFile> files;
  for (const char* name : {"a", "b", "c"}) files.push_back(staged(folder_ / name, "new"));
  fs::create_directories(folder_ / "c");
  EXPECT_THROW(StagedFile::commit_all(files), WriteError);
  files.clear();
  EXPECT_THAT(names(), ElementsAre("a", "c"));
  EXPECT_EQ(text_of(folder_ / "a"), "new");
}

TEST_P(StagedFileTest, NotCommittedLeavesNothing) {
  { const StagedFile file = staged(place_, "new"); }
  {
    StagedFile file = staged(place_, "new");
    const StagedFile other = std::move(file);
  }
  EXPECT_THAT(names(), IsEmpty());
}

TEST_P(StagedFileTest, IsWrittenToTheWorkingFolderAndUnderTheLongestName) {
  const std::string said = test::in_own_process([&]() -> std::string {
    fs::current_path(folder_);
    return failure("walk.mcpr", "new") + failure(std::string(255, 'w'), "new");
  });
  EXPECT_EQ(said, "");
  EXPECT_EQ(names().size(), 2u);
}

TEST_P(StagedFileTest, LeavesTheOldFileWhenTheDiskIsFull) {
  const std::string said = overfill([&] { return test::mount_small_disk(folder_, 256 << 10); },
                                    "No space left on device");
  if (said == test::kSkip) GTEST_SKIP() << "nothing can be mounted here";
  EXPECT_EQ(said, "");
}

TEST_P(StagedFileTest, LeavesTheOldFileWhenItWouldBecomeTooLarge) {
  const std::string said =
      overfill([] { return test::limit_file_size(256 << 10); }, "File too large");
  if (said == test::kSkip) GTEST_SKIP() << "no limits can be set here";
  EXPECT_EQ(said, "");
}

TEST_P(StagedFileTest, LeavesAFolderThatMayNotBeWrittenAsItIs) {
  put(place_, "old");
  fs::permissions(place_, fs::perms{0666});
  fs::permissions(folder_, fs::perms{0555});
  const std::string said = test::in_own_process([&]() -> std::string {
    return test::become_ordinary_user() ? failure(place_, "new") : test::kSkip;
  });
  fs::permissions(folder_, fs::perms{0755});
  if (said == test::kSkip) GTEST_SKIP() << "root cannot become another user here";
  EXPECT_THAT(said, HasSubstr("walk.mcpr: cannot be written: Permission denied"));
  EXPECT_EQ(text_of(place_), "old");
  EXPECT_THAT(names(), ElementsAre("walk.mcpr"));
}

TEST_P(StagedFileTest, RefusesAWriteProtectedFile) {
  put(place_, "old");
  fs::permissions(place_, fs::perms{0444});
  fs::permissions(folder_, fs::perms{0777});
  const std::string said = test::in_own_process([&]() -> std::string {
    return test::become_ordinary_user() ? failure(place_, "new") : test::kSkip;
  });
  if (said == test::kSkip) GTEST_SKIP() << "root cannot become another user here";
  EXPECT_THAT(said, HasSubstr("Permission denied"));
  EXPECT_EQ(text_of(place_), "old");
}

TEST_P(StagedFileTest, LeavesWhatTheUserHasBesideAlone) {
  const fs::path victim = folder_ / "victim";
  put(victim, "precious");
  put(folder_ / "a.mcpr.part", "the user's own");
  fs::create_symlink(victim, folder_ / "b.mcpr.part");
  write(folder_ / "a.mcpr", "new");
  write(folder_ / "b.mcpr", "new");
  EXPECT_EQ(text_of(folder_ / "a.mcpr.part"), "the user's own");
  EXPECT_EQ(text_of(victim), "precious");
  EXPECT_TRUE(fs::is_symlink(folder_ / "b.mcpr.part"));
  EXPECT_THAT(names(), ElementsAre("a.mcpr", "a.mcpr.part", "b.mcpr", "b.mcpr.part", "victim"));
}

TEST_P(StagedFileTest, WritesToWhereALinkPoints) {
  fs::create_directories(folder_ / "clips");
  put(folder_ / "clips/real.mcpr", "old");
  fs::create_symlink("clips/real.mcpr", folder_ / "middle");
  fs::create_symlink("middle", place_);
  write(place_, "new");
  EXPECT_TRUE(fs::is_symlink(place_));
  EXPECT_EQ(text_of(folder_ / "clips/real.mcpr"), "new");
  fs::create_symlink("clips/made.mcpr", folder_ / "to-nothing");
  write(folder_ / "to-nothing", "made");
  EXPECT_EQ(text_of(folder_ / "clips/made.mcpr"), "made");
}

TEST_P(StagedFileTest, RefusesLinksInACircle) {
  fs::create_symlink("circle", folder_ / "circle");
  EXPECT_THAT(failure(folder_ / "circle", "new"), HasSubstr("symbolic links"));
}

TEST_P(StagedFileTest, RefusesALinkThatSomebodyElsePlantedInASharedFolder) {
  const fs::path victim = folder_ / "victim";
  put(victim, "precious");
  const fs::path shared = folder_ / "shared";
  fs::create_directories(shared);
  fs::permissions(shared, fs::perms{01777});
  fs::create_symlink(victim, shared / "walk.mcpr");
  EXPECT_EQ(failure(shared / "walk.mcpr", "mine"), "") << "one's own link";
  put(victim, "precious");
  if (::lchown((shared / "walk.mcpr").c_str(), kSomebodyElse, kSomebodyElse) != 0)
    GTEST_SKIP() << "only root can give a link away";
  EXPECT_THAT(failure(shared / "walk.mcpr", "new"), HasSubstr("somebody else"));
  EXPECT_EQ(text_of(victim), "precious");
}

TEST_P(StagedFileTest, KeepsThePermissionsOfAnOldFile) {
  put(place_, "old");
  for (const mode_t mode : {0600U, 0640U, 0755U, 0666U}) {
    ASSERT_EQ(::chmod(place_.c_str(), mode), 0);
    write(place_, "new");
    EXPECT_EQ(mode_of(place_), mode);
  }
}

TEST_P(StagedFileTest, KeepsTheOwnerOfAnOldFileForRoot) {
  put(place_, "old");
  if (::chown(place_.c_str(), kSomebodyElse, kSomebodyElse) != 0)
    GTEST_SKIP() << "only root can give a file away";
  write(place_, "new");
  struct stat found;
  ASSERT_EQ(::stat(place_.c_str(), &found), 0);
  EXPECT_EQ(found.st_uid, kSomebodyElse);
  EXPECT_EQ(found.st_gid, kSomebodyElse);
}

TEST_P(StagedFileTest, GivesANewFileThePermissionsOfTheUmask) {
  const std::string said = test::in_own_process([&]() -> std::string {
    ::umask(027);
    return failure(place_, "new");
  });
  EXPECT_EQ(said, "");
  EXPECT_EQ(mode_of(place_), 0640u);
}

TEST_P(StagedFileTest, RefusesFoldersPipesAndMissingFolders) {
  fs::create_directories(folder_ / "folder");
  EXPECT_THAT(failure(folder_ / "folder", "new"), HasSubstr("is a folder"));
  EXPECT_THAT(failure(folder_ / "", "new"), HasSubstr("is a folder"));
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(failure(folder_ / "pipe", "new"), HasSubstr("not a regular file"));
  EXPECT_THAT(failure(folder_ / "no/such", "new"), HasSubstr("No such file"));
  EXPECT_NE(failure("", "new"), "");
  EXPECT_THAT(names(), ElementsAre("folder", "pipe"));
}

TEST_P(StagedFileTest, ReplacesNothingThatIsToBeKept) {
  put(place_, "old");
  EXPECT_THAT(failure(place_, "new", Existing::Refuse), HasSubstr("File exists"));
  EXPECT_EQ(text_of(place_), "old");
  EXPECT_EQ(failure(folder_ / "other", "new", Existing::Refuse), "");
  EXPECT_THAT(names(), ElementsAre("other", "walk.mcpr"));
}

TEST_P(StagedFileTest, StaysInItsFolderWhenThatIsRenamed) {
  fs::create_directories(folder_ / "before");
  StagedFile file = staged(folder_ / "before/walk.mcpr", "new");
  fs::rename(folder_ / "before", folder_ / "after");
  file.commit();
  EXPECT_EQ(text_of(folder_ / "after/walk.mcpr"), "new");
}

TEST(StagedFile, KilledLeavesNothing) {
  const fs::path folder =
      fs::path(testing::TempDir()) / ("staged-killed-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const std::string said = test::in_own_process([&]() -> std::string {
    StagedFile file(folder / "walk.mcpr");
    file.write("half of i");
    if (!fs::is_empty(folder)) return test::kSkip;
    ::raise(SIGKILL);
    return "";
  });
  const bool left = !fs::is_empty(folder);
  fs::remove_all(folder);
  if (said == test::kSkip) GTEST_SKIP() << "this file system has no files without a name";
  EXPECT_EQ(said, "killed by 9");
  EXPECT_FALSE(left);
}

}  // namespace
}  // namespace mocapress
