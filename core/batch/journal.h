// SPDX-License-Identifier: MIT
// The progress of a batch on disk, as lines of JSON: a header, then a row for each clip that is
// done or failed.
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

/// Identifies the batch that a journal belongs to, and its shard.
struct JournalHeader {
  std::size_t clips = 0;  // number of clips in the whole batch
  std::string list;       // fingerprint() of the batch
  Shard shard;

  bool operator==(const JournalHeader&) const = default;
};

/// Reads a journal and skips rows that are not complete. Keeps only the rows' positions in memory.
class JournalReader {
 public:
  /// Throws InputError if the journal cannot be read or has no header.
  explicit JournalReader(const std::filesystem::path& path);

  const JournalHeader& header() const { return header_; }

  /// Visits the last row of each output, in the order of the clips' indices.
  void for_each(const std::function<void(const BatchRow&)>& visit) const;

  std::size_t rows() const { return places_.size(); }

  /// Gives the rows of for_each() one by one. Throws InputError if a row can no longer be read.
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

/// The journal that a run writes. Only one run at a time may have it open.
class Journal {
 public:
  enum class Start { New, Resume, Anew };

  /// New: throws WriteError if there is a journal. Resume: keeps the rows that belong to `batch`
  /// and `shard`, and drops incomplete rows. Anew: empties the journal. Throws WriteError, also if
  /// another run has it open; the message names that run, as in the journal's first line. Throws
  /// InputError if rows cannot be read, and then leaves the file as it was. `take_over` ignores the
  /// lock of a run on another computer, since a lock may outlive its run.
  Journal(const std::filesystem::path& path, const Batch& batch, const Shard& shard, Start start,
          bool take_over = false);

  /// Set if the journal could not be locked, so that another run may open it, too.
  const std::optional<Warning>& warning() const { return lines_.warning(); }

  /// The row of a clip that was kept on resuming, if any. Throws InputError if it cannot be read.
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
  std::vector<Place> places_;  // by the clip's index; empty if no rows were kept
};

}  // namespace mocapress
