// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "app/cli/output_place.h"
#include "app/cli/standard_streams.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/file_identity.h"
#include "core/base/memory_limit.h"
#include "core/base/staged_file.h"
#include "core/base/utf8_path.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/format/format_error.h"
#include "core/codec/format/source_section.h"
#include "core/codec/format/tiers.h"
#include "core/codec/methods/compared_file.h"
#include "core/formats/fbx/fbx_writer.h"
#include "core/formats/motion_file.h"
#include "core/formats/text_cursor.h"
#include "core/formats/text_writer.h"
#include "core/motion/rig.h"

namespace mocapress::cli {
namespace {

namespace fs = std::filesystem;

bool lists_the_same_joints(const Skeleton& a, const Skeleton& b) {
  if (a.joint_count() != b.joint_count()) return false;
  for (int j = 0; j < a.joint_count(); ++j)
    if (a.joint(j).parent != b.joint(j).parent ||
        without_namespace(a.joint(j).name) != without_namespace(b.joint(j).name))
      return false;
  return true;
}

struct Decompress {
  std::vector<std::string> inputs;
  std::string output;
  std::string output_format;  // format of standard output
  std::optional<std::string> skeleton_output;
  std::optional<std::string> onto;
  MotionOutput target;
  bool no_clobber = false;
  int tiers = 0;  // number of tiers to read; 0: all

  void run() const {
    check_output();
    std::vector<fs::path> replaced;
    for (const fs::path& place : places()) {
      require_place(place, sources());
      if (!identity_of(place)) continue;
      if (no_clobber) throw WriteError(utf8(place) + " exists: not overwritten");
      replaced.push_back(place);
    }
    write();
    for (const fs::path& place : replaced)
      std::fprintf(stderr, "%s: replaced the file that was there\n",
                   printable(utf8(place)).c_str());
  }

 private:
  bool writes_stream() const { return output == kStandardStream; }
  bool writes(const char* extension) const {
    return equals_ignoring_case(utf8(utf8_path(output).extension()), extension);
  }

  /// Throws CLI::ValidationError.
  void check_output() const {
    if (writes_stream() && output_format.empty())
      throw CLI::ValidationError("standard output needs --format, as --format bvh");
    if (!writes_stream() && !output_format.empty())
      throw CLI::ValidationError("--format", "is of standard output: a file's extension says it");
    if (writes_stream() && onto)
      throw CLI::ValidationError("--onto", "writes a file, not standard output");
    if (!writes_stream() && !is_written(utf8(utf8_path(output).extension())))
      throw CLI::ValidationError(output +
                                 ": its extension is none of .bvh, .fbx, .glb, .gltf, .amc, .csv");
    if (onto && !can_be_onto(utf8_path(output), utf8_path(*onto)))
      throw CLI::ValidationError(
          "--onto", "only an .fbx can be written onto an .fbx, and a .glb or .gltf onto a glTF");
    if (inputs.size() > 1 && (!writes(".fbx") || onto))
      throw CLI::ValidationError("several clips go only into an .fbx of their own, a take each");
  }

  static bool is_written(const std::string& extension) {
    constexpr std::array kWritten = {".bvh", ".fbx", ".glb", ".gltf", ".amc", ".csv"};
    return std::ranges::any_of(
        kWritten, [&](const char* known) { return equals_ignoring_case(extension, known); });
  }

  std::vector<fs::path> sources() const {
    std::vector<fs::path> files = utf8_paths(inputs);
    if (onto) files.push_back(utf8_path(*onto));
    return files;
  }

  /// The paths of the output files.
  std::vector<fs::path> places() const {
    if (writes_stream()) return {};
    std::vector<fs::path> files = {utf8_path(output)};
    if (writes(".amc"))
      files.push_back(skeleton_output ? utf8_path(*skeleton_output)
                                      : utf8_path(output).replace_extension(".asf"));
    return files;
  }

