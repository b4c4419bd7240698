// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/study/row.h"

namespace mocapress::test {

/// A row in which every value differs from its default.
inline StudyRow full_row() {
  StudyRow row;
  row.clip = "clips/walk, \"slow\" <1>.bvh";
  row.fingerprint = "0123456789abcdef";
  row.settings.method = "annealed";
  row.settings.target = {Target::Kind::Error, 0.26};
  row.settings.weighting = Weighting::JointOrigins;
  row.settings.coding = Coding::Rle16;
  row.settings.seed = 18446744073709551615u;
  row.settings.correction = CorrectionSettings{.ratio = 16};
  row.jobs = 3;
  row.measured = Measurement{.frames = 600,
                             .channels = 62,
                             .sample_rate_hz = 119.88,
                             .raw_bytes = 148800,
                             .motion_bytes = 5001,
                             .file_bytes = 6007,
                             .ratio = 148800 / 5001.0,
                             .coefficient_ratio = 17.25,
                             .eps_bone_ends_cm = 0.1 + 0.2,
                             .eps_joint_origins_cm = 0.2599,
                             .max_error_cm = 3.5,
                             .p95_error_cm = 1.1,
                             .p99_error_cm = 2.2,
                             .seen = Seen{1.5, 0.25, "head of head at frame 7: 2.85 degrees"},
                             .worst_frame = 599,
                             .contacts = 4,
                             .footskate_cm = 0.75,
                             .slide = SlidePerContact{0.1875, 0.5, 0.125, 0.25},
                             .iterations = 321,
                             .encode_seconds = 0.125};
  return row;
}

/// One measured point of a clip.
inline StudyRow point(const std::string& clip, const std::string& method, const Target& target,
                      double ratio, double eps_cm) {
  StudyRow row{.clip = clip,
               .fingerprint = clip,
               .settings = {.method = method, .weighting = Weighting::BoneEnds, .target = target}};
  row.measured = Measurement{.frames = 240,
                             .channels = 62,
                             .sample_rate_hz = 120,
                             .raw_bytes = 240 * 62 * 4,
                             .motion_bytes = static_cast<std::size_t>(240 * 62 * 4 / ratio),
                             .file_bytes = 9999,
                             .ratio = ratio,
                             .eps_bone_ends_cm = eps_cm,
                             .eps_joint_origins_cm = 0.8 * eps_cm,
                             .max_error_cm = 5 * eps_cm,
                             .contacts = 2,
                             .footskate_cm = eps_cm,
                             .encode_seconds = 0.5};
  return row;
}

}  // namespace mocapress::test
