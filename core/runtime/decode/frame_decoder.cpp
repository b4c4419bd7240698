// SPDX-License-Identifier: MIT
#include "core/runtime/decode/frame_decoder.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstring>

#include "core/runtime/format/end_poses.h"
#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/trigonometry.h"

namespace mocapress::runtime {
namespace {

/// True if the IK correction turns any of the requested channels.
bool turns_any(const ClipBlock& clip, const mcpr_request& request) {
  if (request.channels == nullptr) return true;
  for (int l = 0; l < clip.limb_count; ++l) {
    const LimbPlan limb = clip.limb(l);
    for (int a = 0; a < limb.turns; ++a)
      if (std::find(request.channels, request.channels + request.channel_count,
                    limb.turn[a].channel) != request.channels + request.channel_count)
        return true;
  }
  return false;
}

/// A joint's local transform, from one row of channels.
JointPlace place_in_parent(const JointModel& joint, const float* row) {
  JointPlace place{Matrix3(), joint.offset};
  if (joint.has_axes) place.world_from_joint = joint.parent_from_axes;
  const auto value = [&](int c) { return static_cast<double>(row[joint.first_channel + c]); };
  apply_channels(joint.kinds, joint.channels, value, place.world_from_joint, place.origin);
  if (joint.has_axes) place.world_from_joint = place.world_from_joint * joint.axes_from_joint;
  return place;
}

/// Multiplies quaternion q by `turn` on the right. Both are w x y z.
void append_turn(const double (&turn)[4], double (&q)[4]) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  q[0] = w * turn[0] - x * turn[1] - y * turn[2] - z * turn[3];
  q[1] = w * turn[1] + x * turn[0] + y * turn[3] - z * turn[2];
  q[2] = w * turn[2] - x * turn[3] + y * turn[0] + z * turn[1];
  q[3] = w * turn[3] + x * turn[2] - y * turn[1] + z * turn[0];
}

void append_turn(const Matrix3& rotation, double (&q)[4]) {
  double turn[4];
  quaternion_of(rotation, turn);
  append_turn(turn, q);
}

/// Writes a joint's local transform as seven floats. The quaternion is a product of one quaternion
/// per angle, made from half the angle. That product is continuous over time, so its sign never
/// flips.
void put_place_in_parent(const JointModel& joint, const float* row, float* out) {
  double q[4] = {1, 0, 0, 0};
  Vector3 origin = joint.offset;
  if (joint.has_axes) append_turn(joint.parent_from_axes, q);
  for (int c = 0; c < joint.channels; ++c) {
    const auto value = static_cast<double>(row[joint.first_channel + c]);
    const int axis = axis_of(joint.kinds[c]);
    if (is_rotation(joint.kinds[c])) {
      const auto [sine, cosine] = sine_and_cosine(0.5 * value);
      double turn[4] = {cosine, 0, 0, 0};
      turn[1 + axis] = sine;
      append_turn(turn, q);
    } else {
      origin[axis] += value;
    }
  }
  if (joint.has_axes) append_turn(joint.axes_from_joint, q);
  for (int i = 0; i < 4; ++i) out[i] = static_cast<float>(q[i]);
  for (int i = 0; i < 3; ++i) out[4 + i] = static_cast<float>(origin[i]);
}

/// True if all channels exist in the clip, without duplicates.
bool are_channels_of(const ClipBlock& clip, const std::uint16_t* channels, std::uint32_t count) {
  if (count > clip.channel_count) return false;
  std::bitset<kMostChannels> seen;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (channels[i] >= clip.channel_count || seen[channels[i]]) return false;
    seen[channels[i]] = true;
  }
  return true;
}

}  // namespace

bool is_possible(const ClipBlock& clip, const mcpr_request& request) {
  if (request.output < MCPR_CHANNELS || request.output > MCPR_POSITIONS) return false;
  if (rows_of(request.path) == nullptr) return false;
  if (request.channels == nullptr) return request.channel_count == 0;
  return request.output == MCPR_CHANNELS &&
         are_channels_of(clip, request.channels, request.channel_count);
}

std::size_t values_of_frame(const ClipBlock& clip, const mcpr_request& request) {
  if (request.output == MCPR_LOCAL) return std::size_t{7} * clip.joint_count;
  if (request.output == MCPR_POSITIONS) return std::size_t{3} * clip.joint_count;
  return request.channels != nullptr ? request.channel_count : clip.channel_count;
}

