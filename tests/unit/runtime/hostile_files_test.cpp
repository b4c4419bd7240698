// SPDX-License-Identifier: MIT
// Malicious bytes are refused or decoded, within the memory and work that the interface states.
#include <gtest/gtest.h>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/codec/format/room.h"
#include "core/codec/format/skeleton_section.h"
#include "core/runtime/format/range_decoder.h"
#include "tests/fuzz/file_sections.h"
#include "tests/support/opened_clip.h"
#include "tests/support/test_motion.h"
#include "tests/support/turned_forms.h"

namespace mocapress::hostile_files_test {
namespace {

using test::OpenedClip;

std::vector<std::byte> small_file() {
  const Motion motion = test::smooth_motion(24);
  const EncodeCorrection correction{
      .joints = {motion.skeleton.joint_count() - 1, motion.skeleton.joint_count() - 4},
      .ratio = 4.0};
  CompressedClip clip = Encoder(motion)
                            .encode({.method = Method::Standard,
                                     .coding = Coding::Adaptive,
                                     .weighting = Weighting::BoneEnds,
                                     .target = {Target::Kind::CoefficientRatio, 8},
                                     .correction = correction})
                            .compressed;
  clip.forms = test::turned_forms(clip.skeleton);
  return write_container(clip);
}

/// Opens a file and, if that succeeds, plays all of it. Returns whether it opened.
bool survives(const std::vector<std::byte>& file) {
  const OpenedClip clip(file);
  if (clip.clip == nullptr) {
    EXPECT_NE(clip.result.status, MCPR_OK);
    EXPECT_LE(clip.result.offset, file.size());
    return false;
  }
  const std::uint32_t frames = mcpr::describe(clip.clip).frames;
  EXPECT_FALSE(frames > 0 && clip.frames({.output = MCPR_POSITIONS, .apply_ik = 1}, 0, 1).empty());
  return true;
}

TEST(HostileFiles, EveryTruncationOfEverySectionIsRefusedOrDecodes) {
  const auto file = small_file();
  for (std::size_t at = 8; at + 12 <= file.size();) {
    std::uint32_t size = 0;
    std::memcpy(&size, file.data() + at + 4, 4);
    for (std::uint32_t kept = 0; kept < size; ++kept) {
      std::vector<std::byte> cut(file.begin(), file.begin() + static_cast<long>(at + 12 + kept));
      std::memcpy(cut.data() + at + 4, &kept, 4);
      cut.insert(cut.end(), file.begin() + static_cast<long>(at + 12 + size), file.end());
      test::mend_checksums(cut);
      survives(cut);
    }
    at += 12 + size;
  }
}

TEST(HostileFiles, EveryChangedByteBehindMendedChecksumsIsRefusedOrDecodes) {
  const auto file = small_file();
  Random random(4);
  int opened = 0;
  for (std::size_t at = 0; at < file.size(); ++at) {
    auto changed = file;
    changed[at] ^= static_cast<std::byte>(1 + random.below(255));
    test::mend_checksums(changed);
    opened += survives(changed) ? 1 : 0;
  }
  EXPECT_GT(opened, 0) << "no mutation got deep";
}

/// Appends a section with a valid checksum.
void append_section(std::vector<std::byte>& file, const char* tag, const ByteWriter& payload) {
  ByteWriter head;
  head.append(std::as_bytes(std::span(tag, 4)));
  head.write(static_cast<std::uint32_t>(payload.bytes().size()));
  head.write(std::uint32_t{0});
  file.insert(file.end(), head.bytes().begin(), head.bytes().end());
  file.insert(file.end(), payload.bytes().begin(), payload.bytes().end());
}

/// A small file that claims to be large: `joints` joints of 6 channels each, `frames` frames, and
/// motion bytes of zeros.
std::vector<std::byte> bomb(int joints, std::uint32_t frames, std::size_t motion_bytes,
                            int effectors = 0) {
  Skeleton skeleton;
  for (int j = 0; j < joints; ++j)
    skeleton.add({.name = "",
                  .parent = j - 1,
                  .channels = std::vector<ChannelKind>(6, ChannelKind::RotationX)});
  CompressedClip clip{.skeleton = skeleton, .coding = Coding::Adaptive, .motion = {}};
  clip.provenance.method = Method::ClosedLoop;
  auto file = write_container(clip);
  // Replaces everything but the skeleton: MOTN, CLIP's number of frames, IKCO.
  std::uint32_t skeleton_bytes = 0;
  std::memcpy(&skeleton_bytes, file.data() + 12, 4);
  const std::size_t description = 8 + 12 + skeleton_bytes;
  std::memcpy(file.data() + description + 12 + 8, &frames, 4);
  file.resize(description + 12 + 32);
  ByteWriter motion;
  motion.write(std::uint16_t{0x3F80});
  for (std::size_t i = 0; i < motion_bytes; ++i) motion.write(std::uint8_t{0xFF});
  append_section(file, "MOTN", motion);
  if (effectors > 0) {
    ByteWriter correction;
    correction.write(std::uint8_t{1});
    correction.write(static_cast<std::uint8_t>(effectors));
    for (int e = 0; e < effectors; ++e) {
      correction.write(static_cast<std::uint16_t>(joints - 1 - e));
      correction.write(static_cast<std::uint16_t>(joints - 8 - e));
    }
    append_section(file, "IKCO", correction);
    file[6] = std::byte{4};
  }
  test::mend_checksums(file);
  return file;
}

TEST(HostileFiles, ABombOfValuesIsRefusedByItsHeadersAlone) {
  mcpr_info info;
  // 2^26 values in about a hundred bytes.
  const auto file = bomb(16, (1U << 26) / 96, 20);
  EXPECT_LT(file.size(), 400u);
  EXPECT_EQ(mcpr_inspect(file.data(), file.size(), nullptr, &info, nullptr), MCPR_INVALID);
  // One frame more than any file with these channels may have, whatever its size.
  const auto larger = bomb(16, (1U << 26) / 96 + 1, 4000);
  EXPECT_EQ(mcpr_inspect(larger.data(), larger.size(), nullptr, &info, nullptr), MCPR_INVALID);
}

TEST(HostileFiles, ABombWithinTheLimitsTakesOnlyTheStatedMemory) {
  const std::uint32_t frames = (1U << 22) / 96;
  const auto file = bomb(16, frames, 2000);
  mcpr_info info;
  ASSERT_EQ(mcpr_inspect(file.data(), file.size(), nullptr, &info, nullptr), MCPR_OK);
  EXPECT_LT(info.read_bytes, 4 * std::size_t{frames} * 96 + 4 * frames + (1U << 20));
  const AlignedBytes scratch(info.read_bytes);
  std::size_t size = 0;
  mcpr_result result;
  mcpr_read(file.data(), file.size(), nullptr, scratch.data(), scratch.size(), &size, &result);
  // The bytes may happen to decode.
  EXPECT_TRUE(result.status == MCPR_INVALID || result.status == MCPR_OK) << result.message;
}

TEST(HostileFiles, FileSizeBoundsSamplesUnderAnyLimits) {
  mcpr_limits limits = mcpr::default_limits();
  limits.scratch_bytes = std::size_t{1} << 32;
  mcpr_info info;
  const std::size_t size = bomb(16, 1, 20).size();
  const auto most = static_cast<std::uint32_t>(((1U << 24) + (size << 14)) / 96);
  const auto held = bomb(16, most, 20);
  ASSERT_EQ(held.size(), size);
  EXPECT_EQ(mcpr_inspect(held.data(), held.size(), &limits, &info, nullptr), MCPR_OK);
  const auto beyond = bomb(16, most + 1, 20);
  EXPECT_EQ(mcpr_inspect(beyond.data(), beyond.size(), &limits, &info, nullptr), MCPR_INVALID);
}

TEST(HostileFiles, BombsOfJointsAndOfLimbsAreRefused) {
  mcpr_info info;
  const auto joints = bomb(900, 1, 20);
  mcpr_limits limits = mcpr::default_limits();
  limits.joints = 899;
  EXPECT_EQ(mcpr_inspect(joints.data(), joints.size(), &limits, &info, nullptr), MCPR_LIMIT);
  // A limb in which every step would turn hundreds of joints.
  EXPECT_EQ(OpenedClip(bomb(600, 0, 4, 1)).result.status, MCPR_INVALID);
  // More effectors in a limb than can be solved together.
  EXPECT_EQ(OpenedClip(bomb(100, 0, 4, 9)).result.status, MCPR_INVALID);
}

/// The file with other numbers of skeleton bytes and joints in the head of JNTS.
std::vector<std::byte> promising(std::vector<std::byte> file, std::uint32_t bytes,
                                 std::uint16_t joints) {
  std::memcpy(file.data() + 20, &bytes, 4);
  std::memcpy(file.data() + 24, &joints, 2);
  test::mend_checksums(file);
  return file;
}

TEST(HostileFiles, JointCountBoundsTheDecodedSkeleton) {
  constexpr std::uint32_t kBytesOfJoint = 306;  // FORMAT.md, Limits
  const auto file = bomb(3, 1, 20);
  mcpr_info info;
  const auto inspect = [&](const std::vector<std::byte>& changed) {
    return mcpr_inspect(changed.data(), changed.size(), nullptr, &info, nullptr);
  };
  EXPECT_EQ(inspect(promising(file, 3 * kBytesOfJoint, 3)), MCPR_OK);
  EXPECT_EQ(inspect(promising(file, 3 * kBytesOfJoint + 1, 3)), MCPR_INVALID);
  EXPECT_EQ(inspect(promising(file, 4U << 20, 3)), MCPR_INVALID);
  EXPECT_THROW(read_container(promising(file, 3 * kBytesOfJoint + 1, 3)), FormatError);
  // The coded bytes end before all joints are decoded, which is refused at once.
  EXPECT_EQ(OpenedClip(promising(file, 4096 * kBytesOfJoint, 4096)).result.status, MCPR_INVALID);
}

TEST(HostileFiles, JointsNestedTooDeepAreRefused) {
  CompressedClip clip{.coding = Coding::Adaptive, .motion = {}};
  for (int j = 0; j < 1000; ++j) clip.skeleton.add({.name = "", .parent = j - 1});
  // Files that no writer in this project makes.
  const std::vector<std::byte> file = bomb(1, 0, 4);
  std::uint32_t before = 0;
  std::memcpy(&before, file.data() + 12, 4);
  const auto deep = [&](const Skeleton& skeleton) {
    const std::vector<std::byte> payload = write_joints(skeleton);
    std::vector<std::byte> changed(file.begin(), file.begin() + 20);
    const auto size = static_cast<std::uint32_t>(payload.size());
    std::memcpy(changed.data() + 12, &size, 4);
    changed.insert(changed.end(), payload.begin(), payload.end());
    changed.insert(changed.end(), file.begin() + 20 + before, file.end());
    test::mend_checksums(changed);
    return changed;
  };
  const auto joints_of = [](const std::vector<std::byte>& bytes) {
    return read_joints(sections_of(bytes)).joint_count();
  };
  EXPECT_EQ(joints_of(deep(clip.skeleton)), 1000);
  EXPECT_NO_THROW(check_room({clip.skeleton, 120, SegmentLayout::whole(1)}));
  clip.skeleton.add({.name = "", .parent = 999});
  EXPECT_THROW(joints_of(deep(clip.skeleton)), FormatError);
  EXPECT_THROW(write_container(clip), Error);
  const mcpr_result refused = OpenedClip(deep(clip.skeleton)).result;
  EXPECT_EQ(refused.status, MCPR_INVALID);
  EXPECT_NE(std::string(refused.message).find("deeper"), std::string::npos) << refused.message;
}

TEST(HostileFiles, BitsPerByteAreBounded) {
  // The highest probability of a bit is 65514 / 65536 (mixed) or 65472 / 65536 (single context).
  for (const std::size_t size : {0, 1, 10, 300}) {
    const std::vector<std::uint8_t> zeros(size, 0);  // always the likelier bit
    runtime::RangeDecoder bits(zeros.data(), zeros.size());
    std::size_t count = 0;
    for (; !bits.failed(); ++count) bits.code(false, 65514);
    EXPECT_LE(count, (std::size_t{1} << 15) * (size + 9));
  }
}

}  // namespace
}  // namespace mocapress::hostile_files_test
