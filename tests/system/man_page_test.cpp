// SPDX-License-Identifier: MIT
// Compares the manual with the program.
#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "core/base/file.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

class ManPage : public CommandLine {
 protected:
  static std::set<std::string> matches(const std::string& text, const char* pattern) {
    const std::regex expression(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
      found.insert((*at)[1]);
    return found;
  }

  const std::string page_ = std::regex_replace(
      read_text(MOCAPRESS_BINARY_DIR "/resources/man/mocapress.1"), std::regex(R"(\\-)"), "-");
};

TEST_F(ManPage, NamesEveryCommandAndEveryOptionOfIt) {
  const std::string help = mocapress({"--help"}).out;
  const std::string commands = help.substr(help.find("Subcommands:"));
  const std::set<std::string> names = matches(commands, R"(\n  ([a-z]+) )");
  EXPECT_THAT(names, testing::IsSupersetOf({"compress", "batch", "study"}));
  for (const std::string& name : names) {
    EXPECT_THAT(page_, testing::HasSubstr("\n.SS " + name));
    for (const std::string& option : matches(mocapress({name, "--help"}).out, R"((--[a-z-]+))"))
      EXPECT_THAT(page_, testing::HasSubstr(option)) << "of " << name;
  }
  for (const std::string& name : matches(mocapress({"bank", "--help"}).out, R"(\n  ([a-z]+) )"))
    for (const std::string& option :
         matches(mocapress({"bank", name, "--help"}).out, R"((--[a-z-]+))"))
      EXPECT_THAT(page_, testing::HasSubstr(option)) << "of bank " << name;
}

TEST_F(ManPage, HasTheVersionOfTheProgram) {
  std::string version = mocapress({"--version"}).out;
  version.resize(version.find('\n'));
  EXPECT_THAT(page_, testing::HasSubstr("Mocapress " + version));
}

}  // namespace
}  // namespace mocapress::test
