// SPDX-License-Identifier: MIT
#include "core/batch/shared_characters.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "core/base/error.h"

namespace mocapress::shared_characters_test {
namespace {

namespace fs = std::filesystem;

class CharactersOfABatch : public testing::Test {
 protected:
  CharactersOfABatch() {
    fs::copy_file(fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.fbx", file_,
                  fs::copy_options::overwrite_existing);
  }
  ~CharactersOfABatch() override { fs::remove(file_); }

  const fs::path file_ =
      fs::path(testing::TempDir()) / ("shared-character-" + std::to_string(getpid()) + ".fbx");
  SharedCharacters characters_;
};

TEST_F(CharactersOfABatch, AreParsedOnce) {
  const auto first = characters_.read(file_);
  EXPECT_NE(first->skin, nullptr);
  EXPECT_EQ(characters_.read(file_), first);
}

TEST_F(CharactersOfABatch, AreParsedAgainWhereTheFileIsWrittenAnew) {
  const auto first = characters_.read(file_);
  fs::last_write_time(file_, fs::last_write_time(file_) + std::chrono::seconds(1));
  EXPECT_NE(characters_.read(file_), first);
}

TEST_F(CharactersOfABatch, AreKeptByFile) {
  const auto first = characters_.read(file_);
  EXPECT_NE(characters_.read(fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.fbx"),
            first);
  EXPECT_EQ(characters_.read(file_), first);
}

TEST_F(CharactersOfABatch, AMissingFileIsReportedForEachClip) {
  fs::remove(file_);
  EXPECT_THROW(characters_.read(file_), InputError);
  EXPECT_THROW(characters_.read(file_), InputError);
}

}  // namespace
}  // namespace mocapress::shared_characters_test
