// SPDX-License-Identifier: MIT
#include "core/report/measurement_json.h"

#include <utility>

#include "core/metrics/sight_limits_json.h"

namespace mocapress {

Json own_limits_json(const SightLimits& limits) {
  SightLimits at_usual_distance = limits;
  at_usual_distance.distance_m = kUsualDistance;
  Json json = to_json(at_usual_distance, false);
  return json.empty() ? Json() : json;
}

namespace {

/// Reads what add_seen() wrote. Throws the JSON library's exceptions.
Seen seen_of(const Json& json) {
  const Json& own = json.at("own_limits");
  SightLimits limits = own.is_null() ? SightLimits() : limits_from(own);
  json.at("distance_m").get_to(limits.distance_m);
  return {json.at("times_noticed").get<double>(), json.at("visible_frames_share").get<double>(),
          optional_at<std::string>(json, "visibility_reason").value_or(""),
          json.at("unnoticed_from_m").get<double>(), limits};
}

/// Reads what add_body_figures() wrote; the places of the worst points are not stored. Throws the
/// JSON library's exceptions.
BodyFigures body_figures_of(const Json& json) {
  const auto spread = [&](const std::string& of) {
    Spread found;
    json.at(of + "_rms_cm").get_to(found.rms);
    json.at(of + "_p95_cm").get_to(found.p95);
    json.at(of + "_p99_cm").get_to(found.p99);
    json.at(of + "_max_cm").get_to(found.max.cm);
    return found;
  };
  const auto turn = [&](const std::string& of) -> std::optional<PartTurn> {
    const auto rms = optional_at<double>(json, (of + "_degrees").c_str());
    if (!rms) return std::nullopt;
    return PartTurn{*rms, json.at(of + "_worst_degrees").get<double>()};
  };
  const bool has_skin = !json.at("skin_rms_cm").is_null();
  return {.surface = spread("surface"),
          .shell = spread("shell"),
          .skin = has_skin ? std::optional(spread("skin")) : std::nullopt,
          .head = turn("head"),
          .hand = turn("hand"),
          .finger = turn("finger"),
          .foot = turn("foot"),
          .root_max_cm = json.at("root_cm").get<double>(),
          .root_max_degrees = json.at("root_degrees").get<double>(),
          .angle_rms_degrees = json.at("angle_rms_degrees").get<double>(),
          .ends = {.first_cm = json.at("first_frame_cm").get<double>(),
                   .last_cm = json.at("last_frame_cm").get<double>(),
                   .seam_cm = json.at("seam_cm").get<double>(),
                   .seam_cm_per_frame = json.at("seam_cm_per_frame").get<double>(),
                   .neighbours_cm = json.at("neighbours_cm").get<double>(),
                   .neighbours_cm_per_frame = json.at("neighbours_cm_per_frame").get<double>(),
                   .worst_neighbours_cm = json.at("worst_neighbours_cm").get<double>(),
                   .worst_neighbours_cm_per_frame =
                       json.at("worst_neighbours_cm_per_frame").get<double>()}};
}

}  // namespace

void add_measurement(Json& json, const std::optional<Measurement>& measured, Weighting weighting) {
  const Measurement m = measured.value_or(Measurement());
  const auto add = [&](const char* key, Json value) {
    json[key] = measured ? std::move(value) : Json();
  };
  add("frames", m.frames);
  add("channels", m.channels);
  add("sample_rate_hz", m.sample_rate_hz);
  add("raw_bytes", m.raw_bytes);
  add("motion_bytes", m.motion_bytes);
  add("file_bytes", m.file_bytes);
  add("ratio", m.ratio);
  add_errors(m, weighting, add);
  add("contacts", m.contacts);
  add("footskate_cm", or_null(m.footskate_cm));
  add("footskate_mean_cm", m.slide ? Json(m.slide->mean_cm) : Json());
  add("footskate_worst_cm", m.slide ? Json(m.slide->worst_cm) : Json());
  add("footskate_drift_mean_cm", m.slide ? Json(m.slide->drift_mean_cm) : Json());
  add("footskate_drift_worst_cm", m.slide ? Json(m.slide->drift_worst_cm) : Json());
  add("ik_bytes", or_null(m.ik_bytes));
  add("knee_speed_ratio", or_null(m.knee_speed_ratio));
  add("iterations", or_null(m.iterations));
}

Measurement measurement_of(const Json& json) {
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
  json.at("bone_ends_max_cm").get_to(m.max_error_cm);
  json.at("bone_ends_p95_cm").get_to(m.p95_error_cm);
  json.at("bone_ends_p99_cm").get_to(m.p99_error_cm);
  m.body = body_figures_of(json);
  m.seen = seen_of(json);
  json.at("worst_frame").get_to(m.worst_frame);
  json.at("contacts").get_to(m.contacts);
  m.footskate_cm = optional_at<double>(json, "footskate_cm");
  if (const auto mean_cm = optional_at<double>(json, "footskate_mean_cm"))
    m.slide = {*mean_cm, json.at("footskate_worst_cm").get<double>(),
               json.at("footskate_drift_mean_cm").get<double>(),
               json.at("footskate_drift_worst_cm").get<double>()};
  m.ik_bytes = optional_at<std::size_t>(json, "ik_bytes");
  m.knee_speed_ratio = optional_at<double>(json, "knee_speed_ratio");
  m.iterations = optional_at<int>(json, "iterations");
  json.at("encode_seconds").get_to(m.encode_seconds);
  return m;
}

}  // namespace mocapress