void place_joints(const ClipBlock& clip, const float* row, JointPlace* places) {
  for (std::uint32_t j = 0; j < clip.joint_count; ++j) {
    const JointModel& joint = clip.joint_models()[j];
    // A local variable, because with -msimd128 emscripten 3.1.6 computes wrong origins if this is
    // written to `places` directly.
    const JointPlace in_parent = place_in_parent(joint, row);
    if (joint.parent < 0) {
      places[j] = in_parent;
      continue;
    }
    const JointPlace& parent = places[joint.parent];
    places[j].origin = parent.origin + parent.world_from_joint * in_parent.origin;
    places[j].world_from_joint = parent.world_from_joint * in_parent.world_from_joint;
  }
}

FrameDecoder::FrameDecoder(Memory& memory, const ClipBlock& clip, const mcpr_request& request)
    : clip_(clip),
      request_(request),
      solves_(request.apply_ik != 0 && clip.effector_count > 0 && turns_any(clip, request)),
      picks_(solves_ && request.channels != nullptr),
      signals_(memory, clip, signal_request(memory)),
      limb_(memory, solves_ ? clip.most_links : 0),
      places_(memory.take<JointPlace>(request.output == MCPR_POSITIONS ? clip.joint_count : 0)),
      row_step_((clip.largest.signal_count + 7) / 8 * 8),
      rows_(memory.take<float>(static_cast<std::uint64_t>(row_step_) * kWindow)) {}

/// Assigns signals to columns: either a requested subset of channels in its order, or all signals
/// in theirs.
SignalRequest FrameDecoder::signal_request(Memory& memory) {
  const int signal_count = clip_.largest.signal_count;
  const bool subset = request_.channels != nullptr && !picks_;
  const int all = solves_ ? signal_count : static_cast<int>(clip_.channel_count);
  columns_ = memory.take<std::int32_t>(static_cast<std::uint64_t>(signal_count));
  if (columns_ != nullptr) {
    for (int s = 0; s < signal_count; ++s)
      columns_[s] = !subset && s < all ? s : ResidentSignals::Columns::kNone;
    for (std::uint32_t i = 0; subset && i < request_.channel_count; ++i)
      columns_[request_.channels[i]] = static_cast<std::int32_t>(i);
  }
  return {.column_of_signal = columns_,
          .in_order = !subset,
          .columns = subset ? static_cast<int>(request_.channel_count) : all,
          .bands_left_out = static_cast<int>(std::min<std::uint32_t>(request_.bands_left_out, 64)),
          .kernels = rows_of(request_.path)};
}

void FrameDecoder::decode(int first, int count, float* out) {
  const std::size_t values = values_of_frame(clip_, request_);
  while (count > 0) {
    const int frames = std::min(count, kWindow);
    if (is_plain()) {
      signals_.decode_window(first, frames, out, static_cast<std::ptrdiff_t>(values));
      for (int t = 0; t < frames; ++t)
        add_ends(shares_at(first + t), out + values * static_cast<std::size_t>(t));
    } else {
      signals_.decode_window(first, frames, rows_, row_step_);
      for (int t = 0; t < frames; ++t)
        put_out(rows_ + t * row_step_, shares_at(first + t),
                out + values * static_cast<std::size_t>(t));
    }
    first += frames;
    out += values * static_cast<std::size_t>(frames);
    count -= frames;
  }
}

void FrameDecoder::sample_at(const PlaceInClip& place, float* out) {
  if (place.across > 0) return decode_across(place.across, out);
  const double frame = place.frame;
  const int before = static_cast<int>(frame);
  const auto share = static_cast<float>(frame - before);
  signals_.decode_window(before, share > 0 ? 2 : 1, rows_, row_step_);
  const float* const after = rows_ + row_step_;
  if (share > 0)
    for (std::ptrdiff_t k = 0; k < row_step_; ++k) rows_[k] += share * (after[k] - rows_[k]);
  put_out(rows_, shares_at(before, share), out);
}

