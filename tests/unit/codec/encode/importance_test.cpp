// SPDX-License-Identifier: MIT
#include "core/codec/encode/importance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/codec/encode/encoder.h"
#include "core/motion/body_part.h"
#include "resources/samples/generator/samples.h"

namespace mocapress {
namespace {

const Encoder& walk() {
  static const Encoder shared(samples::walk_clip());
  return shared;
}

Encoding encoded(Method method, const Importance& importance) {
  return walk().encode({.method = method,
                        .coding = Coding::Adaptive,
                        .target = {Target::Kind::Ratio, 150},
                        .importance = importance});
}

std::vector<double> factor_of(BodyPart part, double factor) {
  const Skeleton& skeleton = walk().motion().skeleton;
  std::vector<double> joints(static_cast<std::size_t>(skeleton.joint_count()), 1.0);
  for (const int joint : joints_of(skeleton, part))
    joints[static_cast<std::size_t>(joint)] = factor;
  return joints;
}

double mean_error_of(BodyPart part, const Encoding& encoding) {
  double sum = 0;
  const auto joints = joints_of(walk().motion().skeleton, part);
  for (const int joint : joints) sum += encoding.distortion.distances.col(joint).mean();
  return sum / static_cast<double>(joints.size());
}

TEST(Importance, BringsAPartNearerAtTheSameSize) {
  for (const Method method : {Method::Annealed, Method::ClosedLoop})
    for (const BodyPart part : {BodyPart::Feet, BodyPart::Hands, BodyPart::Head})
      EXPECT_LT(mean_error_of(part, encoded(method, {.joints = factor_of(part, 20)})),
                0.95 * mean_error_of(part, encoded(method, {})))
          << name(method) << " " << name(part);
}

TEST(Importance, OfContactsKeepsFeetPlanted) {
  EXPECT_LT(encoded(Method::ClosedLoop, {.contacts = 20}).footskate.total_cm,
            0.5 * encoded(Method::ClosedLoop, {}).footskate.total_cm);
}

TEST(Importance, AlikeForAllIsNone) {
  const std::vector<double> alike(static_cast<std::size_t>(walk().motion().skeleton.joint_count()),
                                  3.0);
  EXPECT_EQ(encoded(Method::ClosedLoop, {.joints = alike}).compressed.motion,
            encoded(Method::ClosedLoop, {}).compressed.motion);
}

TEST(Importance, MustBeOneNumberForEachJointAndSomeAboveZero) {
  const Skeleton& skeleton = walk().motion().skeleton;
  const auto joints = static_cast<std::size_t>(skeleton.joint_count());
  for (const std::vector<double>& bad :
       {std::vector<double>(joints - 1, 1.0), std::vector<double>(joints, 0.0),
        std::vector<double>(joints, -1.0), std::vector<double>(joints, NAN)})
    EXPECT_THROW(important_points(skeleton, Weighting::BoneEnds, {.joints = bad}), Error);
}

}  // namespace
}  // namespace mocapress
