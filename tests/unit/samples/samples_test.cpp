// SPDX-License-Identifier: MIT
#include "resources/samples/generator/samples.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include "core/base/file.h"
#include "core/formats/motion_file.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"

namespace mocapress::samples {
namespace {

struct Sample {
  const char* name;
  Choreography (*choreograph)();
  Motion (*clip)();
  int flights;
};

class Samples : public testing::TestWithParam<Sample> {
 protected:
  const Choreography choreography_ = GetParam().choreograph();
  const Motion motion_ = GetParam().clip();

  double seconds(int frame) const { return frame / motion_.clip.sample_rate_hz; }

  /// The path of a point fixed to a joint over the clip.
  std::vector<Eigen::Vector3d> path(const std::string& joint, const Eigen::Vector3d& at) const {
    std::vector<Eigen::Vector3d> points;
    Pose pose;
    for (int t = 0; t < motion_.clip.frames(); ++t) {
      compute_pose(motion_.skeleton, motion_.clip.channels.row(t), pose);
      points.push_back(pose.to_world(motion_.skeleton.find(joint), at));
    }
    return points;
  }

  Eigen::VectorXd degrees(const std::string& joint, ChannelKind kind) const {
    const Skeleton& skeleton = motion_.skeleton;
    for (int c = 0; c < skeleton.channel_count(); ++c)
      if (skeleton.joint(skeleton.channel_joint(c)).name == joint &&
          skeleton.channel_kind(c) == kind)
        return motion_.clip.channels.col(c) * in_degrees(1);
    return {};
  }
};

/// Over every stretch of frames that `down` names for a stance, the point is on the floor and
/// stays.
void expect_planted(const std::vector<Eigen::Vector3d>& path, const FootPlan& plan, double rate,
                    const std::function<bool(const Stance&, double)>& down) {
  int contacts = 0;
  for (const Stance& stance : plan.stances()) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t t = 0; t < path.size(); ++t)
      if (down(stance, static_cast<double>(t) / rate)) points.push_back(path[t]);
    if (points.empty()) continue;
    ++contacts;
    Eigen::AlignedBox2d ground;
    for (const Eigen::Vector3d& point : points) {
      EXPECT_LT(std::abs(point.y()), 0.1);
      ground.extend(Eigen::Vector2d(point.x(), point.z()));
    }
    EXPECT_LT(ground.diagonal().norm(), 0.1);
  }
  EXPECT_GE(contacts, 3);
}

TEST_P(Samples, AreAFewSecondsAt120HzOnThe62ChannelSkeleton) {
  EXPECT_EQ(motion_.clip.sample_rate_hz, 120);
  EXPECT_EQ(motion_.clip.channels.cols(), 62);
  EXPECT_GE(motion_.clip.seconds(), 4);
  EXPECT_LE(motion_.clip.seconds(), 6);
}

TEST_P(Samples, KeepBothHeelsAndBallsWhereTheyCameDown) {
  for (const Side side : {Side::Left, Side::Right}) {
    const FootPlan& plan = choreography_.foot(side);
    const double rate = motion_.clip.sample_rate_hz;
    SCOPED_TRACE(side == Side::Left ? "left" : "right");
    expect_planted(path(sided(side, "foot"), kHeelInFoot), plan, rate, &Stance::heel_down);
    expect_planted(path(sided(side, "toes"), kBallInToes), plan, rate, &Stance::ball_down);
  }
}

TEST_P(Samples, StayAboveTheFloor) {
  EXPECT_GT(
      landmark_tracks(motion_.skeleton, motion_.clip)(Eigen::all, Eigen::seq(1, Eigen::last, 3))
          .minCoeff(),
      -0.3);
  for (const Side side : {Side::Left, Side::Right})
    for (const auto& [joint, sole] :
         {std::pair{"foot", kHeelInFoot}, std::pair{"toes", kBallInToes},
          std::pair{"toes", kTipInToes}})
      for (const Eigen::Vector3d& point : path(sided(side, joint), sole))
        EXPECT_GT(point.y(), -0.3);
}