void FrameDecoder::decode_across(float share, float* out) {
  constexpr float kTurn = 6.28318531F;  // radians
  const int last = clip_.segments.frames - 1;
  if (last == 0) return sample_at({}, out);
  signals_.decode_window(last - 1, 2, rows_, row_step_);
  const float* const before = rows_;
  float* const row = rows_ + row_step_;
  float* const first = row + row_step_;
  signals_.decode_window(0, 1, first, row_step_);
  const auto go = [&](std::int32_t signal, const auto& way) {
    if (const std::int32_t k = columns_[signal]; k != ResidentSignals::Columns::kNone)
      row[k] += share * way(k);
  };
  const auto straight = [&](std::int32_t k) { return first[k] - row[k]; };
  for (std::uint32_t j = 0; j < clip_.joint_count; ++j) {
    const JointModel& joint = clip_.joint_models()[j];
    for (int c = 0; c < joint.channels; ++c) {
      const std::int32_t channel = joint.first_channel + c;
      if (joint.parent < 0 && clip_.loop == LoopKind::Follows)
        go(channel, [&](std::int32_t k) { return row[k] - before[k]; });
      else if (is_rotation(joint.kinds[c]))
        go(channel, [&](std::int32_t k) { return std::remainder(straight(k), kTurn); });
      else
        go(channel, straight);
    }
  }
  for (int s = static_cast<int>(clip_.channel_count); s < clip_.largest.signal_count; ++s)
    go(s, straight);
  EndShares shares;
  if (request_.bands_left_out == 0) shares = {{share, 1 - share}};
  if (!clip_.end_reaches.any()) shares = {};
  put_out(row, shares, out);
}

EndShares FrameDecoder::shares_at(int frame, float share_of_next) const {
  EndShares shares;
  if (request_.bands_left_out > 0) return shares;  // end corrections need full detail
  const auto of_frame = [&](int end, int of) {
    return clip_.end_reaches.share_at(end, of, clip_.segments.frames);
  };
  for (int end = 0; end < kMostEnds && clip_.end_reaches.frames[end] > 0; ++end) {
    shares.of[end] = of_frame(end, frame);
    if (share_of_next > 0)
      shares.of[end] += share_of_next * (of_frame(end, frame + 1) - shares.of[end]);
  }
  return shares;
}

void FrameDecoder::add_ends(const EndShares& shares, float* row) const {
  for (int end = 0; end < kMostEnds; ++end) {
    const float share = shares.of[end];
    if (share == 0) continue;
    const float* const lacking = clip_.end_values(end);
    for (std::uint32_t c = 0; c < clip_.channel_count; ++c)
      if (columns_[c] != ResidentSignals::Columns::kNone) row[columns_[c]] += share * lacking[c];
  }
}

void FrameDecoder::correct(float* row) {
  const float* const lacking = row + clip_.channel_count;
  const std::uint32_t iterations =
      request_.solver_iterations == 0
          ? clip_.solver_iterations
          : std::min(request_.solver_iterations, clip_.solver_iterations);
  for (int l = 0; l < clip_.limb_count; ++l) {
    const LimbPlan plan = clip_.limb(l);
    limb_.set(plan, clip_.joint_models());
    limb_.set_frame(row);
    Vector3 targets[kMostEffectorsOfLimb];
    for (int e = 0; e < plan.effectors; ++e)
      targets[e] = limb_.position(e) + vector_of(lacking + 3 * plan.effector_numbers[e]);
    solve(clip_.solver, limb_, targets, static_cast<int>(iterations));
    for (int a = 0; a < plan.turns; ++a)
      row[plan.turn[a].channel] = static_cast<float>(limb_.angle(a));
  }
}

void FrameDecoder::put_out(float* row, const EndShares& shares, float* out) {
  if (solves_) correct(row);
  add_ends(shares, row);
  if (request_.output == MCPR_LOCAL) return put_out_local(row, out);
  if (request_.output == MCPR_POSITIONS) return put_out_positions(row, out);
  if (!picks_) {
    std::memcpy(out, row, values_of_frame(clip_, request_) * sizeof(float));
    return;
  }
  for (std::uint32_t i = 0; i < request_.channel_count; ++i) out[i] = row[request_.channels[i]];
}

void FrameDecoder::put_out_local(const float* row, float* out) const {
  for (std::uint32_t j = 0; j < clip_.joint_count; ++j, out += 7)
    put_place_in_parent(clip_.joint_models()[j], row, out);
}

void FrameDecoder::put_out_positions(const float* row, float* out) const {
  place_joints(clip_, row, places_);
  for (std::uint32_t j = 0; j < clip_.joint_count; ++j, out += 3)
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(places_[j].origin[i]);
}

}  // namespace mocapress::runtime
