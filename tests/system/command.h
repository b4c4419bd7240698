// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mocapress::test {

/// The result of a finished process.
struct Outcome {
  int exit_code = -1;  // -1: ended by a signal
  std::string out;     // standard output
  std::string err;
};

/// Runs a program found as the shell finds it, with unchanged arguments.
Outcome run_program(const std::vector<std::string>& words);

bool is_installed(const std::string& program);

/// Waits for another process to do something, as long as a slow machine may take.
bool comes_true(const std::function<bool()>& condition);

/// Tests of the `mocapress` executable, each in a folder of its own that is removed at the end.
class CommandLine : public testing::Test {
 protected:
  CommandLine();
  ~CommandLine() override;

  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  /// Writes `text` to a file of the folder and returns its path.
  std::string write(const std::string& name, const std::string& text) const;

  static Outcome mocapress(const std::vector<std::string>& arguments);

  /// The same, expecting success and nothing but one JSON value on standard output.
  static nlohmann::json json_of(const std::vector<std::string>& arguments);

  /// Runs a script of this folder in Blender and returns the JSON that it wrote to its output file;
  /// null without a Blender that starts.
  nlohmann::json run_blender(const std::string& script, const std::vector<std::string>& arguments);

 private:
  std::filesystem::path folder_;
};

/// A BVH of five joints with 14 channels that moves for five seconds at 120 Hz.
std::string test_bvh();

}  // namespace mocapress::test
