// SPDX-License-Identifier: MIT
#include "tests/bench/acl_peer.h"

#include <acl/compression/compress.h>
#include <acl/compression/compression_settings.h>
#include <acl/compression/pre_process.h>
#include <acl/compression/track_array.h>
#include <acl/compression/transform_error_metrics.h>
#include <acl/core/ansi_allocator.h>
#include <acl/decompression/decompress.h>

#include <Eigen/Geometry>
#include <chrono>
#include <memory>
#include <optional>

#include "core/base/error.h"
#include "core/motion/body_tracks.h"
#include "core/motion/forward_kinematics.h"
#include "tests/bench/acl_pose_writer.h"

namespace mocapress {
namespace {

struct Local {
  Eigen::Quaterniond rotation;
  Eigen::Vector3d translation;  // cm
};

/// The transform in the parent's frame, or in the world for a root.
Local local_of(const Skeleton& skeleton, const Pose& pose, int joint) {
  const auto j = static_cast<std::size_t>(joint);
  const int parent = skeleton.joint(joint).parent;
  if (parent < 0) return {Eigen::Quaterniond(pose.world_from_joint[j]), pose.origin[j]};
  const auto p = static_cast<std::size_t>(parent);
  const Eigen::Matrix3d parent_from_world = pose.world_from_joint[p].transpose();
  return {Eigen::Quaterniond(parent_from_world * pose.world_from_joint[j]),
          parent_from_world * (pose.origin[j] - pose.origin[p])};
}

rtm::qvvf qvv_of(const Local& local) {
  const Eigen::Quaternionf q = local.rotation.normalized().cast<float>();
  const Eigen::Vector3f v = local.translation.cast<float>();
  return rtm::qvv_set(rtm::quat_set(q.x(), q.y(), q.z(), q.w()),
                      rtm::vector_set(v.x(), v.y(), v.z()), rtm::vector_set(1.0F));
}

void require(const acl::error_result& result) {
  if (result.any()) throw Error(std::string("ACL: ") + result.c_str());
}

Pose pose_of(const Skeleton& skeleton, const std::vector<rtm::qvvf>& locals) {
  Pose pose;
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const rtm::qvvf& local = locals[static_cast<std::size_t>(j)];
    const Eigen::Quaterniond rotation(
        rtm::quat_get_w(local.rotation), rtm::quat_get_x(local.rotation),
        rtm::quat_get_y(local.rotation), rtm::quat_get_z(local.rotation));
    const Eigen::Vector3d translation(rtm::vector_get_x(local.translation),
                                      rtm::vector_get_y(local.translation),
                                      rtm::vector_get_z(local.translation));
    const int parent = skeleton.joint(j).parent;
    const Eigen::Matrix3d turned = rotation.normalized().toRotationMatrix();
    pose.world_from_joint.push_back(
        parent < 0 ? turned : pose.world_from_joint[static_cast<std::size_t>(parent)] * turned);
    pose.origin.push_back(parent < 0 ? translation : pose.to_world(parent, translation));
  }
  return pose;
}

}  // namespace

struct AclClip::Parts {
  using Context = acl::decompression_context<acl::default_transform_decompression_settings>;
  acl::ansi_allocator allocator;
  acl::compressed_tracks* compressed = nullptr;
  std::uint32_t frames = 0;
  float rate = 0;  // Hz
  double encode_seconds = 0;
  std::vector<rtm::qvvf> bind;
  std::optional<Context> context;
  PoseWriter writer;

  ~Parts() {
    if (compressed != nullptr) allocator.deallocate(compressed, compressed->get_size());
  }
};

