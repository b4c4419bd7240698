// SPDX-License-Identifier: MIT
// Compares the C interface with core, which decodes through the same code.
#include "core/runtime/mocapress_runtime.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/base/random.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "tests/support/opened_clip.h"
#include "tests/support/test_motion.h"
#include "tests/support/turned_forms.h"
#include "tests/unit/runtime/paths.h"

namespace mocapress::mocapress_runtime_test {
namespace {

using test::OpenedClip;

constexpr int kFrames = 150;

/// A file with an IK correction at the ends of both limbs.
std::vector<std::byte> file_corrected_by(IkSolver solver) {
  const Motion motion = test::smooth_motion(kFrames);
  const EncodeCorrection correction{
      .joints = {motion.skeleton.joint_count() - 1, motion.skeleton.joint_count() - 4},
      .ratio = 4.0,
      .solver = solver};
  return write_container(Encoder(motion)
                             .encode({.method = Method::Standard,
                                      .coding = Coding::Adaptive,
                                      .weighting = Weighting::BoneEnds,
                                      .target = {Target::Kind::CoefficientRatio, 6},
                                      .correction = correction})
                             .compressed);
}

const std::vector<std::byte>& corrected_file() {
  static const std::vector<std::byte> file = file_corrected_by(IkSolver::NearestPose);
  return file;
}

const OpenedClip& opened() {
  static const OpenedClip clip(corrected_file());
  return clip;
}

/// Decoded values as a matrix, frames x columns.
Eigen::MatrixXf matrix(const std::vector<float>& rows, Eigen::Index columns) {
  return Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      rows.data(), std::ssize(rows) / columns, columns);
}

Eigen::MatrixXf all_frames(const mcpr_request& request) {
  const auto columns = static_cast<Eigen::Index>(mcpr_frame_values(opened().clip, &request));
  return matrix(opened().frames(request, 0, kFrames), columns);
}

TEST(Decoder, MatchesCoreToTheBit) {
  ASSERT_NE(opened().clip, nullptr) << opened().result.message;
  const CompressedClip compressed = read_container(corrected_file());
  EXPECT_EQ(all_frames({}), decode_uncorrected(compressed).clip.channels.cast<float>());
  EXPECT_EQ(all_frames({.apply_ik = 1}), decode(compressed).channels.cast<float>());
}

TEST(Decoder, DescribesTheFile) {
  const CompressedClip compressed = read_container(corrected_file());
  const mcpr_clip_info info = mcpr::describe(opened().clip);
  EXPECT_EQ(info.frames, static_cast<std::uint32_t>(kFrames));
  EXPECT_EQ(info.sample_rate, compressed.sample_rate_hz);
  EXPECT_EQ(info.channels, static_cast<std::uint32_t>(compressed.skeleton.channel_count()));
  EXPECT_EQ(info.effectors, 2u);
  EXPECT_EQ(opened().info.motion_bytes, compressed.motion_bytes());
  EXPECT_EQ(info.resident_bytes, opened().resident->size());
  for (int j = 0; j < compressed.skeleton.joint_count(); ++j) {
    const Joint& expected = compressed.skeleton.joint(j);
    mcpr_joint joint;
    ASSERT_EQ(mcpr_clip_joint(opened().clip, static_cast<std::uint32_t>(j), &joint, nullptr),
              MCPR_OK);
    EXPECT_EQ(joint.name, expected.name);
    EXPECT_EQ(joint.parent, expected.parent);
    EXPECT_EQ(joint.channels, expected.channels.size());
    EXPECT_EQ(joint.has_end_site != 0, expected.end_site.has_value());
    EXPECT_EQ(joint.offset[1], static_cast<float>(expected.offset.y()));
  }
}

TEST(Decoder, FindsAJointByName) {
  const mcpr_clip* const clip = opened().clip;
  const auto joints = static_cast<std::int32_t>(mcpr::describe(clip).joints);
  for (std::int32_t j = 0; j < joints; ++j) {
    mcpr_joint joint;
    ASSERT_EQ(mcpr_clip_joint(clip, static_cast<std::uint32_t>(j), &joint, nullptr), MCPR_OK);
    EXPECT_EQ(mcpr_find_joint(clip, joint.name), j) << joint.name;
    EXPECT_EQ(mcpr_find_joint(clip, (std::string(joint.name) + "x").c_str()), -1);
  }
  EXPECT_EQ(mcpr_find_joint(clip, ""), -1);
  EXPECT_EQ(mcpr_find_joint(clip, nullptr), -1);
  EXPECT_EQ(mcpr_find_joint(nullptr, "root"), -1);
}

/// The header states that positive angles about y turn z to x, and that quaternions rotate columns.
TEST(Decoder, RotatesRightHanded) {
  Motion motion;
  motion.skeleton.add({.name = "root", .channels = {ChannelKind::RotationY}});
  motion.skeleton.add({.name = "nose", .parent = 0, .offset = {0, 0, 10}, .channels = {}});
  motion.clip.channels = Eigen::MatrixXd::Constant(16, 1, 1.5707963267948966);
  const OpenedClip clip(write_container(Encoder(motion)
                                            .encode({.method = Method::Standard,
                                                     .coding = Coding::Adaptive,
                                                     .weighting = Weighting::BoneEnds,
                                                     .target = {Target::Kind::Error, 1e-3}})
                                            .compressed));
  ASSERT_NE(clip.clip, nullptr) << clip.result.message;
  const std::vector<float> places = clip.frames({.output = MCPR_POSITIONS}, 0, 1);
  ASSERT_EQ(places.size(), 6u);
  EXPECT_NEAR(places[3], 10, 1e-2) << "what lay along z is along x";
  EXPECT_NEAR(places[5], 0, 1e-2);
  const std::vector<float> local = clip.frames({.output = MCPR_LOCAL}, 0, 1);
  const Eigen::Quaternionf turned(local[0], local[1], local[2], local[3]);
  EXPECT_LT((turned * Eigen::Vector3f::UnitZ() - Eigen::Vector3f::UnitX()).norm(), 1e-3);
}

TEST(Decoder, AnyRangeOfFramesEqualsThatPartOfTheWhole) {
  Random random(1);
  for (const mcpr_request& request :
       {mcpr_request{}, mcpr_request{.apply_ik = 1},
        mcpr_request{.output = MCPR_POSITIONS, .apply_ik = 1}, mcpr_request{.output = MCPR_LOCAL},
        mcpr_request{.bands_left_out = 2}}) {
    const Eigen::MatrixXf whole = all_frames(request);
    for (int round = 0; round < 20; ++round) {
      const auto count = static_cast<std::uint32_t>(1 + random.below(kFrames));
      const auto first = static_cast<std::uint32_t>(random.below(kFrames - count + 1));
      EXPECT_EQ(matrix(opened().frames(request, first, count), whole.cols()),
                whole.middleRows(first, count));
      EXPECT_EQ(matrix(opened().moment(request, first), whole.cols()), whole.row(first));
    }
  }
}

TEST(Decoder, EveryPathGivesTheSameBits) {
  for (const mcpr_output output : {MCPR_CHANNELS, MCPR_POSITIONS})
    for (const mcpr_path path : existing_paths())
      EXPECT_EQ(all_frames({.output = output, .apply_ik = 1, .path = path}),
                all_frames({.output = output, .apply_ik = 1}));
}

TEST(Decoder, ARequestCapsTheSolverAsTheLimitsDo) {
  const std::vector<std::byte> file = file_corrected_by(IkSolver::CyclicDescent);
  mcpr_limits limits = mcpr::default_limits();
  limits.solver_iterations = 1;
  const OpenedClip capped(file, &limits);
  const OpenedClip clip(file);
  const auto of = [](const OpenedClip& from, std::uint32_t iterations) {
    return from.frames({.apply_ik = 1, .solver_iterations = iterations}, 0, kFrames);
  };
  EXPECT_EQ(of(clip, 1), of(capped, 0));
  EXPECT_TRUE(of(clip, 1) != of(clip, 0));
  EXPECT_EQ(of(clip, 1000000), of(clip, 0));
  EXPECT_EQ(of(capped, 9), of(capped, 0));
}

TEST(Decoder, InterpolatesChannelsLinearly) {
  const Eigen::MatrixXf whole = all_frames({});
  for (const double frame : {0.25, 63.5, 148.75}) {
    const auto before = static_cast<Eigen::Index>(frame);
    const auto share = static_cast<float>(frame - static_cast<double>(before));
    const Eigen::MatrixXf expected =
        whole.row(before) + share * (whole.row(before + 1) - whole.row(before));
    EXPECT_TRUE(matrix(opened().moment({}, frame), whole.cols()).isApprox(expected, 1e-6F));
  }
}

TEST(Decoder, SubsetOfChannelsHasTheSameBits) {
  const std::vector<std::uint16_t> some = {9, 3, 14};
  for (const int corrected : {0, 1}) {
    const Eigen::MatrixXf whole = all_frames({.apply_ik = corrected});
    const Eigen::MatrixXf chosen =
        all_frames({.apply_ik = corrected, .channels = some.data(), .channel_count = 3});
    ASSERT_EQ(chosen.cols(), 3);
    for (Eigen::Index i = 0; i < 3; ++i)
      EXPECT_EQ(chosen.col(i), whole.col(some[static_cast<std::size_t>(i)])) << corrected;
  }
}

TEST(Decoder, PositionsMatchForwardKinematics) {
  const CompressedClip compressed = read_container(corrected_file());
  const Eigen::MatrixXf positions = all_frames({.output = MCPR_POSITIONS, .apply_ik = 1});
  const Eigen::MatrixXd expected = landmark_tracks(compressed.skeleton, decode(compressed))
                                       .leftCols(positions.cols());  // joints come before end sites
  EXPECT_LT((positions.cast<double>() - expected).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(Decoder, TurnedAxesMatchCore) {
  CompressedClip compressed = read_container(corrected_file());
  compressed.forms = test::turned_forms(compressed.skeleton);
  const OpenedClip turned(write_container(compressed));
  ASSERT_NE(turned.clip, nullptr) << turned.result.message;
  EXPECT_EQ(turned.info.motion_bytes, compressed.motion_bytes());
  const Eigen::MatrixXd expected = landmark_tracks(compressed.skeleton, decode(compressed));
  for (const int corrected : {0, 1}) {
    const mcpr_request request{.output = MCPR_POSITIONS, .apply_ik = corrected};
    const auto columns = static_cast<Eigen::Index>(mcpr_frame_values(turned.clip, &request));
    const Eigen::MatrixXf positions = matrix(turned.frames(request, 0, kFrames), columns);
    EXPECT_EQ((positions.cast<double>() - expected.leftCols(columns)).cwiseAbs().maxCoeff() < 1e-4,
              corrected == 1);
  }
}

TEST(Decoder, FloatsAreWithinTenMicrometresOfDoubles) {
  // Compares with double precision throughout. The figure travels metres, as in the corpus.
  const CompressedClip compressed = read_container(corrected_file());
  const Clip precise{
      compressed.sample_rate_hz,
      reconstruct(AdaptiveSegments(compressed).next(), Lifting(compressed.basis, compressed.frames))
          .leftCols(compressed.skeleton.channel_count())};
  const Eigen::MatrixXf positions = all_frames({.output = MCPR_POSITIONS});
  const Eigen::MatrixXd expected =
      landmark_tracks(compressed.skeleton, precise).leftCols(positions.cols());
  EXPECT_LT((positions.cast<double>() - expected).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(Decoder, LocalTransformsComposeToPositions) {
  const Eigen::MatrixXf local = all_frames({.output = MCPR_LOCAL});
  const Eigen::MatrixXf positions = all_frames({.output = MCPR_POSITIONS});
  const auto joints = local.cols() / 7;
  for (const Eigen::Index t : {0, 77, 149}) {
    std::vector<Eigen::Isometry3d> world_from_joint;
    for (Eigen::Index j = 0; j < joints; ++j) {
      const Eigen::VectorXd place = local.row(t).segment(7 * j, 7).transpose().cast<double>();
      const Eigen::Quaterniond turn(place(0), place(1), place(2), place(3));
      EXPECT_NEAR(turn.norm(), 1, 1e-6);
      mcpr_joint joint;
      mcpr_clip_joint(opened().clip, static_cast<std::uint32_t>(j), &joint, nullptr);
      Eigen::Isometry3d parent_from_joint = Eigen::Isometry3d::Identity();
      parent_from_joint.translate(Eigen::Vector3d(place.tail<3>()));
      parent_from_joint.rotate(turn);
      world_from_joint.push_back(joint.parent < 0
                                     ? parent_from_joint
                                     : world_from_joint[static_cast<std::size_t>(joint.parent)] *
                                           parent_from_joint);
      EXPECT_LT((world_from_joint.back().translation() -
                 positions.row(t).segment(3 * j, 3).transpose().cast<double>())
                    .norm(),
                1e-3);
    }
  }
}

TEST(Decoder, AClipMayBeMovedAsBytes) {
  const AlignedBytes moved(opened().resident->size());
  std::memcpy(moved.data(), opened().resident->data(), moved.size());
  const mcpr_request request{.output = MCPR_POSITIONS, .apply_ik = 1};
  OpenedClip copy({});
  copy.clip = reinterpret_cast<const mcpr_clip*>(moved.data());
  EXPECT_EQ(copy.frames(request, 0, kFrames), opened().frames(request, 0, kFrames));
}

TEST(Decoder, RefusesRequestsTheClipCannotFulfil) {
  const auto status = [](const mcpr_request& request, std::uint32_t first, std::uint32_t count) {
    const AlignedBytes scratch(std::size_t{1} << 20);
    std::vector<float> out(kFrames * 100);
    return mcpr_decode_frames(opened().clip, &request, first, count, out.data(), scratch.data(),
                              scratch.size(), nullptr);
  };
  const std::uint16_t beyond = 999;
  EXPECT_EQ(status({}, 0, kFrames), MCPR_OK);
  EXPECT_EQ(status({}, kFrames, 0), MCPR_OK);
  EXPECT_EQ(status({}, 0, kFrames + 1), MCPR_ARGUMENT);
  EXPECT_EQ(status({}, 0xFFFFFFFF, 2), MCPR_ARGUMENT);
  EXPECT_EQ(status({.channels = &beyond, .channel_count = 1}, 0, 1), MCPR_ARGUMENT);
  EXPECT_EQ(status({.output = MCPR_LOCAL, .channels = &beyond, .channel_count = 1}, 0, 1),
            MCPR_ARGUMENT);
  EXPECT_EQ(opened().moment({}, kFrames - 0.5), opened().moment({}, kFrames - 1));
  EXPECT_EQ(opened().moment({}, -0.1), opened().moment({}, 0));
  EXPECT_TRUE(opened().moment({.wrap = static_cast<mcpr_wrap>(6)}, 0).empty());
  const double rate = mcpr::describe(opened().clip).sample_rate;
  EXPECT_EQ(opened().moment({.unit = MCPR_SECONDS}, 0.25), opened().moment({}, 0.25 * rate));
  EXPECT_TRUE(opened().moment({}, std::numeric_limits<double>::quiet_NaN()).empty());
}

TEST(Decoder, RefusesDuplicateChannels) {
  const auto values = [](const std::vector<std::uint16_t>& channels) {
    const mcpr_request request{.channels = channels.data(),
                               .channel_count = static_cast<std::uint32_t>(channels.size())};
    return mcpr_frame_values(opened().clip, &request);
  };
  EXPECT_EQ(values({3, 9, 4}), 3u);
  EXPECT_EQ(values({3, 9, 3}), 0u);
  const std::uint16_t twice[] = {5, 5};
  for (const int corrected : {0, 1})
    EXPECT_TRUE(opened()
                    .frames({.apply_ik = corrected, .channels = twice, .channel_count = 2}, 0, 1)
                    .empty());
}

TEST(Decoder, RefusesNullForRequiredArguments) {
  const auto& file = corrected_file();
  mcpr_info info;
  EXPECT_EQ(mcpr_inspect(nullptr, file.size(), nullptr, &info, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_inspect(nullptr, 0, nullptr, &info, nullptr), MCPR_NOT_A_CLIP);
  EXPECT_EQ(mcpr_inspect(file.data(), file.size(), nullptr, nullptr, nullptr), MCPR_ARGUMENT);

  const std::size_t need = opened().info.read_bytes;
  const AlignedBytes opening(need);
  std::size_t size = 0;
  EXPECT_EQ(mcpr_read(nullptr, file.size(), nullptr, opening.data(), need, &size, nullptr),
            MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_read(file.data(), file.size(), nullptr, nullptr, need, &size, nullptr),
            MCPR_NO_MEMORY);
  EXPECT_EQ(mcpr_read(file.data(), file.size(), nullptr, opening.data(), need, nullptr, nullptr),
            MCPR_ARGUMENT);
  ASSERT_EQ(mcpr_read(file.data(), file.size(), nullptr, opening.data(), need, &size, nullptr),
            MCPR_OK);

  const AlignedBytes resident(size);
  const mcpr_clip* clip = nullptr;
  EXPECT_EQ(mcpr_build(nullptr, need, resident.data(), size, &clip, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_build(opening.data(), need, nullptr, size, &clip, nullptr), MCPR_NO_MEMORY);
  EXPECT_EQ(mcpr_build(opening.data(), need, resident.data(), size, nullptr, nullptr),
            MCPR_ARGUMENT);
  ASSERT_EQ(mcpr_build(opening.data(), need, resident.data(), size, &clip, nullptr), MCPR_OK);

  EXPECT_EQ(mcpr::describe(static_cast<const mcpr_clip*>(nullptr)).frames, 0u);
  mcpr_joint joint;
  EXPECT_EQ(mcpr_clip_joint(nullptr, 0, &joint, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_clip_joint(clip, 0, nullptr, nullptr), MCPR_ARGUMENT);

  const mcpr_request request{};
  EXPECT_EQ(mcpr_frame_values(nullptr, &request), 0u);
  EXPECT_EQ(mcpr_frame_values(clip, nullptr), 0u);
  EXPECT_EQ(mcpr_scratch_bytes(nullptr, &request), 0u);
  EXPECT_EQ(mcpr_scratch_bytes(clip, nullptr), 0u);
  const mcpr_request no_channels{.channels = nullptr, .channel_count = 2};
  EXPECT_EQ(mcpr_frame_values(clip, &no_channels), 0u);

  const std::size_t scratch_size = mcpr_scratch_bytes(clip, &request);
  const AlignedBytes scratch(scratch_size);
  std::vector<float> out(mcpr_frame_values(clip, &request));
  const auto frames = [&](const mcpr_clip* of, const mcpr_request* asked, float* to, void* memory) {
    return mcpr_decode_frames(of, asked, 0, 1, to, memory, scratch_size, nullptr);
  };
  const auto moment = [&](const mcpr_clip* of, const mcpr_request* asked, float* to, void* memory) {
    return mcpr_decode_moment(of, asked, 0.5, to, memory, scratch_size, nullptr);
  };
  EXPECT_EQ(frames(nullptr, &request, out.data(), scratch.data()), MCPR_ARGUMENT);
  EXPECT_EQ(frames(clip, nullptr, out.data(), scratch.data()), MCPR_ARGUMENT);
  EXPECT_EQ(frames(clip, &request, nullptr, scratch.data()), MCPR_ARGUMENT);
  EXPECT_EQ(frames(clip, &request, out.data(), nullptr), MCPR_NO_MEMORY);
  EXPECT_EQ(frames(clip, &request, out.data(), scratch.data()), MCPR_OK);
  EXPECT_EQ(moment(nullptr, &request, out.data(), scratch.data()), MCPR_ARGUMENT);
  EXPECT_EQ(moment(clip, nullptr, out.data(), scratch.data()), MCPR_ARGUMENT);
  EXPECT_EQ(moment(clip, &request, nullptr, scratch.data()), MCPR_ARGUMENT);
  EXPECT_EQ(moment(clip, &request, out.data(), nullptr), MCPR_NO_MEMORY);
  EXPECT_EQ(moment(clip, &request, out.data(), scratch.data()), MCPR_OK);
}

TEST(Decoder, BuildTakesScratchMemoryAsWritable) {
  // Read-only memory may be passed as const, so work space must not be.
  EXPECT_TRUE((std::is_invocable_v<decltype(mcpr_build), void*, std::size_t, void*, std::size_t,
                                   const mcpr_clip**, mcpr_result*>));
  EXPECT_FALSE((std::is_invocable_v<decltype(mcpr_build), const void*, std::size_t, void*,
                                    std::size_t, const mcpr_clip**, mcpr_result*>));
}

TEST(Decoder, RefusesTooLittleMemory) {
  const mcpr_request request{};
  const AlignedBytes scratch(std::size_t{1} << 20);
  float out[100];
  const std::size_t need = mcpr_scratch_bytes(opened().clip, &request);
  EXPECT_EQ(mcpr_decode_frames(opened().clip, &request, 0, 1, out, scratch.data(), need, nullptr),
            MCPR_OK);
  EXPECT_EQ(
      mcpr_decode_frames(opened().clip, &request, 0, 1, out, scratch.data(), need - 1, nullptr),
      MCPR_MEMORY);
  EXPECT_EQ(
      mcpr_decode_frames(opened().clip, &request, 0, 1, out, scratch.data() + 4, need, nullptr),
      MCPR_MISALIGNED);
  const auto& file = corrected_file();
  std::size_t size = 0;
  EXPECT_EQ(mcpr_read(file.data(), file.size(), nullptr, scratch.data(),
                      opened().info.read_bytes - 1, &size, nullptr),
            MCPR_MEMORY);
}

TEST(Decoder, RefusesFilesBeyondTheLimits) {
  const auto status = [](auto change) {
    mcpr_limits limits = mcpr::default_limits();
    change(limits);
    return OpenedClip(corrected_file(), &limits).result.status;
  };
  EXPECT_EQ(status([](mcpr_limits&) {}), MCPR_OK);
  EXPECT_EQ(status([](mcpr_limits& l) { l.frames = kFrames - 1; }), MCPR_LIMIT);
  EXPECT_EQ(status([](mcpr_limits& l) { l.joints = 3; }), MCPR_LIMIT);
  EXPECT_EQ(status([](mcpr_limits& l) { l.channels = 3; }), MCPR_LIMIT);
  EXPECT_EQ(status([](mcpr_limits& l) { l.values = 150 * 20; }), MCPR_LIMIT);
  EXPECT_EQ(status([](mcpr_limits& l) { l.scratch_bytes = 1000; }), MCPR_LIMIT);
  EXPECT_EQ(status([](mcpr_limits& l) { l.resident_bytes = 1000; }), MCPR_LIMIT);
}

TEST(Decoder, ReportsOtherCodingsAsUnsupported) {
  const Motion motion = test::smooth_motion(40);
  const auto file = write_container(Encoder(motion)
                                        .encode({.method = Method::Standard,
                                                 .weighting = Weighting::BoneEnds,
                                                 .target = {Target::Kind::CoefficientRatio, 4}})
                                        .compressed);
  EXPECT_EQ(OpenedClip(file).result.status, MCPR_UNSUPPORTED);
}

TEST(Decoder, RefusesEveryPrefixAndEveryFlippedBit) {
  const auto& file = corrected_file();
  for (std::size_t size = 0; size < file.size(); ++size) {
    const std::vector<std::byte> prefix(file.begin(), file.begin() + static_cast<long>(size));
    EXPECT_EQ(OpenedClip(prefix).clip, nullptr) << size;
  }
  auto longer = file;
  longer.push_back(std::byte{0});
  EXPECT_EQ(OpenedClip(longer).clip, nullptr);
  for (std::size_t bit = 0; bit < 8 * file.size(); bit += 3) {
    auto flipped = file;
    flipped[bit / 8] ^= static_cast<std::byte>(1 << (bit % 8));
    EXPECT_EQ(OpenedClip(flipped).clip, nullptr) << bit;
  }
}

/// A walk on the spot with 60 frames per cycle, and one whose last frame repeats the first pose.
std::vector<std::byte> loop_file(Loop loop) {
  const int frames = loop == Loop::Repeats ? 61 : 60;
  Motion motion = test::smooth_motion(frames);
  for (int c = 0; c < motion.skeleton.channel_count(); ++c)
    for (int t = 0; t < frames; ++t)
      motion.clip.channels(t, c) = 0.5 * std::sin(6.283185307179586 * t / 60 + c);
  return write_container(Encoder(motion)
                             .encode({.method = Method::ClosedLoop,
                                      .weighting = Weighting::Surface,
                                      .target = {Target::Kind::Error, 0.05},
                                      .loop = loop})
                             .compressed);
}

std::vector<float> looped(const OpenedClip& clip, mcpr_request request, double frame) {
  request.wrap = MCPR_LOOP;
  return clip.moment(request, frame);
}

TEST(DecoderOfALoop, WrapsInBothDirections) {
  for (const Loop loop : {Loop::Repeats, Loop::Follows}) {
    const OpenedClip clip(loop_file(loop));
    ASSERT_NE(clip.clip, nullptr) << clip.result.message;
    EXPECT_EQ(mcpr::describe(clip.clip).loop_frames, 60u);
    for (const mcpr_request& request : {mcpr_request{}, mcpr_request{.output = MCPR_LOCAL}})
      for (const double frame : {0.0, 0.25, 17.0, 58.5}) {
        const std::vector<float> expected = clip.moment(request, frame);
        for (const int turns : {-3, 0, 1, 1000})
          EXPECT_EQ(looped(clip, request, frame + 60 * turns), expected);
      }
  }
}

TEST(DecoderOfALoop, HasNoJumpAtTheSeam) {
  for (const Loop loop : {Loop::Repeats, Loop::Follows}) {
    const OpenedClip clip(loop_file(loop));
    ASSERT_NE(clip.clip, nullptr);
    // An angle with amplitude 0.5 changes by at most 0.053 in a sixtieth of a cycle, and by a
    // hundredth of that in a hundredth of the time.
    std::vector<float> before = looped(clip, {}, 58);
    for (double frame = 58.01; frame < 62; frame += 0.01) {
      const std::vector<float> now = looped(clip, {}, frame);
      for (std::size_t c = 6; c < now.size(); ++c)  // channels of the root are extrapolated
        EXPECT_NEAR(now[c], before[c], 0.004) << frame;
      before = now;
    }
  }
}

TEST(DecoderOfALoop, RefusesClipsThatAreNoLoops) {
  EXPECT_EQ(mcpr::describe(opened().clip).loop_frames, 0u);
  EXPECT_TRUE(looped(opened(), {}, 0).empty());
  const OpenedClip clip(loop_file(Loop::Follows));
  EXPECT_TRUE(looped(clip, {}, std::numeric_limits<double>::infinity()).empty());
}

}  // namespace
}  // namespace mocapress::mocapress_runtime_test
