// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <set>

#include "core/base/file_identity.h"
#include "core/base/progress.h"
#include "core/batch/row.h"
#include "core/batch/shared_characters.h"

namespace mocapress {

/// The progress of one clip.
struct ClipProgress {
  enum class Stage { Reading, Encoding, Verifying };
  Stage stage = Stage::Reading;
  double fraction = 0;  // share of the clip's work; a guess while a target is searched
};

/// The name of a stage: "reading", "encoding" or "verifying".
std::string_view name(ClipProgress::Stage stage);

/// Permissions of an export to replace existing files.
struct ExportRights {
  bool overwrite = false;
  bool resumed = false;  // true: files with exactly the bytes to be written may be replaced
  const BatchRow* earlier = nullptr;  // files that this row names may be replaced if unchanged
  const std::set<FileIdentity>* sources = nullptr;  // all clips' source files, never replaced
};

/// The source files of all clips of a batch.
std::set<FileIdentity> source_files(const Batch& batch);

/// A row that says why a clip failed.
BatchRow failed_row(const Batch& batch, std::size_t index, const std::string& why);

/// True if everything that a row records is unchanged: clip, settings, options for reading and
/// writing, and the written files. Limits of visibility may have changed if they do not influence
/// the files; then the caller must use judged_again().
bool still_done(const BatchRow& row, const Batch& batch, const BatchItem& item,
                const std::filesystem::path& folder);

/// Judges the file of a row for which still_done() is true by the batch's limits of visibility, and
/// returns the new row. Unset if the batch writes no .mcpr, or if a file cannot be read.
std::optional<BatchRow> judged_again(const BatchRow& row, const Batch& batch, std::size_t index,
                                     const std::filesystem::path& folder,
                                     SharedCharacters& characters);

/// Exports a clip: reads it, puts it on the batch's character if there is one, compresses it,
/// writes its files without putting them in place, reads them back and measures them against the
/// request. Only then are the files put in place. If anything before fails, the row has the error
/// and no file has changed. Unset if the observer stopped the export.
std::optional<BatchRow> export_clip(const Batch& batch, std::size_t index,
                                    const std::filesystem::path& folder, const ExportRights& rights,
                                    SharedCharacters& characters,
                                    const Observer<ClipProgress>& observer = {});

}  // namespace mocapress
