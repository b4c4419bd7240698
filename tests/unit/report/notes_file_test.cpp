// SPDX-License-Identifier: MIT
#include "core/report/notes_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress::test {
namespace {

const FrameNote kSlides{.frame = 12,
                        .last_frame = 40,
                        .joint = "lfoot",
                        .text = "slides \"here\"",
                        .reviewer = "ana",
                        .time = "2026-11-28T10:00:00Z",
                        .place_cm = std::array{1.5, 0.0, -20.25},
                        .source_hash = "aa",
                        .settings_hash = "bb"};

class NotesFile : public testing::Test {
 protected:
  NotesFile() { std::filesystem::create_directories(folder_); }
  ~NotesFile() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("notes-" + std::to_string(getpid()));
};

TEST_F(NotesFile, IsBesideTheClipAndReadsBack) {
  const auto clip = folder_ / "walk.bvh";
  EXPECT_EQ(notes_file_of(clip), folder_ / "walk.notes.json");
  EXPECT_TRUE(read_notes(clip).empty());
  const NotesByTake notes{{"Run", {kSlides, {.frame = 40, .text = "pops"}}}, {"Idle", {}}};
  write_notes(clip, notes);
  EXPECT_EQ(read_notes(clip), (NotesByTake{{"Run", notes.at("Run")}}));
  write_notes(clip, {});
  EXPECT_TRUE(read_notes(clip).empty());
  EXPECT_FALSE(std::filesystem::exists(notes_file_of(clip)));
}

TEST_F(NotesFile, KeepsThoseOfAClipInAnotherFormat) {
  write_notes(folder_ / "walk.bvh", {{"", {kSlides}}});
  EXPECT_TRUE(read_notes(folder_ / "walk.fbx").empty());
  EXPECT_THROW(write_notes(folder_ / "walk.fbx", {}), WriteError);
  EXPECT_EQ(read_notes(folder_ / "walk.bvh").at(""), std::vector{kSlides});
}

TEST_F(NotesFile, RefusesOtherFilesWithTheirName) {
  const auto clip = folder_ / "walk.bvh";
  for (const char* text :
       {"[]", "{", "{\"format\":7}", "{\"format\":\"mocapress-notes\",\"version\":9}",
        "{\"format\":\"mocapress-notes\",\"clip\":7,\"takes\":{}}",
        "{\"format\":\"mocapress-notes\",\"version\":\"x\",\"takes\":{}}",
        "{\"format\":\"mocapress-notes\",\"version\":1}",
        "{\"format\":\"mocapress-notes\",\"takes\":{\"\":[{\"frame\":\"x\"}]}}"}) {
    write_text(notes_file_of(clip), text);
    try {
      read_notes(clip);
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("walk.notes.json"), std::string::npos);
    }
  }
}

TEST_F(NotesFile, HasARangeOnlyWhereItEndsAfterItsFrame) {
  const auto clip = folder_ / "walk.bvh";
  write_text(notes_file_of(clip),
             "{\"format\":\"mocapress-notes\",\"takes\":{\"\":["
             "{\"frame\":1,\"last_frame\":1e300,\"text\":\"a\"},"
             "{\"frame\":2,\"last_frame\":2,\"text\":\"b\"},"
             "{\"frame\":3,\"last_frame\":null,\"text\":\"c\"},{\"frame\":4,\"text\":\"d\"}]}}");
  const std::vector<FrameNote> notes = read_notes(clip).at("");
  ASSERT_EQ(notes.size(), 4u);
  EXPECT_EQ(notes[0].last_frame, 1'000'000'000);
  for (int i = 1; i < 4; ++i) EXPECT_FALSE(notes[i].last_frame) << i;
}

TEST_F(NotesFile, LeavesOutNotesWithoutAFrameOrText) {
  const auto clip = folder_ / "walk.bvh";
  write_text(notes_file_of(clip),
             "{\"format\":\"mocapress-notes\",\"takes\":{\"\":[{\"frame\":9,\"text\":\"b\"},"
             "{\"frame\":-1,\"text\":\"a\"},{\"frame\":2},{\"frame\":3,\"text\":\"a\"}]}}");
  const std::vector<FrameNote> notes = read_notes(clip).at("");
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[0].frame, 3);
  EXPECT_EQ(notes[1].frame, 9);
}

}  // namespace
}  // namespace mocapress::test
