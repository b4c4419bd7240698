// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/report.h"

#include <iostream>
#include <numbers>

#include "core/base/frame_text.h"
#include "core/base/number_text.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/methods/compression_method.h"
#include "core/feet/footskate.h"
#include "core/metrics/rate.h"
#include "core/report/measurement_json.h"

namespace mocapress::cli {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;  // degrees in a radian

std::string cm(double value) {
  return fixed_text(value, 3) + " cm";
}

std::string degrees(double value) {
  return fixed_text(value, 2) + " degrees";
}

void print(const char* of, const Spread& spread) {
  std::cerr << "  " << of << ": RMS " << cm(spread.rms) << ", p99 " << cm(spread.p99) << ", max "
            << cm(spread.max.cm) << " (frame " << frame_text(spread.max.frame) << ")\n";
}

void print(const Visibility& seen, const Skeleton& skeleton) {
  const std::string why = printable(reason(seen.worst(), skeleton));
  std::cerr << "  visibility: " << sight_text(seen.sight(), seen.limits.distance_m)
            << (why.empty() ? "" : ": ") << why << '\n'
            << "  not noticed beyond " << significant_text(seen.unnoticed_from_m, 2) << " m, by "
            << limits_text(seen.limits) << '\n'
            << "  velocity error " << fixed_text(seen.velocity_error, 2) << " cm/s (RMS)";
  if (seen.jitter_ratio)
    std::cerr << ", jitter " << fixed_text(*seen.jitter_ratio, 2) << " of the original's";
  if (seen.visible_share > 0)
    std::cerr << ", visible in " << fixed_text(100 * seen.visible_share, 1) << " % of the frames";
  std::cerr << '\n';
}

/// Adds the measurements of visibility, each under a key of its own.
void add_visibility(const Visibility& seen, Json& json) {
  const auto worst = [&](Cue cue) {
    return seen.worst_of[static_cast<std::size_t>(cue)].times_noticed();
  };
  json["velocity_error_cm_per_s"] = seen.velocity_error;
  json["velocity_error_worst_cm_per_s"] = seen.worst_velocity_error;
  json["jitter_ratio"] = or_null(seen.jitter_ratio);
  json["slide_worst_contact_cm"] = seen.contacts ? Json(seen.contacts->worst_slide_cm) : Json();
  json["lift_worst_contact_cm"] = seen.contacts ? Json(seen.contacts->worst_lift_cm) : Json();
  json["floor_depth_cm"] = seen.floor_depth;
  json["root_flight_cm_per_s"] = or_null(seen.flight_error);
  json["head_window_degrees"] = or_null(seen.worst_head);
  json["hand_window_degrees"] = or_null(seen.worst_hand);
  for (std::size_t i = 0; i < kCues; ++i) {
    const auto cue = static_cast<Cue>(i);
    json["noticed_by_cue"][std::string(name(cue))] = worst(cue);
  }
}

void print(const CorrectionResult& correction) {
  if (correction.slide_without_cm)
    std::cerr << "  r_IK found: " << significant_text(correction.ratio, 3)
              << "; footskate without it " << fixed_text(*correction.slide_without_cm, 2)
              << " cm\n";
  else
    std::cerr << "  r_IK " << significant_text(correction.ratio, 3) << "\n";
  std::cerr << "  fastest knee " << fixed_text(correction.fastest_knee * kDegrees, 0)
            << " degrees/s (original "
            << fixed_text(correction.fastest_knee_of_original * kDegrees, 0) << ")\n";
  if (correction.report.unreached > 0)
    std::cerr << "  effector out of reach for " << correction.report.unreached
              << " limbs and frames, by at most " << fixed_text(correction.report.worst_miss_cm, 2)
              << " cm\n";
}

}  // namespace

TrackFigures track_figures(const ScalarTracks& original, std::span<const std::byte> mcpr) {
  const ScalarTracks found = tracks_of(mcpr);
  if (found.empty()) return {};
  return {found.size(), track_bytes_of(mcpr), track_error(original, found)};
}

