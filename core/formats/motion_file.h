// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/staged_file.h"
#include "core/motion/clip.h"
#include "core/motion/scalar_track.h"
#include "core/motion/skin.h"
#include "core/motion/source_format.h"

namespace mocapress {

/// Properties that a file does not state, or states wrongly. Unset ones are taken from the file or
/// guessed, and a guess is a warning.
struct ReadOptions {
  // A rate that overrides a BVH's or AMC's; an AMC without a rate has kUsualAmcRate. Keys of FBX
  // and glTF are sampled at this rate; unset: at the rate at which they were made.
  std::optional<double> sample_rate_hz;
  std::optional<double> cm_per_unit;  // BVH states none: guessed from the skeleton's height
  std::optional<UpAxis> up;           // BVH and AMC state none: Y unless given
  std::optional<TranslationConvention> bvh_root;  // BVH states none: guessed from its values
  std::optional<std::string> take;  // in a file with several: the name, or the number from 1 on
  // A .fbx, .gltf or .glb whose mesh read_motion() puts on the clip, as put_character() does.
  std::optional<std::string> character;
  // A .csv file of curves that read_motion() adds to the clip's own, read by read_csv_tracks().
  // Unset: the file that find_tracks() finds.
  std::optional<std::string> tracks;
  std::optional<int> fbx_version;  // version of a written FBX: 7400 or 7700; unset: 7400

