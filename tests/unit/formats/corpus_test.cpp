// SPDX-License-Identifier: MIT
// The readers and writers against every real file there is.
#include "tests/support/corpus.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <set>

#include "core/base/file.h"
#include "core/formats/amc.h"
#include "core/formats/bvh.h"
#include "core/motion/forward_kinematics.h"
#include "tests/support/same_motion.h"

namespace mocapress::corpus_test {
namespace {

namespace fs = std::filesystem;

constexpr double kMove = 1e-4;  // cm

/// The result of reading a file of the corpus.
struct Row {
  const char* file;
  int frames;
  int channels;
  int joints;
  double rate;
  std::vector<std::string> warnings;  // their main words, in order
};

const std::string kCut = "ends within its last frame";
constexpr const char* kTwoRoots = "strangers/two_roots_min.bvh";
const std::string kAlongZ = "stands along Z";

const std::vector<Row> kTable = {
    {"attack/esc.bvh", 40, 9, 2, 100, {"replace OFFSET", "14.5069 cm to the unit"}},
    {"bvh/11_01.amc", 597, 62, 31, 120, {}},
    {"bvh/11_01.bvh", 598, 132, 43, 120, {}},
    {"bvh/131_01.bvh", 994, 96, 31, 120, {"5.6444 cm to the unit"}},
    {"bvh/cmu_12_01_walk.bvh", 524, 96, 31, 120, {"5.6444 cm to the unit"}},
    {"bvh/iclone_006_05_60hz_100joints.bvh", 192, 303, 100, 60, {}},
    {"odd/Boxing_Toes_extra_row.bvh", 3070, 66, 21, 100, {"says 3069 frames, 3070 follow"}},
    {"odd/bvh_test1.bvh", 75, 75, 24, 30, {kAlongZ, "2.54 cm to the unit"}},
    {"odd/bvh_test3.bvh", 100, 183, 60, 120, {"2.54 cm to the unit"}},
    {"odd/cmu07_12_TRUNCATED_last_frame.amc", 244, 62, 31, 120, {kCut}},
    {"odd/cmu135_FORCE-ALL-JOINTS-BE-3DOF_truncated.amc",
     2611,
     90,
     31,
     120,
     {kCut, "18 bones with three values where the skeleton names fewer, read as its dof"}},
    {"odd/cmu16_11_blender_reexport_96dof_bones_not_in_asf_dof.amc",
     250,
     96,
     31,
     120,
     {"20 bones with three values where the skeleton names fewer, read as rx ry rz"}},
    {"odd/makehuman_benchmark_1frame_891ch_6chan_joints.bvh",
     1,
     891,
     163,
     24,
     {kAlongZ, "10 cm to the unit"}},
    {"odd/makehuman_walk_XYZ_fingers.bvh", 14, 228, 75, 24, {kAlongZ, "10 cm to the unit"}},
    {kTwoRoots, 3, 18, 4, 30, {"replace OFFSET"}},
    {"study/01_14.amc", 2338, 62, 31, 120, {}},
    {"study/02_01.amc", 343, 62, 31, 120, {}},
    {"study/02_05.amc", 1854, 62, 31, 120, {}},
    {"study/05_10.amc", 817, 62, 31, 120, {}},
    {"study/09_01.amc", 148, 62, 31, 120, {}},
    {"study/127_08.amc", 139, 62, 31, 120, {}},
    {"study/135_07.amc", 1472, 62, 31, 120, {}},
    {"study/14_02.amc", 5423, 62, 31, 120, {}},
    {"study/14_06.amc", 5357, 62, 31, 120, {}},
    {"study/16_22.amc", 307, 62, 31, 120, {}},
    {"study/17_10.amc", 2783, 62, 31, 120, {}},
    {"study/29_04.amc", 3833, 62, 31, 120, {}},
    {"study/49_02.amc", 2085, 62, 31, 120, {}},
    {"study/49_06.amc", 481, 62, 31, 120, {}},
    {"study/86_01.amc", 4579, 62, 31, 120, {}},
    {"train/02_08.amc", 1500, 62, 31, 120, {}},
    {"train/03_02.amc", 365, 62, 31, 120, {}},
    {"train/05_06.amc", 885, 62, 31, 120, {}},
    {"train/05_09.amc", 1143, 62, 31, 120, {}},
    {"train/05_15.amc", 540, 62, 31, 120, {}},
    {"train/09_05.amc", 143, 62, 31, 120, {}},
    {"train/09_11.amc", 165, 62, 31, 120, {}},
    {"train/127_12.amc", 177, 62, 31, 120, {}},
    {"train/127_20.amc", 360, 62, 31, 120, {}},
    {"train/127_27.amc", 249, 62, 31, 120, {}},
    {"train/135_03.amc", 2749, 62, 31, 120, {}},
    {"train/135_08.amc", 291, 62, 31, 120, {}},
    {"train/14_08.amc", 2625, 62, 31, 120, {}},
    {"train/14_12.amc", 2753, 62, 31, 120, {}},
    {"train/14_20.amc", 4644, 62, 31, 120, {}},
    {"train/16_05.amc", 295, 62, 31, 120, {}},
    {"train/16_31.amc", 424, 62, 31, 120, {}},
    {"train/16_40.amc", 194, 62, 31, 120, {}},
    {"train/16_49.amc", 127, 62, 31, 120, {}},
    {"train/29_02.amc", 3119, 62, 31, 120, {}},
    {"train/29_11.amc", 3720, 62, 31, 120, {}},
    {"train/35_01.amc", 358, 62, 31, 120, {}},
    {"train/49_10.amc", 1424, 62, 31, 120, {}},
    {"train/49_15.amc", 947, 62, 31, 120, {}},
    {"train/49_18.amc", 1102, 62, 31, 120, {}},
    {"train/86_09.amc", 4794, 62, 31, 120, {}},
};

class Corpus : public testing::Test {
 protected:
  void SetUp() override {
    const auto found = test::corpus();
    if (!found) GTEST_SKIP() << "the corpus of real motions is not here";
    folder_ = *found;
  }

