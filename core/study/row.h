// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/appended_file.h"
#include "core/mocapress/settings.h"
#include "core/report/measurement.h"
#include "core/report/review.h"

namespace mocapress {

/// One compression of a study: its settings, and its measurement or the reason for none.
struct StudyRow {
  std::string clip;         // the path as given
  ClipReview review = {};   // given if a library has one
  std::string fingerprint;  // hash of the motion as read; empty: it could not be read
  Settings settings;        // as asked for
  int jobs = 1;             // compressions at a time, which affect seconds
  std::optional<Measurement> measured;
  std::string error;  // reason for having no measurement

  /// r_IK; unset: without IK correction.
  std::optional<double> ik_ratio() const {
    return settings.correction ? settings.correction->ratio : std::nullopt;
  }

  /// True if the target was met: a ratio within 2 %, a bound not exceeded.
  bool reached() const;

  /// A key that equals that of the same compression in another run: it covers all settings and the
  /// motion, but not its path.
  std::string key() const;
};

/// The row as one line of JSON, without a line end. Keys with the meaning they have in `mocapress
/// compress --json` are the same; null where a value does not apply.
std::string to_json_line(const StudyRow& row);

/// Reads such a line; unset for anything but a complete row.
std::optional<StudyRow> parse_row(std::string_view line);

/// All rows as a JSON array, one on each line, with the program's version and the date.
std::string rows_json(std::span<const StudyRow> rows);

/// The same rows as comma-separated values (RFC 4180, lines end with a line feed) under a header
/// line; empty where a value does not apply.
std::string rows_csv(std::span<const StudyRow> rows);

/// The complete rows in a file of JSON lines; other lines are skipped. Throws InputError.
std::vector<StudyRow> read_rows(const std::filesystem::path& path);

/// The rows of a study so far, as lines of JSON on disk. A run that was stopped or died resumes
/// from them.
class RowsFile {
 public:
  /// Opens or creates the file. Drops lines that are no complete rows, as the last one of a run
  /// that died. Throws InputError; throws WriteError, also if another run has it open.
  explicit RowsFile(const std::filesystem::path& path);

  /// The rows found when it was opened.
  const std::vector<StudyRow>& rows() const { return rows_; }

  /// Set if other runs could not be locked out.
  const std::optional<Warning>& warning() const { return lines_.warning(); }

  /// Appends a row and returns once it is on the disk. Throws WriteError.
  void append(const StudyRow& row);

 private:
  AppendedFile lines_;
  std::vector<StudyRow> rows_;
};

}  // namespace mocapress
