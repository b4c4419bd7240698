// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/report.h"

#include <cstdio>
#include <iostream>
#include <numbers>

#include "core/metrics/rate.h"

namespace mocapress::cli {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;  // in a radian

void print(const CorrectionResult& correction) {
  if (correction.slide_without_cm)
    std::fprintf(stderr, "  r_IK found: %.3g, against %.2f cm of footskate without a correction\n",
                 correction.ratio, *correction.slide_without_cm);
  else
    std::fprintf(stderr, "  r_IK %.3g\n", correction.ratio);
  std::fprintf(stderr, "  knees turn at up to %.0f degrees/s (original %.0f)\n",
               correction.fastest_knee * kDegrees, correction.fastest_knee_of_original * kDegrees);
  if (correction.report.unreached > 0)
    std::fprintf(stderr, "  out of reach of %d limbs and frames, by up to %.2f cm\n",
                 correction.report.unreached, correction.report.worst_miss_cm);
}

}  // namespace

std::optional<double> footskate_of(const std::vector<ContactSpan>& contacts,
                                   const Footskate& footskate) {
  return contacts.empty() ? std::nullopt : std::optional(footskate.total_cm);
}

Json to_json(const Report& report) {
  const Clip& clip = report.original->clip;
  return {
      {"input", report.input},
      {"method", report.method},
      {"weighting", name(report.weighting)},
      {"coding", report.coding ? Json(name(*report.coding)) : Json()},
      {"sample_rate_hz", clip.sample_rate_hz},
      {"frames", clip.frames()},
      {"channels", clip.channels.cols()},
      {"joints", report.original->skeleton.joint_count()},
      {"raw_bytes", raw_bytes(clip)},
      {"motion_bytes", report.motion_bytes},
      {"file_bytes", report.file_bytes},
      {"ratio", compression_ratio(clip, report.motion_bytes)},
      {"coefficient_ratio", or_null(report.coefficient_ratio)},
      {"eps_x_cm", report.distortion.eps(report.weighting)},
      {"eps_x_bone_ends_cm", report.distortion.eps_bone_ends},
      {"eps_x_joint_origins_cm", report.distortion.eps_joint_origins},
      {"max_error_cm", report.distortion.max.cm},
      {"p95_error_cm", report.distortion.p95},
      {"p99_error_cm", report.distortion.p99},
      {"bits_per_joint_sample", bits_per_joint_sample(*report.original, report.motion_bytes)},
      {"iterations", or_null(report.iterations)},
      {"encode_seconds", or_null(report.encode_seconds)},
      {"ik_ratio", report.correction ? Json(report.correction->ratio) : Json()},
      {"ik_bytes", or_null(report.correction_bytes)},
      {"footskate_cm", or_null(report.footskate_cm)},
      {"footskate_without_ik_cm",
       report.correction ? or_null(report.correction->slide_without_cm) : Json()},
      {"verified_by", report.verified_by},
  };
}

void print(const Report& report) {
  const Clip& clip = report.original->clip;
  const Distortion& distortion = report.distortion;
  const std::string coding = report.coding ? ", " + std::string(name(*report.coding)) : "";
  const auto worst_landmark = static_cast<std::size_t>(distortion.max.landmark);
  const std::string worst_name = landmarks(report.original->skeleton)[worst_landmark].name;
  std::fprintf(stderr, "%s: %d frames, %d channels at %g Hz\n", report.input.c_str(), clip.frames(),
               static_cast<int>(clip.channels.cols()), clip.sample_rate_hz);
  std::fprintf(stderr, "  %s%s: %.1f:1 (%zu bytes of motion for %zu, %zu in the file)\n",
               report.method.c_str(), coding.c_str(), compression_ratio(clip, report.motion_bytes),
               report.motion_bytes, raw_bytes(clip), report.file_bytes);
  std::fprintf(stderr, "  eps_x %.3f cm (bone-ends), %.3f cm (joint-origins)\n",
               distortion.eps_bone_ends, distortion.eps_joint_origins);
  std::fprintf(stderr, "  p95 %.3f cm, p99 %.3f cm, max %.3f cm (%s, frame %d)\n", distortion.p95,
               distortion.p99, distortion.max.cm, worst_name.c_str(), distortion.max.frame);
  if (report.footskate_cm) std::fprintf(stderr, "  footskate %.2f cm\n", *report.footskate_cm);
  if (report.correction_bytes)
    std::fprintf(stderr, "  IK correction: %zu bytes\n", *report.correction_bytes);
  if (report.correction) print(*report.correction);
}

void print(const Json& json) {
  std::cout << json.dump(2) << '\n';
}

}  // namespace mocapress::cli
