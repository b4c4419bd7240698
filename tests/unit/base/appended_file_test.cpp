// SPDX-License-Identifier: MIT
#include "core/base/appended_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

#include "core/base/open_file.h"
#include "tests/support/own_process.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A lock as on a network folder without locks.
int no_locks(int) {
  errno = ENOLCK;
  return -1;
}

/// A file that is replaced by another process just before it is locked.
fs::path replaced_once;
int replaced_before(int file) {
  if (const fs::path place = std::exchange(replaced_once, {}); !place.empty()) {
    std::ofstream(place.string() + "2") << "theirs\n";
    fs::rename(place.string() + "2", place);
  }
  return lock_now(file);
}

class AppendedFileTest : public testing::Test {
 protected:
  AppendedFileTest() { fs::create_directories(folder_); }
  ~AppendedFileTest() override { fs::remove_all(folder_); }

  std::string text() const {
    std::ostringstream all;
    all << std::ifstream(path_, std::ios::binary).rdbuf();
    return all.str();
  }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_))
      all.push_back(entry.path().filename());
    return all;
  }

  static std::string failure(const std::function<void()>& work) {
    try {
      work();
      return "";
    } catch (const WriteError& error) {
      return error.what();
    }
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("appended-" + std::to_string(getpid()));
  const fs::path path_ = folder_ / "rows.jsonl";
};

TEST_F(AppendedFileTest, GrowsByLinesAndGoesOnAfterThem) {
  {
    AppendedFile file(path_);
    file.append("one");
    file.append("two");
    EXPECT_EQ(file.size(), 8u);
    EXPECT_EQ(file.read(4, 3), "two");
    EXPECT_EQ(file.read(4, 100), "two\n");
    EXPECT_FALSE(file.warning());
  }
  AppendedFile(path_).append("three");
  EXPECT_EQ(text(), "one\ntwo\nthree\n");
}

TEST_F(AppendedFileTest, IsOpenOnceAtATime) {
  {
    AppendedFile file(path_);
    file.append("one");
    EXPECT_THAT(failure([&] { AppendedFile other(path_); }),
                HasSubstr("rows.jsonl: another run is using it"));
    file.replace([](StagedFile& contents) { contents.write("1\n"); });
    EXPECT_THAT(failure([&] { AppendedFile other(path_); }), HasSubstr("using it")) << "still";
    file.append("two");
  }
  EXPECT_EQ(AppendedFile(path_).size(), 6u);
  EXPECT_EQ(text(), "1\ntwo\n");
}

TEST_F(AppendedFileTest, WithoutLocksSaysSoAndWorks) {
  AppendedFile file(path_, &no_locks);
  ASSERT_TRUE(file.warning());
  EXPECT_THAT(file.warning()->text(), HasSubstr("rows.jsonl: cannot be locked (No locks"));
  file.append("one");
  file.replace([](StagedFile& contents) { contents.write("1\n"); });
  file.append("two");
  EXPECT_EQ(text(), "1\ntwo\n");
}

TEST_F(AppendedFileTest, AppendsToTheFileThatIsThereWhenItIsLocked) {
  std::ofstream(path_) << "old\n";
  replaced_once = path_;
  AppendedFile(path_, &replaced_before).append("ours");
  EXPECT_EQ(text(), "theirs\nours\n");
}

TEST_F(AppendedFileTest, TakesOutALineThatDidNotFit) {
  const std::string said = test::in_own_process([&]() -> std::string {
    if (!test::limit_file_size(1000)) return test::kSkip;
    AppendedFile file(path_);
    file.append("one");
    const std::string why = failure([&] { file.append(std::string(5000, 'x')); });
    file.append("two");
    return why;
  });
  if (said == test::kSkip) GTEST_SKIP() << "no limits can be set here";
  EXPECT_EQ(said, path_.string() + ": cannot be written: File too large");
  EXPECT_EQ(text(), "one\ntwo\n");
}

TEST_F(AppendedFileTest, TakesOutALineThatAFullDiskCutOff) {
  const std::string said = test::in_own_process([&]() -> std::string {
    if (!test::mount_small_disk(folder_, 64 << 10)) return test::kSkip;
    AppendedFile file(path_);
    file.append("one");
    const std::string why = failure([&] { file.append(std::string(1 << 20, 'x')); });
    if (why.find("No space left") == why.npos) return "said: " + why;
    file.append("two");
    return text();
  });
  if (said == test::kSkip) GTEST_SKIP() << "nothing can be mounted here";
  EXPECT_EQ(said, "one\ntwo\n");
}

TEST_F(AppendedFileTest, LeavesNoEmptyFileOfItsOwn) {
  { const AppendedFile file(path_); }
  EXPECT_THAT(names(), IsEmpty());
  std::ofstream(path_).close();
  { const AppendedFile file(path_); }
  EXPECT_THAT(names(), ElementsAre("rows.jsonl")) << "somebody else's";
}

TEST_F(AppendedFileTest, AFailedReplaceLeavesTheFileUnchanged) {
  AppendedFile file(path_);
  file.append("one");
  EXPECT_THROW(file.replace([](StagedFile& contents) {
    contents.write("half");
    throw InputError("clip.bvh", 0, 0, "is gone");
  }),
               InputError);
  file.append("two");
  EXPECT_EQ(text(), "one\ntwo\n");
  EXPECT_THAT(names(), ElementsAre("rows.jsonl"));
}

TEST_F(AppendedFileTest, FollowsALinkOfTheUsers) {
  fs::create_symlink("real.jsonl", path_);
  {
    AppendedFile file(path_);
    file.append("one");
    file.replace([](StagedFile& contents) { contents.write("1\n"); });
  }
  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder_ / "real.jsonl")));
  EXPECT_EQ(text(), "1\n");
}

TEST_F(AppendedFileTest, RefusesWhatIsNoFile) {
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  EXPECT_THAT(failure([&] { AppendedFile file(path_); }), HasSubstr("not a regular file"));
  EXPECT_THAT(failure([&] { AppendedFile file(folder_); }), HasSubstr("not a regular file"));
  EXPECT_THAT(failure([&] { AppendedFile file(folder_ / "no/such"); }), HasSubstr("No such file"));
}

}  // namespace
}  // namespace mocapress