  Motion read(const std::string& file) const { return read_motion(folder_ / file).motion; }

  fs::path folder_;
};

Pose pose_of(const Motion& motion, int frame) {
  Pose pose;
  compute_pose(motion.skeleton, motion.clip.channels.row(frame), pose);
  return pose;
}

double degrees_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::AngleAxisd(a.transpose() * b).angle() * 180 / std::numbers::pi;
}

TEST_F(Corpus, EveryFileReadsAsTheTableSays) {
  for (const Row& row : kTable) {
    SCOPED_TRACE(row.file);
    const auto [motion, warnings, source, states_rate, skin, takes, tracks] =
        read_motion(folder_ / row.file);
    EXPECT_EQ(motion.clip.frames(), row.frames);
    EXPECT_EQ(motion.skeleton.channel_count(), row.channels);
    EXPECT_EQ(motion.skeleton.joint_count(), row.joints);
    EXPECT_EQ(motion.clip.sample_rate_hz, row.rate);
    ASSERT_EQ(warnings.size(), row.warnings.size());
    for (std::size_t i = 0; i < warnings.size(); ++i)
      EXPECT_NE(warnings[i].message.find(row.warnings[i]), std::string::npos)
          << warnings[i].message;
  }
}

TEST_F(Corpus, HasNoMotionThatTheTableLeavesOut) {
  std::set<fs::path> listed;
  for (const Row& row : kTable) listed.insert(folder_ / row.file);
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    const fs::path extension = entry.path().extension();
    const bool has_motion = extension == ".bvh" || extension == ".amc";
    EXPECT_TRUE(!has_motion || listed.contains(entry.path())) << entry.path();
  }
}

TEST_F(Corpus, EverySkeletonReads) {
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    if (entry.path().extension() != ".asf") continue;
    const AsfSkeleton skeleton = read_asf(entry.path().string(), read_text(entry.path()));
    const bool kitchen = entry.path().filename().string().starts_with("cmukitchen");
    EXPECT_EQ(skeleton.joints.size(), kitchen ? 27u : 31u) << entry.path();
  }
}

TEST_F(Corpus, EveryMotionComesBackThroughBvh) {
  for (const Row& row : kTable) {
    const Motion motion = read(row.file);
    const std::vector<std::string> names = bvh_names(motion.skeleton);
    // The two figures, on one spot at rest in the BVH, are 80 cm tall and would not be taken for
    // centimetres.
    const ReadOptions told{.cm_per_unit =
                               row.file == kTwoRoots ? std::optional(1.0) : std::nullopt};
    const auto [reread, warnings, source, states_rate, skin, takes, tracks] =
        read_bvh("f", bvh_text(motion), told);
    EXPECT_LT(test::largest_move(motion, reread, names), kMove) << row.file;
    EXPECT_EQ(reread.clip.sample_rate_hz, row.rate) << row.file;
  }
}

TEST_F(Corpus, EveryMotionComesBackThroughAcclaim) {
  for (const Row& row : kTable) {
    const Motion motion = read(row.file);
    const Motion acclaim = acclaim_motion(motion);
    if (row.file == kTwoRoots) {
      EXPECT_THROW(asf_text(acclaim.skeleton), WriteError);
      continue;
    }
    const AsfSkeleton skeleton = read_asf("f.asf", asf_text(acclaim.skeleton));
    const auto [reread, warnings, source, states_rate, skin, takes, tracks] =
        read_amc("f.amc", amc_text(acclaim), skeleton);
    EXPECT_TRUE(warnings.empty()) << row.file << ": " << warnings.front().text();
    EXPECT_LT(test::largest_move(motion, reread, asf_names(motion.skeleton)), kMove) << row.file;
    const bool gains_helper_bones = !std::string_view(row.file).ends_with(".amc");
    EXPECT_TRUE(gains_helper_bones || reread.skeleton.joint_count() == row.joints) << row.file;
  }
}

