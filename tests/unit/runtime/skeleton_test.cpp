// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/codec/format/container.h"
#include "core/runtime/pose/cooked_check.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress::skeleton_test {
namespace {

using test::CookedClip;
using test::OpenedClip;

std::vector<std::byte> file_of(const Motion& motion) {
  return write_container(test::segmented_clip(motion, SegmentLayout::whole(motion.clip.frames())));
}

class RuntimeSkeleton : public testing::Test {
 protected:
  RuntimeSkeleton() {
    for (std::uint32_t j = 0; j < mcpr::describe(opened_.clip).joints; ++j) {
      mcpr_joint joint{};
      mcpr_clip_joint(opened_.clip, j, &joint, nullptr);
      names_.push_back(joint.name);
      parents_.push_back(static_cast<std::int16_t>(joint.parent));
    }
  }

  std::uint32_t joints() const { return static_cast<std::uint32_t>(names_.size()); }
  mcpr_skeleton skeleton() const { return {joints(), names_.data(), parents_.data()}; }

  const OpenedClip opened_{file_of(test::smooth_motion(40))};
  const CookedClip plain_{opened_.clip};
  const CookedClip cooked_{opened_.clip, {.skeleton = 1}};
  std::vector<const char*> names_;
  std::vector<std::int16_t> parents_;
};

TEST_F(RuntimeSkeleton, AClipCookedAloneKeepsItIfAsked) {
  ASSERT_NE(cooked_.clip, nullptr);
  for (std::uint32_t j = 0; j < joints(); ++j) {
    mcpr_joint wanted{};
    mcpr_joint joint{};
    ASSERT_EQ(mcpr_clip_joint(opened_.clip, j, &wanted, nullptr), MCPR_OK);
    ASSERT_EQ(mcpr_cooked_joint(cooked_.clip, j, &joint, nullptr), MCPR_OK);
    EXPECT_STREQ(joint.name, wanted.name);
    EXPECT_EQ(joint.parent, wanted.parent);
    EXPECT_TRUE(std::equal(joint.offset, joint.offset + 3, wanted.offset));
    EXPECT_EQ(joint.has_end_site, wanted.has_end_site);
    EXPECT_TRUE(std::equal(joint.end_site, joint.end_site + 3, wanted.end_site));
    EXPECT_EQ(mcpr_cooked_joint(plain_.clip, j, &joint, nullptr), MCPR_ARGUMENT);
  }
  mcpr_joint joint{};
  EXPECT_EQ(mcpr_cooked_joint(cooked_.clip, joints(), &joint, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_cooked_joint(nullptr, 0, &joint, nullptr), MCPR_ARGUMENT);
}

TEST_F(RuntimeSkeleton, ACookedSkeletonChangesNoPoseAndTakesLittle) {
  for (double frame = 0; frame < 40; frame += 0.7)
    EXPECT_EQ(cooked_.sample({}, frame), plain_.sample({}, frame));
  EXPECT_LE(cooked_.bytes->size(), plain_.bytes->size() + 64 * joints());
  const mcpr_cooked* checked = nullptr;
  EXPECT_EQ(mcpr_open_cooked(cooked_.bytes->data(), cooked_.bytes->size(), 1, &checked, nullptr),
            MCPR_OK);
}

/// The checksum is right, so that only the skeleton's own check can refuse it.
TEST_F(RuntimeSkeleton, AnImpossibleCookedSkeletonIsRefused) {
  const std::size_t item = mcpr_cooked::skeleton_item();
  const std::size_t first_joint = item + sizeof(std::uint32_t);
  const auto status_with = [&](std::size_t place, std::uint32_t value) {
    const AlignedBytes bytes(cooked_.bytes->size());
    std::memcpy(bytes.data(), cooked_.bytes->data(), bytes.size());
    std::memcpy(bytes.data() + place, &value, sizeof value);
    auto* const clip = reinterpret_cast<mcpr_cooked*>(bytes.data());
    clip->checksum = runtime::checksum_of(*clip);
    const mcpr_cooked* checked = nullptr;
    return mcpr_open_cooked(bytes.data(), bytes.size(), 1, &checked, nullptr);
  };
  EXPECT_EQ(status_with(first_joint, 0xFFFFFFFFU), MCPR_OK);           // the root's parent
  EXPECT_EQ(status_with(first_joint, 0), MCPR_INVALID);                // its own parent
  EXPECT_EQ(status_with(first_joint + 4, 0x7FFFFFFFU), MCPR_INVALID);  // its name
  EXPECT_EQ(status_with(first_joint + 8, 0x7F800000U), MCPR_INVALID);  // an infinite offset
  EXPECT_EQ(status_with(item, joints() - 1), MCPR_INVALID);
  EXPECT_EQ(status_with(item, 0), MCPR_INVALID);
  EXPECT_EQ(status_with(item - 4, 0xFFFFFFFFU), MCPR_INVALID);  // bytes of the item
  EXPECT_EQ(status_with(item - 4, 8), MCPR_INVALID);
}

TEST_F(RuntimeSkeleton, ABlockOfBeforeThereWereSkeletonsOpens) {
  const std::vector<std::byte> old =
      read_bytes(std::string(MOCAPRESS_SOURCE_DIR) + "/tests/fuzz/corpus/bank/cooked_clip.mcpc");
  const AlignedBytes bytes(old.size());
  std::copy(old.begin(), old.end(), bytes.data());
  const mcpr_cooked* clip = nullptr;
  ASSERT_EQ(mcpr_open_cooked(bytes.data(), bytes.size(), 1, &clip, nullptr), MCPR_OK);
  EXPECT_EQ(mcpr_cooked_skeleton_hash(clip), 0U);
}

TEST_F(RuntimeSkeleton, TheHashIsTheSameWhereverTheSkeletonIs) {
  const std::uint64_t hash = mcpr_skeleton_hash(opened_.clip);
  EXPECT_NE(hash, 0U);
  EXPECT_EQ(mcpr_cooked_skeleton_hash(cooked_.clip), hash);
  EXPECT_EQ(mcpr_cooked_skeleton_hash(plain_.clip), 0U);
  EXPECT_EQ(mcpr_skeleton_hash(OpenedClip(file_of(test::smooth_motion(7))).clip), hash);
  EXPECT_EQ(mcpr_skeleton_hash(nullptr), 0U);
  EXPECT_EQ(mcpr_cooked_skeleton_hash(nullptr), 0U);
}

TEST_F(RuntimeSkeleton, NamesParentsAndOffsetsAllCountInTheHash) {
  const std::uint64_t hash = mcpr_skeleton_hash(opened_.clip);
  const auto hash_with = [](const auto& change) {
    Motion motion = test::smooth_motion(7);
    Skeleton skeleton;
    for (int j = 0; j < motion.skeleton.joint_count(); ++j) {
      Joint joint = motion.skeleton.joint(j);
      change(j, joint);
      skeleton.add(joint);
    }
    motion.skeleton = skeleton;
    return mcpr_skeleton_hash(OpenedClip(file_of(motion)).clip);
  };
  EXPECT_EQ(hash_with([](int, Joint&) {}), hash);
  EXPECT_NE(hash_with([](int j, Joint& joint) {
              if (j == 2) joint.name += "x";
            }),
            hash);
  EXPECT_NE(hash_with([](int j, Joint& joint) {
              if (j == 2) joint.offset.y() += 0.5;
            }),
            hash);
  EXPECT_NE(hash_with([](int j, Joint& joint) {
              if (j == 2) joint.parent = joint.parent == 0 ? 1 : 0;
            }),
            hash);
}

TEST_F(RuntimeSkeleton, AnEnginesJointsAreFoundByName) {
  const std::uint32_t count = joints();
  std::vector<const char*> names(names_.rbegin(), names_.rend());
  names.push_back("no such joint");
  names.erase(names.begin() + 1);
  const mcpr_skeleton engine{count, names.data(), nullptr};
  std::vector<std::int16_t> map(count, -7);
  mcpr_map_gaps gaps{};
  std::vector<std::int16_t> wanted;
  for (std::uint32_t j = 0; j + 1 < count; ++j)
    wanted.push_back(static_cast<std::int16_t>(j == 0 ? count - 1 : count - 2 - j));
  wanted.push_back(-1);
  ASSERT_EQ(mcpr_map_joints(opened_.clip, &engine, map.data(), &gaps, nullptr), MCPR_OK);
  EXPECT_EQ(map, wanted);
  EXPECT_EQ(gaps.missing, 1U);
  EXPECT_EQ(gaps.unused, 1U);
  std::vector<std::int16_t> of_cooked(count, -7);
  ASSERT_EQ(mcpr_map_cooked_joints(cooked_.clip, &engine, of_cooked.data(), &gaps, nullptr),
            MCPR_OK);
  EXPECT_EQ(of_cooked, wanted);
  EXPECT_EQ(mcpr_map_cooked_joints(plain_.clip, &engine, of_cooked.data(), &gaps, nullptr),
            MCPR_ARGUMENT);
  std::vector<mcpr_transform> bind(count);
  for (std::uint32_t j = 0; j < count; ++j)
    bind[j] = {{1, 0, 0, 0}, {static_cast<float>(j), 0, 0, 0}};
  std::vector<mcpr_transform> pose(count);
  const std::vector<float> sampled = cooked_.sample({}, 11.5);
  std::memcpy(pose.data(), sampled.data(), sampled.size() * sizeof(float));
  std::vector<mcpr_transform> out(count);
  ASSERT_EQ(
      mcpr_remap_pose(map.data(), count, bind.data(), pose.data(), count, out.data(), nullptr),
      MCPR_OK);
  for (std::uint32_t j = 0; j < count; ++j) {
    const mcpr_transform& from = map[j] < 0 ? bind[j] : pose[static_cast<std::size_t>(map[j])];
    EXPECT_EQ(std::memcmp(&out[j], &from, sizeof from), 0) << j;
  }
  EXPECT_EQ(
      mcpr_remap_pose(map.data(), count, bind.data(), pose.data(), count - 1, out.data(), nullptr),
      MCPR_ARGUMENT);
}

TEST_F(RuntimeSkeleton, JointsThatHangElsewhereAreCounted) {
  std::vector<std::int16_t> map(joints());
  mcpr_map_gaps gaps{};
  mcpr_skeleton engine = skeleton();
  ASSERT_EQ(mcpr_map_joints(opened_.clip, &engine, map.data(), &gaps, nullptr), MCPR_OK);
  EXPECT_EQ(gaps.missing + gaps.unused + gaps.moved, 0U);
  std::vector<std::int16_t> parents = parents_;
  parents[2] = parents[2] == 0 ? 1 : 0;
  engine.parents = parents.data();
  ASSERT_EQ(mcpr_map_joints(opened_.clip, &engine, map.data(), &gaps, nullptr), MCPR_OK);
  EXPECT_EQ(gaps.moved, 1U);
  // A joint of the engine above the clip's root.
  std::vector<const char*> names(engine.names, engine.names + joints());
  names.push_back("armature");
  parents = parents_;
  parents[0] = static_cast<std::int16_t>(joints());
  parents.push_back(-1);
  const mcpr_skeleton above{.joints = static_cast<std::uint32_t>(names.size()),
                            .names = names.data(),
                            .parents = parents.data()};
  std::vector<std::int16_t> map_of_more(names.size());
  ASSERT_EQ(mcpr_map_joints(opened_.clip, &above, map_of_more.data(), &gaps, nullptr), MCPR_OK);
  EXPECT_EQ(gaps.missing, 1U);
  EXPECT_EQ(gaps.moved, 1U);
  parents = parents_;
  engine.parents = parents.data();
  parents[2] = static_cast<std::int16_t>(joints());
  EXPECT_EQ(mcpr_map_joints(opened_.clip, &engine, map.data(), &gaps, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_map_joints(nullptr, &engine, map.data(), &gaps, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_map_joints(opened_.clip, nullptr, map.data(), &gaps, nullptr), MCPR_ARGUMENT);
}

}  // namespace
}  // namespace mocapress::skeleton_test
