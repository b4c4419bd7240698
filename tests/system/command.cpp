// SPDX-License-Identifier: MIT
#include "tests/system/command.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <sstream>
#include <thread>

#include "core/base/file.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) c == '\'' ? text += "'\\''" : text += c;
  return text + "'";
}

/// A new folder for this process and call.
fs::path new_folder() {
  std::string pattern = (fs::temp_directory_path() / "mocapress-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
  return pattern;
}

constexpr const char* kHierarchy = R"(HIERARCHY
ROOT hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT spine
  {
    OFFSET 0 20 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT head
    {
      OFFSET 0 50 2
      CHANNELS 2 Xrotation Yrotation
      End Site
      {
        OFFSET 0 20 0
      }
    }
  }
  JOINT thigh
  {
    OFFSET 10 -5 0
    CHANNELS 2 Zrotation Xrotation
    JOINT shin
    {
      OFFSET 0 -42 0
      CHANNELS 1 Xrotation
      End Site
      {
        OFFSET 0 -40 10
      }
    }
  }
}
)";

}  // namespace

Outcome run_program(const std::vector<std::string>& words) {
  const fs::path folder = new_folder();
  std::string line;
  for (const std::string& word : words) line += quoted(word) + " ";
  line += "> " + quoted(folder / "out") + " 2> " + quoted(folder / "err");
  const int status = std::system(line.c_str());
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(folder / "out"),
                  read_text(folder / "err")};
  fs::remove_all(folder);
  return outcome;
}

bool is_installed(const std::string& program) {
  return run_program({"sh", "-c", "command -v " + program}).exit_code == 0;
}

bool comes_true(const std::function<bool()>& condition) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  while (!condition()) {
    const Clock::duration passed = Clock::now() - begin;
    if (passed > std::chrono::minutes(5)) return false;
    // Checks often at first, and less often later.
    std::this_thread::sleep_for(std::clamp<Clock::duration>(
        passed / 10, std::chrono::milliseconds(1), std::chrono::milliseconds(100)));
  }
  return true;
}

CommandLine::CommandLine() : folder_(new_folder()) {}
CommandLine::~CommandLine() {
  fs::remove_all(folder_);
}

std::string CommandLine::write(const std::string& name, const std::string& text) const {
  write_text(file(name), text);
  return file(name);
}

nlohmann::json CommandLine::run_blender(const std::string& script,
                                        const std::vector<std::string>& arguments) {
  const fs::path answer = file("answer.json");
  std::vector<std::string> words = {"timeout",
                                    "600",
                                    "blender",
                                    "-b",
                                    "--factory-startup",
                                    "--python-exit-code",
                                    "1",
                                    "-P",
                                    MOCAPRESS_SOURCE_DIR "/tests/system/" + script,
                                    "--",
                                    answer};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const Outcome outcome = run_program(words);
  if (!fs::exists(answer.string() + ".started")) return {};
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  return fs::exists(answer) ? nlohmann::json::parse(read_text(answer)) : nlohmann::json::array();
}

Outcome CommandLine::mocapress(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{MOCAPRESS_EXECUTABLE};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program(words);
}

nlohmann::json CommandLine::json_of(const std::vector<std::string>& arguments) {
  const Outcome outcome = mocapress(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  nlohmann::json json = nlohmann::json::parse(outcome.out, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << "not JSON alone:\n" << outcome.out;
  return json;
}

std::string test_bvh() {
  constexpr int kFrames = 600;
  constexpr int kChannels = 14;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << kHierarchy << "MOTION\nFrames: " << kFrames << "\nFrame Time: 0.00833333\n";
  for (int t = 0; t < kFrames; ++t) {
    const double s = t / 120.0;
    text << 60 * s << ' ' << 90 + 3 * std::sin(9 * s) << ' ' << 2 * std::cos(5 * s);
    for (int c = 3; c < kChannels; ++c)
      text << ' ' << 25 * std::sin((2 + 0.7 * c) * s + c) + 4 * std::sin((13 + c) * s * s);
    text << '\n';
  }
  return text.str();
}

}  // namespace mocapress::test
