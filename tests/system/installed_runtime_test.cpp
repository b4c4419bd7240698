// SPDX-License-Identifier: MIT
// Tests the decoder as engines get it: installed into a folder of its own, with the example built
// against it.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/file.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

class InstalledDecoder : public CommandLine {
 protected:
  void SetUp() override {
    run({"cmake", "--install", MOCAPRESS_BINARY_DIR, "--component", "runtime", "--prefix",
         file("prefix").string()});
    example_ = file("prefix") / "share/mocapress-runtime/example";
    ASSERT_TRUE(std::filesystem::exists(example_ / "walk.mcpr"));
  }

  /// Expects success and returns standard output.
  static std::string run(const std::vector<std::string>& words) {
    const Outcome outcome = run_program(words);
    EXPECT_EQ(outcome.exit_code, 0) << words.front() << ": " << outcome.out << outcome.err;
    return outcome.out;
  }

  std::string play(const std::filesystem::path& program) const {
    return run({program.string(), (example_ / "walk.mcpr").string()});
  }

  std::filesystem::path example_;
};

TEST_F(InstalledDecoder, BuildsAndRunsTheExampleByCMakeAndByPkgConfig) {
  const std::string build = file("build").string();
  run({"cmake", "-S", example_.string(), "-B", build,
       "-DCMAKE_PREFIX_PATH=" + file("prefix").string()});
  run({"cmake", "--build", build});
  const std::string by_cmake = play(file("build") / "play");

  // CMake installs mocapress-runtime.pc below lib or lib/<machine>.
  const std::string by_pkg_config = file("play").string();
  run({"sh", "-c",
       "PKG_CONFIG_PATH=$(dirname $(find " + file("prefix").string() +
           " -name mocapress-runtime.pc)) && export PKG_CONFIG_PATH && cc -std=c11 -Wall -Wextra "
           "-Werror " +
           (example_ / "play.c").string() + " $(pkg-config --cflags --libs mocapress-runtime) -o " +
           by_pkg_config});
  EXPECT_EQ(play(by_pkg_config), by_cmake);
  EXPECT_NE(by_cmake.find("\n0 ms\n"), std::string::npos);
  EXPECT_GT(std::count(by_cmake.begin(), by_cmake.end(), '#'), 100) << "a figure, second by second";
}

TEST_F(InstalledDecoder, TheCrowdPlaysACookedBankAndRefusesAPackedOne) {
  const std::string program = file("crowd").string();
  run({"sh", "-c",
       "cc -std=c11 -Wall -Wextra -Werror " + (example_ / "crowd.c").string() + " -I" +
           (file("prefix") / "include").string() + " $(find " + file("prefix").string() +
           " -name libmocapress-runtime.a) -lstdc++ -lm -o " + program});
  const std::string clip = (example_ / "walk.mcpr").string();
  ASSERT_EQ(mocapress({"bank", "make", file("packed.mcpk"), clip}).exit_code, 0);
  ASSERT_EQ(mocapress({"bank", "make", file("cooked.mcpk"), clip, "--cooked"}).exit_code, 0);
  const std::string said = run({program, file("cooked.mcpk"), "5"});
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 15) << said;
  EXPECT_NE(said.find("2 s: 4 plays walk at "), std::string::npos) << said;
  const Outcome outcome = run_program({program, file("packed.mcpk"), "5"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("crowd: "), std::string::npos) << outcome.err;
}

TEST_F(InstalledDecoder, TheExampleRefusesWhatIsNoClip) {
  const std::string program = file("play").string();
  run({"sh", "-c",
       "cc " + (example_ / "play.c").string() + " -I" + (file("prefix") / "include").string() +
           " $(find " + file("prefix").string() +
           " -name libmocapress-runtime.a) -lstdc++ -lm -o " + program});
  const Outcome outcome = run_program({program, write("not.mcpr", "not a clip at all")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("not a Mocapress file"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace mocapress::test
