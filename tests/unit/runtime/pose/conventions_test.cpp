// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"
#include "tests/support/test_motion.h"
#include "tests/unit/runtime/paths.h"

namespace mocapress::conventions_test {
namespace {

using test::CookedClip;
using test::OpenedClip;

constexpr mcpr_engine kEngines[] = {MCPR_MOCAPRESS, MCPR_GLTF,   MCPR_GODOT,
                                    MCPR_UNITY,     MCPR_UNREAL, MCPR_BLENDER};

class Conventions : public testing::Test {
 protected:
  Conventions()
      : opened_(write_container(
            Encoder(test::smooth_motion(90))
                .encode({.method = Method::ClosedLoop, .weighting = Weighting::BoneEnds})
                .compressed)),
        cooked_(opened_.clip) {
    for (std::uint32_t j = 0; j < mcpr::describe(opened_.clip).joints; ++j) {
      mcpr_joint joint{};
      mcpr_clip_joint(opened_.clip, j, &joint, nullptr);
      parents_.push_back(static_cast<std::int16_t>(joint.parent));
    }
  }

  static mcpr_convention of(mcpr_engine engine) {
    mcpr_convention convention{};
    EXPECT_EQ(mcpr_convention_of(engine, &convention, nullptr), MCPR_OK);
    return convention;
  }

  mcpr_status refusal_of(const mcpr_sample_request& request) const {
    std::vector<float> out(4096);
    return mcpr_sample(cooked_.clip, &request, 3, out.data(), nullptr);
  }

