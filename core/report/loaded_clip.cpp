// SPDX-License-Identifier: MIT
#include "core/report/loaded_clip.h"

#include <span>

#include "core/base/fnv1a.h"
#include "core/codec/format/skeleton_section.h"
#include "core/metrics/rate.h"

namespace mocapress {

std::string fingerprint(const Motion& motion) {
  Fnv1a hash;
  hash.add(joint_bytes(motion.skeleton));
  hash.add(std::as_bytes(std::span(&motion.clip.sample_rate_hz, 1)));
  const Eigen::MatrixXd& channels = motion.clip.channels;
  hash.add(std::as_bytes(std::span(channels.data(), static_cast<std::size_t>(channels.size()))));
  if (const auto& skin = motion.skeleton.skin())
    for (const SkinPoint& point : *skin)
      for (const SkinPointShare& share : point) {
        hash.add(std::as_bytes(std::span(&share.joint, 1)));
        hash.add(std::as_bytes(std::span(share.in_joint.data(), 3)));
        hash.add(std::as_bytes(std::span(&share.weight, 1)));
      }
  return hash.text();
}

LoadedClip::LoadedClip(MotionFile file)
    : warnings_(std::move(file.warnings)),
      source_(file.source),
      tracks_(std::move(file.tracks)),
      fingerprint_(mocapress::fingerprint(file.motion)),
      encoder_(std::move(file.motion)) {}

Measurement LoadedClip::measure(const Encoding& encoding, std::optional<std::size_t> edited) const {
  const Clip& clip = motion().clip;
  const Distortion& distortion = encoding.distortion;
  Measurement m;
  m.frames = clip.frames();
  m.channels = static_cast<int>(clip.channels.cols());
  m.sample_rate_hz = clip.sample_rate_hz;
  m.raw_bytes = raw_bytes(clip);
  m.motion_bytes = encoding.compressed.motion_bytes();
  m.file_bytes = encoding.file.size();
  m.ratio = compression_ratio(clip, encoding.compressed.motion_bytes());
  m.coefficient_ratio = encoding.coefficient_ratio;
  m.eps_bone_ends_cm = distortion.eps_bone_ends;
  m.eps_joint_origins_cm = distortion.eps_joint_origins;
  m.max_error_cm = distortion.max.cm;
  m.p95_error_cm = distortion.p95;
  m.p99_error_cm = distortion.p99;
  m.body = body_figures(motion().skeleton, distortion);
  m.seen = seen_in(encoding.visibility, motion().skeleton);
  m.worst_frame = distortion.worst(encoding.compressed.provenance.weighting).frame;
  m.iterations = encoding.iterations;
  m.encode_seconds = encoding.seconds;
  m.contacts = static_cast<int>(edited.value_or(contacts().size()));
  m.slide = slide_per_contact(encoding.footskate, static_cast<std::size_t>(m.contacts));
  if (m.slide) m.footskate_cm = encoding.footskate.total_cm;
  if (encoding.correction) {
    m.ik_ratio_used = encoding.correction->ratio;
    m.ik_bytes = encoding.correction->bytes;
    m.knee_speed_ratio =
        encoding.correction->fastest_knee / encoding.correction->fastest_knee_of_original;
  }
  return m;
}

}  // namespace mocapress
