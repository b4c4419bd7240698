// SPDX-License-Identifier: MIT
// Records of viewers' answers in blind tests. A file of them is a JSON array, in the order of the
// tests.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json_text.h"
#include "core/metrics/blind_test.h"
#include "core/metrics/sight_limits.h"

namespace mocapress {

/// A finished blind test. Levels are multiples of the error that is just noticeable by `limits`.
struct BlindTestRecord {
  std::string viewer;
  std::string clip;
  std::string character;    // its file; empty: a figure of capsules
  std::string time;         // ISO 8601, UTC
  Cue cue = Cue::Velocity;  // cue by which the errors were most visible
  SightLimits limits;       // include the viewer's distance
  std::vector<double> levels;
  std::vector<BlindAnswer> answers;

  int right() const;
  double p() const { return p_by_guessing(right(), static_cast<int>(answers.size())); }
  ThresholdFit fit() const;
};

Json to_json(const BlindTestRecord& record);

/// Reads what to_json() wrote. Values that follow from the answers are computed again instead of
/// read. Throws Error.
BlindTestRecord blind_test_from(const Json& json);

/// Reads the records of a file; none if the file does not exist. Throws InputError.
std::vector<BlindTestRecord> read_blind_tests(const std::filesystem::path& path);

/// Adds a record to the end of a file. Throws InputError and WriteError.
void add_blind_test(const std::filesystem::path& path, const BlindTestRecord& record);

/// Returns the limits of visibility for these viewers. A tested cue gets the limit of each test
/// times the threshold that the test found, as the geometric mean of all its tests with a
/// threshold. Cues without such a test keep the limits of `otherwise`.
SightLimits limits_by(const std::vector<BlindTestRecord>& records, const SightLimits& otherwise);

}  // namespace mocapress
