// SPDX-License-Identifier: MIT
#include "core/study/row_json.h"

#include "core/report/body_json.h"
#include "core/study/plan.h"

namespace mocapress {
namespace {

/// The one of `values` whose name() the text is. Throws like the JSON library does.
template <typename Enum>
Enum value_named(const Json& text, std::initializer_list<Enum> values) {
  for (const Enum value : values)
    if (name(value) == text.get_ref<const std::string&>()) return value;
  throw Json::other_error::create(501, "unknown word", &text);
}

/// The columns of a measurement, all of them null without one.
void add_measurement(Json& json, const StudyRow& row) {
  const Measurement none;
  const Measurement& m = row.measured ? *row.measured : none;
  const auto add = [&](const char* key, Json value) {
    json[key] = row.measured ? std::move(value) : Json();
  };
  add("reached", row.reached());
  add("frames", m.frames);
  add("channels", m.channels);
  add("sample_rate_hz", m.sample_rate_hz);
  add("raw_bytes", m.raw_bytes);
  add("motion_bytes", m.motion_bytes);
  add("file_bytes", m.file_bytes);
  add("ratio", m.ratio);
  add("coefficient_ratio", or_null(m.coefficient_ratio));
  add("eps_x_cm", m.eps_cm(row.weighting));
  add("eps_x_bone_ends_cm", m.eps_bone_ends_cm);
  add("eps_x_joint_origins_cm", m.eps_joint_origins_cm);
  add("max_error_cm", m.max_error_cm);
  add("p95_error_cm", m.p95_error_cm);
  add("p99_error_cm", m.p99_error_cm);
  add_body_figures(m.body, add);
  add_seen(m.seen, add);
  add("worst_frame", m.worst_frame);
  add("contacts", m.contacts);
  add("footskate_cm", or_null(m.footskate_cm));
  add("footskate_mean_cm", m.slide ? Json(m.slide->mean_cm) : Json());
  add("footskate_worst_cm", m.slide ? Json(m.slide->worst_cm) : Json());
  add("ik_bytes", or_null(m.ik_bytes));
  add("knee_speed_ratio", or_null(m.knee_speed_ratio));
  add("iterations", or_null(m.iterations));
  add("encode_seconds", m.encode_seconds);
  add("ms_per_frame", m.ms_per_frame());
}

Json to_json(const StudyRow& row) {
  Json json = {{"clip", row.clip},
               {"fingerprint", row.fingerprint},
               {"method", row.method},
               {"target", name(row.target.kind)},
               {"target_value", row.target.value},
               {"weighting", name(row.weighting)},
               {"coding", row.coding ? Json(name(*row.coding)) : Json()},
               {"seed", row.seed},
               {"ik_ratio", or_null(row.ik_ratio)},
               {"jobs", row.jobs}};
  add_measurement(json, row);
  json["verdict"] = text_or_null(name(row.review.verdict));
  json["note"] = text_or_null(row.review.note);
  json["error"] = text_or_null(row.error);
  return json;
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
  if (const auto mean_cm = optional_at<double>(json, "footskate_mean_cm"))
    m.slide = {*mean_cm, json.at("footskate_worst_cm").get<double>()};
  m.ik_bytes = optional_at<std::size_t>(json, "ik_bytes");
  m.knee_speed_ratio = optional_at<double>(json, "knee_speed_ratio");
  m.iterations = optional_at<int>(json, "iterations");
  json.at("encode_seconds").get_to(m.encode_seconds);
  return m;
}

StudyRow row_from(const Json& json) {
  StudyRow row;
  json.at("clip").get_to(row.clip);
  json.at("fingerprint").get_to(row.fingerprint);
  json.at("method").get_to(row.method);
  const auto kind = target_kind(json.at("target").get_ref<const std::string&>());
  if (!kind) throw Json::other_error::create(501, "unknown target", &json);
  row.target = {*kind, json.at("target_value").get<double>()};
  row.weighting = value_named(json.at("weighting"), kWeightings);
  row.coding.reset();
  if (!json.at("coding").is_null())
    row.coding = value_named(json.at("coding"), {Coding::Rle16, Coding::Deflate, Coding::Adaptive});
  json.at("seed").get_to(row.seed);
  row.ik_ratio = optional_at<double>(json, "ik_ratio");
  json.at("jobs").get_to(row.jobs);
  row.review = {verdict_named(optional_at<std::string>(json, "verdict").value_or("")),
                optional_at<std::string>(json, "note").value_or("")};
  row.error = optional_at<std::string>(json, "error").value_or("");
  if (!json.at("frames").is_null()) row.measured = measurement_from(json);
  return row;
}

/// File names and messages may hold anything: what is not UTF-8 is replaced.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string csv_field(const Json& value) {
  if (value.is_null()) return "";
  if (!value.is_string()) return value.dump();
  const std::string& text = value.get_ref<const std::string&>();
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

std::string to_json_line(const StudyRow& row) {
  return dumped(to_json(row));
}

std::optional<StudyRow> parse_row(std::string_view line) {
  try {
    return row_from(Json::parse(line));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string rows_json(std::span<const StudyRow> rows) {
  std::string text = "[";
  for (const StudyRow& row : rows) text += (text.size() > 1 ? ",\n" : "\n") + to_json_line(row);
  return text + "\n]\n";
}

std::string rows_csv(std::span<const StudyRow> rows) {
  std::string text;
  const auto add_line = [&](const Json& row, bool keys) {
    bool first = true;
    for (const auto& [key, value] : row.items()) {
      if (!first) text += ',';
      text += keys ? key : csv_field(value);
      first = false;
    }
    text += '\n';
  };
  add_line(to_json({}), true);
  for (const StudyRow& row : rows) add_line(to_json(row), false);
  return text;
}

}  // namespace mocapress
