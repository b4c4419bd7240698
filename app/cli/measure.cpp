// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/contacts.h"
#include "app/cli/motion_input.h"
#include "app/cli/report.h"
#include "app/cli/sight_arguments.h"
#include "core/base/file.h"
#include "core/base/utf8_path.h"
#include "core/codec/methods/compared_file.h"
#include "core/motion/body_tracks.h"

namespace mocapress::cli {
namespace {

struct Measure {
  std::string original;
  std::string compressed;
  MotionInput source;
  ContactInput contact_input;
  SightArguments sight;
  bool json = false;

  void run() const {
    const MotionFile file = source.read_file(original);
    const Motion& motion = file.motion;
    const OpenedMcpr opened = open_mcpr(utf8_path(compressed));
    const std::vector<std::byte> bytes = read_bytes(utf8_path(compressed));
    const std::vector<ContactSpan> contacts = contact_input.spans(motion);
    const Comparison found = compared(motion, opened.decoded, contacts, sight.read());
    const Report report{
        .input = original,
        .original = &motion,
        .loop = opened.compressed.loop,
        .method = opened.method,
        .weighting = opened.compressed.provenance.weighting,
        .coding = opened.coding(),
        .motion_bytes = opened.compressed.motion_bytes(),
        .file_bytes = bytes.size(),
        .verified_by = "library",
        .distortion = found.distortion,
        .footskate = found.footskate,
        .visibility = found.visibility,
        .contacts = contacts.size(),
        .correction_bytes = opened.compressed.correction
                                ? std::optional(opened.compressed.correction_bytes())
                                : std::nullopt,
        .tracks = track_figures(file.tracks, bytes)};
    json ? print(to_json(report)) : print(report);
  }

  Comparison compared(const Motion& motion, const Clip& decoded,
                      const std::vector<ContactSpan>& contacts, const SightLimits& limits) const {
    try {
      return compare(motion, body_tracks(motion.skeleton, motion.clip), decoded, contacts, limits);
    } catch (const Error& error) {
      throw InputError(compressed, 0, 0, error.what());
    }
  }
};

}  // namespace

void add_measure(CLI::App& app) {
  CLI::App* command = app.add_subcommand("measure", "Compare a .mcpr with its original");
  const auto call = std::make_shared<Measure>();
  command->add_option("original", call->original, "Original clip (.bvh, .amc, .fbx, .gltf or .glb)")
      ->required()
      ->type_name("ORIGINAL");
  command->add_option("compressed", call->compressed, "The same clip compressed (.mcpr)")
      ->required()
      ->type_name("COMPRESSED");
  call->source.add_options(*command);
  call->source.add_character_option(*command);
  call->source.add_tracks_option(*command);
  call->contact_input.add_options(*command);
  call->sight.add_options(*command, "else 5");
  command->add_flag("--json", call->json, "Print one JSON object");
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
