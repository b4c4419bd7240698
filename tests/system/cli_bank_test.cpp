// SPDX-License-Identifier: MIT
// `mocapress bank` from outside.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "tests/system/command.h"
#include "tests/system/sample_clips.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CliBank : public CommandLine {
 protected:
  /// Makes the folder `clips` of walk.mcpr and slow/walk.mcpr.
  void compress_two() {
    fs::create_directories(file("clips/slow"));
    const std::string clip = write("walk.bvh", test_bvh());
    ASSERT_EQ(mocapress({"compress", clip, "-o", file("clips/walk.mcpr")}).exit_code, 0);
    ASSERT_EQ(
        mocapress({"compress", clip, "--ratio", "5", "-o", file("clips/slow/walk.mcpr")}).exit_code,
        0);
  }
};

TEST_F(CliBank, WhatWasPutInComesOutByteForByte) {
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

TEST_F(CliBank, ACookedBankIsMadeOfAPackedOne) {
  compress_two();
  ASSERT_EQ(mocapress({"bank", "make", file("b.mcpk"), file("clips")}).exit_code, 0);
  ASSERT_EQ(mocapress({"bank", "make", file("c.mcpk"), file("b.mcpk"), "--cooked"}).exit_code, 0);
  EXPECT_EQ(mocapress({"bank", "verify", file("c.mcpk")}).exit_code, 0);
  const Outcome refused = mocapress({"bank", "extract", file("c.mcpk"), "-o", file("out")});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("the bank is cooked"));
}

TEST_F(CliBank, SaysWhatIsWrong) {
  compress_two();
  ASSERT_EQ(mocapress({"bank", "make", file("b.mcpk"), file("clips")}).exit_code, 0);
  EXPECT_EQ(mocapress({"bank", "extract", file("b.mcpk"), "run"}).exit_code, 3);
  EXPECT_EQ(mocapress({"bank", "make", file("b.mcpk"), file("clips"), "--meta", "x"}).exit_code, 2);
  const Outcome twice = mocapress(
      {"bank", "make", file("b.mcpk"), file("clips/walk.mcpr"), file("clips/slow/walk.mcpr")});
  EXPECT_EQ(twice.exit_code, 3);
  EXPECT_THAT(twice.err, HasSubstr("would be the clip 'walk'"));
  EXPECT_EQ(mocapress({"bank", "list", file("clips/walk.mcpr")}).exit_code, 3);
  EXPECT_EQ(mocapress({"bank", "verify", file("b.mcpk")}).exit_code, 0);
}

}  // namespace
}  // namespace mocapress::test
