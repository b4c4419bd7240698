// SPDX-License-Identifier: MIT
// Measurements as JSON. Commands, rows and reports share the keys.

#pragma once

#include <string>

#include "core/report/json_value.h"
#include "core/report/measurement.h"

namespace mocapress {

/// The limits that differ from the built-in ones, without the distance; null if there are none.
Json own_limits_json(const SightLimits& limits);

/// Calls `add(key, value)` for each measurement of the body.
template <typename Add>
void add_body_figures(const BodyFigures& figures, const Add& add) {
  const auto add_spread = [&](const std::string& of, const std::optional<Spread>& spread) {
    const auto put = [&](const char* what, double cm) {
      add((of + what).c_str(), spread ? Json(cm) : Json());
    };
    const Spread all = spread.value_or(Spread());
    put("_rms_cm", all.rms);
    put("_p95_cm", all.p95);
    put("_p99_cm", all.p99);
    put("_max_cm", all.max.cm);
  };
  add_spread("surface", figures.surface);
  add_spread("shell", figures.shell);
  add_spread("skin", figures.skin);  // null without a mesh
  const auto add_turn = [&](const std::string& of, const std::optional<PartTurn>& turn) {
    add((of + "_degrees").c_str(), turn ? Json(turn->rms_degrees) : Json());
    add((of + "_worst_degrees").c_str(), turn ? Json(turn->max_degrees) : Json());
  };
  add_turn("head", figures.head);  // null without a joint of that name
  add_turn("hand", figures.hand);
  add_turn("finger", figures.finger);
  add_turn("foot", figures.foot);
  add("root_cm", Json(figures.root_max_cm));
  add("root_degrees", Json(figures.root_max_degrees));
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

/// Calls `add(key, value)` for each value of visibility. "own_limits" is null if all limits are
/// built-in.
template <typename Add>
void add_seen(const Seen& seen, const Add& add) {
  add("visibility", Json(name(seen.sight())));
  add("visibility_reason", text_or_null(seen.reason));
  add("times_noticed", Json(seen.times_noticed));
  add("unnoticed_from_m", Json(seen.unnoticed_from_m));
  add("visible_frames_share", Json(seen.visible_share));
  add("distance_m", Json(seen.limits.distance_m));
  add("own_limits", own_limits_json(seen.limits));
}

/// Calls `add(key, value)` for a measurement's errors, from the coefficient ratio to the worst
/// frame.
template <typename Add>
void add_errors(const Measurement& m, Weighting weighting, const Add& add) {
  add("coefficient_ratio", or_null(m.coefficient_ratio));
  const Spread spread = m.spread(weighting);
  add("eps_x_cm", Json(spread.rms));
  add("max_error_cm", Json(spread.max.cm));
  add("p95_error_cm", Json(spread.p95));
  add("p99_error_cm", Json(spread.p99));
  add("eps_x_bone_ends_cm", Json(m.eps_bone_ends_cm));
  add("bone_ends_max_cm", Json(m.max_error_cm));
  add("bone_ends_p95_cm", Json(m.p95_error_cm));
  add("bone_ends_p99_cm", Json(m.p99_error_cm));
  add("eps_x_joint_origins_cm", Json(m.eps_joint_origins_cm));
  add_body_figures(m.body, add);
  add_seen(m.seen, add);
  add("worst_frame", Json(m.worst_frame));
}

/// Adds the measurement's keys that all rows of results have; all are null without a measurement.
/// Times are not among them.
void add_measurement(Json& json, const std::optional<Measurement>& measured, Weighting weighting);

/// Reads a row's measurement. Leaves out the places of the worst points, which are not stored, and
/// "ik_ratio_used", which only some rows have. Throws the JSON library's exceptions.
Measurement measurement_of(const Json& row);

}  // namespace mocapress
