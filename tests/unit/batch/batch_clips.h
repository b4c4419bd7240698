// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <string>

#include "core/base/file.h"
#include "core/base/utf8_path.h"
#include "core/batch/batch_folder.h"
#include "tests/support/test_motion.h"

namespace mocapress::test {

/// A folder of the test's own with a few clips, and a batch of them to run.
class BatchTest : public testing::Test {
 protected:
  BatchTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "in/more");
    write_motion(folder_ / "in/one.bvh", smooth_motion(120, 1));
    write_motion(folder_ / "in/two.amc", smooth_motion(90, 2));
    write_motion(folder_ / "in/more/three.bvh", smooth_motion(150, 3));
  }
  ~BatchTest() override { std::filesystem::remove_all(folder_); }

  Batch batch() const {
    Batch all{.presets = {{.name = "rough", .target = {Target::Kind::Error, 2}}}};
    add_items(all, find_sources({utf8(folder_ / "in")}), 0, kUsualNames);
    mark_collisions(all);
    return all;
  }

  BatchOutcome run(const Batch& asked, const BatchRunOptions& options = {},
                   const Observer<BatchProgress>& observer = {}) const {
    BatchControl control;
    return run_batch_in(out(), asked, options, control, observer);
  }

  std::filesystem::path out() const { return folder_ / "out"; }

  /// All files of a folder except journals, which contain times.
  static std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().extension() != ".jsonl")
        files[entry.path().lexically_relative(folder).generic_string()] = read_text(entry.path());
    return files;
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("batch-" + std::to_string(getpid()));
};

}  // namespace mocapress::test
