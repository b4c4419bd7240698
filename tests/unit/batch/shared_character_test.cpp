// SPDX-License-Identifier: MIT
#include "core/batch/shared_character.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "core/base/error.h"

namespace mocapress::shared_character_test {
namespace {

namespace fs = std::filesystem;

class SharedCharacterOfAFile : public testing::Test {
 protected:
  SharedCharacterOfAFile() {
    fs::copy_file(fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.fbx", file_,
                  fs::copy_options::overwrite_existing);
  }
  ~SharedCharacterOfAFile() override { fs::remove(file_); }

  const fs::path file_ =
      fs::path(testing::TempDir()) / ("shared-character-" + std::to_string(getpid()) + ".fbx");
  SharedCharacter character_;
};

TEST_F(SharedCharacterOfAFile, IsParsedOnce) {
  const auto first = character_.read(file_);
  EXPECT_NE(first->skin, nullptr);
  EXPECT_EQ(character_.read(file_), first);
}

TEST_F(SharedCharacterOfAFile, IsParsedAgainWhereTheFileIsWrittenAnew) {
  const auto first = character_.read(file_);
  fs::last_write_time(file_, fs::last_write_time(file_) + std::chrono::seconds(1));
  EXPECT_NE(character_.read(file_), first);
}

TEST_F(SharedCharacterOfAFile, IsNotThatOfAnotherFile) {
  const auto first = character_.read(file_);
  EXPECT_NE(character_.read(fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.fbx"),
            first);
}

TEST_F(SharedCharacterOfAFile, IsMissedAtEachClip) {
  fs::remove(file_);
  EXPECT_THROW(character_.read(file_), InputError);
  EXPECT_THROW(character_.read(file_), InputError);
}

}  // namespace
}  // namespace mocapress::shared_character_test
