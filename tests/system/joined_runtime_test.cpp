// SPDX-License-Identifier: MIT
// Tests the runtime decoder in the form of two files, for users who copy them into a game.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "core/base/file.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;

class JoinedRuntime : public CommandLine {
 protected:
  void SetUp() override {
    run("cmake --install " MOCAPRESS_BINARY_DIR " --component runtime --prefix " + prefix());
    fs::create_directory(file("game"));
    for (const char* name :
         {"mocapress_runtime.h", "mocapress_runtime.hpp", "mocapress_runtime.cpp"})
      fs::copy_file(file("prefix/share/mocapress-runtime") / name, file("game") / name);
    example_ = file("prefix/share/mocapress-runtime/example");
  }

  std::string prefix() const { return file("prefix").string(); }

  /// Runs a shell command in the folder with the two files, expects success and returns its output.
  std::string run(const std::string& words) const {
    const std::string folder = fs::exists(file("game")) ? file("game").string() : ".";
    const Outcome outcome = run_program({"sh", "-c", "cd " + folder + " && " + words});
    EXPECT_EQ(outcome.exit_code, 0) << words << ": " << outcome.out << outcome.err;
    return outcome.out;
  }

  /// The object that the build compiled from the two files alone; empty without that compiler.
  static std::string object_of(const std::string& compiler) {
    const fs::path object =
        fs::path(MOCAPRESS_BINARY_DIR) / "tests/system/joined" / (compiler + ".o");
    return fs::exists(object) ? object.string() : "";
  }

  /// The example's output with the decoder of an object file.
  std::string played_with(const std::string& object) const {
    run("cc -std=c11 -Wall -Wextra -Werror -I. " + (example_ / "play.c").string() + " " + object +
        " -lm -o play");
    return run("./play " + (example_ / "walk.mcpr").string());
  }

  /// The example's output with the installed library.
  std::string played_by_the_library() const {
    run("PKG_CONFIG_PATH=$(dirname $(find " + prefix() +
        " -name mocapress-runtime.pc)) && export PKG_CONFIG_PATH && cc -std=c11 " +
        (example_ / "play.c").string() +
        " $(pkg-config --cflags --libs mocapress-runtime) -o play-with-library");
    return run("./play-with-library " + (example_ / "walk.mcpr").string());
  }

  fs::path example_;
};

/// The object file lacks no symbols but those of C.
TEST_F(JoinedRuntime, CompilesAloneNeedsNothingOfCxxAndPlaysAsTheLibraryDoes) {
  const std::string expected = played_by_the_library();
  EXPECT_NE(expected.find('#'), std::string::npos) << "nobody is to be seen";
  for (const char* name : {"mocapress_runtime.h", "mocapress_runtime.hpp", "mocapress_runtime.cpp"})
    EXPECT_EQ(read_text(file("game") / name),
              read_text(fs::path(MOCAPRESS_BINARY_DIR) / "runtime" / name))
        << "installed as it was compiled";
  const std::string object = object_of("g++");
  ASSERT_NE(object, "");
  EXPECT_EQ(played_with(object), expected);
  if (is_installed("clang++")) {
    ASSERT_NE(object_of("clang++"), "");
    EXPECT_EQ(played_with(object_of("clang++")), expected);
  }
  const std::string missing = run("nm -C --undefined-only " + object);
  EXPECT_EQ(missing.find("std::"), std::string::npos) << missing;
  EXPECT_EQ(missing.find("operator new"), std::string::npos) << missing;
  EXPECT_EQ(missing.find("mocapress"), std::string::npos) << missing;
}

/// The indented lines of the readme from the one that includes this header to the end of main.
std::string example_of_readme(const std::string& header) {
  std::istringstream readme(read_text(fs::path(MOCAPRESS_SOURCE_DIR) / "core/runtime/README.md"));
  std::string program;
  for (std::string line; std::getline(readme, line);) {
    if (program.empty() && line != "    #include <" + header + ">") continue;
    program += line.substr(std::min<std::size_t>(line.size(), 4)) + "\n";
    if (line == "    }") break;
  }
  return program;
}

TEST_F(JoinedRuntime, PlaysByTheExamplesOfItsReadme) {
  const std::string flags =
      " -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror -I. ";
  write("game/example.cpp", example_of_readme("mocapress_runtime.hpp"));
  write("game/example.c", example_of_readme("mocapress_runtime.h"));
  for (const std::string compiler :
       {"g++ -std=c++20 -fno-exceptions -fno-rtti", "clang++ -std=c++20 -fno-exceptions -fno-rtti",
        "gcc -std=c11", "clang -std=c11"}) {
    if (!is_installed(compiler.substr(0, compiler.find(' ')))) continue;
    const std::string source = compiler.find("++") != std::string::npos ? "cpp" : "c";
    run(compiler + flags + "example." + source + " " + object_of("g++") + " -lm -o example");
    const std::string said = run("./example " + (example_ / "walk.mcpr").string());
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 4) << compiler << said;
    EXPECT_NE(said.find("1.5 s: the root is 9"), std::string::npos) << compiler << said;
    const Outcome refused =
        run_program({(file("game") / "example").string(), write("no.mcpr", "no clip at all")});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.out.find("not a Mocapress file"), std::string::npos) << refused.out;
  }
}

