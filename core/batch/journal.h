// SPDX-License-Identifier: MIT
// What a batch has done so far, on disk as lines of JSON: a header, then a row a clip as clips end.
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

/// Which batch a journal is of, and which part of it.
struct JournalHeader {
  std::size_t clips = 0;  // of the whole batch
  std::string list;       // fingerprint() of the batch
  Shard shard;

  bool operator==(const JournalHeader&) const = default;
};

/// The whole rows of a journal. Only their places are in memory.
class JournalReader {
 public:
  /// Throws InputError when it cannot be read or has no header.
  explicit JournalReader(const std::filesystem::path& path);

  const JournalHeader& header() const { return header_; }

  /// The last row of each output, in the order of their index.
  void for_each(const std::function<void(const BatchRow&)>& visit) const;

  std::size_t rows() const { return places_.size(); }

  /// The same one by one. Throws InputError where it cannot be read any more.
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

/// The journal of a run, which nobody else may have open at a time.
class Journal {
 public:
  enum class Start { New, Resume, Anew };

  /// New: throws WriteError where there is one already. Resume: its rows are kept as far as they
  /// are of `batch` and `shard`, whatever is left half-written. Anew: it is emptied. Throws
  /// WriteError, also when another run has it open: it says who, as the journal's first line does;
  /// and InputError where rows cannot be read: then the file stays as it was. With `take_over` a run
  /// on another computer does not count: its lock may stand when it is gone.
  Journal(const std::filesystem::path& path, const Batch& batch, const Shard& shard, Start start,
          bool take_over = false);

  /// That other runs could not be kept away from it.
  const std::optional<Warning>& warning() const { return lines_.warning(); }

  /// The row of a clip of the batch that was kept on resuming, if there is one. Throws InputError
  /// where it cannot be read.
  std::optional<BatchRow> find(std::size_t index) const;

  /// Appends a row; it is on the disk then. Throws WriteError.
  void append(const BatchRow& row);

 private:
  struct Place {
    std::uint64_t offset = 0;
    std::size_t length = 0;  // 0: there is no row
  };

  void keep_rows_of(const Batch& batch, const JournalHeader& header);

  std::filesystem::path path_;
  AppendedFile lines_;
  std::vector<Place> places_;  // by the index of the clip; empty: nothing is kept
};

}  // namespace mocapress
