// SPDX-License-Identifier: MIT
#include "core/base/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <ostream>

#include "core/base/error.h"
#include "tests/support/own_process.h"

namespace mocapress {
namespace {

class File : public testing::Test {
 protected:
  File() { std::filesystem::create_directories(folder_); }
  ~File() override { std::filesystem::remove_all(folder_); }
  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("mocapress-file-" + std::to_string(getpid()));
};

TEST_F(File, ReadsBackWhatWasWritten) {
  write_text(folder_ / "a.txt", "one\ntwo");
  EXPECT_EQ(read_text(folder_ / "a.txt"), "one\ntwo");
}

TEST_F(File, APipeIsRefusedAndNotWaitedFor) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  try {
    read_text(folder_ / "pipe");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), (folder_ / "pipe").string() + ": is a pipe or a device, not a file");
  }
  EXPECT_THROW(MappedFile file(folder_ / "pipe"), InputError);
  EXPECT_THROW(read_text("/dev/zero"), InputError);
  EXPECT_THROW(read_text(folder_), InputError);
}

TEST_F(File, NamesAGitLfsFileThatWasNotFetched) {
  const auto path = folder_ / "a.fbx";
  write_text(path, "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n");
  const std::string expected =
      path.string() + ": is a pointer of Git LFS, not the file itself: 'git lfs pull' fetches that";
  for (const bool as_text : {false, true}) try {
      if (as_text)
        read_text(path);
      else
        read_bytes(path);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), expected);
    }
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
  const auto entries = std::filesystem::directory_iterator(folder_);
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

TEST_F(File, AStreamWritesLongTextsWholeAndInNoLocale) {
  const std::string word(1000, 'w');
  write_stream(folder_ / "a.txt", [&](std::ostream& out) {
    for (int i = 0; i < 100; ++i) out << word;
    out << 1234.5;
  });
  const std::string text = read_text(folder_ / "a.txt");
  EXPECT_EQ(text.size(), 100'006u);
  EXPECT_TRUE(text.ends_with("w1234.5"));
}

TEST_F(File, AStreamThatFailsLeavesTheOldFile) {
  write_text(folder_ / "a.txt", "old");
  EXPECT_THROW(write_stream(folder_ / "a.txt",
                            [](std::ostream& out) {
                              out << "half";
                              throw InputError("clip.bvh", 0, 0, "is gone");
                            }),
               InputError);
  EXPECT_EQ(read_text(folder_ / "a.txt"), "old");
}

TEST_F(File, AStreamSaysWhatStoppedIt) {
  const std::string said = test::in_own_process([&]() -> std::string {
    if (!test::limit_file_size(1 << 10)) return test::kSkip;
    write_stream(folder_ / "a.txt", [&](std::ostream& out) {
      for (int i = 0; i < 1000; ++i) out << "line " << i << '\n';
    });
    return "";
  });
  if (said == test::kSkip) GTEST_SKIP() << "no limits can be set here";
  EXPECT_EQ(said, "threw: " + (folder_ / "a.txt").string() + ": cannot be written: File too large");
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(File, RefusesAMissingFileAndAFolderByName) {
  EXPECT_THROW(read_text(folder_ / "missing"), InputError);
  EXPECT_THROW(read_bytes(folder_), InputError);
}

}  // namespace
}  // namespace mocapress
