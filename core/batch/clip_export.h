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

/// "reading", "encoding", "verifying".
std::string_view name(ClipProgress::Stage stage);

/// Rights to replace files that exist.
struct ExportRights {
  bool overwrite = false;
  bool resumed = false;  // true: a file with exactly the same bytes belongs to this batch
  const BatchRow* earlier = nullptr;  // its files may be replaced if they are unchanged
  const std::set<FileIdentity>* sources = nullptr;  // sources of the whole batch, never written to
};

/// The source files of all clips of a batch.
std::set<FileIdentity> source_files(const Batch& batch);

/// The row of a clip that failed.
BatchRow failed_row(const Batch& batch, std::size_t index, const std::string& why);

/// True if everything that a row records is unchanged: clip, settings, options for reading and
/// writing, and the written files. Limits of visibility may differ where they do not shape files:
/// then judged_again() is due.
bool still_done(const BatchRow& row, const Batch& batch, const BatchItem& item,
                const std::filesystem::path& folder);

/// A row that is still done, its file judged by the batch's limits of visibility. Unset if the
/// batch writes no .mcpr, or something cannot be read.
std::optional<BatchRow> judged_again(const BatchRow& row, const Batch& batch, std::size_t index,
                                     const std::filesystem::path& folder,
                                     SharedCharacters& characters);

/// Exports a clip: reads it, puts it on the batch's character if there is one, compresses it,
/// writes its files under temporary names, reads them back and measures them against the request.
/// Only then are the files put in place. On an error the row has the message and no file is
/// changed. Unset if the observer stopped it.
std::optional<BatchRow> export_clip(const Batch& batch, std::size_t index,
                                    const std::filesystem::path& folder, const ExportRights& rights,
                                    SharedCharacters& characters,
                                    const Observer<ClipProgress>& observer = {});

}  // namespace mocapress
