// SPDX-License-Identifier: MIT
#include "core/batch/verification.h"

#include "core/base/error.h"
#include "core/codec/original.h"
#include "core/compare/compared_file.h"

namespace mocapress {
namespace {

/// landmark_tracks() of all frames or, of a long clip, of some thousand: enough to find the ground.
Eigen::MatrixXd tracks_of_some(const Motion& motion) {
  constexpr int kMost = 8192;
  const int step = motion.clip.frames() / kMost + 1;
  const auto frames = Eigen::seq(0, motion.clip.frames() - 1, step);
  return landmark_tracks(motion.skeleton,
                         {motion.clip.sample_rate_hz, motion.clip.channels(frames, Eigen::all)});
}

Verification compare(const OpenedMcpr& opened, const Encoder& encoder, bool asks_for_motion) {
  const Motion& motion = encoder.motion();
  const CompressedClip& compressed = opened.compressed;
  if (compressed.frames != motion.clip.frames() ||
      compressed.skeleton.channel_count() != motion.clip.channels.cols())
    throw Error("verification: what was written has another shape");
  const bool is_long = compressed.segments.has_value();
  const Original::Tracks tracks = [&]() -> const Eigen::MatrixXd& {
    return encoder.original_tracks();
  };
  const Original original(motion, is_long ? Original::Tracks() : tracks);
  const bool in_blocks = is_long && !asks_for_motion;
  DistortionMeter meter(motion.skeleton, motion.clip.frames(),
                        in_blocks ? Detail::Figures : Detail::Distances);
  PosePoints wanted;
  PosePoints found;
  const auto visit = [&](int first, const TrackRows& there, const TrackRows& decoded) {
    meter.add(first, there, decoded);
    const int row = meter.worst().frame - first;
    if (row < 0 || row >= there.rows()) return;  // one of those before is still the worst
    wanted = points_at(there, row);
    found = points_at(decoded, row);
  };
  Verification verification;
  if (in_blocks) {
    original.compare(compressed, visit);
  } else {
    verification.decoded = decode(opened);
    original.compare(0, verification.decoded, visit);
  }
  verification.distortion = meter.distortion();
  const double ground_cm = is_long ? ground_of(tracks_of_some(motion)) : ground_of(tracks());
  verification.worst =
      worst_pose(motion.skeleton, std::move(wanted), std::move(found), ground_cm, meter.worst());
  return verification;
}

}  // namespace

Verification verify(std::span<const std::byte> file, const Encoder& original,
                    bool asks_for_motion) {
  try {
    return compare(read_coded_mcpr(file), original, asks_for_motion);
  } catch (const FormatError& error) {
    throw Error(std::string("verification: what was written cannot be read: ") + error.what());
  }
}

}  // namespace mocapress
