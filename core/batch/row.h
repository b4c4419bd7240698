// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/batch/batch.h"
#include "core/batch/worst_pose.h"
#include "core/report/measurement.h"
#include "core/report/report_stamp.h"
#include "core/report/review.h"

namespace mocapress {

/// The state of a clip's source files when it was done: an .amc with its skeleton, the character
/// put on it and the curves beside it all count.
struct InputStamp {
  std::uintmax_t bytes = 0;
  std::int64_t newest_ns = 0;  // time of the latest change to any of them
  std::string hash;            // hash over all their bytes
  std::string source;          // the same hash without the character

  bool operator==(const InputStamp&) const = default;
};

/// The stamp of a clip that is read with these options. Throws InputError.
InputStamp stamp(const BatchItem& item, const ReadOptions& reading);

/// The same, reading bytes only if sizes or times differ from those of an `earlier` stamp.
InputStamp stamp_again(const BatchItem& item, const ReadOptions& reading,
                       const InputStamp& earlier);

/// True if the files still match the stamp. Bytes are read only if their times differ.
bool unchanged(const BatchItem& item, const ReadOptions& reading, const InputStamp& stamp);

/// A hash of everything that shapes a clip's file: settings without their name, and options for
/// reading. Limits of visibility count only where they are the target: elsewhere they judge a file
/// and do not change it. For a character and curves their bytes count, through InputStamp::hash,
/// and not their paths.
std::string settings_hash(const Settings& settings, const ReadOptions& reading);

/// The hash of a file's bytes. Throws InputError.
std::string hash_of(const std::filesystem::path& file);

/// A file of a batch that was read back and checked before it got its name.
struct WrittenFile {
  std::string name;  // relative to the batch's folder
  std::uintmax_t bytes = 0;
  std::string hash;

  bool operator==(const WrittenFile&) const = default;
};

/// The result of one clip.
struct BatchRow {
  std::size_t index = 0;  // in the whole batch
  std::string input;
  std::string output;
  ClipReview review = {};
  Settings preset;
  std::vector<OutputFormat> formats;
  ReadOptions reading;
  WriteOptions writing;
  InputStamp stamp;
  int joints = 0;
  std::optional<Measurement> measured;  // measured on the file as read back
  std::string verified_by;              // Verification::by; empty: not measured
  std::vector<WrittenFile> files;
  std::vector<std::string> warnings;  // the reader's repairs and guesses
  std::optional<WorstPose> worst;
  SightChart sights;
  std::string error;  // reason for failing; empty: it is done

  bool done() const { return error.empty(); }
};

/// The reason why the row's verdict does not apply to its source and settings. Unset: it applies,
/// there is no verdict, or the clip was not read.
std::optional<std::string> stale_reason(const BatchRow& row);

/// The same for one of its notes.
std::optional<std::string> stale_reason(const BatchRow& row, const FrameNote& note);

/// True if a measurement keeps the preset's promise: a ratio within 2 %, a bound not exceeded.
bool keeps_promise(const Settings& preset, const Measurement& measured);

/// The whole row as one line of JSON, without a line end.
std::string to_journal_line(const BatchRow& row);

/// Reads such a line; unset for anything but a complete row.
std::optional<BatchRow> parse_batch_row(std::string_view line);

/// One line of JSON for reports and programs, with the keys of `mocapress compress --json` and null
/// where a value does not apply. Equal for the same clip and preset; only the stamp, with the
/// program's version and the report's time, depends on the clock.
std::string to_report_line(const BatchRow& row, const ReportStamp& stamp = {});

/// The same row as comma-separated values (RFC 4180), with a line feed.
std::string to_csv_line(const BatchRow& row, const ReportStamp& stamp = {});
std::string csv_head();

}  // namespace mocapress
