// SPDX-License-Identifier: MIT
// Stores notes on frames in a file beside the clip, so that they travel with it: walk.bvh has
// walk.notes.json. The file is a JSON object of "format" ("mocapress-notes"), "version" (1), "clip"
// (the clip's file name) and "takes". The latter is an object with a list of notes for each take,
// by its name; in a file without takes the name is "". to_json() in verdict.h defines the form of a
// note.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/report/review.h"

namespace mocapress {

/// Notes on a clip's frames, by the names of takes. In a file without takes the name is "".
using NotesByTake = std::map<std::string, std::vector<FrameNote>>;

/// The path of a clip's notes: walk.notes.json beside walk.bvh.
std::filesystem::path notes_file_of(const std::filesystem::path& clip);

/// Writes notes beside their clip. Without notes, removes the file. Throws WriteError, also if the
/// file has the notes of another clip: those of walk.fbx, beside walk.bvh.
void write_notes(const std::filesystem::path& clip, const NotesByTake& notes);

/// Reads the notes beside a clip; none if there is no file, or if it has the notes of another clip.
/// Throws InputError.
NotesByTake read_notes(const std::filesystem::path& clip);

/// Adds those of `others` that `notes` does not have, and sorts by frame. Notes are equal if
/// frames, joint, text and reviewer are.
void add_notes(std::vector<FrameNote>& notes, const std::vector<FrameNote>& others);

}  // namespace mocapress
