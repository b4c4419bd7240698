// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "app/cli/standard_streams.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/file_identity.h"
#include "core/base/staged_file.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/format/source_section.h"
#include "core/codec/methods/compared_file.h"
#include "core/formats/motion_file.h"
#include "core/formats/text_cursor.h"

namespace mocapress::cli {
namespace {

namespace fs = std::filesystem;

struct Decompress {
  std::string input;
  std::string output;
  std::string output_format;  // format of standard output
  std::optional<std::string> skeleton_output;
  std::optional<std::string> onto;
  MotionOutput target;
  bool no_clobber = false;

  void run() const {
    check_output();
    std::vector<fs::path> replaced;
    for (const fs::path& place : places()) {
      refuse_source(place, sources());
      if (!identity_of(place)) continue;
      if (no_clobber) throw WriteError(place.string() + " exists: not overwritten");
      replaced.push_back(place);
    }
    write();
    for (const fs::path& place : replaced)
      std::fprintf(stderr, "%s: replaced the file that was there\n",
                   printable(place.string()).c_str());
  }

 private:
  bool writes_stream() const { return output == kStandardStream; }
  bool is_acclaim() const {
    return equals_ignoring_case(fs::path(output).extension().string(), ".amc");
  }

  /// Throws CLI::ValidationError.
  void check_output() const {
    if (writes_stream() && output_format.empty())
      throw CLI::ValidationError("standard output needs --format, as --format bvh");
    if (!writes_stream() && !output_format.empty())
      throw CLI::ValidationError("--format", "is of standard output: a file's extension says it");
    if (writes_stream() && onto)
      throw CLI::ValidationError("--onto", "writes a file, not standard output");
    if (!writes_stream() && !is_written(fs::path(output).extension().string()))
      throw CLI::ValidationError(output +
                                 ": its extension is none of .bvh, .fbx, .glb, .gltf, .amc, .csv");
  }

  static bool is_written(const std::string& extension) {
    constexpr std::array kWritten = {".bvh", ".fbx", ".glb", ".gltf", ".amc", ".csv"};
    return std::ranges::any_of(
        kWritten, [&](const char* known) { return equals_ignoring_case(extension, known); });
  }

  std::vector<fs::path> sources() const {
    std::vector<fs::path> files = {input};
    if (onto) files.emplace_back(*onto);
    return files;
  }

  /// The paths of the output files.
  std::vector<fs::path> places() const {
    if (writes_stream()) return {};
    std::vector<fs::path> files = {output};
    if (is_acclaim())
      files.push_back(skeleton_output ? fs::path(*skeleton_output)
                                      : fs::path(output).replace_extension(".asf"));
    return files;
  }

  void write() const {
    const OpenedMcpr opened = open_mcpr(input);
    const Motion motion{opened.compressed.skeleton, opened.decoded};
    const SourceFormat source = load_source(input);
    const ScalarTracks tracks = tracks_of(read_bytes(input));
    // Also refuses a file that appeared after run() looked.
    const auto existing = no_clobber ? StagedFile::Existing::Refuse : StagedFile::Existing::Replace;
    if (writes_stream())
      write_standard_output(
          motion_bytes("standard output." + output_format, motion, source, target.options, tracks));
    else if (onto)
      write_motion_onto(output, motion, *onto, source, target.options, tracks, existing);
    else
      print_warnings(
          write_motion(output, motion, skeleton_output, source, target.options, tracks, existing));
  }
};

}  // namespace

void add_decompress(CLI::App& app) {
  CLI::App* command = app.add_subcommand("decompress", "Turn a .mcpr back into a motion file");
  const auto call = std::make_shared<Decompress>();
  command->add_option("input", call->input, "A .mcpr file")->required()->type_name("IN.mcpr");
  command
      ->add_option("-o,--output", call->output,
                   "A .bvh, .fbx, .glb, .gltf, .amc or .csv file, by its extension; - is standard "
                   "output")
      ->required()
      ->type_name("OUT");
  command->add_option("--format", call->output_format, "Format of standard output")
      ->check(CLI::IsMember({"bvh", "fbx", "glb", "gltf", "csv"}));
  command->add_flag("--no-clobber", call->no_clobber, "Replace no file that is there");
  command->add_option("--skeleton-out", call->skeleton_output, "The .asf that goes with an .amc")
      ->type_name("S.asf");
  command
      ->add_option(
          "--onto", call->onto,
          "The .fbx, .glb or .gltf it came from: written with this motion, its meshes kept")
      ->type_name("SOURCE");
  command
      ->add_option("--take", call->target.options.take,
                   "Its animation to replace, by name or number [the first that moves]")
      ->type_name("TAKE");
  call->target.add_options(*command);
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
