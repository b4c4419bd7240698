// SPDX-License-Identifier: MIT
#pragma once

#include "core/metrics/body_figures.h"
#include "core/metrics/visibility.h"
#include "core/report/json_value.h"

namespace mocapress {

/// Calls `add(key, value)` for each figure.
template <typename Add>
void add_body_figures(const BodyFigures& figures, const Add& add) {
  const auto add_spread = [&](const std::string& of, const Spread& spread) {
    add((of + "_rms_cm").c_str(), Json(spread.rms));
    add((of + "_p95_cm").c_str(), Json(spread.p95));
    add((of + "_p99_cm").c_str(), Json(spread.p99));
    add((of + "_max_cm").c_str(), Json(spread.max.cm));
  };
  add_spread("surface", figures.surface);
  add_spread("shell", figures.shell);
  add("head_degrees", or_null(figures.head_degrees));
  add("hand_degrees", or_null(figures.hand_degrees));
  add("angle_rms_degrees", Json(figures.angle_rms_degrees));
  add("first_frame_cm", Json(figures.ends.first_cm));
  add("last_frame_cm", Json(figures.ends.last_cm));
  add("seam_cm", Json(figures.ends.seam_cm));
  add("seam_cm_per_frame", Json(figures.ends.seam_cm_per_frame));
  add("neighbours_cm", Json(figures.ends.neighbours_cm));
  add("neighbours_cm_per_frame", Json(figures.ends.neighbours_cm_per_frame));
  add("worst_neighbours_cm", Json(figures.ends.worst_neighbours_cm));
  add("worst_neighbours_cm_per_frame", Json(figures.ends.worst_neighbours_cm_per_frame));
}

/// The same of what the eye sees.
template <typename Add>
void add_seen(const std::optional<Seen>& seen, const Add& add) {
  add("visibility", seen ? Json(name(seen->sight())) : Json());
  add("visibility_reason", seen ? text_or_null(seen->reason) : Json());
  add("times_noticed", seen ? Json(seen->times_noticed) : Json());
  add("visible_frames_share", seen ? Json(seen->visible_share) : Json());
}

/// What add_seen() wrote; unset where nothing did. Throws like the JSON library does.
inline std::optional<Seen> seen_of(const Json& json) {
  if (!json.contains("times_noticed") || json.at("times_noticed").is_null()) return std::nullopt;
  return Seen{json.at("times_noticed").get<double>(), json.at("visible_frames_share").get<double>(),
              optional_at<std::string>(json, "visibility_reason").value_or("")};
}

/// What add_body_figures() wrote, but for where the worst points are. Throws like the JSON library
/// does.
inline BodyFigures body_figures_of(const Json& json) {
  const auto spread = [&](const std::string& of) {
    Spread found;
    json.at(of + "_rms_cm").get_to(found.rms);
    json.at(of + "_p95_cm").get_to(found.p95);
    json.at(of + "_p99_cm").get_to(found.p99);
    json.at(of + "_max_cm").get_to(found.max.cm);
    return found;
  };
  return {.surface = spread("surface"),
          .shell = spread("shell"),
          .head_degrees = optional_at<double>(json, "head_degrees"),
          .hand_degrees = optional_at<double>(json, "hand_degrees"),
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

}  // namespace mocapress
