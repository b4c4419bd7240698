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

/// One compression of a study: its settings, and its measurement or the reason why there is none.
struct StudyRow {
  std::string clip;         // the path in the plan
  ClipReview review = {};   // the verdict from a library, if it has one
  std::string fingerprint;  // of the motion that was read; empty: the clip could not be read
  Settings settings;        // requested settings
  int jobs = 1;             // compressions running at a time, which influences times
  std::optional<Measurement> measured;
  std::string error;  // why there is no measurement

  /// r_IK; unset without IK correction.
  std::optional<double> ik_ratio() const {
    return settings.correction ? settings.correction->ratio : std::nullopt;
  }

  /// True if the target was met: a ratio within 2 %, or a bound that is not exceeded.
  bool reached() const;

  /// Identifies the compression in any run: equal for equal settings and an equal motion, whatever
  /// its path.
  std::string key() const;
};

/// The row as one line of JSON, without a line end. Keys of `mocapress compress --json` have the
/// same meaning here; a value that does not apply is null.
std::string to_json_line(const StudyRow& row);

/// Reads what to_json_line() wrote. Unset for anything but a complete row.
std::optional<StudyRow> parse_row(std::string_view line);

/// All rows as a JSON array, one row on each line, with the program's version and the time of the
/// report.
std::string rows_json(std::span<const StudyRow> rows);

/// All rows as comma-separated values (RFC 4180, with line feeds) under a header line. A value that
/// does not apply is empty.
std::string rows_csv(std::span<const StudyRow> rows);

/// Reads the complete rows of a file of JSON lines; skips other lines. Throws InputError.
std::vector<StudyRow> read_rows(const std::filesystem::path& path);

/// The rows of a study so far, on disk as lines of JSON. The next run continues from them if this
/// one is stopped or killed.
class RowsFile {
 public:
  /// Opens or creates the file. Drops lines that are not complete rows, such as the last line of a
  /// run that was killed. Throws InputError; throws WriteError, also if another run has the file
  /// open.
  explicit RowsFile(const std::filesystem::path& path);

  /// The rows that were in the file when it was opened.
  const std::vector<StudyRow>& rows() const { return rows_; }

  /// Set if the file could not be locked, so that another run may open it, too.
  const std::optional<Warning>& warning() const { return lines_.warning(); }

  /// Appends a row and returns once it is on the disk. Throws WriteError.
  void append(const StudyRow& row);

 private:
  AppendedFile lines_;
  std::vector<StudyRow> rows_;
};

}  // namespace mocapress
