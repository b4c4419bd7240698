// SPDX-License-Identifier: MIT
// Exit codes and leftovers of failed runs. Codes: 2 usage, 3 bad input, 4 quality target missed, 5
// cannot write.
#include <gmock/gmock.h>

#include "core/base/file.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class CliErrors : public CommandLine {
 protected:
  const std::string clip_ = write("walk.bvh", test_bvh());
  const std::string packed_ = file("walk.mcpr");

  /// Runs a command that must fail with this code, print one sentence on standard error and nothing
  /// on standard output.
  static std::string error_of(int exit_code, const std::vector<std::string>& arguments) {
    const Outcome outcome = mocapress(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, Not(IsEmpty()));
    return outcome.err;
  }
};

TEST_F(CliErrors, WrongUseIsTwo) {
  error_of(2, {});
  error_of(2, {"shrink", clip_});
  error_of(2, {"compress", clip_, "--no-such-option"});
  error_of(2, {"compress", clip_, "--ratio", "10", "--target-error", "1"});
  error_of(2, {"compress", clip_, "--ratio", "-3"});
  error_of(2, {"compress", clip_, "--ratio", "many"});
  error_of(2, {"compress", clip_, "--method", "magic"});
  error_of(2, {"compress"});
  error_of(2, {"decompress", packed_});
}

TEST_F(CliErrors, WrongUseIsSaidInTheWordsThatWereTyped) {
  EXPECT_THAT(error_of(2, {"comress", clip_}),
              HasSubstr("'comress' is no command; did you mean compress?"));
  EXPECT_THAT(error_of(2, {"bank", "mkae", packed_}), HasSubstr("did you mean make?"));
  EXPECT_THAT(error_of(2, {"shrink", clip_}), HasSubstr("'shrink' is no command\n"));
  EXPECT_THAT(error_of(2, {"compress", clip_, "--raito", "30"}),
              HasSubstr("Not expected: --raito 30"));
  EXPECT_THAT(error_of(2, {"compress", clip_, "--ratio", "-3"}),
              HasSubstr("--ratio: -3 is not a number above 0"));
  EXPECT_THAT(error_of(2, {"compress", clip_, "--importance", "foot=3"}),
              HasSubstr("parts are feet, hands, fingers, head, contacts"));
  EXPECT_EQ(mocapress({"help", "bank"}).out, mocapress({"bank", "--help"}).out);
}

TEST_F(CliErrors, AMissingFileIsThreeAndNamed) {
  for (const char* name : {"none.bvh", "none.amc"})
    EXPECT_THAT(error_of(3, {"compress", file(name)}), HasSubstr(name));
  EXPECT_THAT(error_of(3, {"decompress", file("none.mcpr"), "-o", file("x.bvh")}),
              HasSubstr("none.mcpr"));
  EXPECT_THAT(error_of(3, {"info", file("none.mcpr")}), HasSubstr("none.mcpr"));
  EXPECT_THAT(error_of(3, {"measure", clip_, file("none.mcpr")}), HasSubstr("none.mcpr"));
}

TEST_F(CliErrors, ABrokenTextFileIsThreeAndNamesLineAndColumn) {
  std::string text = test_bvh();
  text.replace(text.find("Zrotation"), 9, "Wrotation");
  const std::string broken = write("broken.bvh", text);
  EXPECT_THAT(error_of(3, {"compress", broken, "-o", packed_}),
              testing::ContainsRegex("broken\\.bvh:5:[0-9]+: "));
  EXPECT_FALSE(std::filesystem::exists(packed_));
}

TEST_F(CliErrors, StandardOutputThatCannotBeWrittenIsFive) {
  ASSERT_EQ(mocapress({"compress", clip_, "-o", packed_}).exit_code, 0);
  const std::string bank = file("walk.mcpk");
  ASSERT_EQ(mocapress({"bank", "make", bank, packed_}).exit_code, 0);
  const std::vector<std::vector<std::string>> printing = {
      {"--help"},
      {"--version"},
      {"info", packed_, "--json"},
      {"compress", clip_, "--json"},
      {"measure", clip_, packed_, "--json"},
      {"contacts", clip_, "--json"},
      {"bank", "list", bank, "--json"},
      {"batch", clip_, "-o", file("batch"), "--json-progress"},
      {"study", clip_, "-o", file("study"), "--methods", "standard", "--ratios", "10",
       "--json-progress"}};
  for (const std::vector<std::string>& words : printing) {
    std::vector<std::string> line = {"sh", "-c", "\"$@\" > /dev/full", "sh", MOCAPRESS_EXECUTABLE};
    line.insert(line.end(), words.begin(), words.end());
    const Outcome outcome = run_program(line);
    EXPECT_EQ(outcome.exit_code, 5) << words[0] << ": " << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("standard output: cannot be written")) << words[0];
  }
}

