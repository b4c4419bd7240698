// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "core/baselines/compared_file.h"
#include "core/codec/format/source_section.h"
#include "core/formats/motion_file.h"

namespace mocapress::cli {

void add_decompress(CLI::App& app) {
  struct Decompress {
    std::string input;
    std::string output;
    std::optional<std::string> skeleton_output;
    MotionOutput target;
  };
  CLI::App* command = app.add_subcommand("decompress", "Turn a .mcpr back into a motion file");
  const auto call = std::make_shared<Decompress>();
  command->add_option("input", call->input, "A .mcpr file")->required()->type_name("IN.mcpr");
  command->add_option("-o,--output", call->output, "A .bvh, .amc or .csv file, by its extension")
      ->required()
      ->type_name("OUT");
  command->add_option("--skeleton-out", call->skeleton_output, "The .asf that goes with an .amc")
      ->type_name("S.asf");
  call->target.add_options(*command);
  command->callback([call] {
    const OpenedMcpr opened = open_mcpr(call->input);
    write_motion(call->output, {opened.compressed.skeleton, opened.decoded}, call->skeleton_output,
                 load_source(call->input), call->target.options);
  });
}

}  // namespace mocapress::cli
