// SPDX-License-Identifier: MIT
#include "core/mocapress/player.h"

#include <cmath>

#include "core/codec/decode/runtime_clip.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/format/source_section.h"
#include "core/codec/methods/compared_file.h"

namespace mocapress {
namespace {

mcpr_wrap wrap_of(AtEnds at_ends) {
  return at_ends == AtEnds::Loop ? MCPR_LOOP : MCPR_CLAMP;
}

}  // namespace

struct Player::Parts {
  RuntimeClip clip;
  mcpr_clip_info info;
  Skeleton skeleton;
  ScalarTracks tracks;

  /// Decodes one instant. `out` has room for as many floats as the output has.
  void decode(mcpr_output output, double seconds, AtEnds at_ends, float* out) const {
    const mcpr_request request{
        .output = output, .apply_ik = 1, .unit = MCPR_SECONDS, .wrap = wrap_of(at_ends)};
    const AlignedBytes scratch(mcpr_scratch_bytes(clip.get(), &request));
    if (!std::isfinite(seconds)) throw Error("an instant that is not finite");
    mcpr_result result;
    mcpr_decode_moment(clip.get(), &request, seconds, out, scratch.data(), scratch.size(), &result);
    if (result.status != MCPR_OK) throw Error(result.message);
  }
};

Eigen::Quaternionf LocalPose::rotation(int joint) const {
  const auto column = joints.col(joint);
  return {column[0], column[1], column[2], column[3]};
}

Player::Player(std::span<const std::byte> file) {
  RuntimeClip clip(file);
  const mcpr_clip_info info = clip.info();
  if (info.frames == 0) throw Error("the clip has no frames");
  parts_ = std::make_unique<const Parts>(
      Parts{std::move(clip), info, read_coded_mcpr(file).compressed.skeleton, tracks_of(file)});
}

Player::~Player() = default;

const Skeleton& Player::skeleton() const {
  return parts_->skeleton;
}

int Player::frames() const {
  return static_cast<int>(parts_->info.frames);
}

double Player::sample_rate_hz() const {
  return parts_->info.sample_rate;
}

double Player::seconds() const {
  const int steps = is_loop() ? static_cast<int>(parts_->info.loop_frames) : frames() - 1;
  return steps / sample_rate_hz();
}

bool Player::is_loop() const {
  return parts_->info.loop_frames > 0;
}

LocalPose Player::sample(double seconds, AtEnds at_ends) const {
  LocalPose pose;
  pose.joints.resize(7, skeleton().joint_count());
  parts_->decode(MCPR_LOCAL, seconds, at_ends, pose.joints.data());
  return pose;
}

Eigen::Matrix3Xf Player::positions(double seconds, AtEnds at_ends) const {
  Eigen::Matrix3Xf places(3, skeleton().joint_count());
  parts_->decode(MCPR_POSITIONS, seconds, at_ends, places.data());
  return places;
}

const ScalarTracks& Player::tracks() const {
  return parts_->tracks;
}

Eigen::VectorXf Player::track_values(double seconds, AtEnds at_ends) const {
  if (!std::isfinite(seconds)) throw Error("an instant that is not finite");
  if (at_ends == AtEnds::Loop && !is_loop()) throw Error("the clip is not a loop");
  const mcpr_track_request all{.sample_rate = sample_rate_hz(), .wrap = wrap_of(at_ends)};
  Eigen::VectorXf values(tracks().size());
  if (tracks().empty()) return values;
  const mcpr_tracks* const held = mcpr_clip_tracks(parts_->clip.get());
  const AlignedBytes scratch(mcpr_track_scratch_bytes(held, &all));
  mcpr_result result;
  mcpr_track_moment(held, &all, seconds, values.data(), scratch.data(), scratch.size(), &result);
  if (result.status != MCPR_OK) throw Error(result.message);
  return values;
}

MotionFile decompress(std::span<const std::byte> file) {
  OpenedMcpr opened = read_mcpr(file);
  return {.motion = {std::move(opened.compressed.skeleton), std::move(opened.decoded)},
          .source = source_of(file),
          .tracks = tracks_of(file)};
}

}  // namespace mocapress
