// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/formats/csv.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(CsvTracks, AreOneAColumnAndWholeNumbersStep) {
  const ScalarTracks tracks = read_csv_tracks(
      "t.csv", "\xEF\xBB\xBFtime_s, ik blend ,step\r\n0,0.25,0\r\n\r\n0.5,1e-1,1\r\n1,-2,0", 3);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0], (ScalarTrack{.node = "", .name = "ik blend", .values = {0.25F, 0.1F, -2}}));
  EXPECT_EQ(tracks[1],
            (ScalarTrack{.node = "", .name = "step", .steps = true, .values = {0, 1, 0}}));
}

TEST(CsvTracks, ComeBackFromWhatIsWritten) {
  Motion still;
  still.clip.sample_rate_hz = 4;
  still.clip.channels.resize(3, 0);
  const ScalarTracks tracks = {{.node = "", .name = "heat", .values = {0.5F, 0.25F, 7.125F}}};
  EXPECT_EQ(read_csv_tracks("t.csv", csv_text(still, tracks), 3), tracks);
}

TEST(CsvTracks, SayWhereTheyAreWrong) {
  const auto message = [](std::string_view text) -> std::string {
    try {
      read_csv_tracks("t.csv", text, 2);
    } catch (const InputError& error) {
      return error.what();
    }
    return "was read";
  };
  EXPECT_EQ(message("a,b\n1,2\n3,4\n"), "was read");
  EXPECT_EQ(message(" \n"), "t.csv:1:1: has no line of names");
  EXPECT_EQ(message("a,,b\n"), "t.csv:1:3: a column needs a name of 1 to 255 bytes");
  EXPECT_EQ(message("a, a\n"), "t.csv:1:4: two columns are called 'a'");
  EXPECT_EQ(message("\"a\"\n"), "t.csv:1:1: a name of a column has no quotes");
  EXPECT_EQ(message("a,b\n1, x\n"), "t.csv:2:4: expected a number, found 'x'");
  EXPECT_EQ(message("a,b\n1,nan\n"), "t.csv:2:3: expected a number, found 'nan'");
  EXPECT_EQ(message("a,b\n1,1e39\n"), "t.csv:2:3: expected a number, found '1e39'");
  EXPECT_EQ(message("a,b\n1,\n"), "t.csv:2:3: expected a number, found nothing");
  EXPECT_EQ(message("a,b\n1\n"), "t.csv:2:1: has 1 value for 2 columns");
  EXPECT_EQ(message("a\n1\n"), "t.csv:2:1: ends after values of 1 frame, the clip has 2");
  EXPECT_EQ(message("a\n1\n2\n3\n"), "t.csv:4:1: is one more than the clip's 2 frames");
}

}  // namespace
}  // namespace mocapress
