// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/contacts.h"
#include "app/cli/motion_input.h"
#include "app/cli/report.h"
#include "core/base/file.h"
#include "core/baselines/compared_file.h"

namespace mocapress::cli {
namespace {

struct Measure {
  std::string original;
  std::string compressed;
  MotionInput source;
  ContactInput contact_input;
  bool json = false;

  void run() const {
    const MotionFile file = source.read_file(original);
    const Motion& motion = file.motion;
    const OpenedMcpr opened = open_mcpr(compressed);
    const Clip& decoded = opened.decoded;
    if (decoded.channels.rows() != motion.clip.channels.rows() ||
        decoded.channels.cols() != motion.clip.channels.cols())
      throw InputError(compressed, 0, 0,
                       "is not a compressed form of " + original + ": it has " +
                           std::to_string(decoded.frames()) + " frames of " +
                           std::to_string(decoded.channels.cols()) + " channels, the original " +
                           std::to_string(motion.clip.frames()) + " of " +
                           std::to_string(motion.clip.channels.cols()));
    const Eigen::MatrixXd tracks = body_tracks(motion.skeleton, motion.clip);
    const Eigen::MatrixXd found = body_tracks(motion.skeleton, decoded);
    const std::vector<ContactSpan> contacts = contact_input.spans(motion);
    const Report report{
        .input = original,
        .original = &motion,
        .loop = opened.compressed.loop,
        .method = opened.method,
        .weighting = opened.compressed.provenance.weighting,
        .coding = opened.coding(),
        .motion_bytes = opened.compressed.motion_bytes(),
        .file_bytes = std::filesystem::file_size(compressed),
        .verified_by = "library",
        .distortion = mocapress::measure(motion.skeleton, tracks, found),
        .footskate = measure_footskate(contacts, tracks, found, decoded.sample_rate_hz),
        .visibility =
            measure_visibility(motion.skeleton, tracks, found, decoded.sample_rate_hz, contacts),
        .contacts = contacts.size(),
        .correction_bytes = opened.compressed.correction
                                ? std::optional(opened.compressed.correction_bytes())
                                : std::nullopt,
        .tracks = track_figures(file.tracks, read_bytes(compressed))};
    json ? print(to_json(report)) : print(report);
  }
};

}  // namespace

void add_measure(CLI::App& app) {
  CLI::App* command = app.add_subcommand("measure", "Compare a .mcpr with its original");
  const auto call = std::make_shared<Measure>();
  command->add_option("original", call->original, "A .bvh, .amc, .fbx, .gltf or .glb file")
      ->required()
      ->type_name("ORIGINAL");
  command->add_option("compressed", call->compressed, "A .mcpr file")
      ->required()
      ->type_name("COMPRESSED");
  call->source.add_options(*command);
  call->contact_input.add_options(*command);
  command->add_flag("--json", call->json, "Print one JSON object");
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
