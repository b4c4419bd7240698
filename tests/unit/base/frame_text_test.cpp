// SPDX-License-Identifier: MIT
#include "core/base/frame_text.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/utf8_path.h"
#include "core/batch/report.h"
#include "core/codec/encode/options/important_range.h"
#include "core/metrics/visibility.h"
#include "core/report/clip_link.h"
#include "core/report/sign_off.h"
#include "core/report/verdict.h"

namespace mocapress::frame_text_test {
namespace {

using testing::HasSubstr;

const FrameNote kNote{.frame = 0, .joint = "lfoot", .text = "slides"};

TEST(FrameText, TheFirstFrameIsOneForPeople) {
  Skeleton skeleton;
  skeleton.add({.name = "root"});
  EXPECT_THAT(reason({.frame = 0, .value = 2}, skeleton), HasSubstr("at frame 1:"));
  EXPECT_THAT(note_text(kNote), HasSubstr("frame 1, lfoot"));
  EXPECT_THAT(note_text({.frame = 0, .last_frame = 11, .text = "slides"}),
              HasSubstr("frames 1\u201312: slides"));
  EXPECT_EQ(frame_text(std::numeric_limits<int>::max()), "2147483648");
  try {
    frame_factors({{0, 9, 2}}, 5);
    FAIL() << "the clip has no tenth frame";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("frames 1 to 10 are not a range of the clip"));
  }
}

TEST(FrameText, PagesSayOneAndLinkToZero) {
  const auto is_first = HasSubstr("frame=0&amp;joint=lfoot\">1, 0.00 s<");
  const std::string path =
      utf8(std::filesystem::absolute("/m/walk.bvh"));  // on Windows with a drive
  SignOffClip clip{.path = path, .sample_rate_hz = 30, .review = {.notes = {kNote}}};
  SignOff sign_off;
  sign_off.clips = {clip};
  EXPECT_THAT(sign_off_html(sign_off), is_first);

  BatchRow row{.input = path, .output = "walk"};
  row.measured = Measurement{};
  row.review.notes = {kNote};
  std::ostringstream page;
  write_batch_html(page, [&](const auto& visit) { visit(row); }, 0, {}, {});
  EXPECT_THAT(page.str(), HasSubstr("frame=0&amp;joint=lfoot\">1<"));
}

TEST(FrameText, ProgramsCountFromZero) {
  EXPECT_EQ(to_json({kNote})[0]["frame"], 0);
  EXPECT_THAT(link_text({.clip = "/m/walk.bvh", .frame = 0}), HasSubstr("frame=0"));
}

/// Nobody writes a frame's number beside frame_text().
TEST(FrameText, IsWhatEveryTextUses) {
  const std::filesystem::path root = utf8_path(MOCAPRESS_SOURCE_DIR);
  const std::regex bare(
      R"re(\bframes? ("\s*(\+|<<)\s*(std::to_string|[\w.]*frame\b(?!_text))|%\d*[du]))re");
  for (const char* room : {"core", "app/cli"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / room)) {
      const std::string path = generic_utf8(entry.path());
      if (entry.path().extension() != ".cpp" || path.find("/bindings/") != path.npos)
        continue;  // Python counts from 0
      EXPECT_FALSE(std::regex_search(read_text(entry.path()), bare)) << path;
    }
}

}  // namespace
}  // namespace mocapress::frame_text_test