/// A pragma for AVX2 would apply to all templates of a joined source, which must run without it.
TEST_F(JoinedRuntime, HasAvx2InTheFunctionsThatAskForItAlone) {
  std::istringstream lines(run("objdump -dC --no-show-raw-insn " + object_of("g++")));
  std::string function;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(">:")) function = line;
    if (line.find("%ymm") != std::string::npos && function.find("avx2") == std::string::npos)
      FAIL() << function << line;
  }
  EXPECT_FALSE(function.empty());
}

TEST_F(JoinedRuntime, RefusesOptionsThatWouldChangeItsBits) {
  const Outcome outcome = run_program({"g++", "-std=c++20", "-ffast-math", "-E", "-o", "/dev/null",
                                       (file("game") / "mocapress_runtime.cpp").string()});
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("fast-math"), std::string::npos) << outcome.err;
}

TEST_F(JoinedRuntime, IsOfTheSizesThatItsReadmeTells) {
  std::ifstream words(fs::path(MOCAPRESS_SOURCE_DIR) / "core/runtime/README.md");
  std::vector<double> told;  // KB: of the sources, then of what they are compiled to
  for (std::string word, before; words >> word; before = word)
    if (word == "KB") told.push_back(std::strtod(before.c_str(), nullptr));
  ASSERT_GE(told.size(), 2);
  const auto sources = static_cast<double>(fs::file_size(file("game/mocapress_runtime.h")) +
                                           fs::file_size(file("game/mocapress_runtime.cpp")));
  EXPECT_NEAR(told[0], sources / 1000, 0.05 * told[0]);
  std::istringstream sizes(run("size " + object_of("g++") + " | tail -1"));
  double code = 0;
  sizes >> code;
  EXPECT_NEAR(told[1], code / 1000, 0.05 * told[1]);
}

/// A call with a painted stack tells how much of it is overwritten.
TEST_F(JoinedRuntime, TakesNoMoreStackThanItsReadmeTells) {
  const fs::path tests = fs::path(MOCAPRESS_SOURCE_DIR) / "tests";
  std::string inputs;
  for (const char* name :
       {"golden/v1_axes.mcpr", "golden/v1_ends.mcpr", "golden/v1_joints.mcpr",
        "golden/v1_segments.mcpr", "golden/v1_source.mcpr", "golden/v1_tracks.mcpr",
        "golden/v1_tiers.mcpr", "golden/v1_velocity.mcpr", "golden/v1_bank.mcpk",
        "fuzz/corpus/bank/cooked.mcpk"})
    inputs += " " + (tests / name).string();
  std::set<std::string> functions;
  const std::string header = read_text(file("game/mocapress_runtime.h"));
  const std::regex declared("MCPR_API [^(;]*\\b(mcp[rk]_\\w+)\\(");
  for (std::sregex_iterator i(header.begin(), header.end(), declared), end; i != end; ++i)
    functions.insert((*i)[1]);
  ASSERT_GT(functions.size(), 70U);
  for (const std::string compiler : {"g++", "clang++"}) {
    if (!is_installed(compiler)) continue;
    run("g++ -std=c++20 -O1 -I. " + (tests / "system/stack_use.cpp").string() + " " +
        object_of(compiler) + " -Wl,-z,now -o stack_use");
    std::istringstream lines(run("./stack_use" + inputs));
    std::set<std::string> measured;
    std::string call;
    for (std::size_t bytes = 0; lines >> call >> bytes; measured.insert(call))
      EXPECT_LE(bytes, std::size_t{16} << 10) << call << ", " << compiler;
    EXPECT_EQ(measured, functions) << "every function of the header";
  }
  EXPECT_NE(read_text(fs::path(MOCAPRESS_SOURCE_DIR) / "core/runtime/README.md")
                .find("at most 16 KiB of stack in any call"),
            std::string::npos);
}

TEST_F(JoinedRuntime, IsOfTheVersionThatThePackageHas) {
  std::string version = run("PKG_CONFIG_PATH=$(dirname $(find " + prefix() +
                            " -name mocapress-runtime.pc)) pkg-config --modversion "
                            "mocapress-runtime");
  while (!version.empty() && version.back() == '\n') version.pop_back();
  write("game/version.c",
        "#include <mocapress_runtime.h>\n#include <stdio.h>\n"
        "int main(void) { return printf(\"%d.%d.%d %d\", MCPR_VERSION_MAJOR, MCPR_VERSION_MINOR, "
        "MCPR_VERSION_PATCH, MCPR_VERSION) < 0; }\n");
  run("cc -I. version.c -o version");
  int major = 0, minor = 0, patch = 0;
  ASSERT_EQ(std::sscanf(version.c_str(), "%d.%d.%d", &major, &minor, &patch), 3) << version;
  EXPECT_EQ(run("./version"), version + " " + std::to_string(10000 * major + 100 * minor + patch));
}

}  // namespace
}  // namespace mocapress::test
