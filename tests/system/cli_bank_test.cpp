// SPDX-License-Identifier: MIT
// Runs `mocapress bank` as a process.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/bank/bank.h"
#include "core/base/file.h"
#include "tests/system/command.h"
#include "tests/system/running.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CliBank : public CommandLine {
 protected:
  /// Makes the folder `clips` with walk.mcpr and slow/walk.mcpr.
  void compress_two() {
    fs::create_directories(file("clips/slow"));
    const std::string clip = write("walk.bvh", test_bvh());
    ASSERT_EQ(mocapress({"compress", clip, "-o", file("clips/walk.mcpr")}).exit_code, 0);
    ASSERT_EQ(
        mocapress({"compress", clip, "--ratio", "5", "-o", file("clips/slow/walk.mcpr")}).exit_code,
        0);
  }

  /// Makes a folder with one clip under many names, enough to take seconds.
  void write_many(const std::string& folder, int count) {
    const std::string walk =
        std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/human_walk.amc";
    ASSERT_EQ(mocapress({"compress", walk, "-o", file("many.mcpr")}).exit_code, 0);
    fs::create_directories(file(folder));
    for (int i = 0; i < count; ++i)
      fs::create_hard_link(file("many.mcpr"), file(folder) / ("c" + std::to_string(i) + ".mcpr"));
  }

  /// The names of all files in a folder.
  std::set<std::string> names(const std::string& folder) const {
    std::set<std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(file(folder)))
      if (!entry.is_directory()) all.insert(entry.path().lexically_relative(file(folder)));
    return all;
  }

  /// Runs a bank command, and sends a signal once it reports clips.
  std::optional<int> stopped(std::vector<std::string> words, int signal) {
    words.insert(words.begin(), {MOCAPRESS_EXECUTABLE, "bank"});
    fs::remove(file("err"));  // removes earlier output
    Running running(words, "/dev/null", file("err"));
    const auto tells = [&] {
      return running.ended() || (fs::exists(file("err")) && fs::file_size(file("err")) > 0);
    };
    EXPECT_TRUE(comes_true(tells));
    running.send(signal);
    return running.wait();
  }
  std::string last_line_of_err() const {
    std::string text = read_text(file("err"));
    if (!text.empty()) text.pop_back();
    return text.substr(text.rfind('\n') + 1);
  }
};