TEST_F(CliErrors, AnUnknownExtensionIsThree) {
  const std::string odd = write("walk.xyz", "hello");
  EXPECT_THAT(error_of(3, {"compress", odd}), HasSubstr("walk.xyz"));
}

TEST_F(CliErrors, ATruncatedOrForeignMcprIsThreeAndNamesTheByte) {
  ASSERT_EQ(mocapress({"compress", clip_, "-o", packed_}).exit_code, 0);
  const std::string whole = read_text(packed_);
  const std::string output = file("x.bvh");
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{3}, std::size_t{40}, whole.size() - 1}) {
    const std::string cut = write("cut.mcpr", whole.substr(0, size));
    EXPECT_THAT(error_of(3, {"decompress", cut, "-o", output}),
                testing::ContainsRegex("cut\\.mcpr: byte [0-9]+: "));
  }
  EXPECT_THAT(error_of(3, {"info", write("foreign.mcpr", "PK\3\4 something else")}),
              HasSubstr("not a Mocapress file"));
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(CliErrors, MeasuringAgainstAnotherClipIsThree) {
  ASSERT_EQ(mocapress({"compress", clip_, "-o", packed_}).exit_code, 0);
  std::string text = test_bvh();
  text.erase(text.rfind('\n', text.size() - 2) + 1);  // removes the last frame
  const std::string shorter = write("shorter.bvh", text);
  EXPECT_THAT(error_of(3, {"measure", shorter, packed_, "--json"}), HasSubstr("600"));
}

TEST_F(CliErrors, AnUnreachableTargetIsFourAndWritesNothing) {
  for (const auto& target : {std::vector<std::string>{"--ratio", "1e6"},
                             {"--target-error", "1e-9"},
                             {"--target-size", "3"},
                             {"--max-error", "1e-9"}}) {
    std::vector<std::string> arguments{"compress", clip_, "-o", packed_, "--json"};
    arguments.insert(arguments.end(), target.begin(), target.end());
    EXPECT_THAT(error_of(4, arguments), HasSubstr("out of reach"));
    EXPECT_FALSE(std::filesystem::exists(packed_)) << target[0];
  }
}

TEST_F(CliErrors, AnUnwritableOutputIsFive) {
  std::filesystem::create_directory(file("folder.mcpr"));
  for (const std::string& output :
       {file("no/such/folder/x.mcpr").string(), file("folder.mcpr").string()})
    error_of(5, {"compress", clip_, "-o", output});
  ASSERT_EQ(mocapress({"compress", clip_, "-o", packed_}).exit_code, 0);
  for (const char* name : {"no/folder/x.bvh", "no/folder/x.amc", "no/folder/x.csv"})
    error_of(5, {"decompress", packed_, "-o", file(name)});
}

TEST_F(CliErrors, AMissingFolderOfTheOutputIsNamedBeforeTheClipIsRead) {
  const std::string broken = write("broken.bvh", "nonsense");
  EXPECT_THAT(error_of(5, {"compress", broken, "-o", file("nodir/x.mcpr")}),
              HasSubstr("nodir/x.mcpr: cannot be written: No such file or directory\n"));
  EXPECT_THAT(error_of(5, {"decompress", broken, "-o", file("nodir/x.bvh")}),
              HasSubstr("nodir/x.bvh: cannot be written: No such file or directory\n"));
}

TEST_F(CliErrors, AFolderOrABankIsNoClip) {
  EXPECT_THAT(error_of(3, {"compress", file("")}), HasSubstr("batch takes folders"));
  EXPECT_THAT(error_of(3, {"info", write("game.mcpk", "")}), HasSubstr("bank list"));
}

TEST_F(CliErrors, AFailedRunLeavesTheExistingOutputAlone) {
  write("walk.mcpr", "precious");
  error_of(4, {"compress", clip_, "-o", packed_, "--ratio", "1e6"});
  error_of(3, {"compress", file("none.bvh"), "-o", packed_});
  EXPECT_EQ(read_text(packed_), "precious");
  write("walk.out.bvh", "precious");
  error_of(3, {"decompress", packed_, "-o", file("walk.out.bvh")});
  EXPECT_EQ(read_text(file("walk.out.bvh")), "precious");
}

}  // namespace
}  // namespace mocapress::test