  OpenedClip opened_;
  CookedClip cooked_;
  std::vector<std::int16_t> parents_;
};

TEST_F(Conventions, ModelSpaceHasTheDecodersPositions) {
  for (const double frame : {0.0, 17.5, 89.0}) {
    const std::vector<float> world = opened_.moment({.output = MCPR_POSITIONS}, frame);
    const std::size_t joints = world.size() / 3;
    for (const mcpr_layout layout : {MCPR_TRANSFORMS, MCPR_ARRAYS, MCPR_MATRICES}) {
      const std::vector<float> pose =
          cooked_.sample({.layout = layout, .parents = parents_.data()}, frame);
      for (std::size_t j = 0; j < joints; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t at = layout == MCPR_TRANSFORMS ? 8 * j + 4 + i
                                 : layout == MCPR_ARRAYS   ? (4 + i) * joints + j
                                                           : 12 * j + 4 * i + 3;
          EXPECT_NEAR(pose[at], world[3 * j + i], 0.02) << layout << " " << j;
        }
    }
  }
}

TEST_F(Conventions, QuaternionsAndMatricesOfEveryEngineAreTheSameRotations) {
  for (const mcpr_engine engine : kEngines) {
    const mcpr_convention convention = of(engine);
    const std::vector<float> pose = cooked_.sample({.convention = &convention}, 31.3);
    const std::vector<float> matrices =
        cooked_.sample({.layout = MCPR_MATRICES, .convention = &convention}, 31.3);
    const std::vector<float> arrays =
        cooked_.sample({.layout = MCPR_ARRAYS, .convention = &convention}, 31.3);
    const std::size_t joints = pose.size() / 8;
    for (std::size_t j = 0; j < joints; ++j) {
      const float* const q = &pose[8 * j];
      for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(arrays[k * joints + j], q[k]);
      const bool w_last = convention.w_last != 0;
      const float w = q[w_last ? 3 : 0];
      const float* const v = q + (w_last ? 0 : 1);
      const float* const m = &matrices[12 * j];
      EXPECT_NEAR(m[0], 1 - 2 * (v[1] * v[1] + v[2] * v[2]), 1e-6);
      EXPECT_NEAR(m[1], 2 * (v[0] * v[1] - w * v[2]), 1e-6);
      EXPECT_NEAR(m[4], 2 * (v[0] * v[1] + w * v[2]), 1e-6);
      EXPECT_NEAR(m[9], 2 * (v[1] * v[2] + w * v[0]), 1e-6);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(m[4 * i + 3], q[4 + i]);
    }
  }
}

TEST_F(Conventions, VectorsOfFourHoldTheTransformsAndARestBehindTheLast) {
  const std::uint16_t joints[] = {2, 0, 1, 4, 3, 5};  // one vector, and half of another
  for (const mcpr_engine engine : {MCPR_MOCAPRESS, MCPR_UNREAL}) {
    const mcpr_convention convention = of(engine);
    mcpr_sample_request request{.joints = joints, .joint_count = 6, .convention = &convention};
    const std::vector<float> pose = cooked_.sample(request, 31.3);
    request.layout = MCPR_FOURS;
    const std::vector<float> fours = cooked_.sample(request, 31.3);
    ASSERT_EQ(fours.size(), 80U);
    const auto at = [&](std::size_t vector, std::size_t joint) {
      return fours[40 * (joint / 4) + 4 * vector + joint % 4];
    };
    for (std::size_t j = 0; j < 8; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(at(k, j), j < 6 ? pose[8 * j + 4 + k] : 0);
        EXPECT_EQ(at(7 + k, j), 1);
      }
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_EQ(at(3 + k, j), j < 6                                     ? pose[8 * j + k]
                                : k == (convention.w_last != 0 ? 3U : 0U) ? 1
                                                                          : 0);
    }
  }
}

/// The number that a half float stands for.
double number_of(std::uint16_t half) {
  const int exponent = half >> 10 & 31;
  const double fraction = half & 1023;
  const double size =
      exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  return half >> 15 != 0 ? -size : size;
}

TEST_F(Conventions, HalvesAreTheNearestToTheTransforms) {
  for (const double frame : {0.0, 12.7, 60.2}) {
    const std::vector<float> pose = cooked_.sample({}, frame);
    const std::vector<float> packed = cooked_.sample({.layout = MCPR_HALVES}, frame);
    ASSERT_EQ(2 * packed.size(), pose.size());
    std::vector<std::uint16_t> halves(pose.size());
    std::memcpy(halves.data(), packed.data(), sizeof(float) * packed.size());
    for (std::size_t i = 0; i < pose.size(); ++i) {
      const auto value = static_cast<double>(pose[i]);
      const double error = std::abs(number_of(halves[i]) - value);
      for (const int neighbour : {-1, 1})
        EXPECT_LE(error, std::abs(number_of(static_cast<std::uint16_t>(
                                      (halves[i] & 0x7FFF) == 0 ? 1 : halves[i] + neighbour)) -
                                  value))
            << value;
    }
  }
}

TEST_F(Conventions, HalvesTooLargeAreInfinite) {
  const mcpr_convention convention{.length = 1e6F};
  const std::vector<float> pose =
      cooked_.sample({.layout = MCPR_HALVES, .convention = &convention}, 31.3);
  std::uint16_t halves[8];
  std::memcpy(halves, pose.data(), sizeof halves);
  EXPECT_EQ(halves[5] & 0x7FFF, 0x7C00) << "the height of the root";
  EXPECT_EQ(halves[7], 0);
}

TEST_F(Conventions, AWriterGetsEveryJointInTurn) {
  std::vector<mcpr_transform> written;
  mcpr_writer writer{[](void* context, std::uint32_t joint, const mcpr_transform* transform) {
                       auto& all = *static_cast<std::vector<mcpr_transform>*>(context);
                       EXPECT_EQ(joint, all.size());
                       all.push_back(*transform);
                     },
                     &written};
  const mcpr_convention convention = of(MCPR_UNITY);
  mcpr_sample_request request{.convention = &convention, .parents = parents_.data()};
  const std::vector<float> pose = cooked_.sample(request, 31.3);
  request.layout = MCPR_WRITER;
  ASSERT_EQ(mcpr_sample(cooked_.clip, &request, 31.3, &writer, nullptr), MCPR_OK);
  ASSERT_EQ(8 * written.size(), pose.size());
  EXPECT_EQ(std::memcmp(written.data(), pose.data(), sizeof(float) * pose.size()), 0);

  written.clear();
  const mcpr_character character{
      .clip = cooked_.clip, .time = 31.3, .out = &writer, .parents = parents_.data()};
  const mcpr_crowd_request crowd{.layout = MCPR_WRITER, .convention = &convention};
  const AlignedBytes scratch(mcpr_crowd_scratch_bytes());
  ASSERT_EQ(mcpr_sample_crowd(&crowd, &character, 1, scratch.data(), scratch.size(), nullptr),
            MCPR_OK);
  EXPECT_EQ(std::memcmp(written.data(), pose.data(), sizeof(float) * pose.size()), 0);

  writer.write = nullptr;
  EXPECT_EQ(mcpr_sample(cooked_.clip, &request, 31.3, &writer, nullptr), MCPR_ARGUMENT);
}

TEST_F(Conventions, PositionsAreInTheEnginesAxesAndUnit) {
  const std::vector<float> own = cooked_.sample({.parents = parents_.data()}, 31.3);
  const auto expect = [&](mcpr_engine engine, const auto& mapped) {
    const mcpr_convention convention = of(engine);
    const std::vector<float> pose =
        cooked_.sample({.convention = &convention, .parents = parents_.data()}, 31.3);
    for (std::size_t j = 0; j < pose.size() / 8; ++j) {
      const float* const t = &own[8 * j + 4];
      const std::array<float, 3> wanted = mapped(t[0], t[1], t[2]);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(pose[8 * j + 4 + i], wanted[i], 1e-3);
    }
  };
  using Point = std::array<float, 3>;
  const auto metres = [](float x, float y, float z) {
    return Point{0.01F * x, 0.01F * y, 0.01F * z};
  };
  expect(MCPR_MOCAPRESS, [](float x, float y, float z) { return Point{x, y, z}; });
  expect(MCPR_GLTF, metres);
  expect(MCPR_GODOT, metres);
  expect(MCPR_UNITY, [&](float x, float y, float z) { return metres(-x, y, z); });
  expect(MCPR_UNREAL, [](float x, float y, float z) { return Point{x, z, y}; });
  expect(MCPR_BLENDER, [&](float x, float y, float z) { return metres(x, -z, y); });
}

/// Children are placed by rotations, so a wrong sign of a quaternion would misplace them.
TEST_F(Conventions, ModelSpaceMayBeMadeBeforeOrAfterTheConversion) {
  for (const mcpr_engine engine : kEngines) {
    mcpr_convention convention = of(engine);
    convention.w_last = 0;
    const std::vector<float> before =
        cooked_.sample({.convention = &convention, .parents = parents_.data()}, 50);
    std::vector<float> after =
        cooked_.sample({.layout = MCPR_MATRICES, .convention = &convention}, 50);
    for (std::size_t j = 0; j < parents_.size(); ++j) {
      if (parents_[j] < 0) continue;
      const float* const p = &after[12 * static_cast<std::size_t>(parents_[j])];
      float m[12];
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
          m[4 * row + column] = column == 3 ? p[4 * row + 3] : 0;
          for (std::size_t k = 0; k < 3; ++k)
            m[4 * row + column] += p[4 * row + k] * after[12 * j + 4 * k + column];
        }
      std::copy_n(m, 12, &after[12 * j]);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(before[8 * j + 4 + i], after[12 * j + 4 * i + 3], 1e-3) << engine << " " << j;
    }
  }
}

