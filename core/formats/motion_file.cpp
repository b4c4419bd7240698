// SPDX-License-Identifier: MIT
#include "core/formats/motion_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/base/memory_limit.h"
#include "core/base/path_kind.h"
#include "core/base/printable.h"
#include "core/base/utf8_path.h"
#include "core/formats/amc.h"
#include "core/formats/asf.h"
#include "core/formats/bvh.h"
#include "core/formats/clip_files.h"
#include "core/formats/csv.h"
#include "core/formats/fbx/fbx_onto.h"
#include "core/formats/fbx/fbx_reader.h"
#include "core/formats/fbx/fbx_writer.h"
#include "core/formats/gltf_reader.h"
#include "core/formats/gltf_writer.h"
#include "core/formats/text_cursor.h"
#include "core/formats/text_writer.h"
#include "core/motion/additive.h"
#include "core/motion/clip.h"
#include "core/motion/skin_points.h"
#include "core/motion/surface_points.h"

namespace mocapress {
namespace {

using std::filesystem::path;

constexpr const char* kGltfExtensions[] = {".gltf", ".glb", ".vrm", ".vrma"};

bool has_extension(const path& file, std::string_view extension) {
  return equals_ignoring_case(utf8(file.extension()), extension);
}

/// True for the extensions of glTF. Models and animations of VRM are .glb files by another name.
bool is_gltf(const path& file) {
  return std::ranges::any_of(kGltfExtensions,
                             [&](const char* extension) { return has_extension(file, extension); });
}

/// The container for writing a glTF; unset if the extension is not one of glTF.
std::optional<GltfContainer> gltf_container(const path& file) {
  if (has_extension(file, ".glb")) return GltfContainer::Glb;
  if (has_extension(file, ".gltf")) return GltfContainer::Gltf;
  return std::nullopt;
}

/// Throws InputError unless the extension is one of a motion.
void require_motion(const path& file) {
  if (has_extension(file, ".asf"))
    throw InputError(utf8(file), 0, 0, "is a skeleton without motion: open one of its .amc files");
  if (!is_clip(file)) throw InputError(utf8(file), 0, 0, "is none of " + readable_extensions(", "));
}

struct SkeletonText {
  path file;
  std::string text;
};

/// True if no bone has a length, as often in clips of differences to another clip, which may have
/// rotations only.
bool is_without_lengths(const Skeleton& skeleton) {
  const std::vector<double> lengths = skeleton.driven_lengths();
  return skeleton.joint_count() > 1 &&
         std::ranges::all_of(lengths, [](double length) { return length == 0; });
}

/// Throws Error if a value to be written is NaN or infinite.
void require_finite(const path& file, const Motion& motion, const ScalarTracks& tracks) {
  const auto is_finite = [](const ScalarTrack& track) {
    return std::ranges::all_of(track.values, [](float value) { return std::isfinite(value); });
  };
  if (!motion.clip.channels.allFinite() || !std::ranges::all_of(tracks, is_finite))
    throw Error(utf8(file) + ": is not written: the motion has values that are not finite");
}

void append(const Warnings& more, Warnings& warnings) {
  warnings.insert(warnings.end(), more.begin(), more.end());
}

MotionFile parse_by_extension(const path& file, std::string_view text, const SkeletonText& asf,
                              const ReadOptions& options) {
  require_motion(file);
  if (has_extension(file, ".bvh")) return read_bvh(utf8(file), text, options);
  if (has_extension(file, ".fbx")) return read_fbx(utf8(file), text, options);
  if (is_gltf(file)) return read_gltf(utf8(file), text, options);
  const AsfSkeleton skeleton = read_asf(utf8(asf.file), asf.text, options.cm_per_unit);
  return read_amc(utf8(file), text, skeleton, options);
}

/// Turns any exception of the libraries under the readers into a sentence with the file's name.
template <typename Read>
auto with_library_errors(const path& file, const Read& read) {
  try {
    return naming_what_takes_memory(utf8(file), read);
  } catch (const Error&) {
    throw;
  } catch (const Json::exception&) {
    throw InputError(utf8(file), 0, 0, "has a JSON value of another type than its place asks for");
  } catch (const std::exception&) {
    throw InputError(utf8(file), 0, 0, "cannot be read: a library that reads its parts failed");
  }
}

MotionFile parse(const path& file, std::string_view text, const SkeletonText& asf,
                 const ReadOptions& options) {
  MotionFile read =
      with_library_errors(file, [&] { return parse_by_extension(file, text, asf, options); });
  append(surface_warnings(file, read.motion.skeleton), read.warnings);
  if (looks_additive(read.motion))
    read.warnings.push_back({utf8(file), 0,
                             "looks like an additive clip, near its rest pose with the root at the "
                             "origin: errors are those that it makes on that pose, and where feet "
                             "stand means nothing"});
  return read;
}

}  // namespace

path find_skeleton(const path& amc) {
  const std::string stem = utf8(amc.stem());
  const std::string subject = stem.substr(0, stem.find('_'));
  for (const std::string& name : {stem, subject})
    for (const char* extension : {".asf", ".ASF"}) {
      path candidate = amc.parent_path() / utf8_path(name + extension);
      if (is_there(candidate)) return candidate;
    }
  throw InputError(utf8(amc), 0, 0,
                   stem == subject ? "needs its skeleton, but " + stem + ".asf is not beside it"
                                   : "needs its skeleton, but neither " + stem + ".asf nor " +
                                         subject + ".asf is beside it");
}

std::optional<path> find_tracks(const path& motion) {
  path table = path(motion).replace_extension(".tracks.csv");
  return is_there(table) ? std::optional(std::move(table)) : std::nullopt;
}

MotionFile parse_motion(const path& file, std::string_view text, std::string_view skeleton_text,
                        const ReadOptions& options) {
  return parse(file, text, {path(file).replace_extension(".asf"), std::string(skeleton_text)},
               options);
}

MotionFile read_motion(const path& file, const std::optional<path>& skeleton_path,
                       const ReadOptions& options) {
  require_motion(file);
  ReadOptions with_tracks = options;
  if (!with_tracks.tracks)
    if (const std::optional<path> table = find_tracks(file)) with_tracks.tracks = utf8(*table);
  return read_motion_bytes(file, read_text(file), skeleton_path, with_tracks);
}

MotionFile read_motion_bytes(const path& file, std::string_view bytes,
                             const std::optional<path>& skeleton_path, const ReadOptions& options) {
  SkeletonText skeleton;
  if (has_extension(file, ".amc")) {
    skeleton.file = skeleton_path ? *skeleton_path : find_skeleton(file);
    skeleton.text = read_text(skeleton.file);
  }
  MotionFile read = parse(file, bytes, skeleton, options);
  if (options.character) put_character(utf8_path(*options.character), read);
  if (options.tracks) {
    const ScalarTracks more = read_csv_tracks(
        *options.tracks, read_text(utf8_path(*options.tracks)), read.motion.clip.frames());
    read.tracks.insert(read.tracks.end(), more.begin(), more.end());
  }
  return read;
}

std::vector<path> files_of_motion(const path& file, const std::optional<path>& skeleton_path,
                                  const ReadOptions& options) {
  std::vector<path> files = {file};
  if (has_extension(file, ".amc"))
    files.push_back(skeleton_path ? *skeleton_path : find_skeleton(file));
  if (options.tracks)
    files.emplace_back(*options.tracks);
  else if (const std::optional<path> table = find_tracks(file))
    files.push_back(*table);
  if (options.character) files.emplace_back(*options.character);
  return files;
}

Character read_character(const path& file) {
  const bool is_fbx = has_extension(file, ".fbx");
  if (!is_fbx && !is_gltf(file))
    throw InputError(utf8(file), 0, 0, "is none of .fbx, .gltf, .glb, .vrm");
  const std::string bytes = read_text(file);
  return with_library_errors(file, [&] {
    return is_fbx ? read_fbx_character(utf8(file), bytes) : read_gltf_character(utf8(file), bytes);
  });
}

namespace {

/// Warnings about a character that does not quite fit the clip and may look odd.
Warnings fit_warnings(const path& file, const Character& character, const Skeleton& skeleton,
                      const OwnLengths& lengths) {
  Warnings warnings;
  const std::vector<std::string> missing =
      missing_joints(*character.skin, character.skeleton, skeleton);
  if (!missing.empty())
    warnings.push_back(
        {utf8(file), 0,
         "the clip has no joint " + shortened(missing.front()) +
             (missing.size() > 1 ? ", nor " + std::to_string(missing.size() - 1) + " more" : "") +
             ": what hangs there stays in its bind pose"});
  if (!lengths.bones.empty())
    warnings.push_back(
        {utf8(file), 0,
         "has other proportions than the clip, and legs of " +
             std::to_string(std::lround(100 * lengths.scale)) +
             " % the length: it is shown and coloured with its own bones, and figures are "
             "measured on the clip's"});
  return warnings;
}

}  // namespace

std::shared_ptr<const Skin> put_character(const path& file, const Character& character,
                                          Skeleton& skeleton, Warnings& warnings) {
  auto bound =
      std::make_shared<const Skin>(bound_to(*character.skin, character.skeleton, skeleton));
  measure_on(bound.get(), skeleton);
  append(fit_warnings(file, character, skeleton, bound->lengths), warnings);
  append(surface_warnings(file, skeleton), warnings);
  return bound;
}

void put_character(const path& file, MotionFile& clip) {
  const Character character = read_character(file);
  try {
    clip.skin = put_character(file, character, clip.motion.skeleton, clip.warnings);
  } catch (const Error& error) {
    throw InputError(utf8(file), 0, 0, std::string("cannot be put on: ") + error.what());
  }
}

MotionFile read_motion_of_many(const path& file, const std::optional<path>& skeleton_path,
                               const ReadOptions& options, const CharacterReader& read) {
  ReadOptions plain = options;
  const std::optional<std::string> character = std::exchange(plain.character, std::nullopt);
  MotionFile clip = read_motion(file, skeleton_path, plain);
  if (!character) return clip;
  const path file_of_character = utf8_path(*character);
  const auto shared = read ? read(file_of_character)
                           : std::make_shared<const Character>(read_character(file_of_character));
  try {
    clip.skin = put_character(file_of_character, *shared, clip.motion.skeleton, clip.warnings);
  } catch (const Error& error) {
    clip.warnings.push_back({*character, 0, std::string("is not put on: ") + error.what()});
  }
  return clip;
}

Warnings surface_warnings(const path& file, const Skeleton& skeleton) {
  Warnings warnings;
  const std::vector<FarMesh> far = far_meshes(skeleton);
  if (is_without_lengths(skeleton) && std::ssize(far) < skeleton.joint_count())
    warnings.push_back({utf8(file), 0,
                        "no bone has a length: errors are measured on three points 3 cm from each "
                        "joint"});
  if (far.empty()) return warnings;
  const auto cm = [](double length) { return std::to_string(std::lround(length)); };
  warnings.push_back({utf8(file), 0,
                      "the mesh reaches much further than the bones at " +
                          counted(std::ssize(far), "joint") + ", first " +
                          shortened(skeleton.joint(far.front().joint).name) + " (" +
                          cm(far.front().mesh_cm) + " cm, not " + cm(far.front().body_cm) +
                          "): the surface there is the mesh"});
  return warnings;
}

Motion exported_motion(const Motion& motion, const SourceFormat& source,
                       const WriteOptions& options) {
  Motion exported = with_up_axis(motion, UpAxis::Y, options.up.value_or(source.up));
  exported.clip.sample_rate_hz = options.sample_rate_hz.value_or(motion.clip.sample_rate_hz);
  return exported;
}

std::string motion_bytes(const path& file, const Motion& motion, const SourceFormat& source,
                         const WriteOptions& options, const ScalarTracks& tracks) {
  if (const auto container = gltf_container(file))
    return gltf_bytes(motion, *container, source, options, tracks);
  if (has_extension(file, ".fbx")) return fbx_bytes(motion, source, options, tracks);
  const Motion exported = exported_motion(motion, source, options);
  if (has_extension(file, ".bvh")) return bvh_text(exported, bvh_style(source, options));
  if (has_extension(file, ".csv")) return csv_text(exported, tracks);
  throw Error(utf8(file) +
              ": cannot be written: its extension is none of .bvh, .fbx, .glb, .gltf, .amc, .csv");
}

namespace {

void write_staged(const path& file, std::string_view text, StagedFile::Existing existing) {
  StagedFile staged(file);
  staged.write(text);
  staged.commit(existing);
}

}  // namespace

Warnings write_motion(const path& file, const Motion& motion,
                      const std::optional<path>& skeleton_path, const SourceFormat& source,
                      const WriteOptions& options, const ScalarTracks& tracks,
                      StagedFile::Existing existing) {
  require_finite(file, motion, tracks);
  const auto lost = [&](const auto& is_lost) -> Warnings {
    const auto count = std::ranges::count_if(tracks, is_lost);
    if (count == 0) return {};
    return {{utf8(file), 0, "has no place for " + counted(count, "track") + " of the clip"}};
  };
  if (!has_extension(file, ".amc")) {
    write_staged(file, motion_bytes(file, motion, source, options, tracks), existing);
    return lost([&](const ScalarTrack& track) {
      return has_extension(file, ".bvh") || (gltf_container(file) && !is_scale(track.kind));
    });
  }
  const Motion acclaim = acclaim_motion(exported_motion(motion, source, options));
  const double cm_per_unit = asf_cm_per_unit(source, options);
  std::array pair = {StagedFile(skeleton_path.value_or(path(file).replace_extension(".asf"))),
                     StagedFile(file)};
  pair[0].write(asf_text(acclaim.skeleton, cm_per_unit));
  pair[1].write(amc_text(acclaim, cm_per_unit));
  StagedFile::commit_all(pair, existing);
  return lost([](const ScalarTrack&) { return true; });
}

void write_takes(const path& file, const std::vector<FbxClip>& clips, const SourceFormat& source,
                 const WriteOptions& options, StagedFile::Existing existing) {
  for (const FbxClip& clip : clips) require_finite(file, clip.motion, clip.tracks);
  write_staged(file, fbx_bytes(clips, source, options), existing);
}

bool can_be_onto(const path& file, const path& onto) {
  return has_extension(file, ".fbx") ? has_extension(onto, ".fbx")
                                     : gltf_container(file) && is_gltf(onto);
}

void write_motion_onto(const path& file, const Motion& motion, const path& onto,
                       const SourceFormat& source, const WriteOptions& options,
                       const ScalarTracks& tracks, StagedFile::Existing existing) {
  if (!can_be_onto(file, onto))
    throw Error(utf8(file) +
                ": only an .fbx can be written onto an .fbx, and a .glb or .gltf "
                "onto a glTF");
  require_finite(file, motion, tracks);
  write_staged(file,
               has_extension(file, ".fbx")
                   ? fbx_bytes_onto(utf8(onto), read_text(onto), motion, options, tracks)
                   : gltf_bytes_onto(onto, motion, *gltf_container(file), file.parent_path(),
                                     source, options, tracks),
               existing);
}

}  // namespace mocapress
