// SPDX-License-Identifier: MIT
#include "core/codec/format/container.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/decode/runtime_clip.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/section_writer.h"
#include "core/runtime/format/coded_error.h"
#include "tests/support/test_motion.h"
#include "tests/support/turned_forms.h"

namespace mocapress {
namespace {

/// With an IK correction at the ends of both limbs.
CompressedClip small_clip(Coding coding = Coding::Deflate) {
  const Motion motion = test::smooth_motion(40);
  const EncodeCorrection correction{
      .joints = {motion.skeleton.joint_count() - 1, motion.skeleton.joint_count() - 4},
      .ratio = 4.0};
  return Encoder(motion)
      .encode({.method = Method::Standard,
               .coding = coding,
               .weighting = Weighting::BoneEnds,
               .target = {Target::Kind::CoefficientRatio, 4},
               .correction = correction})
      .compressed;
}

/// The section's first byte and size are found as FORMAT.md lays them out.
struct Place {
  std::size_t start;
  std::uint32_t size;
};
Place find_section(const std::vector<std::byte>& file, const char* tag) {
  std::size_t at = 8;
  while (std::memcmp(file.data() + at, tag, 4) != 0) {
    std::uint32_t size = 0;
    std::memcpy(&size, file.data() + at + 4, 4);
    at += 12 + size;
  }
  std::uint32_t size = 0;
  std::memcpy(&size, file.data() + at + 4, 4);
  return {at, size};
}

void mend_checksum(std::vector<std::byte>& file, const Place& place) {
  const auto* bytes = reinterpret_cast<const Bytef*>(file.data() + place.start);
  const auto crc = static_cast<std::uint32_t>(crc32(crc32(0, bytes, 8), bytes + 12, place.size));
  std::memcpy(file.data() + place.start + 8, &crc, 4);
}

TEST(Container, ReadsBackWhatWasWritten) {
  for (const Coding coding : {Coding::Rle16, Coding::Deflate}) {
    const CompressedClip clip = small_clip(coding);
    const CompressedClip read = read_container(write_container(clip));
    EXPECT_EQ(read.frames, clip.frames);
    EXPECT_EQ(read.sample_rate_hz, clip.sample_rate_hz);
    EXPECT_EQ(read.coding, coding);
    EXPECT_EQ(read.basis, clip.basis);
    EXPECT_EQ(read.motion, clip.motion);
    EXPECT_EQ(read.provenance.method, Method::Standard);
    EXPECT_EQ(read.provenance.eps_cm, runtime::rounded_error(clip.provenance.eps_cm));
    EXPECT_EQ(read.correction->solver, clip.correction->solver);
    const Uncorrected decoded = decode_uncorrected(read);
    EXPECT_EQ(decoded.clip.channels, decode_uncorrected(clip).clip.channels);
    EXPECT_EQ(decoded.differences, decode_uncorrected(clip).differences);
  }
}

TEST(Container, KeepsTheSkeletonToTheMicrometre) {
  const Motion motion = test::smooth_motion(40);
  const CompressedClip read = read_container(write_container(small_clip()));
  ASSERT_EQ(read.skeleton.joint_count(), motion.skeleton.joint_count());
  for (int j = 0; j < read.skeleton.joint_count(); ++j) {
    EXPECT_EQ(read.skeleton.joint(j).name, motion.skeleton.joint(j).name);
    EXPECT_EQ(read.skeleton.joint(j).channels, motion.skeleton.joint(j).channels);
  }
  const Eigen::MatrixXd moved =
      landmark_tracks(read.skeleton, motion.clip) - landmark_tracks(motion.skeleton, motion.clip);
  EXPECT_LT(moved.cwiseAbs().maxCoeff(), 1e-4);
}

TEST(Container, ReadsBackAMotionOfNoBytes) {
  Motion still;
  still.skeleton.add({.name = "stone", .end_site = Eigen::Vector3d(0, 1, 0)});
  still.clip.channels.resize(10, 0);
  for (const Coding coding : {Coding::Rle16, Coding::Deflate, Coding::Adaptive}) {
    const Encoding encoding =
        Encoder(still).encode({.method = Method::Standard,
                               .coding = coding,
                               .weighting = Weighting::BoneEnds,
                               .target = {Target::Kind::CoefficientRatio, 4}});
    EXPECT_EQ(decode(read_container(write_container(encoding.compressed))).frames(), 10);
  }
}

/// With joints whose angles are coded in another order than the source has them.
std::vector<std::byte> reordered_file() {
  CompressedClip clip = small_clip();
  clip.forms =
      RotationForms(static_cast<std::size_t>(clip.skeleton.joint_count()), {RotationOrder::Yxz});
  return write_container(clip);
}

TEST(Container, KeepsTheOrdersOfTheSourceBesideThoseThatAreCoded) {
  const CompressedClip clip = small_clip();
  const CompressedClip read = read_container(reordered_file());
  EXPECT_EQ(rotation_forms(read.skeleton), rotation_forms(clip.skeleton));
  const Skeleton coded = read.coded_skeleton();
  for (const Joint& joint : coded.joints())
    if (turns_freely(joint)) {
      EXPECT_EQ(rotation_order(joint), RotationOrder::Yxz);
    }
}

CompressedClip turned_clip() {
  CompressedClip clip = small_clip(Coding::Adaptive);
  clip.forms = test::turned_forms(clip.skeleton);
  return clip;
}

TEST(Container, KeepsTurnedAxesWhichCountAsMotion) {
  const CompressedClip clip = turned_clip();
  const std::vector<std::byte> file = write_container(clip);
  const CompressedClip read = read_container(file);
  EXPECT_EQ(read.forms, clip.forms);
  EXPECT_EQ(read.motion_bytes(), clip.motion_bytes());
  const std::uint32_t size = find_section(file, "AXES").size;
  EXPECT_GT(size, 4);
  EXPECT_EQ(clip.motion_bytes(), small_clip(Coding::Adaptive).motion_bytes() + size);
}

TEST(Container, RefusesInvalidTurnedAxes) {
  const std::vector<std::byte> good = write_container(turned_clip());
  const Place place = find_section(good, "AXES");
  const auto refused = [&](std::uint32_t byte, int bits) {
    std::vector<std::byte> file = good;
    file[place.start + 12 + byte] |= static_cast<std::byte>(bits);
    mend_checksum(file, place);
    EXPECT_THROW(read_container(file), FormatError);
    EXPECT_THROW(RuntimeClip{file}, FormatError);
  };
  refused(0, 0x80);  // a joint there is not
  refused(4, 0x40);  // a seventh number
}

TEST(Container, RefusesInvalidOrders) {
  const std::vector<std::byte> good = reordered_file();
  const Place place = find_section(good, "ordr");
  for (std::uint32_t i = 0; i < place.size; ++i) {
    std::vector<std::byte> file = good;
    file[place.start + 12 + i] = std::byte{6};
    mend_checksum(file, place);
    EXPECT_THROW(read_container(file), FormatError);
  }
  std::vector<std::byte> twice = good;
  twice.insert(twice.end(), good.begin() + static_cast<long>(place.start), good.end());
  twice[6] = static_cast<std::byte>(std::to_integer<int>(twice[6]) + 1);
  EXPECT_THROW(read_container(twice), FormatError);
}

TEST(Container, RefusesEveryPrefix) {
  const auto file = write_container(small_clip());
  for (std::size_t size = 0; size < file.size(); ++size) {
    // A copy of just that size, so that the address sanitizer sees every read past it.
    const std::vector<std::byte> prefix(file.begin(), file.begin() + static_cast<long>(size));
    EXPECT_THROW(read_container(prefix), FormatError) << "of " << size << " bytes";
  }
}

TEST(Container, RefusesExtraBytes) {
  auto file = write_container(small_clip());
  file.push_back(std::byte{0});
  EXPECT_THROW(read_container(file), FormatError);
}

TEST(Container, RefusesEveryFlippedBit) {
  const auto file = write_container(small_clip());
  for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
    auto flipped = file;
    flipped[bit / 8] ^= static_cast<std::byte>(1 << (bit % 8));
    EXPECT_THROW(read_container(flipped), FormatError) << "bit " << bit;
  }
}

TEST(Container, RefusesAnotherVersionByName) {
  auto file = write_container(small_clip());
  file[4] = std::byte{2};
  try {
    read_container(file);
    FAIL();
  } catch (const FormatError& error) {
    EXPECT_NE(std::string(error.what()).find("version is unknown"), std::string::npos);
  }
}

TEST(Container, RefusesMoreSamplesThanItMayHoldBeforeAllocatingThem) {
  auto file = write_container(small_clip());
  const Place place = find_section(file, "CLIP");
  const std::uint32_t frames = 0xFFFFFFF0;
  std::memcpy(file.data() + place.start + 12 + 8, &frames, 4);
  mend_checksum(file, place);
  EXPECT_THROW(read_container(file), FormatError);
}

TEST(Container, RefusesMoreSamplesThanItsBytesMayStandFor) {
  const CompressedClip clip = small_clip();
  auto file = write_container(clip);
  const Place place = find_section(file, "CLIP");
  const auto signals = static_cast<std::size_t>(clip.skeleton.channel_count() +
                                                clip.correction.value().signal_count());
  const std::size_t most = ((1U << 24) + (file.size() << 14)) / signals;
  const auto claim = [&](std::size_t frames) {
    const auto claimed = static_cast<std::uint32_t>(frames);
    std::memcpy(file.data() + place.start + 12 + 8, &claimed, 4);
    mend_checksum(file, place);
  };
  claim(most);
  EXPECT_EQ(read_container(file).frames, static_cast<int>(most));
  claim(most + 1);
  EXPECT_THROW(read_container(file), FormatError);
}

TEST(Container, AClipThatHardlyMovesHasAFileHoweverLongItIs) {
  // Ten hours of three channels that stand still.
  CompressedClip clip{.frames = 1 << 22, .coding = Coding::Rle16, .motion = {}};
  clip.provenance.method = Method::Standard;
  clip.skeleton.add(
      {.name = "stone",
       .channels = {ChannelKind::RotationX, ChannelKind::RotationY, ChannelKind::RotationZ}});
  ByteWriter words;
  for (int c = 0; c < 3; ++c) words.write(std::int8_t{0});
  for (int c = 0; c < 3; ++c) words.write(std::int16_t{-32768});
  clip.motion = words.release();
  const auto file = write_container(clip);
  EXPECT_LT(file.size(), 200u);
  EXPECT_EQ(read_container(file).frames, clip.frames);
  EXPECT_EQ(read_container(file).motion, clip.motion);
}

TEST(Container, UnknownSectionsDoNotRaiseTheSampleLimit) {
  const CompressedClip clip = small_clip();
  const auto file = write_container(clip);
  const auto signals = static_cast<std::size_t>(clip.skeleton.channel_count() +
                                                clip.correction.value().signal_count());
  auto padded = with_section(file, "pads", std::vector<std::byte>(4000));
  EXPECT_EQ(read_container(padded).frames, clip.frames);
  const Place place = find_section(padded, "CLIP");
  const auto beyond = static_cast<std::uint32_t>(((1U << 24) + (file.size() << 14)) / signals + 1);
  std::memcpy(padded.data() + place.start + 12 + 8, &beyond, 4);
  mend_checksum(padded, place);
  EXPECT_THROW(read_container(padded), FormatError);
}

TEST(Container, RefusesAnInvalidEffector) {
  const auto file = write_container(small_clip());
  const Place place = find_section(file, "IKCO");
  const std::size_t effectors = place.start + 12 + 2;
  const auto expect_refused = [&](std::size_t at, int value) {
    auto changed = file;
    changed[at] = static_cast<std::byte>(value);
    mend_checksum(changed, place);
    EXPECT_THROW(read_container(changed), FormatError) << at << ' ' << value;
  };
  expect_refused(place.start + 12, 9);                               // a solver that is not known
  expect_refused(place.start + 13, 0);                               // no effectors
  expect_refused(place.start + 13, 200);                             // too many
  expect_refused(effectors, 99);                                     // no such joint
  expect_refused(effectors + 2, 99);                                 // no such top
  expect_refused(effectors + 4, static_cast<int>(file[effectors]));  // twice the same, or no chain
}

TEST(Container, SkipsOptionalSectionsAndRefusesUnknownOnes) {
  const auto file = write_container(small_clip());
  for (const bool optional : {true, false}) {
    auto extended = file;
    extended[6] = std::byte{5};  // sections
    const std::size_t start = extended.size();
    const char* const tag = optional ? "note" : "NOTE";
    for (int i = 0; i < 4; ++i) extended.push_back(static_cast<std::byte>(tag[i]));
    extended.resize(extended.size() + 8 + 3);
    extended[start + 4] = std::byte{3};
    mend_checksum(extended, {start, 3});
    if (optional)
      EXPECT_NO_THROW(read_container(extended));
    else
      EXPECT_THROW(read_container(extended), FormatError);
  }
}

TEST(Container, RefusesOrDecodesWholeWhatWasMutatedBehindItsChecksums) {
  const auto file = write_container(small_clip(Coding::Rle16));
  Random random(2);
  int refused = 0;
  int decoded = 0;
  for (int round = 0; round < 600; ++round) {
    auto mutated = file;
    for (const char* tag : {"JNTS", "CLIP", "MOTN", "IKCO"}) {
      const Place place = find_section(mutated, tag);
      if (random.below(2) == 0)
        mutated[place.start + 12 + random.below(place.size)] =
            static_cast<std::byte>(random.below(256));
      mend_checksum(mutated, place);
    }
    try {
      const CompressedClip clip = read_container(mutated);
      const Clip motion = decode(clip);
      ++decoded;
      EXPECT_EQ(motion.channels.rows(), clip.frames);
      EXPECT_EQ(motion.channels.cols(), clip.skeleton.channel_count());
      EXPECT_TRUE(motion.channels.allFinite());
      EXPECT_EQ(motion.sample_rate_hz, clip.sample_rate_hz);
    } catch (const FormatError& error) {
      ++refused;
      EXPECT_LE(error.byte_offset(), mutated.size()) << error.what();
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(decoded, 0);
}

}  // namespace
}  // namespace mocapress
