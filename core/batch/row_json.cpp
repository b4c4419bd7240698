// SPDX-License-Identifier: MIT
#include <cmath>

#include "core/base/error.h"
#include "core/batch/format_options_json.h"
#include "core/batch/row.h"
#include "core/mocapress/settings_json.h"
#include "core/report/body_json.h"

namespace mocapress {
namespace {

constexpr double kUnit = 100;  // of a pose's numbers in a cm

void add_measurement(Json& json, const BatchRow& row) {
  const Measurement none;
  const Measurement& m = row.measured ? *row.measured : none;
  const double joint_samples = std::max(1.0, static_cast<double>(m.frames) * row.joints);
  const auto add = [&](const char* key, Json value) {
    json[key] = row.measured ? std::move(value) : Json();
  };
  add("frames", m.frames);
  add("channels", m.channels);
  add("joints", row.joints);
  add("sample_rate_hz", m.sample_rate_hz);
  add("raw_bytes", m.raw_bytes);
  add("motion_bytes", m.motion_bytes);
  add("file_bytes", m.file_bytes);
  add("ratio", m.ratio);
  add("bits_per_joint_sample", 8.0 * static_cast<double>(m.motion_bytes) / joint_samples);
  add("coefficient_ratio", or_null(m.coefficient_ratio));
  add("eps_x_cm", m.eps_cm(row.preset.weighting));
  add("eps_x_bone_ends_cm", m.eps_bone_ends_cm);
  add("eps_x_joint_origins_cm", m.eps_joint_origins_cm);
  add("max_error_cm", m.max_error_cm);
  add("p95_error_cm", m.p95_error_cm);
  add("p99_error_cm", m.p99_error_cm);
  add_body_figures(m.body, add);
  add_seen(m.seen, add);
  add("worst_frame", m.worst_frame);
  add("worst_point", row.worst ? Json(row.worst->landmark) : Json());
  add("contacts", m.contacts);
  add("footskate_cm", or_null(m.footskate_cm));
  add("ik_ratio_used", or_null(m.ik_ratio_used));
  add("footskate_mean_cm", m.slide ? Json(m.slide->mean_cm) : Json());
  add("footskate_worst_cm", m.slide ? Json(m.slide->worst_cm) : Json());
  add("ik_bytes", or_null(m.ik_bytes));
  add("knee_speed_ratio", or_null(m.knee_speed_ratio));
  add("iterations", or_null(m.iterations));
  add("verified_by", row.verified_by);
}

Measurement measurement_from(const Json& json) {
  Measurement m;
  json.at("frames").get_to(m.frames);
  json.at("channels").get_to(m.channels);
  json.at("sample_rate_hz").get_to(m.sample_rate_hz);
  json.at("raw_bytes").get_to(m.raw_bytes);
  json.at("motion_bytes").get_to(m.motion_bytes);
  json.at("file_bytes").get_to(m.file_bytes);
  json.at("ratio").get_to(m.ratio);
  m.coefficient_ratio = optional_at<double>(json, "coefficient_ratio");
  json.at("eps_x_bone_ends_cm").get_to(m.eps_bone_ends_cm);
  json.at("eps_x_joint_origins_cm").get_to(m.eps_joint_origins_cm);
  json.at("max_error_cm").get_to(m.max_error_cm);
  json.at("p95_error_cm").get_to(m.p95_error_cm);
  json.at("p99_error_cm").get_to(m.p99_error_cm);
  m.body = body_figures_of(json);
  m.seen = seen_of(json);
  json.at("worst_frame").get_to(m.worst_frame);
  json.at("contacts").get_to(m.contacts);
  m.footskate_cm = optional_at<double>(json, "footskate_cm");
  m.ik_ratio_used = optional_at<double>(json, "ik_ratio_used");
  if (const auto mean_cm = optional_at<double>(json, "footskate_mean_cm"))
    m.slide = {*mean_cm, json.at("footskate_worst_cm").get<double>()};
  m.ik_bytes = optional_at<std::size_t>(json, "ik_bytes");
  m.knee_speed_ratio = optional_at<double>(json, "knee_speed_ratio");
  m.iterations = optional_at<int>(json, "iterations");
  return m;
}

Json report_json(const BatchRow& row) {
  const Settings& preset = row.preset;
  Json json = {{"input", row.input},
               {"output", row.output},
               {"done", row.done()},
               {"preset", preset.name},
               {"method", preset.method},
               {"target", name(preset.target.kind)},
               {"target_value", preset.target.value},
               {"weighting", name(preset.weighting)},
               {"coding", coding_of(preset) ? Json(name(*coding_of(preset))) : Json()},
               {"seed", preset.seed},
               {"ik_ratio", Json()}};
  if (preset.correction)
    json["ik_ratio"] = preset.correction->ratio ? Json(*preset.correction->ratio) : Json("auto");
  add_measurement(json, row);
  json["files"] = Json::array();
  for (const WrittenFile& file : row.files) json["files"].push_back(file.name);
  json["warnings"] = row.warnings;
  json["verdict"] = text_or_null(name(row.review.verdict));
  json["note"] = text_or_null(row.review.note);
  json["error"] = text_or_null(row.error);
  return json;
}

Json points_json(const PosePoints& points) {
  Json numbers = Json::array();
  for (const Eigen::Vector3d& point : points)
    for (const double cm : point) numbers.push_back(std::llround(kUnit * cm));
  return numbers;
}

PosePoints points_from(const Json& numbers) {
  PosePoints points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    points.emplace_back(numbers.at(i).get<double>() / kUnit,
                        numbers.at(i + 1).get<double>() / kUnit,
                        numbers.at(i + 2).get<double>() / kUnit);
  return points;
}

Json to_json(const WorstPose& pose) {
  Json bones = Json::array();
  for (const DrawnBone& bone : pose.bones)
    bones.push_back({bone.from, bone.to, std::llround(kUnit * bone.from_radius),
                     std::llround(kUnit * bone.to_radius)});
  return {{"frame", pose.frame},
          {"landmark", pose.landmark},
          {"point", pose.point},
          {"off_cm", pose.off_cm},
          {"ground_cm", pose.ground_cm},
          {"facing", {pose.facing.x(), pose.facing.y(), pose.facing.z()}},
          {"bones", bones},
          {"original", points_json(pose.original)},
          {"decoded", points_json(pose.decoded)}};
}

/// A journal may have been edited: what would be drawn from outside the arrays is no pose.
void check(const WorstPose& pose) {
  const auto points = static_cast<int>(pose.original.size());
  const auto is_point = [&](int index) { return index >= 0 && index < points; };
  bool whole = is_point(pose.point) && pose.decoded.size() == pose.original.size();
  for (const DrawnBone& bone : pose.bones)
    whole = whole && is_point(bone.from) && is_point(bone.to);
  if (!whole) throw Error("not a pose");
}

WorstPose pose_from(const Json& json) {
  WorstPose pose;
  json.at("frame").get_to(pose.frame);
  json.at("landmark").get_to(pose.landmark);
  json.at("point").get_to(pose.point);
  json.at("off_cm").get_to(pose.off_cm);
  json.at("ground_cm").get_to(pose.ground_cm);
  for (int axis = 0; axis < 3; ++axis)
    pose.facing[axis] = json.at("facing").at(static_cast<std::size_t>(axis)).get<double>();
  for (const Json& bone : json.at("bones"))
    pose.bones.push_back({bone.at(0).get<int>(), bone.at(1).get<int>(),
                          bone.at(2).get<double>() / kUnit, bone.at(3).get<double>() / kUnit});
  pose.original = points_from(json.at("original"));
  pose.decoded = points_from(json.at("decoded"));
  check(pose);
  return pose;
}

BatchRow row_from(const Json& json) {
  BatchRow row;
  json.at("index").get_to(row.index);
  json.at("input").get_to(row.input);
  json.at("output").get_to(row.output);
  row.preset = preset_from(json.at("settings"));
  for (const Json& format : json.at("formats"))
    if (const auto known = output_format(format.get_ref<const std::string&>()))
      row.formats.push_back(*known);
  row.reading = format_options(json.at("reading"));
  row.writing = format_options(json.at("writing"));
  json.at("stamp").at("bytes").get_to(row.stamp.bytes);
  json.at("stamp").at("newest_ns").get_to(row.stamp.newest_ns);
  json.at("stamp").at("hash").get_to(row.stamp.hash);
  if (!json.at("frames").is_null()) {
    row.measured = measurement_from(json);
    json.at("joints").get_to(row.joints);
    json.at("verified_by").get_to(row.verified_by);
    json.at("encode_seconds").get_to(row.measured->encode_seconds);
  }
  for (const Json& file : json.at("written"))
    row.files.push_back({file.at("name").get<std::string>(), file.at("bytes").get<std::uintmax_t>(),
                         file.at("hash").get<std::string>()});
  json.at("warnings").get_to(row.warnings);
  row.review = {verdict_named(optional_at<std::string>(json, "verdict").value_or("")),
                optional_at<std::string>(json, "note").value_or("")};
  row.error = optional_at<std::string>(json, "error").value_or("");
  for (const Json& line : json.value("sights", Json::array()))
    row.sights.push_back({line.at(0).get<std::string>(), line.at(1).get<std::string>()});
  if (!json.at("worst").is_null()) row.worst = pose_from(json.at("worst"));
  return row;
}

std::string csv_text(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string all;
  for (const Json& one : value) all += (all.empty() ? "" : "; ") + one.get<std::string>();
  return all;
}

std::string csv_field(const Json& value) {
  const std::string text = csv_text(value);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

bool keeps_promise(const Settings& preset, const Measurement& measured) {
  return reached(preset.target, measured.quantity(preset.target.kind, preset.weighting));
}

std::string to_report_line(const BatchRow& row) {
  return dumped(report_json(row));
}

std::string to_journal_line(const BatchRow& row) {
  Json json = report_json(row);
  json["index"] = row.index;
  json["settings"] = to_json(row.preset);
  json["formats"] = Json::array();
  for (const OutputFormat format : row.formats) json["formats"].push_back(name(format));
  put(json["reading"] = Json::object(), row.reading);
  put(json["writing"] = Json::object(), row.writing);
  json["stamp"] = {
      {"bytes", row.stamp.bytes}, {"newest_ns", row.stamp.newest_ns}, {"hash", row.stamp.hash}};
  json["written"] = Json::array();
  for (const WrittenFile& file : row.files)
    json["written"].push_back({{"name", file.name}, {"bytes", file.bytes}, {"hash", file.hash}});
  json["encode_seconds"] = row.measured ? Json(row.measured->encode_seconds) : Json();
  json["worst"] = row.worst ? to_json(*row.worst) : Json();
  json["sights"] = Json::array();
  for (const SightLine& line : row.sights) json["sights"].push_back({line.joint, line.sights});
  return dumped(json);
}

std::optional<BatchRow> parse_batch_row(std::string_view line) {
  try {
    return row_from(Json::parse(line));
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::string csv_head() {
  const Json json = report_json({});
  std::string text;
  for (const auto& [key, value] : json.items()) text += (text.empty() ? "" : ",") + key;
  return text + '\n';
}

std::string to_csv_line(const BatchRow& row) {
  const Json json = report_json(row);
  std::string text;
  for (const auto& [key, value] : json.items())
    text += (key == "input" ? "" : ",") + csv_field(value);
  return text + '\n';
}

}  // namespace mocapress