  bool operator==(const ReadOptions&) const = default;
};

/// Properties of a file to be written that differ from its source's. The rate only changes the rate
/// that the file states: no frame is added or left out.
using WriteOptions = ReadOptions;

/// The animations of a file, by the ReadOptions::take that selects each.
struct Takes {
  std::vector<std::string> keys;  // empty: files of its format hold one motion
  std::size_t read = 0;           // index of the one that was read
};

/// A motion as read, with warnings about repairs and guesses.
struct MotionFile {
  Motion motion;  // cm, Y up, radians (unwrapped), seconds
  Warnings warnings;
  SourceFormat source;
  bool states_rate = true;           // false: the rate is the format's usual one, or the options'
  std::shared_ptr<const Skin> skin;  // bound to motion.skeleton; null: the file has none
  Takes takes;
  ScalarTracks tracks;  // as many frames as the clip
};

/// The .asf beside an .amc, with the same name or the part before '_' (09_01.amc: 09_01.asf,
/// 09.asf), with the extension in any case. Throws InputError if there is none.
std::filesystem::path find_skeleton(const std::filesystem::path& amc);

/// The table of curves beside a clip (walk.fbx: walk.tracks.csv), if there is one.
std::optional<std::filesystem::path> find_tracks(const std::filesystem::path& motion);

/// Reads the bytes of a .bvh, .fbx, .gltf, .glb or, with the text of its .asf, an .amc. `file`
/// names it in messages, and its extension tells the format. Throws InputError.
MotionFile parse_motion(const std::filesystem::path& file, std::string_view text,
                        std::string_view skeleton_text = {}, const ReadOptions& options = {});

/// Reads .bvh, .fbx, .gltf, .glb or .amc by its extension. An .amc needs its skeleton:
/// `skeleton_path`, or else the one that find_skeleton() finds. Throws InputError.
MotionFile read_motion(const std::filesystem::path& path,
                       const std::optional<std::filesystem::path>& skeleton_path = {},
                       const ReadOptions& options = {});

/// Does the same as read_motion() for bytes that came another way, as from a pipe. `file` names
/// them in messages, and its extension tells their format. Does not look for curves beside it.
MotionFile read_motion_bytes(const std::filesystem::path& file, std::string_view bytes,
                             const std::optional<std::filesystem::path>& skeleton_path = {},
                             const ReadOptions& options = {});

/// All files that read_motion() reads for these arguments. Throws InputError as find_skeleton()
/// does.
std::vector<std::filesystem::path> files_of_motion(
    const std::filesystem::path& path,
    const std::optional<std::filesystem::path>& skeleton_path = {},
    const ReadOptions& options = {});

/// The mesh and skeleton of a .fbx, .gltf or .glb, which needs no animation. Throws InputError.
Character read_character(const std::filesystem::path& path);

/// Replaces the clip's skin by a character's: the one shown, and measured by Weighting::Skin. Warns
/// of whatever does not fit. If too little of the character would be left, throws InputError, which
/// names a joint that the clip lacks.
void put_character(const std::filesystem::path& character, MotionFile& clip);

/// Replaces the skeleton's skin by a character that was already read from `file`, and returns the
/// character's skin bound to the skeleton. Throws Error.
std::shared_ptr<const Skin> put_character(const std::filesystem::path& file,
                                          const Character& character, Skeleton& skeleton,
                                          Warnings& warnings);

/// A function that returns read_character() of a file; it may keep characters that it has read.
using CharacterReader =
    std::function<std::shared_ptr<const Character>(const std::filesystem::path& file)>;

/// Reads one of many clips as read_motion() does. If the character does not fit, the clip keeps its
/// own skin, with a warning. Without `read` the character is parsed for this clip alone.
MotionFile read_motion_of_many(const std::filesystem::path& path,
                               const std::optional<std::filesystem::path>& skeleton_path = {},
                               const ReadOptions& options = {}, const CharacterReader& read = {});

/// Warns of joints whose errors are not measured on a body around the bones: the mesh of `file`
/// reaches much further there, or no bone has a length.
Warnings surface_warnings(const std::filesystem::path& file, const Skeleton& skeleton);

/// The bytes of a .bvh, .fbx, .glb, .gltf or .csv, by the extension of `file`, as write_motion()
/// writes them. Throws Error on another extension.
std::string motion_bytes(const std::filesystem::path& file, const Motion& motion,
                         const SourceFormat& source = {}, const WriteOptions& options = {},
                         const ScalarTracks& tracks = {});

/// Writes .bvh, .fbx, .glb, .gltf, .csv, or .amc with the skeleton at `skeleton_path` (by default
/// beside the .amc, same name, extension .asf), by the extension of `path`. The file has the axes
/// of `source`, and its unit and root convention if the formats match, unless `options` ask for
/// others. A glTF has Y up and metres, an FBX centimetres, unless the source was such a file with
/// another unit. A .csv and an .fbx hold all `tracks`, a glTF the scales. Warnings list everything
/// that had no place. Throws WriteError, also for an existing file if `existing` is Refuse; Error
/// for an unknown extension.
Warnings write_motion(const std::filesystem::path& path, const Motion& motion,
                      const std::optional<std::filesystem::path>& skeleton_path = {},
                      const SourceFormat& source = {}, const WriteOptions& options = {},
                      const ScalarTracks& tracks = {},
                      StagedFile::Existing existing = StagedFile::Existing::Replace);

struct FbxClip;
/// Writes an .fbx of clips of one rig, a take each, with fbx_bytes(). Throws WriteError.
void write_takes(const std::filesystem::path& path, const std::vector<FbxClip>& clips,
                 const SourceFormat& source = {}, const WriteOptions& options = {},
                 StagedFile::Existing existing = StagedFile::Existing::Replace);

/// True if write_motion_onto() can write a file with the extension of `path` from one with that of
/// `onto`.
bool can_be_onto(const std::filesystem::path& path, const std::filesystem::path& onto);

/// Writes a copy of the .fbx, .glb or .gltf `onto` to `path`, with this motion in place of the
/// animation that it was read from: fbx_bytes_onto(), gltf_bytes_onto(). Throws InputError,
/// WriteError; Error on an extension that does not fit.
void write_motion_onto(const std::filesystem::path& path, const Motion& motion,
                       const std::filesystem::path& onto, const SourceFormat& source = {},
                       const WriteOptions& options = {}, const ScalarTracks& tracks = {},
                       StagedFile::Existing existing = StagedFile::Existing::Replace);

/// The motion in the axes and at the rate of a file to be written.
Motion exported_motion(const Motion& motion, const SourceFormat& source,
                       const WriteOptions& options = {});

}  // namespace mocapress
