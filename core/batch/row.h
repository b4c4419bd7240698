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

/// The state of a clip's source files when it was done. It covers all files that are read: for
/// example an .amc's skeleton, the character put on the clip, and a file of curves beside it.
struct InputStamp {
  std::uintmax_t bytes = 0;
  std::int64_t newest_ns = 0;  // time of the latest change to any of the files
  std::string hash;            // hash of all their bytes
  std::string source;          // hash of all but the character's bytes

  bool operator==(const InputStamp&) const = default;
};

/// Stamps the files that are read for a clip with these options. Throws InputError.
InputStamp stamp(const BatchItem& item, const ReadOptions& reading);

/// Stamps the files again. Reads them only if sizes or times differ from those of `earlier`.
InputStamp stamp_again(const BatchItem& item, const ReadOptions& reading,
                       const InputStamp& earlier);

/// True if the files still match the stamp. Reads their bytes only if their times differ.
bool unchanged(const BatchItem& item, const ReadOptions& reading, const InputStamp& stamp);

/// A hash of everything that shapes a clip's file: settings without their name, and options for
/// reading. Limits of visibility count only if visibility is the target; otherwise they judge a
/// file but do not change it. The paths of a character and of curves do not count; their bytes do,
/// through InputStamp::hash.
std::string settings_hash(const Settings& settings, const ReadOptions& reading);

/// The hash of a file's bytes. Throws InputError.
std::string hash_of(const std::filesystem::path& file);

/// A file of a batch that was read back and checked before it was put in place.
struct WrittenFile {
  std::string name;  // relative to the batch's folder
  std::uintmax_t bytes = 0;
  std::string hash;

  bool operator==(const WrittenFile&) const = default;
};

/// The result of one clip.
struct BatchRow {
  std::size_t index = 0;  // index in the whole batch
  std::string input;
  std::string output;
  ClipReview review = {};
  Settings preset;
  std::vector<OutputFormat> formats;
  ReadOptions reading;
  WriteOptions writing;
  InputStamp stamp;
  int joints = 0;
  std::optional<Measurement> measured;  // measured on the file as read back from the disk
  std::string verified_by;              // Verification::by; empty: not measured
  std::vector<WrittenFile> files;
  std::vector<std::string> warnings;  // repairs and guesses of the reader
  std::optional<WorstPose> worst;
  SightChart sights;
  std::string error;  // why the clip failed; empty: it is done

  bool done() const { return error.empty(); }
};

/// The reason why a row's verdict no longer applies to the clip's source and settings. Unset if it
/// applies, if there is no verdict, or if the clip was not read.
std::optional<std::string> stale_reason(const BatchRow& row);

/// The reason why one of the row's notes no longer applies.
std::optional<std::string> stale_reason(const BatchRow& row, const FrameNote& note);

/// True if a measurement meets the preset's target: a ratio within 2 %, or a bound that is not
/// exceeded.
bool keeps_promise(const Settings& preset, const Measurement& measured);

/// The whole row as one line of JSON, without a line end.
std::string to_journal_line(const BatchRow& row);

/// Reads what to_journal_line() wrote. Unset for anything but a complete row.
std::optional<BatchRow> parse_batch_row(std::string_view line);

/// A row as one line of JSON for reports and programs, with the keys of `mocapress compress
/// --json`, and null where a value does not apply. The same clip and preset give the same line;
/// only the stamp, with the program's version and the report's time, depends on the clock.
std::string to_report_line(const BatchRow& row, const ReportStamp& stamp = {});

/// A row as comma-separated values (RFC 4180), with a line feed.
std::string to_csv_line(const BatchRow& row, const ReportStamp& stamp = {});
std::string csv_head();

}  // namespace mocapress