// Bone ends in cm from an independent ASF/AMC reader, written in another language.
TEST_F(Corpus, BonesEndWhereAnIndependentReadingPutsThem) {
  struct Point {
    const char* file;
    int frame;  // the number in the file
    const char* bone;
    Eigen::Vector3d end;
  };
  const std::vector<Point> points = {
      {"study/09_01.amc", 100, "head", {1.447407, 161.050014, 147.647272}},
      {"study/09_01.amc", 100, "ltoes", {-1.510987, 3.977837, 136.423402}},
      {"study/09_01.amc", 100, "rfingers", {-25.119911, 95.212225, 155.245496}},
      {"study/09_01.amc", 100, "lthumb", {9.969395, 119.339422, 174.702369}},
      {"study/49_02.amc", 777, "head", {5.959153, 186.682977, 34.213122}},
      {"study/49_02.amc", 777, "ltoes", {16.498681, 76.119230, -15.615301}},
      {"study/49_02.amc", 777, "rfingers", {-15.420944, 145.672410, -33.011919}},
      {"study/49_02.amc", 777, "lthumb", {45.329980, 144.913534, -22.690379}},
      {"study/14_02.amc", 5000, "head", {-28.377674, 159.472718, 13.945055}},
      {"study/14_02.amc", 5000, "ltoes", {-15.627895, 7.706443, -41.512685}},
      {"study/14_02.amc", 5000, "rfingers", {-32.586329, 120.270693, 29.762418}},
      {"study/14_02.amc", 5000, "lthumb", {-12.468906, 131.118419, 27.520150}},
  };
  for (const Point& point : points) {
    const Motion motion = read(point.file);
    const int joint = motion.skeleton.find(point.bone);
    const Eigen::Vector3d end =
        pose_of(motion, point.frame - 1).to_world(joint, *motion.skeleton.joint(joint).end_site);
    EXPECT_LT((end - point.end).norm(), 1e-5) << point.file << " " << point.bone;
  }
}

// The BVH comes from someone else's converter. Its figure has longer hips and straight legs at
// rest, one more frame at the start, and a blend from a T pose in the first few frames. The root's
// rotation must agree exactly. A limb's rotation differs by the other rest pose, which is a
// constant except for the converter's smoothing.
TEST_F(Corpus, BothFormsOf11_01Agree) {
  const Motion acclaim = read("bvh/11_01.amc");
  const Motion bvh = read("bvh/11_01.bvh");
  constexpr int kExtraFrames = 1;
  constexpr int kBlendedFrames = 20;
  constexpr int kReference = 300;
  ASSERT_EQ(bvh.clip.frames(), acclaim.clip.frames() + kExtraFrames);
  const std::vector<std::pair<const char*, const char*>> limbs = {
      {"lfemur", "lThigh"},   {"ltibia", "lShin"},     {"lfoot", "lFoot"},
      {"rfemur", "rThigh"},   {"rtibia", "rShin"},     {"rfoot", "rFoot"},
      {"lhumerus", "lShldr"}, {"lradius", "lForeArm"}, {"rhumerus", "rShldr"},
      {"rradius", "rForeArm"}};
  const auto world_from = [](const Motion& motion, const Pose& pose, const char* joint) {
    return pose.world_from_joint[static_cast<std::size_t>(motion.skeleton.find(joint))];
  };
  const Pose reference = pose_of(acclaim, kReference);
  const Pose bvh_reference = pose_of(bvh, kReference + kExtraFrames);
  std::vector<double> summed(limbs.size(), 0.0);
  for (int t = kBlendedFrames; t < acclaim.clip.frames(); ++t) {
    const Pose pose = pose_of(acclaim, t);
    const Pose bvh_pose = pose_of(bvh, t + kExtraFrames);
    EXPECT_LT(degrees_between(pose.world_from_joint[0], bvh_pose.world_from_joint[0]), 0.001) << t;
    for (std::size_t i = 0; i < limbs.size(); ++i) {
      const auto& [bone, joint] = limbs[i];
      const Eigen::Matrix3d bone_from_joint =
          world_from(acclaim, reference, bone).transpose() * world_from(bvh, bvh_reference, joint);
      summed[i] += degrees_between(world_from(acclaim, pose, bone) * bone_from_joint,
                                   world_from(bvh, bvh_pose, joint));
    }
  }
  for (std::size_t i = 0; i < limbs.size(); ++i)
    EXPECT_LT(summed[i] / (acclaim.clip.frames() - kBlendedFrames), 2.5) << limbs[i].first;
}

// The wrist's angles flip by half turns between frames: only the right order and axes make it
// smooth.
TEST_F(Corpus, WristsAreContinuousWhere3DofAreForced) {
  const Motion motion = read("odd/cmu135_FORCE-ALL-JOINTS-BE-3DOF_truncated.amc");
  const auto wrist = static_cast<std::size_t>(motion.skeleton.find("rwrist"));
  Pose previous = pose_of(motion, 0);
  for (int t = 1; t < motion.clip.frames(); ++t) {
    const Pose pose = pose_of(motion, t);
    ASSERT_LT(degrees_between(previous.world_from_joint[wrist], pose.world_from_joint[wrist]), 12)
        << t;
    previous = pose;
  }
}

}  // namespace
}  // namespace mocapress::corpus_test
