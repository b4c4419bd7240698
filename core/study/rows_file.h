// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "core/study/row.h"

namespace mocapress {

/// The whole rows in such a file; what is none is passed over. Throws InputError.
std::vector<StudyRow> read_rows(const std::filesystem::path& path);

/// The rows a study has so far, on disk as lines of JSON: what makes a run that was stopped, or
/// died, go on where it was.
class RowsFile {
 public:
  /// Opens or makes the file. Lines that are no whole row (the last of a run that died) are
  /// dropped. Throws InputError, WriteError.
  explicit RowsFile(std::filesystem::path path);

  /// The rows that were there.
  const std::vector<StudyRow>& rows() const { return rows_; }

  /// Appends a row and hands it to the system at once. Throws WriteError.
  void append(const StudyRow& row);

 private:
  std::filesystem::path path_;
  std::vector<StudyRow> rows_;
  std::ofstream stream_;
};

}  // namespace mocapress
