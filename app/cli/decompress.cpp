// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "core/base/file.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/format/source_section.h"
#include "core/codec/methods/compared_file.h"
#include "core/formats/motion_file.h"

namespace mocapress::cli {

void add_decompress(CLI::App& app) {
  struct Decompress {
    std::string input;
    std::string output;
    std::optional<std::string> skeleton_output;
    std::optional<std::string> onto;
    MotionOutput target;
  };
  CLI::App* command = app.add_subcommand("decompress", "Turn a .mcpr back into a motion file");
  const auto call = std::make_shared<Decompress>();
  command->add_option("input", call->input, "A .mcpr file")->required()->type_name("IN.mcpr");
  command
      ->add_option("-o,--output", call->output,
                   "A .bvh, .glb, .gltf, .amc or .csv file, by its extension")
      ->required()
      ->type_name("OUT");
  command->add_option("--skeleton-out", call->skeleton_output, "The .asf that goes with an .amc")
      ->type_name("S.asf");
  command
      ->add_option("--onto", call->onto,
                   "The .glb or .gltf it came from: written with this motion, its meshes kept")
      ->type_name("SOURCE");
  command
      ->add_option("--take", call->target.options.take,
                   "Its animation to replace, by name or number [the first that moves]")
      ->type_name("TAKE");
  call->target.add_options(*command);
  command->callback([call] {
    const OpenedMcpr opened = open_mcpr(call->input);
    const Motion motion{opened.compressed.skeleton, opened.decoded};
    const SourceFormat source = load_source(call->input);
    const ScalarTracks tracks = tracks_of(read_bytes(call->input));
    if (call->onto)
      write_motion_onto(call->output, motion, *call->onto, source, call->target.options, tracks);
    else
      print_warnings(write_motion(call->output, motion, call->skeleton_output, source,
                                  call->target.options, tracks));
  });
}

}  // namespace mocapress::cli
