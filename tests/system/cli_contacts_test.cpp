// SPDX-License-Identifier: MIT
// Contacts of the feet as the command line finds, writes and reads them.
#include <gmock/gmock.h>

#include "core/base/file.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

using nlohmann::json;

class CliContacts : public CommandLine {
 protected:
  const std::string samples_ = std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/";
  const std::string packed_ = file("walk.mcpr");
};

TEST_F(CliContacts, AreDataThatCanBeEditedAndTakenBack) {
  const std::string walk = samples_ + "human_walk.amc";
  const std::string edited = file("contacts.json");
  const json found = json_of({"contacts", walk, "-o", edited, "--json"});
  ASSERT_GT(found.size(), 2u);
  EXPECT_EQ(json::parse(read_text(edited)), found);
  EXPECT_NE(json_of({"contacts", walk, "--contact-speed", "1,2", "--json"}), found);

  const auto footskate = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command = {"compress", walk, "--method", "standard", "--ratio",
                                        "60",       "-o", packed_,    "--json"};
    command.insert(command.end(), more.begin(), more.end());
    return json_of(command)["footskate_cm"].get<double>();
  };
  EXPECT_EQ(footskate({"--contacts", edited}), footskate({}));
  const json findings = json_of({"contacts", walk, packed_, "--json"});
  double sum = 0;
  for (const json& one : findings) {
    sum += one["slid_cm"].get<double>();
    EXPECT_TRUE(one.contains("drift_cm") || one["slid_cm"] == 0);
  }
  EXPECT_NEAR(sum, footskate({}), 0.02);  // the file's skeleton has 32-bit floats

  write("contacts.json", json::array({found[0]}).dump());
  EXPECT_LT(footskate({"--contacts", edited}), footskate({}));
}

TEST_F(CliContacts, NamesOfJointsGiveTheTerminalNoOrders) {
  for (const std::string name : {"human.asf", "human_walk.amc"}) {
    std::string text = read_text(samples_ + name);
    for (std::size_t at = 0; (at = text.find("ltoes", at)) != std::string::npos; at += 6)
      text.replace(at, 5, "\x1b[1mtoes");
    write(name, text);
  }
  const std::string said = mocapress({"contacts", file("human_walk.amc")}).out;
  EXPECT_THAT(said, testing::HasSubstr("\\x1b[1mtoes"));
  EXPECT_THAT(said, testing::Not(testing::HasSubstr("\x1b")));
}

TEST_F(CliContacts, SaysWhatIsWrongWithAFileOfThem) {
  const std::string clip = write("walk.bvh", test_bvh());
  json_of({"compress", clip, "-o", packed_, "--json"});
  const auto message = [&](const std::string& text) {
    const Outcome outcome =
        mocapress({"measure", clip, packed_, "--contacts", write("contacts.json", text)});
    EXPECT_EQ(outcome.exit_code, 3);
    return outcome.err;
  };
  EXPECT_THAT(message("[{"), testing::HasSubstr("contacts.json:1:3: is not JSON"));
  EXPECT_THAT(message("[{\"joint\": \"hips\"}]"), testing::HasSubstr("contact 1 lacks"));
  EXPECT_THAT(message("[{\"joint\": \"nose\", \"first_frame\": 0, \"last_frame\": 3}]"),
              testing::HasSubstr("nose"));
  EXPECT_THAT(message("{}"), testing::HasSubstr("array"));
}

}  // namespace
}  // namespace mocapress::test