Json to_json(const Report& report) {
  const Clip& clip = report.original->clip;
  const auto slide = slide_per_contact(report.footskate, report.contacts);
  const Spread spread = report.distortion.spread(report.weighting);
  Json json = {
      {"input", report.input},
      {"method", report.method},
      {"weighting", name(report.weighting)},
      {"coding", report.coding ? Json(name(*report.coding)) : Json()},
      {"sample_rate_hz", clip.sample_rate_hz},
      {"frames", clip.frames()},
      {"loop", name(report.loop)},
      {"channels", clip.channels.cols()},
      {"joints", report.original->skeleton.joint_count()},
      {"raw_bytes", raw_bytes(clip)},
      {"motion_bytes", report.motion_bytes},
      {"file_bytes", report.file_bytes},
      {"ratio", compression_ratio(clip, report.motion_bytes)},
      {"coefficient_ratio", or_null(report.coefficient_ratio)},
      {"eps_x_cm", spread.rms},
      {"max_error_cm", spread.max.cm},
      {"p95_error_cm", spread.p95},
      {"p99_error_cm", spread.p99},
      {"eps_x_bone_ends_cm", report.distortion.eps_bone_ends},
      {"bone_ends_max_cm", report.distortion.max.cm},
      {"bone_ends_p95_cm", report.distortion.p95},
      {"bone_ends_p99_cm", report.distortion.p99},
      {"eps_x_joint_origins_cm", report.distortion.eps_joint_origins},
  };
  add_body_figures(body_figures(report.original->skeleton, report.distortion),
                   [&](const char* key, Json value) { json[key] = std::move(value); });
  add_seen(seen_in(report.visibility, report.original->skeleton),
           [&](const char* key, Json value) { json[key] = std::move(value); });
  add_visibility(report.visibility, json);
  json.update(Json{
      {"bits_per_joint_sample", bits_per_joint_sample(*report.original, report.motion_bytes)},
      {"iterations", or_null(report.iterations)},
      {"encode_seconds", or_null(report.encode_seconds)},
      {"ik_ratio", report.correction ? Json(report.correction->ratio) : Json()},
      {"ik_bytes", or_null(report.correction_bytes)},
      {"contacts", report.contacts},
      {"footskate_cm", slide ? Json(report.footskate.total_cm) : Json()},
      {"footskate_without_ik_cm",
       report.correction ? or_null(report.correction->slide_without_cm) : Json()},
      {"footskate_mean_cm", slide ? Json(slide->mean_cm) : Json()},
      {"footskate_worst_cm", slide ? Json(slide->worst_cm) : Json()},
      {"footskate_drift_mean_cm", slide ? Json(slide->drift_mean_cm) : Json()},
      {"footskate_drift_worst_cm", slide ? Json(slide->drift_worst_cm) : Json()},
      {"tracks", report.tracks.count},
      {"track_bytes", report.tracks.bytes},
      {"track_max_error", report.tracks.count > 0 ? Json(report.tracks.max_error) : Json()},
      {"verified_by", report.verified_by},
  });
  return json;
}

void print(const Report& report) {
  const Clip& clip = report.original->clip;
  const Distortion& distortion = report.distortion;
  const std::string coding = report.coding ? ", " + std::string(name(*report.coding)) : "";
  const auto worst_landmark = static_cast<std::size_t>(distortion.max.landmark);
  const std::string worst_name =
      printable(landmarks(report.original->skeleton)[worst_landmark].name);
  std::cerr << printable(report.input) << ": " << clip.frames() << " frames, "
            << clip.channels.cols() << " channels at " << significant_text(clip.sample_rate_hz, 6)
            << " Hz\n"
            << "  " << method_title(report.method) << coding << ": "
            << fixed_text(compression_ratio(clip, report.motion_bytes), 1) << ":1 ("
            << report.motion_bytes << " bytes of motion for " << raw_bytes(clip) << ", "
            << report.file_bytes << " in the file)\n"
            << "  eps_x " << cm(distortion.eps(report.weighting)) << " (" << name(report.weighting)
            << "), largest error there " << cm(distortion.worst(report.weighting).cm) << "\n"
            << "  bone ends: RMS " << cm(distortion.eps_bone_ends) << ", p95 " << cm(distortion.p95)
            << ", p99 " << cm(distortion.p99) << ", max " << cm(distortion.max.cm) << " ("
            << worst_name << ", frame " << frame_text(distortion.max.frame)
            << "); joint origins: RMS " << cm(distortion.eps_joint_origins) << "\n";
  const BodyFigures body = body_figures(report.original->skeleton, distortion);
  print("surface", body.surface);
  print("shell", body.shell);
  if (body.skin) print("skin", *body.skin);
  std::cerr << "  rotation error of joints " << degrees(body.angle_rms_degrees);
  if (body.head) std::cerr << ", head " << degrees(body.head->rms_degrees);
  if (body.hand) std::cerr << ", worse hand " << degrees(body.hand->rms_degrees);
  std::cerr << " (RMS); largest error of the root " << cm(body.root_max_cm) << " and "
            << degrees(body.root_max_degrees) << "\n";
  const EndErrors& ends = body.ends;
  std::cerr << "  surface error of the first pose " << cm(ends.first_cm) << ", last "
            << cm(ends.last_cm);
  if (report.loop != Loop::None)
    std::cerr << "; loop: seam error " << cm(ends.seam_cm) << " and " << cm(ends.seam_cm_per_frame)
              << " a frame, largest between neighbouring frames " << cm(ends.worst_neighbours_cm)
              << " and " << cm(ends.worst_neighbours_cm_per_frame) << " a frame";
  std::cerr << '\n';
  print(report.visibility, report.original->skeleton);
  if (const auto slide = slide_per_contact(report.footskate, report.contacts))
    std::cerr << "  footskate " << fixed_text(report.footskate.total_cm, 2) << " cm in "
              << report.contacts << " contacts: mean " << cm(slide->mean_cm) << ", worst "
              << cm(slide->worst_cm) << " of path; drift mean " << cm(slide->drift_mean_cm)
              << ", worst " << cm(slide->drift_worst_cm) << '\n';
  if (report.correction_bytes)
    std::cerr << "  IK correction: " << *report.correction_bytes << " bytes\n";
  if (report.correction) print(*report.correction);
  if (report.tracks.count > 0)
    std::cerr << "  " << report.tracks.count
              << " tracks of weights, properties and scales: " << report.tracks.bytes
              << " bytes, largest error " << significant_text(report.tracks.max_error, 3) << "\n";
}

void print(const Json& json) {
  std::cout << dumped(json, 2) << '\n';
}

}  // namespace mocapress::cli
