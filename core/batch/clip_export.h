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

/// How far one clip is.
struct ClipProgress {
  enum class Stage { Reading, Encoding, Verifying };
  Stage stage = Stage::Reading;
  double fraction = 0;  // of the clip; the searches for a target are guessed
};

/// "reading", "encoding", "verifying".
std::string_view name(ClipProgress::Stage stage);

/// What may be done to files that are there.
struct ExportRights {
  bool overwrite = false;
  bool resumed = false;               // a file with the very same bytes is this batch's own
  const BatchRow* earlier = nullptr;  // what was written before may be replaced while unchanged
  const std::set<FileIdentity>* sources = nullptr;  // files of the whole batch: never written to
};

/// The files that the clips of a batch are made from.
std::set<FileIdentity> source_files(const Batch& batch);

/// The row of a clip that was given up.
BatchRow failed_row(const Batch& batch, std::size_t index, const std::string& why);

/// Whether nothing has changed since a row was done: clip, settings, how files are read
/// and written, and the files it wrote.
bool still_done(const BatchRow& row, const Batch& batch, const BatchItem& item,
                const std::filesystem::path& folder);

/// Reads a clip, puts it on the batch's character where it has one, compresses it, writes its files
/// beside their places, reads them back and measures what was read against what was promised; only
/// then are they put in place. What goes wrong is in the row, and then nothing was put in place.
/// Unset when the observer ended it.
std::optional<BatchRow> export_clip(const Batch& batch, std::size_t index,
                                    const std::filesystem::path& folder, const ExportRights& rights,
                                    SharedCharacters& characters,
                                    const Observer<ClipProgress>& observer = {});

}  // namespace mocapress
