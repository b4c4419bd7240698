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

/// What a clip's files were when it was done: of an .amc, with its skeleton, of a character that is
/// put on it and of the curves beside it.
struct InputStamp {
  std::uintmax_t bytes = 0;
  std::int64_t newest_ns = 0;  // when the newest of them was last written
  std::string hash;            // of all their bytes
  std::string source;          // the same without the character

  bool operator==(const InputStamp&) const = default;
};

/// Of a clip that is read by these options. Throws InputError.
InputStamp stamp(const BatchItem& item, const ReadOptions& reading);

/// The same. Bytes are only read where sizes or times are not those of an `earlier` stamp.
InputStamp stamp_again(const BatchItem& item, const ReadOptions& reading,
                       const InputStamp& earlier);

/// Whether the files still are what they were. Their bytes are only read where their times differ.
bool unchanged(const BatchItem& item, const ReadOptions& reading, const InputStamp& stamp);

/// Changes with all that shapes a clip's file: settings but their name, and how the source is read.
/// The bytes of a character and of curves count in InputStamp::hash: where they lie does not.
std::string settings_hash(const Settings& settings, const ReadOptions& reading);

/// Of a file's bytes. Throws InputError.
std::string hash_of(const std::filesystem::path& file);

/// A file of a batch, read back and found right before it got its name.
struct WrittenFile {
  std::string name;  // below the batch's folder
  std::uintmax_t bytes = 0;
  std::string hash;

  bool operator==(const WrittenFile&) const = default;
};

/// What became of one clip.
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
  std::optional<Measurement> measured;  // of the file as read back
  std::string verified_by;              // Verification::by; empty: it was not measured
  std::vector<WrittenFile> files;
  std::vector<std::string> warnings;  // what the reader repaired or guessed
  std::optional<WorstPose> worst;
  SightChart sights;  // empty: in rows from before it was kept
  std::string error;  // why it failed; empty: it is done

  bool done() const { return error.empty(); }
};

/// Why the row's verdict does not hold for what was read and how it was compressed. Unset: it
/// holds, there is none, or the clip was not read.
std::optional<std::string> stale_reason(const BatchRow& row);

/// Whether a measurement keeps what a preset promises: a ratio within 2 %, a bound not exceeded.
bool keeps_promise(const Settings& preset, const Measurement& measured);

/// One line of JSON without its end, with everything.
std::string to_journal_line(const BatchRow& row);

/// The inverse; unset on anything that is not a whole row.
std::optional<BatchRow> parse_batch_row(std::string_view line);

/// One line of JSON for reports and programs: keys as `mocapress compress --json` has them, null
/// where a value does not apply. The same for the same clip and preset: only the stamp, which says
/// which program made the report and when, is a clock's.
std::string to_report_line(const BatchRow& row, const ReportStamp& stamp = {});

/// The same as comma-separated values (RFC 4180), with a line feed.
std::string to_csv_line(const BatchRow& row, const ReportStamp& stamp = {});
std::string csv_head();

}  // namespace mocapress