AclClip::AclClip(const Motion& motion, double precision_cm) : parts_(std::make_unique<Parts>()) {
  const Skeleton& skeleton = motion.skeleton;
  const auto joints = static_cast<std::uint32_t>(skeleton.joint_count());
  const auto frames = static_cast<std::uint32_t>(motion.clip.frames());
  const auto rate = static_cast<float>(motion.clip.sample_rate_hz);
  acl::ansi_allocator& allocator = parts_->allocator;
  acl::track_array_qvvf tracks(allocator, joints);
  const Pose bind = rest_pose(skeleton);
  std::vector<rtm::qvvf>& bind_locals = parts_->bind;
  for (std::uint32_t j = 0; j < joints; ++j) {
    const int parent = skeleton.joint(static_cast<int>(j)).parent;
    bind_locals.push_back(qvv_of(local_of(skeleton, bind, static_cast<int>(j))));
    acl::track_desc_transformf description;
    description.output_index = j;
    description.parent_index =
        parent < 0 ? acl::k_invalid_track_index : static_cast<std::uint32_t>(parent);
    description.precision = static_cast<float>(precision_cm);
    description.shell_distance = static_cast<float>(kShellRadius);
    description.default_value = bind_locals.back();
    tracks[j] = acl::track_qvvf::make_reserve(description, allocator, frames, rate);
  }
  Pose pose;
  for (std::uint32_t t = 0; t < frames; ++t) {
    compute_pose(skeleton, motion.clip.channels.row(t), pose);
    for (std::uint32_t j = 0; j < joints; ++j)
      tracks[j][t] = qvv_of(local_of(skeleton, pose, static_cast<int>(j)));
  }

  const auto start = std::chrono::steady_clock::now();
  acl::qvvf_transform_error_metric metric;
  acl::pre_process_settings_t before;
  before.precision_policy = acl::pre_process_precision_policy::lossy;
  before.error_metric = &metric;
  require(acl::pre_process_track_list(allocator, before, tracks));
  acl::compression_settings settings = acl::get_default_compression_settings();
  settings.level = acl::compression_level8::medium;
  settings.error_metric = &metric;
  acl::output_stats stats;
  require(acl::compress_track_list(allocator, tracks, settings, parts_->compressed, stats));
  parts_->encode_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  parts_->frames = frames;
  parts_->rate = rate;
}

AclClip::~AclClip() = default;

std::size_t AclClip::bytes() const {
  return parts_->compressed->get_size();
}

std::span<const std::byte> AclClip::block() const {
  return {reinterpret_cast<const std::byte*>(parts_->compressed), bytes()};
}

double AclClip::encode_seconds() const {
  return parts_->encode_seconds;
}

void AclClip::decode_frames() {
  for (std::uint32_t t = 0; t < parts_->frames; ++t) {
    parts_->context->seek(static_cast<float>(t) / parts_->rate,
                          acl::sample_rounding_policy::nearest);
    parts_->context->decompress_tracks(parts_->writer);
  }
}

Eigen::MatrixXd AclClip::tracks(const Skeleton& skeleton) const {
  std::vector<Landmark> points = landmarks(skeleton);
  const std::vector<Landmark> shell = shell_points(skeleton);
  points.insert(points.end(), shell.begin(), shell.end());
  Eigen::MatrixXd tracks(parts_->frames, 3 * std::ssize(points));
  Parts::Context context;
  if (!context.initialize(*parts_->compressed)) throw Error("ACL: cannot open what it wrote");
  PoseWriter writer;
  for (std::uint32_t t = 0; t < parts_->frames; ++t) {
    writer.joints = parts_->bind;
    context.seek(static_cast<float>(t) / parts_->rate, acl::sample_rounding_policy::nearest);
    context.decompress_tracks(writer);
    place_landmarks(points, pose_of(skeleton, writer.joints), static_cast<int>(t), tracks);
  }
  return tracks;
}

void AclClip::open() {
  parts_->context.emplace();
  if (!parts_->context->initialize(*parts_->compressed))
    throw Error("ACL: cannot open what it wrote");
  if (parts_->writer.joints.empty()) parts_->writer.joints = parts_->bind;
}

struct AclPlayer::State {
  AclClip::Parts::Context context;
  PoseWriter writer;
};

AclPlayer::AclPlayer(const AclClip& clip) : state_(std::make_unique<State>()) {
  if (!state_->context.initialize(*clip.parts_->compressed))
    throw Error("ACL: cannot open what it wrote");
  state_->writer.joints = clip.parts_->bind;
}

AclPlayer::AclPlayer(AclPlayer&&) noexcept = default;
AclPlayer::~AclPlayer() = default;

AclPlayer::AclPlayer(const std::byte* block, std::size_t joints)
    : state_(std::make_unique<State>()) {
  state_->writer.joints.resize(joints);
  open(block);
}

void AclPlayer::open(const std::byte* block) {
  if (!state_->context.initialize(*reinterpret_cast<const acl::compressed_tracks*>(block)))
    throw Error("ACL: cannot open what it wrote");
}

void AclPlayer::sample(float seconds) {
  state_->context.seek(seconds, acl::sample_rounding_policy::none);
  state_->context.decompress_tracks(state_->writer);
}

void AclClip::sample(float seconds) {
  parts_->context->seek(seconds, acl::sample_rounding_policy::none);
  parts_->context->decompress_tracks(parts_->writer);
}

}  // namespace mocapress