TEST_F(CliBank, ExtractsClipsByteForByte) {
  compress_two();
  const Outcome made = mocapress(
      {"bank", "make", file("b.mcpk"), file("clips"), "--tag", "walk", "--meta", "by=us"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto list =
      nlohmann::json::parse(mocapress({"bank", "list", file("b.mcpk"), "--json"}).out);
  EXPECT_EQ(list["meta"]["by"], "us");
  ASSERT_EQ(list["clips"].size(), 2U);
  EXPECT_EQ(list["clips"][0]["name"], "slow/walk");
  EXPECT_EQ(list["clips"][1]["tags"][0], "walk");
  ASSERT_EQ(mocapress({"bank", "extract", file("b.mcpk"), "-o", file("out")}).exit_code, 0);
  for (const char* const name : {"walk.mcpr", "slow/walk.mcpr"})
    EXPECT_EQ(read_bytes(file("out/" + std::string(name))),
              read_bytes(file("clips/" + std::string(name))));
  EXPECT_EQ(mocapress({"bank", "verify", file("b.mcpk")}).exit_code, 0);
}

TEST_F(CliBank, ListsOneJsonDocument) {
  compress_two();
  ASSERT_EQ(mocapress({"bank", "make", file("b.mcpk"), file("clips"), "--tag", "a \"]\"", "--tag",
                       "b\nc", "--meta", "k=]}"})
                .exit_code,
            0);
  ASSERT_EQ(
      mocapress({"bank", "make", file("c.mcpk"), file("clips/walk.mcpr"), "--cooked"}).exit_code,
      0);
  for (const char* const bank : {"b.mcpk", "c.mcpk"}) {
    const std::string listed = mocapress({"bank", "list", file(bank), "--json"}).out;
    const auto json = nlohmann::ordered_json::parse(listed);
    EXPECT_EQ(json["clips"].size(), std::string(bank) == "b.mcpk" ? 2U : 1U);
    EXPECT_EQ(listed, json.dump(2) + '\n');
  }
}

TEST_F(CliBank, TellsWhichClipsHaveOneSkeleton) {
  compress_two();
  const std::string other = std::string(MOCAPRESS_SOURCE_DIR) + "/core/runtime/example/walk.mcpr";
  fs::copy_file(other, file("other.mcpr"));
  ASSERT_EQ(
      mocapress({"bank", "make", file("b.mcpk"), file("clips"), file("other.mcpr")}).exit_code, 0);
  ASSERT_EQ(mocapress({"bank", "make", file("c.mcpk"), file("b.mcpk"), "--cooked"}).exit_code, 0);
  std::vector<std::string> hashes;
  for (const char* const bank : {"b.mcpk", "c.mcpk"}) {
    const auto list = nlohmann::json::parse(mocapress({"bank", "list", file(bank), "--json"}).out);
    ASSERT_EQ(list["skeletons"].size(), 2U);
    EXPECT_EQ(list["skeletons"][0]["first_clip"], "other");
    EXPECT_EQ(list["skeletons"][0]["clips"], 1);
    EXPECT_EQ(list["skeletons"][1]["clips"], 2);
    EXPECT_EQ(list["clips"][0]["skeleton"], 0);
    EXPECT_EQ(list["clips"][1]["skeleton"], 1);
    EXPECT_EQ(list["clips"][2]["skeleton"], 1);
    for (const auto& skeleton : list["skeletons"])
      hashes.push_back(skeleton["hash"].get<std::string>());
  }
  EXPECT_EQ(hashes[0], hashes[2]);
  EXPECT_EQ(hashes[1], hashes[3]);
  EXPECT_NE(hashes[0], hashes[1]);
}

TEST_F(CliBank, ACookedBankIsMadeOfAPackedOne) {
  compress_two();
  ASSERT_EQ(mocapress({"bank", "make", file("b.mcpk"), file("clips")}).exit_code, 0);
  ASSERT_EQ(mocapress({"bank", "make", file("c.mcpk"), file("b.mcpk"), "--cooked"}).exit_code, 0);
  EXPECT_EQ(mocapress({"bank", "verify", file("c.mcpk")}).exit_code, 0);
  const Outcome refused = mocapress({"bank", "extract", file("c.mcpk"), "-o", file("out")});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("the bank is cooked"));
}

TEST_F(CliBank, SaysWhatIkCorrectionsTake) {
  const std::string walk = std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/human_walk.amc";
  const std::string clip = file("walk.mcpr");
  ASSERT_EQ(mocapress({"compress", walk, "--ik", "auto", "-o", clip}).exit_code, 0);
  const auto bytes_with = [&](const std::vector<std::string>& options, bool says) {
    std::vector<std::string> words = {"bank", "make", file("b.mcpk"), clip, "--cooked"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome made = mocapress(words);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(made.err.find("IK corrections take ") != std::string::npos, says) << made.err;
    return fs::file_size(file("b.mcpk"));
  };
  const std::uintmax_t none = bytes_with({"--no-ik"}, false);
  const std::uintmax_t usual = bytes_with({}, true);
  const std::uintmax_t exact = bytes_with({"--ik-error", "0"}, true);
  EXPECT_LT(none, usual);
  EXPECT_LT(usual, exact);
}

TEST_F(CliBank, SaysHowManyTiersAreLeft) {
  const std::string clip = write("walk.bvh", test_bvh());
  const std::string name = "h\xC3\xA9ros";
  ASSERT_EQ(mocapress({"compress", clip, "--tiers", "3", "-o", file(name + ".mcpr")}).exit_code, 0);
  ASSERT_EQ(mocapress({"bank", "make", file("b.mcpk"), file(name + ".mcpr")}).exit_code, 0);
  const Outcome stripped =
      mocapress({"bank", "strip", file("b.mcpk"), "--tiers", "2", "-o", file("s.mcpk")});
  EXPECT_EQ(stripped.exit_code, 0);
  EXPECT_THAT(stripped.err, HasSubstr("s.mcpk: 1 clip, "));
  const std::string text = mocapress({"bank", "list", file("s.mcpk")}).out;
  EXPECT_THAT(text, HasSubstr("tiers: 2 of 3\n"));
  EXPECT_EQ(text.find(" bytes"), 43U) << "columns are as wide as letters, not as bytes: " << text;
  const auto list =
      nlohmann::json::parse(mocapress({"bank", "list", file("s.mcpk"), "--json"}).out);
  EXPECT_EQ(list["tiers"], 3);
  EXPECT_EQ(list["tiers_present"], 2);
}

TEST_F(CliBank, RemovesClips) {
  compress_two();
  const std::string bank = file("b.mcpk");
  ASSERT_EQ(mocapress({"bank", "make", bank, file("clips")}).exit_code, 0);
  const Outcome none = mocapress({"bank", "remove", bank, "walk", "run"});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_EQ(none.err, "mocapress: " + bank + ": holds no clip 'run'\n");
  const Outcome removed = mocapress({"bank", "remove", bank, "walk"});
  EXPECT_EQ(removed.exit_code, 0);
  EXPECT_THAT(removed.err, HasSubstr(": 1 clip, "));
  EXPECT_THAT(mocapress({"bank", "list", bank}).out, testing::StartsWith("slow/walk "));
  EXPECT_EQ(mocapress({"bank", "verify", bank}).exit_code, 0);
}

TEST_F(CliBank, ShowsNamesThatATerminalWouldObey) {
  compress_two();
  const std::string bank = file("b.mcpk");
  make_bank(bank,
            {{"a\x1b[2Jb\xc2\x9b"
              "c\xc3\xa4",
              file("clips/walk.mcpr"),
              {}}},
            {.tags = {"t\nu"}});
  const Outcome listed = mocapress({"bank", "list", bank});
  EXPECT_THAT(listed.out, testing::StartsWith("a\\x1b[2Jb\\x9bc\xc3\xa4 "));
  EXPECT_THAT(listed.out, HasSubstr(" Hz, skeleton 0  t\\x0au\nskeleton 0: "));
  EXPECT_EQ(mocapress({"bank", "remove", bank, "\x1b[2J"}).err,
            "mocapress: " + bank + ": holds no clip '\\x1b[2J'\n");
}

TEST_F(CliBank, SaysWhatIsWrong) {
  compress_two();
  ASSERT_EQ(mocapress({"bank", "make", file("b.mcpk"), file("clips")}).exit_code, 0);
  EXPECT_EQ(mocapress({"bank", "extract", file("b.mcpk"), "run"}).exit_code, 3);
  EXPECT_EQ(mocapress({"bank", "make", file("b.mcpk"), file("clips"), "--meta", "x"}).exit_code, 2);
  for (const char* const wrong : {"-1", "nan", "inf", "1e39", "far"}) {
    const Outcome refused =
        mocapress({"bank", "make", file("b.mcpk"), file("clips"), "--cooked", "--ik-error", wrong});
    EXPECT_EQ(refused.exit_code, 2) << wrong;
    EXPECT_THAT(refused.err, HasSubstr("is not a distance in cm, 0 or more")) << wrong;
  }
  const Outcome packed = mocapress({"bank", "make", file("p.mcpk"), file("clips"), "--no-ik"});
  EXPECT_EQ(packed.exit_code, 2);
  EXPECT_THAT(packed.err, HasSubstr("is for a cooked bank"));
  const Outcome added =
      mocapress({"bank", "add", file("b.mcpk"), file("clips"), "--detail-bands", "2"});
  EXPECT_EQ(added.exit_code, 2);
  EXPECT_THAT(added.err, HasSubstr("b.mcpk is packed"));
  ASSERT_EQ(mocapress({"bank", "make", file("c.mcpk"), file("clips"), "--cooked"}).exit_code, 0);
  EXPECT_EQ(
      mocapress({"bank", "add", file("c.mcpk"), file("clips"), "--detail-bands", "2"}).exit_code,
      0);
  const Outcome twice = mocapress(
      {"bank", "make", file("b.mcpk"), file("clips/walk.mcpr"), file("clips/slow/walk.mcpr")});
  EXPECT_EQ(twice.exit_code, 3);
  EXPECT_THAT(twice.err, HasSubstr("would be the clip 'walk'"));
  EXPECT_EQ(mocapress({"bank", "list", file("clips/walk.mcpr")}).exit_code, 3);
  EXPECT_EQ(mocapress({"bank", "verify", file("b.mcpk")}).exit_code, 0);
}

class StoppedBank : public CliBank, public testing::WithParamInterface<int> {};

TEST_P(StoppedBank, IsAsItWas) {
  write_many("clips", 2000);
  fs::create_directories(file("out"));
  EXPECT_EQ(stopped({"make", file("out/b.mcpk"), file("clips")}, GetParam()), 128 + GetParam());
  EXPECT_THAT(last_line_of_err(), testing::MatchesRegex("Stopped after [0-9]+ of 2000 clips. "
                                                        "Nothing was written."));
  EXPECT_THAT(names("out"), testing::IsEmpty());
  ASSERT_EQ(mocapress({"bank", "make", file("out/b.mcpk"), file("many.mcpr")}).exit_code, 0);
  const auto before = read_bytes(file("out/b.mcpk"));
  EXPECT_EQ(stopped({"add", file("out/b.mcpk"), file("clips")}, GetParam()), 128 + GetParam());
  EXPECT_THAT(last_line_of_err(), HasSubstr(" of 2001 clips. Nothing was written."));
  EXPECT_EQ(read_bytes(file("out/b.mcpk")), before);
  EXPECT_EQ(names("out").size(), 1U);
}

TEST_P(StoppedBank, WritesWholeFilesUntilThen) {
  write_many("clips", 1000);
  const std::string bank = file("b.mcpk");
  ASSERT_EQ(mocapress({"bank", "make", bank, file("clips")}).exit_code, 0);
  fs::create_directories(file("out"));
  EXPECT_EQ(stopped({"extract", bank, "-o", file("out")}, GetParam()), 128 + GetParam());
  EXPECT_THAT(last_line_of_err(),
              testing::MatchesRegex("Stopped. [0-9]+ of 1000 clips are written, each whole. .*"));
  const auto one = read_bytes(file("many.mcpr"));
  for (const std::string& name : names("out"))
    EXPECT_EQ(read_bytes(file("out") / name), one) << name;
  EXPECT_LT(names("out").size(), 1000U);
  EXPECT_EQ(mocapress({"bank", "extract", bank, "-o", file("out"), "--overwrite"}).exit_code, 0);
  EXPECT_EQ(names("out"), names("clips"));
  EXPECT_EQ(stopped({"verify", bank}, GetParam()), 128 + GetParam());
  EXPECT_THAT(last_line_of_err(), testing::MatchesRegex("Stopped after [0-9]+ of 1000 clips."));
}

INSTANTIATE_TEST_SUITE_P(Signals, StoppedBank, testing::Values(SIGINT, SIGTERM));

TEST_F(CliBank, ExtractingOverwritesNothingUnasked) {
  compress_two();
  ASSERT_EQ(mocapress({"bank", "make", file("b.mcpk"), file("clips")}).exit_code, 0);
  fs::create_directories(file("out"));
  write("out/walk.mcpr", "mine");
  const Outcome refused = mocapress({"bank", "extract", file("b.mcpk"), "-o", file("out")});
  EXPECT_EQ(refused.exit_code, 5);
  EXPECT_EQ(refused.err,
            "mocapress: " + file("out/walk.mcpr").string() + " exists: not overwritten\n");
  EXPECT_EQ(names("out"), std::set<std::string>{"walk.mcpr"});
  EXPECT_EQ(read_text(file("out/walk.mcpr")), "mine");
  ASSERT_EQ(
      mocapress({"bank", "extract", file("b.mcpk"), "-o", file("out"), "--overwrite"}).exit_code,
      0);
  EXPECT_EQ(read_bytes(file("out/walk.mcpr")), read_bytes(file("clips/walk.mcpr")));
}

TEST_F(CliBank, ClipsStayInTheFolderWhateverTheirNames) {
  compress_two();
  const fs::path clip = file("clips/walk.mcpr");
  const auto extracted = [&](const std::vector<std::string>& names) {
    std::vector<BankSource> sources;
    for (const std::string& name : names) sources.push_back({name, clip, {}});
    make_bank(file("odd.mcpk"), sources, {});
    fs::remove_all(file("in"));
    fs::create_directories(file("in/out"));
    return mocapress({"bank", "extract", file("odd.mcpk"), "-o", file("in/out")});
  };
  for (const std::string name : {"../up", "a/../../up", "/tmp/mocapress-odd", "..//up"}) {
    const Outcome refused = extracted({name, "walk"});
    EXPECT_EQ(refused.exit_code, 3) << name;
    EXPECT_EQ(refused.err, "mocapress: " + file("odd.mcpk").string() + ": the clip '" + name +
                               "' leaves the folder\n");
    EXPECT_THAT(names("in"), testing::IsEmpty());
  }
  const Outcome same = extracted({"a/../walk", "walk"});
  EXPECT_EQ(same.exit_code, 3);
  EXPECT_THAT(same.err, HasSubstr("would take another's place"));
  EXPECT_THAT(names("in"), testing::IsEmpty());
  EXPECT_EQ(extracted({"A/Walk", "a/walk", "a//b", "..", "."}).exit_code, 0);
  EXPECT_THAT(names("in/out"),
              testing::ElementsAre("...mcpr", "..mcpr", "A/Walk.mcpr", "a/b.mcpr", "a/walk.mcpr"));
}

TEST_F(CliBank, MakingABankNeverOverwritesAnInput) {
  compress_two();
  const std::string clip = file("clips/walk.mcpr");
  const auto before = read_bytes(clip);
  const Outcome slip = mocapress({"bank", "make", clip, file("clips/slow/walk.mcpr")});
  EXPECT_EQ(slip.exit_code, 5);
  EXPECT_EQ(slip.err, "mocapress: " + clip + ": is there and is no bank: not overwritten\n");
  EXPECT_EQ(read_bytes(clip), before);
  const std::string bank = file("b.mcpk");
  ASSERT_EQ(mocapress({"bank", "make", bank, file("clips"), "--meta", "by=us"}).exit_code, 0);
  const auto packed = read_bytes(bank);
  const Outcome onto_itself = mocapress({"bank", "make", bank, bank, "--cooked"});
  EXPECT_EQ(onto_itself.exit_code, 5);
  EXPECT_EQ(onto_itself.err, "mocapress: " + bank + ": is one of the inputs: not overwritten\n");
  EXPECT_EQ(read_bytes(bank), packed);
  EXPECT_EQ(mocapress({"bank", "add", bank, bank}).exit_code, 0);
  EXPECT_EQ(read_bytes(bank), packed);
  write("clips/broken.mcpr", "no clip");
  const Outcome broken = mocapress({"bank", "add", bank, file("clips")});
  EXPECT_EQ(broken.exit_code, 3);
  EXPECT_THAT(broken.err, HasSubstr("broken.mcpr"));
  EXPECT_EQ(read_bytes(bank), packed);
}

}  // namespace
}  // namespace mocapress::test
