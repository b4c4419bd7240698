// SPDX-License-Identifier: MIT
#include "core/base/line_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

class LineReaderTest : public testing::Test {
 protected:
  ~LineReaderTest() override { fs::remove(path_); }

  static std::vector<std::string> lines(LineReader& reader) {
    std::vector<std::string> all;
    for (std::string line; reader.next(line);) all.push_back(line);
    return all;
  }

  const fs::path path_ =
      fs::path(testing::TempDir()) / ("line-reader-" + std::to_string(getpid()) + ".txt");
};

TEST_F(LineReaderTest, GivesEveryLineAndItsPlace) {
  const std::string longer(200'000, 'x');  // longer than a piece of the file
  write_text(path_, "one\n\n" + longer + "\nlast");
  LineReader reader(path_);
  std::string line;
  ASSERT_TRUE(reader.next(line));
  EXPECT_EQ(line, "one");
  EXPECT_EQ(reader.offset(), 0u);
  ASSERT_TRUE(reader.next(line));
  EXPECT_EQ(line, "");
  EXPECT_EQ(reader.offset(), 4u);
  ASSERT_TRUE(reader.next(line));
  EXPECT_EQ(line, longer);
  EXPECT_EQ(reader.offset(), 5u);
  EXPECT_EQ(reader.read(0, 3), "one");
  ASSERT_TRUE(reader.next(line)) << "reading elsewhere changes nothing";
  EXPECT_EQ(line, "last");
  EXPECT_EQ(reader.offset(), 200'006u);
  EXPECT_FALSE(reader.next(line));
}

TEST_F(LineReaderTest, AnEmptyFileHasNoLine) {
  write_text(path_, "");
  LineReader reader(path_);
  EXPECT_TRUE(lines(reader).empty());
}

TEST_F(LineReaderTest, AReadErrorIsNotTheEnd) {
  LineReader unreadable("/proc/self/mem");  // opens, but its first page cannot be read
  std::string line;
  EXPECT_THROW(unreadable.next(line), InputError);
  EXPECT_THROW(LineReader(path_.string() + "-none"), InputError);
}

TEST_F(LineReaderTest, AFileThatEndsBeforeIsAnError) {
  write_text(path_, "one\n");
  EXPECT_THROW(LineReader(path_).read(2, 3), InputError);
}

}  // namespace
}  // namespace mocapress
