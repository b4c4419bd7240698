// SPDX-License-Identifier: MIT
#include "core/formats/gltf_animation.h"

#include <algorithm>
#include <cmath>

namespace mocapress {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

std::vector<float> vectors_of(const std::vector<Vector3d>& track) {
  std::vector<float> values;
  for (const Vector3d& vector : track)
    for (const double value : vector) values.push_back(static_cast<float>(value));
  return values;
}

/// Quaternions with signs chosen so that each is near the one before.
std::vector<float> turnings_of(const NodeTrack& track) {
  std::vector<float> values;
  Quaterniond last = track.rest.rotation;
  for (const Quaterniond& rotation : track.rotation) {
    const double side = rotation.dot(last) < 0 ? -1 : 1;
    last = Quaterniond(side * rotation.normalized().coeffs());
    for (const double value : last.coeffs()) values.push_back(static_cast<float>(value));
  }
  return values;
}

}  // namespace

AnimationWriter::AnimationWriter(BufferWriter& buffer, Json& animation, double first_s, int frames,
                                 double sample_rate_hz)
    : buffer_(buffer), animation_(animation), first_s_(first_s) {
  std::vector<float> times;
  for (int t = 0; t < frames; ++t)
    times.push_back(static_cast<float>(first_s + t / sample_rate_hz));
  times_ = buffer_.add("SCALAR", 1, times, true);
}

void AnimationWriter::add(const NodeTrack& track, bool always) {
  constexpr double kSamePlace = 1e-8;  // m
  constexpr double kSameTurn = 1e-8;
  const auto moves = [&](const Vector3d& place) {
    return (place - track.rest.translation).norm() > kSamePlace;
  };
  const auto turns = [&](const Quaterniond& rotation) {
    return 1 - std::abs(rotation.dot(track.rest.rotation)) > kSameTurn * kSameTurn;
  };
  if (std::ranges::any_of(track.translation, moves))
    add_channel(track.node, "translation", times_,
                buffer_.add("VEC3", 3, vectors_of(track.translation)));
  if (always || std::ranges::any_of(track.rotation, turns))
    add_channel(track.node, "rotation", times_, buffer_.add("VEC4", 4, turnings_of(track)));
  if (!track.scales.empty())
    add_channel(track.node, "scale", times_, buffer_.add("VEC3", 3, vectors_of(track.scales)));
  if (track.scale) {
    if (!start_) start_ = buffer_.add("SCALAR", 1, {static_cast<float>(first_s_)}, true);
    const Eigen::Vector3f scale = track.scale->cast<float>();
    add_channel(track.node, "scale", *start_,
                buffer_.add("VEC3", 3, {scale.x(), scale.y(), scale.z()}));
  }
}

void AnimationWriter::add(const WeightsTrack& weights) {
  std::vector<float> values;
  for (std::size_t t = 0; t < weights.of_target.front()->values.size(); ++t)
    for (const ScalarTrack* const track : weights.of_target) values.push_back(track->values[t]);
  const bool steps =
      std::ranges::all_of(weights.of_target, [](const ScalarTrack* track) { return track->steps; });
  add_channel(weights.node, "weights", times_, buffer_.add("SCALAR", 1, values),
              steps ? "STEP" : "LINEAR");
}

void AnimationWriter::add_channel(std::size_t node, const char* path, std::size_t input,
                                  std::size_t output, const char* interpolation) {
  Json& samplers = animation_["samplers"];
  samplers.push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
  animation_["channels"].push_back(
      {{"sampler", samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
}

Json json_of(const Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

void set_transform(Json& node, const LocalTransform& local) {
  if (!local.translation.isZero(0)) node["translation"] = json_of(local.translation);
  const Quaterniond& rotation = local.rotation;
  if (!rotation.coeffs().isApprox(Quaterniond::Identity().coeffs(), 1e-12))
    node["rotation"] = {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
  if (local.scale != Vector3d::Ones()) node["scale"] = json_of(local.scale);
}

}  // namespace mocapress