  /// With --no-clobber, refuses to replace even a file that appeared after run() checked.
  StagedFile::Existing existing() const {
    return no_clobber ? StagedFile::Existing::Refuse : StagedFile::Existing::Replace;
  }

  struct Read {
    Motion motion;
    SourceFormat source;
    ScalarTracks tracks;
  };

  /// Reads a whole file, or its first tiers. Throws InputError.
  Read read(const std::string& input) const {
    try {
      return naming_what_takes_memory(input, [&] {
        std::vector<std::byte> file = read_bytes(utf8_path(input));
        if (tiers > 0) file = file_of_tiers(file, tiers);
        OpenedMcpr opened = read_mcpr(file);
        return Read{{std::move(opened.compressed.skeleton), std::move(opened.decoded)},
                    source_of(file),
                    tracks_of(file)};
      });
    } catch (const FormatError& error) {
      throw InputError(input, 0, 0, error.what());
    }
  }

  void write() const {
    if (inputs.size() > 1) return write_together();
    const auto [motion, source, tracks] = read(inputs.front());
    if (writes_stream())
      write_standard_output(
          motion_bytes("standard output." + output_format, motion, source, target.options, tracks));
    else if (onto)
      write_motion_onto(utf8_path(output), motion, utf8_path(*onto), source, target.options, tracks,
                        existing());
    else
      print_warnings(write_motion(utf8_path(output), motion, utf8_path_if(skeleton_output), source,
                                  target.options, tracks, existing()));
  }

  /// Writes one file with a take for each clip, named after the clip's file. All takes use the
  /// nodes of the first clip, so the clips must list the same joints in the same order.
  void write_together() const {
    std::vector<Read> read;
    for (const std::string& input : inputs) {
      read.push_back(this->read(input));
      if (!lists_the_same_joints(read.back().motion.skeleton, read.front().motion.skeleton))
        throw InputError(input, 0, 0,
                         "has other joints than " + inputs.front() +
                             ", or another order of them: only clips of one rig go into one file");
    }
    std::vector<FbxClip> clips;
    std::unordered_set<std::string> names;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      clips.push_back(
          {unique_word(utf8(utf8_path(inputs[i]).stem()), names), read[i].motion, read[i].tracks});
    write_takes(utf8_path(output), clips, read.front().source, target.options, existing());
  }
};

}  // namespace

void add_decompress(CLI::App& app) {
  CLI::App* command = app.add_subcommand("decompress", "Turn a .mcpr back into a motion file");
  const auto call = std::make_shared<Decompress>();
  command
      ->add_option("input", call->inputs,
                   "A .mcpr file. An .fbx can hold several of one rig, each as a take with the "
                   "name of its file")
      ->required()
      ->type_name("IN.mcpr...");
  command
      ->add_option("-o,--output", call->output,
                   "File to write; its extension sets the format (.bvh, .fbx, .glb, .gltf, .amc or "
                   ".csv). - for standard output")
      ->required()
      ->type_name("OUT");
  command->add_option("--format", call->output_format, "Format of a clip on standard output")
      ->check(CLI::IsMember({"bvh", "fbx", "glb", "gltf", "csv"}));
  command->add_flag("--no-clobber", call->no_clobber, "Fail instead of replacing an existing file");
  command
      ->add_option("--skeleton-out", call->skeleton_output,
                   "Skeleton file to write with an .amc [OUT with the extension .asf]")
      ->type_name("S.asf");
  command
      ->add_option("--onto", call->onto,
                   "Source of the clip (.fbx, .glb or .gltf): OUT is a copy of it, with meshes and "
                   "all else, whose animation is this motion")
      ->type_name("SOURCE");
  command
      ->add_option("--take", call->target.options.take,
                   "Name or number of the animation of SOURCE to replace [the first that moves]")
      ->type_name("TAKE");
  command
      ->add_option("--tiers", call->tiers,
                   "Decode only the first tiers of a file that was written with some [all]")
      ->check(CLI::Range(1, runtime::kMostTiers));
  call->target.add_options(*command);
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
