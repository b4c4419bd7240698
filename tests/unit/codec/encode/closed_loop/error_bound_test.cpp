// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/error_bound.h"

#include <gtest/gtest.h>

#include <random>

#include "core/metrics/distortion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

/// Changes to a clip, some frames of a channel at a time.
class Changes {
 public:
  explicit Changes(int frames) : frames_(frames) {}

  /// Returns the first frame; up to `most` radians, or as many centimetres.
  Eigen::Index draw(double most, Eigen::VectorXd& delta) {
    const int count = std::uniform_int_distribution(1, frames_ / 2)(random_);
    delta = Eigen::VectorXd::NullaryExpr(
        count, [&] { return std::uniform_real_distribution(-most, most)(random_); });
    return std::uniform_int_distribution(0, frames_ - count)(random_);
  }

 private:
  int frames_;
  std::mt19937 random_{7};
};

struct Fixture {
  Motion motion = test::smooth_motion(60);
  Clip decoded = motion.clip;

  Eigen::VectorXd everywhere(double cm) const {
    return Eigen::VectorXd::Constant(motion.clip.frames(), cm);
  }
  double furthest_cm() const { return measure(motion.skeleton, motion.clip, decoded).max.cm; }
};

TEST(ErrorBound, KnowsTheErrorsOfWhateverIsAdded) {
  Fixture f;
  ErrorBound bound(f.motion, Weighting::BoneEnds, f.everywhere(2));
  Changes changes(f.decoded.frames());
  Eigen::VectorXd delta;
  for (int pass = 0; pass < 3; ++pass) {
    bound.begin(f.decoded);
    for (int c = 0; c < f.motion.skeleton.channel_count(); ++c) {
      bound.next();
      for (int i = 0; i < 3; ++i) {
        const Eigen::Index first = changes.draw(0.7, delta);  // far from linear
        bound.add(first, delta);
        f.decoded.channels.col(c).segment(first, delta.size()) += delta;
      }
    }
    EXPECT_NEAR(2 * bound.furthest(), f.furthest_cm(), 1e-5);
  }
}

TEST(ErrorBound, AllowsWhatStaysWithinItAndNothingElse) {
  Fixture f;
  constexpr double kBound = 1.5;  // cm
  ErrorBound bound(f.motion, Weighting::BoneEnds, f.everywhere(kBound));
  Changes changes(f.decoded.frames());
  Eigen::VectorXd delta;
  int allowed = 0;
  int refused = 0;
  bound.begin(f.decoded);
  for (int c = 0; c < f.motion.skeleton.channel_count(); ++c) {
    bound.next();
    for (int i = 0; i < 20; ++i) {
      const Eigen::Index first = changes.draw(0.04, delta);
      const bool allows = bound.allows(first, delta);
      f.decoded.channels.col(c).segment(first, delta.size()) += delta;
      EXPECT_EQ(allows, f.furthest_cm() <= kBound);
      ++(allows ? allowed : refused);
      if (allows)
        bound.add(first, delta);
      else
        f.decoded.channels.col(c).segment(first, delta.size()) -= delta;
    }
  }
  EXPECT_GT(allowed, 50);
  EXPECT_GT(refused, 50);
}

TEST(ErrorBound, LetsWhatIsBeyondItComeNearer) {
  Fixture f;
  f.decoded.channels.col(0).array() += 3;  // cm
  ErrorBound bound(f.motion, Weighting::BoneEnds, f.everywhere(1));
  bound.begin(f.decoded);
  bound.next();
  EXPECT_NEAR(bound.furthest(), 3, 1e-6);
  EXPECT_TRUE(bound.allows(0, Eigen::VectorXd::Constant(60, -1)));
  EXPECT_FALSE(bound.allows(0, Eigen::VectorXd::Constant(60, 0.1)));
}

TEST(ErrorBound, HasABoundForEachFrame) {
  Fixture f;
  Eigen::VectorXd bound_cm = f.everywhere(1);
  bound_cm.tail(30).setConstant(3);
  ErrorBound bound(f.motion, Weighting::BoneEnds, bound_cm);
  bound.begin(f.decoded);
  bound.next();
  const Eigen::VectorXd two = Eigen::VectorXd::Constant(30, 2);  // cm
  EXPECT_FALSE(bound.allows(0, two));
  EXPECT_FALSE(bound.allows(29, two));
  ASSERT_TRUE(bound.allows(30, two));
  bound.add(30, two);
  EXPECT_NEAR(bound.furthest(), 2.0 / 3, 1e-6);
}

}  // namespace
}  // namespace mocapress
