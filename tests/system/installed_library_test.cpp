// SPDX-License-Identifier: MIT
// Tests the library as programs get it: installed into a folder of its own, with the example built
// against it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <regex>
#include <sstream>

#include "core/base/file.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;

class InstalledLibrary : public CommandLine {
 protected:
  void SetUp() override {
    for (const char* component : {"runtime", "library"})
      run({"cmake", "--install", MOCAPRESS_BINARY_DIR, "--component", component, "--prefix",
           prefix()});
    example_ = file("prefix") / "share/mocapress/example";
    ASSERT_TRUE(fs::exists(example_ / "compress_clip.cpp"));
  }

  std::string prefix() const { return file("prefix").string(); }

  /// Expects success and returns standard output.
  static std::string run(const std::vector<std::string>& words) {
    const Outcome outcome = run_program(words);
    EXPECT_EQ(outcome.exit_code, 0) << words.back() << ": " << outcome.out << outcome.err;
    return outcome.out;
  }

  /// Runs a shell command in which pkg-config finds the installed library.
  std::string run_shell(const std::string& command) const {
    return run({"sh", "-c",
                "PKG_CONFIG_PATH=$(dirname $(find " + prefix() +
                    " -name mocapress.pc)) && export PKG_CONFIG_PATH && " + command});
  }

  static std::string clip() {
    return (fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/human_walk.amc").string();
  }

  fs::path example_;
};

TEST_F(InstalledLibrary, BuildsTheExampleByCMakeAndByPkgConfigWhichRunsAndSaysWhatIsWrong) {
  const std::string build = file("build").string();
  run({"cmake", "-S", example_.string(), "-B", build, "-DCMAKE_PREFIX_PATH=" + prefix()});
  run({"cmake", "--build", build});
  const std::string by_cmake = run({(file("build") / "compress_clip").string(), clip(), "lfoot"});

  const std::string program = file("compress_clip").string();
  run_shell("c++ -std=c++20 -Wall -Wextra -Werror " + (example_ / "compress_clip.cpp").string() +
            " $(pkg-config --cflags --libs mocapress) -o " + program);
  EXPECT_EQ(run({program, clip(), "lfoot"}), by_cmake);

  std::size_t bytes = 0;
  double ratio = 0;
  double error_cm = 0;
  const std::size_t line = by_cmake.find("eps_x 0.25 cm: ");
  ASSERT_NE(line, std::string::npos) << by_cmake;
  ASSERT_EQ(std::sscanf(by_cmake.c_str() + line, "eps_x 0.25 cm: %zu bytes, 1 : %lf, eps_x %lf cm",
                        &bytes, &ratio, &error_cm),
            3)
      << by_cmake;
  EXPECT_GT(bytes, 100u);
  EXPECT_GT(ratio, 20);
  EXPECT_LE(error_cm, 0.25);
  EXPECT_THAT(by_cmake, testing::HasSubstr("lfoot after 0.5 s of ")) << "a joint by its name";

  const Outcome no_joint = run_program({program, clip(), "tail"});
  EXPECT_EQ(no_joint.exit_code, 1);
  EXPECT_THAT(no_joint.err, testing::HasSubstr("no joint named tail"));
  const Outcome no_clip = run_program({program, write("a.bvh", "HIERARCHY\nROOT 3\n")});
  EXPECT_EQ(no_clip.exit_code, 1);
  EXPECT_THAT(no_clip.err, testing::HasSubstr("a.bvh:")) << "file, line and column";
}

/// FetchContent takes the tree itself in place of a clone, and nothing is linked: that would
/// compile all of core.
TEST_F(InstalledLibrary, TheExampleCompilesByTheSameNamesInATreeThatIsFetched) {
  write("CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.25)\nproject(fetching LANGUAGES CXX)\n"
        "include(FetchContent)\nFetchContent_Declare(mocapress GIT_REPOSITORY none)\n"
        "FetchContent_MakeAvailable(mocapress)\nadd_library(tool OBJECT " +
            (example_ / "compress_clip.cpp").string() +
            ")\ntarget_link_libraries(tool PRIVATE mocapress::mocapress)\n");
  const std::string build = file("build").string();
  run({"cmake", "-G", "Ninja", "-S", file("").string(), "-B", build,
       std::string("-DFETCHCONTENT_SOURCE_DIR_MOCAPRESS=") + MOCAPRESS_SOURCE_DIR});
  run({"cmake", "--build", build, "--target", "tool"});
}

TEST_F(InstalledLibrary, ItsHeadersNeedEigenAndTheStandardLibraryAlone) {
  static const std::regex kInclude(R"(\s*#\s*include\s*(\S+))");
  const fs::path headers = file("prefix") / "include/mocapress";
  std::string tests;
  for (const auto& entry : fs::recursive_directory_iterator(headers)) {
    if (!entry.is_regular_file()) continue;
    std::istringstream lines(read_text(entry.path()));
    for (std::string line; std::getline(lines, line);) {
      std::smatch match;
      if (!std::regex_search(line, match, kInclude)) continue;
      const std::string header = match[1];
      EXPECT_TRUE(header.starts_with("<Eigen/") || header.starts_with("<mocapress/") ||
                  header == "<stddef.h>" || header == "<stdint.h>" ||
                  header.find_first_of("/.\"") == std::string::npos)
          << entry.path() << " includes " << header;
    }
    // Includes each public header twice, and alone.
    const std::string name = entry.path().filename().string();
    if (entry.path().parent_path() == headers)
      tests += " " + write(name + ".cpp", "#include <mocapress/" + name +
                                              ">\n#include <mocapress/" + name + ">\n");
  }
  ASSERT_THAT(tests, testing::HasSubstr("/settings.h.cpp"));
  run_shell("c++ -std=c++20 -fsyntax-only -Wall -Wextra -Werror $(pkg-config --cflags mocapress)" +
            tests);
}

}  // namespace
}  // namespace mocapress::test
