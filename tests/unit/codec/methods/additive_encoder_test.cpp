// SPDX-License-Identifier: MIT
#include "core/codec/methods/additive_encoder.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/error.h"
#include "core/codec/format/container.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"
#include "core/runtime/mocapress_runtime.h"
#include "tests/support/opened_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress::additive_encoder_test {
namespace {

constexpr int kFrames = 240;

/// A motion, and one that leans beyond it more and less.
Motion base_clip() {
  return test::smooth_motion(kFrames);
}
Motion leaning() {
  Motion motion = base_clip();
  const int spine = motion.skeleton.first_channel(motion.skeleton.find("spine"));
  const int upper = motion.skeleton.first_channel(motion.skeleton.find("lupper"));
  for (int t = 0; t < kFrames; ++t) {
    motion.clip.channels(t, spine) += 0.3 + 0.1 * std::sin(t / 25.0);
    motion.clip.channels(t, upper + 1) += 0.2 * std::sin(t / 40.0);
    motion.clip.channels(t, 1) += 2 * std::cos(t / 30.0);
  }
  return motion;
}

const CompressionMethod& closed_loop() {
  return *find_compression_method("closed-loop");
}

EncodeSettings to_error(double cm, Weighting weighting = Weighting::JointOrigins) {
  return {.weighting = weighting, .target = {Target::Kind::Error, cm}};
}

Encoding compressed(const Motion& base, const EncodeSettings& settings) {
  return AdditiveEncoder(leaning(), base).compress(closed_loop(), settings, {});
}

TEST(AdditiveEncoder, MeetsTheErrorOfBasePlusDifferenceInTheWorld) {
  for (const Motion& base : {frames_of(base_clip(), 0, 1), base_clip()})
    for (const double cm : {0.1, 0.5}) {
      const Encoding made = compressed(base, to_error(cm));
      EXPECT_LE(made.distortion.eps_joint_origins, cm);
      // The search knows a base pose, but of a clip only its first frame.
      EXPECT_GT(made.distortion.eps_joint_origins, (base.clip.frames() == 1 ? 0.9 : 0.5) * cm);
      EXPECT_NEAR(sections_of(made.file).eps_cm, made.distortion.eps_joint_origins, 1e-3 * cm);
      const Encoding largest =
          AdditiveEncoder(leaning(), base)
              .compress(closed_loop(), {.target = {Target::Kind::MaxError, 4 * cm}}, {});
      EXPECT_LE(largest.distortion.max.cm, 4 * cm);
    }
}

TEST(AdditiveEncoder, TakesFewerBytesThanTheMotionWhereTheBaseHasMostOfIt) {
  const Encoding whole = MethodEncoder(leaning()).compress(closed_loop(), to_error(0.25));
  const Encoding difference = compressed(base_clip(), to_error(0.25));
  EXPECT_LT(5 * difference.compressed.motion_bytes(), 2 * whole.compressed.motion_bytes());
}

mcpr_transform transform_of(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation) {
  const Eigen::Quaternionf q(rotation.cast<float>());
  const Eigen::Vector3f t = translation.cast<float>();
  return {{q.w(), q.x(), q.y(), q.z()}, {t.x(), t.y(), t.z(), 0}};
}

/// A frame's local transforms.
std::vector<mcpr_transform> locals(const Motion& motion, int frame) {
  Pose pose;
  compute_pose(motion.skeleton, motion.clip.channels.row(frame), pose);
  std::vector<mcpr_transform> transforms;
  for (int j = 0; j < motion.skeleton.joint_count(); ++j) {
    const auto joint = static_cast<std::size_t>(j);
    const int p = motion.skeleton.joint(j).parent;
    const auto parent = static_cast<std::size_t>(p);
    const Eigen::Matrix3d from_world =
        p < 0 ? Eigen::Matrix3d::Identity()
              : Eigen::Matrix3d(pose.world_from_joint[parent].transpose());
    const Eigen::Vector3d above = p < 0 ? Eigen::Vector3d::Zero() : pose.origin[parent];
    transforms.push_back(transform_of(from_world * pose.world_from_joint[joint],
                                      from_world * (pose.origin[joint] - above)));
  }
  return transforms;
}

/// Origins of all joints in the world, from local transforms.
Eigen::Matrix3Xd origins(const Skeleton& skeleton, const std::vector<mcpr_transform>& pose) {
  Eigen::Matrix3Xd places(3, std::ssize(pose));
  std::vector<Eigen::Quaterniond> world;
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const auto& [r, t] = pose[static_cast<std::size_t>(j)];
    const Eigen::Quaterniond rotation(r[0], r[1], r[2], r[3]);
    const Eigen::Vector3d translation(t[0], t[1], t[2]);
    const int p = skeleton.joint(j).parent;
    const auto parent = static_cast<std::size_t>(p);
    places.col(j) =
        p < 0 ? translation : Eigen::Vector3d(places.col(p) + world[parent] * translation);
    world.push_back(p < 0 ? rotation : world[parent] * rotation);
  }
  return places;
}

