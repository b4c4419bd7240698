// SPDX-License-Identifier: MIT
// The progress of a batch, on disk as lines of JSON: a header, then a row for each clip that has
// ended.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/appended_file.h"
#include "core/base/line_reader.h"
#include "core/batch/row.h"

namespace mocapress {

/// The batch and the part of it that a journal belongs to.
struct JournalHeader {
  std::size_t clips = 0;  // number in the whole batch
  std::string list;       // fingerprint() of the batch
  Shard shard;

  bool operator==(const JournalHeader&) const = default;
};

/// Reads the complete rows of a journal. Only their places are kept in memory.
class JournalReader {
 public:
  /// Throws InputError if the journal cannot be read or has no header.
  explicit JournalReader(const std::filesystem::path& path);

  const JournalHeader& header() const { return header_; }

  /// Visits the last row of each output, in the order of their index.
  void for_each(const std::function<void(const BatchRow&)>& visit) const;

  std::size_t rows() const { return places_.size(); }

  /// The same rows one by one. Throws InputError if a row can no longer be read.
  std::size_t index_at(std::size_t place) const { return places_[place].index; }
  BatchRow row_at(std::size_t place) const;

 private:
  struct Place {
    std::size_t index;
    std::uint64_t offset;
    std::size_t length;
  };

  std::string path_;
  LineReader lines_;
  JournalHeader header_;
  std::vector<Place> places_;
};

/// The journal of a run. Only one run at a time may have it open.
class Journal {
 public:
  enum class Start { New, Resume, Anew };

  /// New: throws WriteError if a journal exists. Resume: keeps the rows that belong to `batch` and
  /// `shard`, and drops a row that is not complete. Anew: empties the journal. Throws WriteError,
  /// also if another run has it open, and names that run by the journal's first line. Throws
  /// InputError if rows cannot be read, and then leaves the file as it was. `take_over` ignores a
  /// run on another computer, whose lock may outlive it.
  Journal(const std::filesystem::path& path, const Batch& batch, const Shard& shard, Start start,
          bool take_over = false);

  /// Set if other runs could not be locked out.
  const std::optional<Warning>& warning() const { return lines_.warning(); }

  /// The row of a clip that resuming has kept, if any. Throws InputError if it cannot be read.
  std::optional<BatchRow> find(std::size_t index) const;

  /// Appends a row and returns once it is on the disk. Throws WriteError.
  void append(const BatchRow& row);

 private:
  struct Place {
    std::uint64_t offset = 0;
    std::size_t length = 0;  // 0: no row
  };

  void keep_rows_of(const Batch& batch, const JournalHeader& header);

  std::filesystem::path path_;
  AppendedFile lines_;
  std::vector<Place> places_;  // by the index of the clip; empty: no rows were kept
};

}  // namespace mocapress
