// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/contact_input.h"
#include "app/cli/motion_input.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number_text.h"
#include "core/baselines/compared_file.h"
#include "core/feet/footskate.h"

namespace mocapress::cli {
namespace {

struct Contacts {
  std::string clip;
  std::optional<std::string> compressed;
  MotionInput source;
  ContactInput contacts;
  std::optional<std::string> output;
  bool json = false;

  void run() const {
    const Motion motion = source.read(clip);
    const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
    const std::vector<ContactSpan> spans = contacts.spans(motion);
    Json all = contacts_json(motion.skeleton, spans);
    if (output) write_text(*output, all.dump(2) + "\n");
    if (compressed) add_findings(all, spans, tracks, motion);
    json ? print(all) : print_lines(all);
  }

  /// What slid in each contact; 0 where the decoded foot slid no further than the original.
  void add_findings(Json& all, const std::vector<ContactSpan>& spans, const Eigen::MatrixXd& tracks,
                    const Motion& motion) const {
    const Clip decoded = open_mcpr(*compressed).decoded;
    if (decoded.frames() != motion.clip.frames() ||
        decoded.channels.cols() != motion.clip.channels.cols())
      throw InputError(*compressed, 0, 0, "is not a compressed form of " + clip);
    const Footskate footskate = measure_footskate(
        spans, tracks, landmark_tracks(motion.skeleton, decoded), decoded.sample_rate_hz);
    for (Json& one : all) one["slid_cm"] = 0;
    for (const SlideFinding& finding : footskate.findings)
      for (std::size_t i = 0; i < spans.size(); ++i) {
        if (spans[i] != finding.span) continue;
        all[i]["slid_cm"] = finding.slid_cm;
        all[i]["worst_speed_cm_s"] = finding.worst_speed_cm_s;
        all[i]["worst_frame"] = finding.worst_frame;
      }
  }

  static void print_lines(const Json& all) {
    for (const Json& one : all) {
      std::fprintf(stderr, "%-16s frames %5d to %5d", one["joint"].get<std::string>().c_str(),
                   one["first_frame"].get<int>(), one["last_frame"].get<int>());
      if (one.contains("worst_frame"))
        std::fprintf(stderr, "  slid %s cm, %s cm/s at frame %d",
                     fixed_text(one["slid_cm"].get<double>(), 2).c_str(),
                     fixed_text(one["worst_speed_cm_s"].get<double>(), 0).c_str(),
                     one["worst_frame"].get<int>());
      std::fputc('\n', stderr);
    }
    if (all.empty()) std::fprintf(stderr, "no foot stands on the ground\n");
  }
};

}  // namespace

void add_contacts(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "contacts", "Say when the feet of a clip stand, and how far they slide in its .mcpr");
  const auto call = std::make_shared<Contacts>();
  command->add_option("clip", call->clip, "A .bvh, .amc, .fbx, .gltf or .glb file")
      ->required()
      ->type_name("CLIP");
  command->add_option("compressed", call->compressed, "Its .mcpr")->type_name("COMPRESSED");
  call->source.add_options(*command);
  call->contacts.add_options(*command);
  command
      ->add_option("-o,--output", call->output,
                   "Write the contacts to a file, to be edited for --contacts")
      ->type_name("OUT.json");
  command->add_flag("--json", call->json, "Print one JSON array");
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