/// As the runtime's README says: the difference of a sampled pose to the rest pose is added to the
/// base.
TEST(AdditiveEncoder, EnginesAddItToWhereItWasMeasured) {
  constexpr double kTarget = 0.2;  // cm
  const Motion motion = leaning();
  const Eigen::RowVectorXd weights = landmark_weights(motion.skeleton, Weighting::JointOrigins)
                                         .head(motion.skeleton.joint_count());
  for (const Motion& base : {frames_of(base_clip(), 0, 1), base_clip()}) {
    const Encoding made = compressed(base, to_error(kTarget));
    const test::OpenedClip opened(made.file);
    ASSERT_NE(opened.clip, nullptr);
    const auto joints = static_cast<std::size_t>(motion.skeleton.joint_count());
    const std::vector<float> frames = opened.frames({.output = MCPR_LOCAL}, 0, kFrames);
    std::vector<mcpr_transform> rest;
    for (const Joint& joint : motion.skeleton.joints())
      rest.push_back(transform_of(Eigen::Matrix3d::Identity(), joint.offset));
    const mcpr_pose_form form{static_cast<std::uint32_t>(joints), nullptr};
    double squares = 0;
    for (int t = 0; t < kFrames; ++t) {
      std::vector<mcpr_transform> difference(joints);
      for (std::size_t j = 0; j < joints; ++j) {
        const float* const values = &frames[7 * (joints * static_cast<std::size_t>(t) + j)];
        difference[j] = {{values[0], values[1], values[2], values[3]},
                         {values[4], values[5], values[6], 0}};
      }
      ASSERT_EQ(
          mcpr_pose_difference(&form, difference.data(), rest.data(), difference.data(), nullptr),
          MCPR_OK);
      std::vector<mcpr_transform> pose = locals(base, base.clip.frames() == 1 ? 0 : t);
      const mcpr_weighted_pose added{difference.data(), 1, nullptr};
      ASSERT_EQ(mcpr_blend_additive(&form, &added, pose.data(), nullptr), MCPR_OK);
      const Eigen::Matrix3Xd off =
          origins(motion.skeleton, pose) - origins(motion.skeleton, locals(motion, t));
      squares += off.colwise().squaredNorm().dot(weights);
    }
    const double rms = std::sqrt(squares / kFrames);
    EXPECT_NEAR(rms, made.distortion.eps_joint_origins, 0.01 * kTarget);
    EXPECT_LE(rms, 1.001 * kTarget);
  }
}

TEST(AdditiveEncoder, RefusesInverseKinematicsAndOtherCodings) {
  const AdditiveEncoder encoder(leaning(), base_clip());
  EncodeSettings settings = to_error(0.5);
  settings.correction.emplace();
  EXPECT_THROW(encoder.compress(closed_loop(), settings, {}), Error);
  EXPECT_THROW(encoder.compress(*find_compression_method("annealed"), to_error(0.5), {}), Error);
}

}  // namespace
}  // namespace mocapress::additive_encoder_test
