// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/contacts.h"

#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "app/cli/option_words.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/file_identity.h"
#include "core/base/frame_text.h"
#include "core/base/number_text.h"
#include "core/base/utf8_path.h"
#include "core/codec/methods/compared_file.h"
#include "core/feet/footskate.h"
#include "core/metrics/comparison.h"
#include "core/motion/landmarks.h"

namespace mocapress::cli {

namespace {

/// Index in landmarks(skeleton), or -1.
int find_landmark(const std::vector<Landmark>& points, const std::string& name) {
  const auto found = std::find_if(points.begin(), points.end(),
                                  [&](const Landmark& point) { return point.name == name; });
  return found == points.end() ? -1 : static_cast<int>(found - points.begin());
}

ContactSpan span_from(const Json& json, const Motion& motion, const std::vector<Landmark>& points) {
  const auto joint = json.at("joint").get<std::string>();
  const ContactSpan span{find_landmark(points, joint), json.at("first_frame").get<int>(),
                         json.at("last_frame").get<int>()};
  if (span.landmark < 0) throw Error("the skeleton has no joint named " + joint);
  if (span.first_frame < 0 || span.last_frame < span.first_frame ||
      span.last_frame >= motion.clip.frames())  // the message counts from 0, as the file does
    throw Error("first_frame " + std::to_string(span.first_frame) + " and last_frame " +
                std::to_string(span.last_frame) +
                " are not a span of the clip, whose frames are 0 to " +
                std::to_string(motion.clip.frames() - 1));
  return span;
}

std::vector<ContactSpan> read_contacts(const std::string& path, const Motion& motion) {
  const std::vector<Landmark> points = landmarks(motion.skeleton);
  const Json json = parse_json(path, read_text(utf8_path(path)));
  std::vector<ContactSpan> spans;
  try {
    if (!json.is_array()) throw Error("not an array of contacts");
    for (const Json& one : json) spans.push_back(span_from(one, motion, points));
  } catch (const Json::exception&) {
    throw InputError(path, 0, 0,
                     "contact " + std::to_string(spans.size() + 1) +
                         " lacks a joint, first_frame or last_frame");
  } catch (const Error& error) {
    throw InputError(path, 0, 0,
                     "contact " + std::to_string(spans.size() + 1) + ": " + error.what());
  }
  return spans;
}

}  // namespace

void ContactInput::add_options(CLI::App& command) {
  const auto add = [&](const char* flag, std::vector<double>& values, const char* unit,
                       const char* help) {
    return command.add_option(flag, values, help)
        ->delimiter(',')
        ->expected(2)
        ->check(number_above_0())
        ->type_name(unit);
  };
  CLI::Option* of_height = add("--contact-height", height, "BEGIN,END",
                               "Heights in cm above the foot's lowest point: a contact begins "
                               "below BEGIN and ends above END [2.5,4]");
  CLI::Option* of_speed =
      add("--contact-speed", speed, "BEGIN,END",
          "Speeds in cm/s: a contact begins below BEGIN and ends above END [30,50]");
  command
      .add_option("--contacts", file,
                  "Contacts to use, from a file that the contacts command has written")
      ->type_name("FILE.json")
      ->excludes(of_height)
      ->excludes(of_speed);
}

std::vector<ContactSpan> ContactInput::spans(const Motion& motion) const {
  if (file) return read_contacts(*file, motion);
  ContactSettings settings;
  if (!height.empty()) settings.begin_height = height[0], settings.end_height = height[1];
  if (!speed.empty()) settings.begin_speed = speed[0], settings.end_speed = speed[1];
  return find_foot_contacts(motion, settings);
}

Json contacts_json(const Skeleton& skeleton, const std::vector<ContactSpan>& contacts) {
  const std::vector<Landmark> points = landmarks(skeleton);
  Json all = Json::array();
  for (const ContactSpan& span : contacts)
    all.push_back({{"joint", points[static_cast<std::size_t>(span.landmark)].name},
                   {"first_frame", span.first_frame},
                   {"last_frame", span.last_frame}});
  return all;
}

namespace {

struct Contacts {
  std::string clip;
  std::optional<std::string> compressed;
  MotionInput source;
  ContactInput contacts;
  std::optional<std::string> output;
  bool json = false;

