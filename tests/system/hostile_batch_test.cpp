// SPDX-License-Identifier: MIT
// A batch over malicious files, with good clips between them.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/formats/clip_files.h"
#include "tests/support/corpus.h"
#include "tests/system/command.h"
#include "tests/system/sample_clips.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;

class HostileBatch : public CommandLine {};

/// Seconds allowed for one file: of the clock in a batch, of a processor alone. Ten, plus a third
/// for other work on the machine; debug and instrumented builds get more.
constexpr const char* kMostSeconds = MOCAPRESS_MOST_SECONDS;

/// Runs the program with 2 GiB of memory by prlimit(1). Sanitizers map far more than they use.
std::vector<std::string> in_two_gigabytes(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"prlimit", "--core=0"};
#ifndef MOCAPRESS_INSTRUMENTED
  words.emplace_back("--as=2147483648");
#endif
  words.emplace_back(MOCAPRESS_EXECUTABLE);
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

/// Expects one short sentence, not counting the folders in the file's path.
bool is_one_sentence(const std::string& error) {
  const std::size_t slash = error.rfind('/');
  const std::string said = error.substr(slash == error.npos ? 0 : slash + 1);
  return !said.empty() && said.size() <= 200 && error.find('\n') == error.npos;
}

TEST_F(HostileBatch, DoesEveryGoodClipAndRefusesTheOthersInOneSentence) {
  const auto corpus = test::corpus();
  if (!corpus || !fs::exists(*corpus / "attack")) GTEST_SKIP() << "the corpus is not here";
  write_sample_clips(file("in"), 6);
  std::size_t clips = 6;
  for (const char* kind : {"attack", "fbx_fuzz", "odd"})
    for (const auto& entry : fs::directory_iterator(*corpus / kind)) {
      if (!is_clip(entry.path()) && entry.path().extension() != ".asf") continue;
      fs::copy_file(entry.path(), file("in") / entry.path().filename());
      clips += is_clip(entry.path());
    }
  const Outcome outcome =
      run_program(in_two_gigabytes({"batch", file("in").string(), "-o", file("out").string(),
                                    "--jobs", "1", "--clip-timeout", kMostSeconds}));
  EXPECT_EQ(outcome.exit_code, 7) << outcome.err;
  EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos);
  const auto rows = nlohmann::json::parse(read_text(file("out") / "report.json"));
  ASSERT_EQ(rows.size(), clips);
  std::size_t good = 0;
  for (const auto& row : rows) {
    const std::string name = fs::path(row["input"].get<std::string>()).filename();
    if (name.starts_with("clip_")) {
      EXPECT_TRUE(row["done"]) << name << row["error"];
      ++good;
    }
    EXPECT_TRUE(row["done"] || is_one_sentence(row["error"])) << row["error"];
  }
  EXPECT_EQ(good, 6U);
}

/// Runs each file alone, since a batch does not report times of single clips.
TEST_F(HostileBatch, NoneTakesLongOrMoreThanTwoGigabytes) {
  const auto corpus = test::corpus();
  if (!corpus || !fs::exists(*corpus / "attack")) GTEST_SKIP() << "the corpus is not here";
  for (const auto& entry : fs::directory_iterator(*corpus / "attack")) {
    const fs::path& path = entry.path();
    const bool is_mcpr = path.extension() == ".mcpr";
    std::vector<std::string> words =
        is_mcpr ? in_two_gigabytes({"decompress", path, "-o", file("out.bvh")})
                : in_two_gigabytes({"compress", path, "-o", file("out.mcpr")});
    words.insert(words.begin() + 1, std::string("--cpu=") + kMostSeconds);
    const Outcome outcome = run_program(words);
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3 || outcome.exit_code == 4)
        << path << ": " << outcome.exit_code << outcome.err;
    EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos) << path;
  }
}

}  // namespace
}  // namespace mocapress::test
