// SPDX-License-Identifier: MIT
#include "core/study/clip_in_hand.h"

#include "core/contact/footskate.h"
#include "core/ik/effector.h"
#include "core/metrics/rate.h"
#include "core/study/fingerprint.h"

namespace mocapress {

ClipInHand::ClipInHand(const StudyPlan& plan, const std::filesystem::path& path)
    : ClipInHand(read_motion(path, plan.skeleton, plan.reading)) {}

ClipInHand::ClipInHand(MotionFile file)
    : warnings_(std::move(file.warnings)),
      fingerprint_(mocapress::fingerprint(file.motion)),
      encoder_(std::move(file.motion)) {
  std::vector<int> feet;  // landmark j is the origin of joint j
  for (const Effector& foot : find_feet(motion().skeleton)) feet.push_back(foot.joint);
  if (!feet.empty())
    contacts_ =
        find_contacts(encoder_.wavelets().original_tracks(), motion().clip.sample_rate_hz, feet);
}

Measurement ClipInHand::measure(const Compression& compression) const {
  const Clip& clip = motion().clip;
  const Distortion& distortion = compression.distortion;
  Measurement m;
  m.frames = clip.frames();
  m.channels = static_cast<int>(clip.channels.cols());
  m.sample_rate_hz = clip.sample_rate_hz;
  m.raw_bytes = raw_bytes(clip);
  m.motion_bytes = compression.motion_bytes;
  m.file_bytes = compression.file.size();
  m.ratio = compression_ratio(clip, compression.motion_bytes);
  m.coefficient_ratio = compression.coefficient_ratio;
  m.eps_bone_ends_cm = distortion.eps_bone_ends;
  m.eps_joint_origins_cm = distortion.eps_joint_origins;
  m.max_error_cm = distortion.max.cm;
  m.p95_error_cm = distortion.p95;
  m.p99_error_cm = distortion.p99;
  m.worst_frame = distortion.max.frame;
  m.iterations = compression.iterations;
  m.encode_seconds = compression.seconds;
  if (contacts_) {
    m.contacts = static_cast<int>(contacts_->size());
    m.footskate_cm = measure_footskate(*contacts_, encoder_.wavelets().original_tracks(),
                                       landmark_tracks(motion().skeleton, compression.decoded),
                                       clip.sample_rate_hz)
                         .total_cm;
  }
  return m;
}

}  // namespace mocapress
