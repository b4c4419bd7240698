// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/appended_file.h"
#include "core/study/row.h"

namespace mocapress {

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
