// SPDX-License-Identifier: MIT
// Answers of viewers in blind tests, kept as JSON: one list, a test after the other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json_text.h"
#include "core/metrics/blind_test.h"
#include "core/metrics/sight_limits.h"

namespace mocapress {

/// A finished blind test. Levels are multiples of the error that `limits` take for noticeable.
struct BlindTestRecord {
  std::string viewer;
  std::string clip;
  std::string character;    // empty: a figure of capsules
  std::string time;         // ISO 8601, UTC
  Cue cue = Cue::Velocity;  // by which the errors were most visible
  SightLimits limits;       // with the viewer's distance
  std::vector<double> levels;
  std::vector<BlindAnswer> answers;

  int right() const;
  double p() const { return p_by_guessing(right(), static_cast<int>(answers.size())); }
  ThresholdFit fit() const;
};

Json to_json(const BlindTestRecord& record);

/// The inverse, which fits again instead of reading what follows from the answers. Throws Error.
BlindTestRecord blind_test_from(const Json& json);

/// The records of a file; none if there is no such file. Throws InputError.
std::vector<BlindTestRecord> read_blind_tests(const std::filesystem::path& path);

/// Adds a record to the end of a file. Throws InputError and WriteError.
void add_blind_test(const std::filesystem::path& path, const BlindTestRecord& record);

/// The limits by which these viewers notice half of what can be noticed: the limit of each tested
/// cue times the threshold, in the geometric mean of all tests whose threshold was found. Other
/// cues keep the limits of `otherwise`.
SightLimits limits_by(const std::vector<BlindTestRecord>& records, const SightLimits& otherwise);

}  // namespace mocapress
