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

/// One compression of a study: what was asked, and what came of it or why nothing did.
struct StudyRow {
  std::string clip;         // the path as given
  ClipReview review = {};   // where a library has one
  std::string fingerprint;  // of the motion that was read; empty: it could not be
  Settings settings;        // what was asked
  int jobs = 1;             // compressions at a time, which seconds depend on
  std::optional<Measurement> measured;
  std::string error;  // why there is no measurement

  /// r_IK; unset: without IK correction.
  std::optional<double> ik_ratio() const {
    return settings.correction ? settings.correction->ratio : std::nullopt;
  }

  /// Whether the target was met: a ratio within 2 %, a bound not exceeded.
  bool reached() const;

  /// What makes it the same compression in another run: all that was asked and the motion itself,
  /// wherever its file is.
  std::string key() const;
};

/// A row as one line of JSON without its end. The keys are those of `mocapress compress --json`
/// where they mean the same; null where a value does not apply.
std::string to_json_line(const StudyRow& row);

/// The inverse; unset on anything that is not a whole row.
std::optional<StudyRow> parse_row(std::string_view line);

/// All rows as a JSON array, one a line, each with the program's version and the date.
std::string rows_json(std::span<const StudyRow> rows);

/// The same columns as comma-separated values (RFC 4180, lines end with a line feed) under a header
/// line; empty where a value does not apply.
std::string rows_csv(std::span<const StudyRow> rows);

/// The whole rows in such a file; what is none is passed over. Throws InputError.
std::vector<StudyRow> read_rows(const std::filesystem::path& path);

/// The rows a study has so far, on disk as lines of JSON: what makes a run that was stopped, or
/// died, go on where it was.
class RowsFile {
 public:
  /// Opens or makes the file. Lines that are no whole row (the last of a run that died) are
  /// dropped. Throws InputError, and WriteError, also when another run has it open.
  explicit RowsFile(const std::filesystem::path& path);

  /// The rows that were there.
  const std::vector<StudyRow>& rows() const { return rows_; }

  /// That other runs could not be kept away from it.
  const std::optional<Warning>& warning() const { return lines_.warning(); }

  /// Appends a row; it is on the disk then. Throws WriteError.
  void append(const StudyRow& row);

 private:
  AppendedFile lines_;
  std::vector<StudyRow> rows_;
};

}  // namespace mocapress
