// SPDX-License-Identifier: MIT
// Notes on frames in a file of their own beside the clip, so that they travel with it: walk.bvh has
// walk.notes.json. A JSON object of "format" ("mocapress-notes"), "version" (1), "clip" (the file's
// name) and "takes", an object that holds the notes of each take by its name, and those of a file
// without takes by "". Each note is as to_json() in verdict.h writes it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/report/review.h"

namespace mocapress {

/// The notes of a file's takes; "" stands for the only one.
using NotesByTake = std::map<std::string, std::vector<FrameNote>>;

/// walk.notes.json beside walk.bvh.
std::filesystem::path notes_file_of(const std::filesystem::path& clip);

/// Writes the notes beside the clip, or removes that file if there are none. Throws WriteError,
/// also if the file holds the notes of another clip: those of walk.fbx, beside walk.bvh.
void write_notes(const std::filesystem::path& clip, const NotesByTake& notes);

/// The notes beside the clip; empty if there is no such file, or it is another clip's. Throws
/// InputError.
NotesByTake read_notes(const std::filesystem::path& clip);

/// Adds those of `others` that `notes` lacks, in the order of frames. Two notes are the same if
/// frame, joint, text and reviewer are.
void add_notes(std::vector<FrameNote>& notes, const std::vector<FrameNote>& others);

}  // namespace mocapress
