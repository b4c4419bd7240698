// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/contact_input.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/motion/landmarks.h"

namespace mocapress::cli {
namespace {

/// The place in landmarks(skeleton), or -1.
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
      span.last_frame >= motion.clip.frames())
    throw Error("frames " + std::to_string(span.first_frame) + " to " +
                std::to_string(span.last_frame) + " are not a span of the clip");
  return span;
}

std::vector<ContactSpan> read_contacts(const std::string& path, const Motion& motion) {
  const std::string text = read_text(path);
  const std::vector<Landmark> points = landmarks(motion.skeleton);
  std::vector<ContactSpan> spans;
  try {
    const Json json = Json::parse(text);
    if (!json.is_array()) throw Error("not an array of contacts");
    for (const Json& one : json) spans.push_back(span_from(one, motion, points));
  } catch (const Json::parse_error& error) {
    throw InputError(path, 0, 0, "not JSON from byte " + std::to_string(error.byte) + " on");
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
        ->check(CLI::PositiveNumber)
        ->type_name(unit);
  };
  CLI::Option* of_height =
      add("--contact-height", height, "BEGIN,END",
          "A contact begins below BEGIN and ends above END, cm over the foot's lowest [2.5,4]");
  CLI::Option* of_speed = add("--contact-speed", speed, "BEGIN,END",
                              "A contact begins below BEGIN and ends above END, cm/s [30,50]");
  command.add_option("--contacts", file, "Take contacts from this file, as `contacts` writes it")
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

}  // namespace mocapress::cli
