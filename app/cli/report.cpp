// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/report.h"

#include <cstdio>
#include <iostream>

#include "core/metrics/rate.h"

namespace mocapress::cli {

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
      {"ik_ratio", nullptr},
      {"ik_bytes", nullptr},
      {"footskate_cm", nullptr},
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
}

void print(const Json& json) {
  std::cout << json.dump(2) << '\n';
}

}  // namespace mocapress::cli