TEST_F(Conventions, TheClipsOwnChangesNoBit) {
  const mcpr_convention own{};
  EXPECT_EQ(cooked_.sample({.convention = &own}, 12.5), cooked_.sample({}, 12.5));
}

TEST_F(Conventions, EveryPathAndACrowdGiveTheSameBits) {
  const mcpr_convention convention = of(MCPR_UNREAL);
  const std::vector<float> expected =
      cooked_.sample({.convention = &convention, .parents = parents_.data()}, 12.5);
  for (const mcpr_path path : existing_paths())
    EXPECT_EQ(
        cooked_.sample({.path = path, .convention = &convention, .parents = parents_.data()}, 12.5),
        expected);
  std::vector<float> posed(expected.size());
  const mcpr_character character = {
      .clip = cooked_.clip, .time = 12.5, .out = posed.data(), .parents = parents_.data()};
  const mcpr_crowd_request request = {.convention = &convention, .exact = 1};
  const AlignedBytes scratch(mcpr_crowd_scratch_bytes());
  ASSERT_EQ(mcpr_sample_crowd(&request, &character, 1, scratch.data(), scratch.size(), nullptr),
            MCPR_OK);
  EXPECT_EQ(posed, expected);
}

TEST_F(Conventions, RootMotionIsConverted) {
  const mcpr_convention convention = of(MCPR_BLENDER);
  const mcpr_sample_request own{};
  const mcpr_sample_request request = {.convention = &convention};
  mcpr_transform moved{};
  mcpr_transform converted{};
  ASSERT_EQ(mcpr_sample_motion(cooked_.clip, &own, 0, 3, 40, &moved, nullptr), MCPR_OK);
  ASSERT_EQ(mcpr_sample_motion(cooked_.clip, &request, 0, 3, 40, &converted, nullptr), MCPR_OK);
  EXPECT_FLOAT_EQ(converted.translation[0], 0.01F * moved.translation[0]);
  EXPECT_FLOAT_EQ(converted.translation[1], -0.01F * moved.translation[2]);
  EXPECT_FLOAT_EQ(converted.translation[2], 0.01F * moved.translation[1]);
  EXPECT_EQ(converted.rotation[3], moved.rotation[2]);
}

TEST_F(Conventions, RefuseAxesThatAreNotThreeAndParentsThatComeLater) {
  for (const mcpr_convention& wrong :
       {mcpr_convention{{1, 1, 2}, 0, 1}, mcpr_convention{{1, 2, 4}, 0, 1},
        mcpr_convention{{0, 2, 3}, 0, 1}, mcpr_convention{{1, 2, 0}, 0, 1},
        mcpr_convention{{1, 2, 3}, 0, std::numeric_limits<float>::infinity()}})
    EXPECT_EQ(refusal_of({.convention = &wrong}), MCPR_ARGUMENT);
  std::vector<std::int16_t> later = parents_;
  later[1] = 1;
  EXPECT_EQ(refusal_of({.parents = later.data()}), MCPR_ARGUMENT);
  later[1] = -2;
  EXPECT_EQ(refusal_of({.parents = later.data()}), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_convention_of(static_cast<mcpr_engine>(6), nullptr, nullptr), MCPR_ARGUMENT);
}

}  // namespace
}  // namespace mocapress::conventions_test