TEST_P(Samples, NeverBendAKneeBackwards) {
  for (const char* knee : {"ltibia", "rtibia"}) {
    const Eigen::VectorXd flexion = degrees(knee, ChannelKind::RotationX);
    EXPECT_GE(flexion.minCoeff(), 2) << knee;
    EXPECT_LE(flexion.maxCoeff(), 140) << knee;
  }
}

TEST_P(Samples, MoveNoJointFasterThanPeopleDo) {
  const Skeleton& skeleton = motion_.skeleton;
  const Eigen::Index steps = motion_.clip.frames() - 1;
  const Eigen::MatrixXd speeds =
      (motion_.clip.channels.bottomRows(steps) - motion_.clip.channels.topRows(steps)).cwiseAbs() *
      motion_.clip.sample_rate_hz;
  for (int c = 0; c < skeleton.channel_count(); ++c) {
    const bool turns = is_rotation(skeleton.channel_kind(c));
    const double fastest = speeds.col(c).maxCoeff() * (turns ? in_degrees(1) : 1);
    EXPECT_LT(fastest, turns ? 1200 : 450) << skeleton.channel_name(c);  // degrees/s, cm/s
  }
}

TEST_P(Samples, MoveEveryChannel) {
  for (int c = 0; c < motion_.skeleton.channel_count(); ++c) {
    const auto channel = motion_.clip.channels.col(c).array();
    EXPECT_GT(channel.maxCoeff() - channel.minCoeff(), in_radians(0.5))
        << motion_.skeleton.channel_name(c);
  }
}

TEST_P(Samples, FallFreelyWhileNoFootIsDown) {
  const auto aloft = [&](int t) {
    return !choreography_.left.stance_at(seconds(t)) && !choreography_.right.stance_at(seconds(t));
  };
  const auto height = [&](int t) {
    return centre_of_mass(motion_.skeleton, motion_.clip.channels.row(t)).y();
  };
  int flights = 0;
  for (int first = 1; first < motion_.clip.frames(); ++first) {
    if (!aloft(first) || aloft(first - 1)) continue;
    int last = first;
    while (last + 1 < motion_.clip.frames() && aloft(last + 1)) ++last;
    ++flights;
    for (int t = first; t <= last; ++t) {
      const double flown = seconds(t) - seconds(first);
      const double left = seconds(last) - seconds(t);
      const double share = last > first ? flown / (flown + left) : 0;
      const double parabola =
          std::lerp(height(first), height(last), share) + kGravity / 2 * flown * left;
      EXPECT_NEAR(height(t), parabola, 0.15) << "frame " << t;
    }
    first = last;
  }
  EXPECT_EQ(flights, GetParam().flights);
}

TEST_P(Samples, AreTheBundledFilesByteForByte) {
  const std::filesystem::path bundled =
      std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources" / "samples";
  const std::filesystem::path made =
      testing::TempDir() + "mocapress-sample-" + std::to_string(getpid());
  std::filesystem::create_directories(made);
  const std::string amc = std::string("human_") + GetParam().name + ".amc";
  write_motion(made / amc, motion_, made / "human.asf");
  EXPECT_TRUE(read_bytes(made / amc) == read_bytes(bundled / amc)) << made / amc;
  EXPECT_TRUE(read_bytes(made / "human.asf") == read_bytes(bundled / "human.asf"));
  std::filesystem::remove_all(made);
}

TEST_P(Samples, ReadBackAsTheyWereMadeAndWithoutWarnings) {
  const std::filesystem::path bundled =
      std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources" / "samples";
  const MotionFile read = read_motion(bundled / (std::string("human_") + GetParam().name + ".amc"));
  EXPECT_TRUE(read.warnings.empty()) << read.warnings.front().text();
  const Eigen::MatrixXd moved = landmark_tracks(read.motion.skeleton, read.motion.clip) -
                                landmark_tracks(motion_.skeleton, motion_.clip);
  EXPECT_LT(moved.cwiseAbs().maxCoeff(), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(All, Samples,
                         testing::Values(Sample{"walk", walk, walk_clip, 0},
                                         Sample{"run", run, run_clip, 13},
                                         Sample{"jump", jump, jump_clip, 2}),
                         [](const auto& sample) { return std::string(sample.param.name); });

}  // namespace
}  // namespace mocapress::samples