  void run() const {
    if (output) refuse_source(utf8_path(*output), sources());
    const Motion motion = source.read(clip);
    const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
    const std::vector<ContactSpan> spans = contacts.spans(motion);
    Json all = contacts_json(motion.skeleton, spans);
    if (output) write_text(utf8_path(*output), dumped(all, 2) + "\n");
    if (compressed) add_findings(all, spans, tracks, motion);
    json ? print(all) : print_lines(all);
  }

  std::vector<std::filesystem::path> sources() const {
    std::vector<std::filesystem::path> files = source.files(clip);
    if (compressed) files.push_back(utf8_path(*compressed));
    if (contacts.file) files.push_back(utf8_path(*contacts.file));
    return files;
  }

  /// Adds the slide of each contact; 0 if the decoded foot slid no further than the original.
  void add_findings(Json& all, const std::vector<ContactSpan>& spans, const Eigen::MatrixXd& tracks,
                    const Motion& motion) const {
    const Clip decoded = open_mcpr(utf8_path(*compressed)).decoded;
    try {
      require_same_shape(motion.clip, decoded);
    } catch (const Error& error) {
      throw InputError(*compressed, 0, 0, error.what());
    }
    const Footskate footskate = measure_footskate(
        spans, tracks, landmark_tracks(motion.skeleton, decoded), decoded.sample_rate_hz);
    for (Json& one : all) one["slid_cm"] = 0;
    for (const SlideFinding& finding : footskate.findings)
      for (std::size_t i = 0; i < spans.size(); ++i) {
        if (spans[i] != finding.span) continue;
        all[i]["slid_cm"] = finding.slid_cm;
        all[i]["drift_cm"] = finding.drift_cm;
        all[i]["worst_speed_cm_s"] = finding.worst_speed_cm_s;
        all[i]["worst_frame"] = finding.worst_frame;
      }
  }

  static void print_lines(const Json& all) {
    for (const Json& one : all) {
      std::printf("%-16s frames %5s to %5s", printable(one["joint"].get<std::string>()).c_str(),
                  frame_text(one["first_frame"].get<int>()).c_str(),
                  frame_text(one["last_frame"].get<int>()).c_str());
      if (one.contains("worst_frame"))
        std::printf("  slid %s cm, drifted %s cm, %s cm/s at frame %s",
                    fixed_text(one["slid_cm"].get<double>(), 2).c_str(),
                    fixed_text(one["drift_cm"].get<double>(), 2).c_str(),
                    fixed_text(one["worst_speed_cm_s"].get<double>(), 0).c_str(),
                    frame_text(one["worst_frame"].get<int>()).c_str());
      std::putchar('\n');
    }
    if (all.empty()) std::fprintf(stderr, "no foot stands on the ground\n");
  }
};

}  // namespace

void add_contacts(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "contacts", "List when the feet of a clip stand, and how far they slide in its .mcpr");
  const auto call = std::make_shared<Contacts>();
  command->add_option("clip", call->clip, "Original clip (.bvh, .amc, .fbx, .gltf or .glb)")
      ->required()
      ->type_name("CLIP");
  command->add_option("compressed", call->compressed, "The same clip compressed (.mcpr)")
      ->type_name("COMPRESSED");
  call->source.add_options(*command);
  call->contacts.add_options(*command);
  command
      ->add_option("-o,--output", call->output,
                   "Write the contacts to a file that can be edited and given to --contacts")
      ->type_name("OUT.json");
  command->add_flag("--json", call->json, "Print one JSON array");
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
