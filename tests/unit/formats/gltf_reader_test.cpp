// SPDX-License-Identifier: MIT
#include "core/formats/gltf_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <limits>
#include <numbers>

#include "core/base/file.h"
#include "core/base/random.h"
#include "core/motion/forward_kinematics.h"
#include "tests/support/corpus.h"
#include "tests/support/small_gltf.h"

namespace mocapress::gltf_reader_test {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using test::SmallGltf;

constexpr double kPlace = 1e-4;  // cm
constexpr double kRight = std::numbers::pi / 2;

MotionFile read(const SmallGltf& gltf, const ReadOptions& options = {}) {
  return read_gltf("small.glb", gltf.glb(), options);
}

/// The position of a joint (cm).
Vector3d place(const Motion& motion, const std::string& joint, int frame) {
  Pose pose;
  compute_pose(motion.skeleton, motion.clip.channels.row(frame), pose);
  return pose.origin.at(static_cast<std::size_t>(motion.skeleton.find(joint)));
}

void expect_place(const Motion& motion, const std::string& joint, int frame, const Vector3d& cm) {
  EXPECT_LT((place(motion, joint, frame) - cm).norm(), kPlace)
      << joint << " in frame " << frame << " is at " << place(motion, joint, frame).transpose();
}

/// The ankle's position with the knee bent by `angle`.
Vector3d ankle_at(double angle) {
  return {0, 50 - 40 * std::cos(angle), -40 * std::sin(angle)};
}

std::string refusal(const std::string& bytes, const std::string& name = "small.glb") {
  try {
    read_gltf(name, bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "reads";
}

std::string refusal(const SmallGltf& gltf) {
  return refusal(gltf.glb());
}

std::vector<float> turn_about_x(double angle) {
  return {static_cast<float>(std::sin(angle / 2)), 0, 0, static_cast<float>(std::cos(angle / 2))};
}

/// A knee at rest at 0 s and bent by a right angle at 1 s, from an accessor of four numbers for
/// each key.
SmallGltf two_keys(const std::string& interpolation, const std::vector<float>& turns) {
  SmallGltf gltf;
  gltf.begin_animation();
  const std::size_t input = gltf.add<float>("SCALAR", {0, 1});
  gltf.move(1, "rotation", input, gltf.add("VEC4", turns), interpolation);
  return gltf;
}

std::vector<float> joined(std::vector<float> a, const std::vector<float>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(GltfReader, ReadsMetresAndEveryKeyAsAFrame) {
  const MotionFile file = read(test::bending_knee());
  EXPECT_TRUE(file.warnings.empty());
  EXPECT_EQ(file.source.kind, SourceFormat::Kind::Gltf);
  EXPECT_EQ(file.source.cm_per_unit, 100);
  EXPECT_EQ(file.motion.clip.sample_rate_hz, 10);
  ASSERT_EQ(file.motion.clip.frames(), 11);
  EXPECT_EQ(file.motion.skeleton.joint_count(), 3);
  expect_place(file.motion, "hips", 4, {0, 100, 0});
  for (int frame = 0; frame <= 10; ++frame)
    expect_place(file.motion, "ankle", frame, ankle_at(kRight * frame / 10));
}

TEST(GltfReader, TurnsTheShortWayBetweenLinearKeys) {
  std::vector<float> other_side = turn_about_x(kRight);
  for (float& value : other_side) value = -value;
  const SmallGltf gltf = two_keys("LINEAR", joined(turn_about_x(0), other_side));
  const Motion motion = read(gltf, {.sample_rate_hz = 10}).motion;
  ASSERT_EQ(motion.clip.frames(), 11);
  expect_place(motion, "ankle", 3, ankle_at(0.3 * kRight));
}

TEST(GltfReader, HoldsStepKeys) {
  const SmallGltf gltf = two_keys("STEP", joined(turn_about_x(0), turn_about_x(kRight)));
  const Motion motion = read(gltf, {.sample_rate_hz = 10}).motion;
  expect_place(motion, "ankle", 9, ankle_at(0));
  expect_place(motion, "ankle", 10, ankle_at(kRight));
}

TEST(GltfReader, FollowsCubicSplines) {
  SmallGltf gltf;
  gltf.begin_animation();
  const std::size_t input = gltf.add<float>("SCALAR", {0, 2});
  // x = t^3 / 8 has slope 0 at 0 s and 1.5 at 2 s. Each key has in-tangent, value, out-tangent.
  const std::size_t output =
      gltf.add<float>("VEC3", {9, 9, 9, 0, 1, 0, 0, 0, 0, 1.5, 0, 0, 1, 1, 0, 9, 9, 9});
  gltf.move(0, "translation", input, output, "CUBICSPLINE");
  const Motion motion = read(gltf, {.sample_rate_hz = 10}).motion;
  ASSERT_EQ(motion.clip.frames(), 21);
  expect_place(motion, "hips", 6, {100 * 0.6 * 0.6 * 0.6 / 8, 100, 0});
  expect_place(motion, "hips", 20, {100, 100, 0});
}

TEST(GltfReader, FollowsCubicSplinesOfRotations) {
  // With tangents of zero, s = 1/2 is half way, and the quaternion is normalised.
  std::vector<float> keys(24, 0.0F);
  std::copy_n(turn_about_x(0).begin(), 4, keys.begin() + 4);
  std::copy_n(turn_about_x(kRight).begin(), 4, keys.begin() + 16);
  const Motion motion = read(two_keys("CUBICSPLINE", keys), {.sample_rate_hz = 10}).motion;
  expect_place(motion, "ankle", 5, ankle_at(kRight / 2));
  expect_place(motion, "ankle", 10, ankle_at(kRight));
}

TEST(GltfReader, ReadsIntegersOfEverySizeAsShares) {
  const auto check = [](auto one, int type) {
    using Integer = decltype(one);
    SmallGltf gltf;
    gltf.begin_animation();
    const std::size_t input = gltf.add<float>("SCALAR", {0, 1});
    // The rotation (0.6, 0, 0, 0.8): half its angle has the sine 0.6.
    const auto share = [&](double of) {
      return static_cast<Integer>(std::lround(of * static_cast<double>(one)));
    };
    const std::vector<Integer> turns = {0, 0, 0, one, share(0.6), 0, 0, share(0.8)};
    gltf.move(1, "rotation", input, gltf.add("VEC4", turns, type, true));
    const Motion motion = read(gltf, {.sample_rate_hz = 10}).motion;
    EXPECT_LT((place(motion, "ankle", 10) - ankle_at(2 * std::asin(0.6))).norm(),
              80.0 / static_cast<double>(one))
        << "component type " << type;
  };
  check(std::numeric_limits<std::int8_t>::max(), 5120);
  check(std::numeric_limits<std::uint8_t>::max(), 5121);
  check(std::numeric_limits<std::int16_t>::max(), 5122);
  check(std::numeric_limits<std::uint16_t>::max(), 5123);
}

TEST(GltfReader, ReadsPlacesThatAreWholeNumbers) {
  SmallGltf gltf;
  gltf.begin_animation();
  const std::size_t input = gltf.add<float>("SCALAR", {0, 1});
  gltf.move(0, "translation", input, gltf.add<std::int16_t>("VEC3", {0, 1, 0, 3, -2, 0}, 5122));
  expect_place(read(gltf, {.sample_rate_hz = 10}).motion, "hips", 10, {300, -200, 0});
}

TEST(GltfReader, FillsInSparseValues) {
  SmallGltf gltf;
  gltf.begin_animation();
  const std::size_t input = gltf.add<float>("SCALAR", {0, 0.1F, 0.2F});
  const std::size_t indices = gltf.add_view<std::uint8_t>({0, 2});
  const std::size_t values = gltf.add_view<float>({0, 1, 0, 0, 2, 0});
  // An accessor without a bufferView is zero, except for its sparse values.
  gltf.json["accessors"].push_back(
      {{"componentType", 5126},
       {"count", 3},
       {"type", "VEC3"},
       {"sparse",
        {{"count", 2},
         {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
         {"values", {{"bufferView", values}}}}}});
  gltf.move(0, "translation", input, gltf.json["accessors"].size() - 1);
  const Motion motion = read(gltf, {.sample_rate_hz = 10}).motion;
  expect_place(motion, "hips", 0, {0, 100, 0});
  expect_place(motion, "hips", 1, {0, 0, 0});
  expect_place(motion, "hips", 2, {0, 200, 0});
}

TEST(GltfReader, StepsOverWhatLiesBetweenValues) {
  SmallGltf gltf;
  gltf.begin_animation();
  // Times and places are interleaved.
  const std::size_t view = gltf.add_view<float>({0, 0, 1, 0, 0.1F, 1, 1, 0, 0.2F, 2, 1, 0});
  gltf.json["bufferViews"][view]["byteStride"] = 16;
  const auto accessor = [&](const char* type, int offset) {
    gltf.json["accessors"].push_back({{"bufferView", view},
                                      {"byteOffset", offset},
                                      {"componentType", 5126},
                                      {"count", 3},
                                      {"type", type}});
    return gltf.json["accessors"].size() - 1;
  };
  const std::size_t input = accessor("SCALAR", 0);
  gltf.move(0, "translation", input, accessor("VEC3", 4));
  expect_place(read(gltf, {.sample_rate_hz = 10}).motion, "hips", 2, {200, 100, 0});
}

TEST(GltfReader, TakesMatricesApart) {
  SmallGltf gltf = test::bending_knee();
  // An armature twice as large, a quarter turn about y, and off the centre.
  gltf.json["nodes"].push_back({{"name", "armature"},
                                {"matrix", {0, 0, -2, 0, 0, 2, 0, 0, 2, 0, 0, 0, 3, 0, 0, 1}},
                                {"children", {0}}});
  gltf.json["scenes"][0]["nodes"] = Json::array({3});
  const MotionFile file = read(gltf);
  EXPECT_EQ(file.motion.skeleton.find("armature"), -1);
  expect_place(file.motion, "hips", 0, {300, 200, 0});
  expect_place(file.motion, "ankle", 10, {300 - 80, 100, 0});
}

TEST(GltfReader, ReadsTheFirstTakeThatMovesNodesOrTheOneAskedFor) {
  SmallGltf gltf = test::bending_knee();
  const Json walk = gltf.json["animations"][0];
  gltf.json["animations"] = Json::array();
  gltf.begin_animation("smile");
  gltf.move(0, "weights", 0, 0);
  gltf.json["animations"].push_back(walk);
  gltf.begin_animation("jump");
  gltf.move(0, "translation", gltf.add<float>("SCALAR", {0, 0.1F}),
            gltf.add<float>("VEC3", {0, 1, 0, 0, 3, 0}));

  const MotionFile file = read(gltf);
  EXPECT_EQ(file.motion.clip.frames(), 11);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_EQ(file.warnings[0].text(), "small.glb: take walk is read; there are also smile, jump");
  for (const char* jump : {"jump", "3"}) {
    const MotionFile other = read(gltf, {.sample_rate_hz = 10, .take = jump});
    EXPECT_TRUE(other.warnings.empty());
    expect_place(other.motion, "hips", other.motion.clip.frames() - 1, {0, 300, 0});
  }
  const auto message = [&](const char* take) -> std::string {
    try {
      read(gltf, {.take = take});
    } catch (const InputError& error) {
      return error.what();
    }
    return "reads";
  };
  EXPECT_EQ(message("run"), "small.glb: has no take run: there are smile, walk, jump");
  EXPECT_EQ(message("4"), "small.glb: has no take 4: there are smile, walk, jump");
  EXPECT_EQ(message("smile"), "small.glb: moves neither nodes nor morph weights that can be read");
}

/// A face of three shapes on the ankle. Its mesh has no points, and nothing reads them.
SmallGltf with_face() {
  SmallGltf gltf = test::bending_knee();
  gltf.json["nodes"][2]["children"] = {3};
  gltf.json["nodes"].push_back({{"name", "Face"}, {"mesh", 0}});
  gltf.json["meshes"] =
      Json::array({{{"primitives",
                     {{{"attributes", Json::object()},
                       {"targets", {Json::object(), Json::object(), Json::object()}}}}},
                    {"extras", {{"targetNames", {"smile", "frown"}}}}}});
  return gltf;
}

const ScalarTrack& track_named(const MotionFile& file, const std::string& name) {
  const auto found = std::find_if(file.tracks.begin(), file.tracks.end(),
                                  [&](const ScalarTrack& track) { return label(track) == name; });
  if (found == file.tracks.end()) throw std::runtime_error("there is no track " + name);
  return *found;
}

TEST(GltfReader, PassesOverATakeThatStandsStill) {
  SmallGltf gltf = test::bending_knee();
  const std::size_t times = gltf.add<float>("SCALAR", {0, 1});
  const std::size_t rest = gltf.add<float>("VEC4", {0, 0, 0, 1, 0, 0, 0, 1});
  gltf.begin_animation("still");
  gltf.move(1, "rotation", times, rest);
  std::swap(gltf.json["animations"][0], gltf.json["animations"][1]);
  const MotionFile file = read(gltf);
  EXPECT_EQ(file.takes.read, 1u);
  EXPECT_EQ(file.takes.keys, (std::vector<std::string>{"still", "walk"}));
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_EQ(file.warnings[0].message, "take walk is read; there are also still");
  expect_place(file.motion, "ankle", 10, ankle_at(kRight));
  // If nothing moves, the first animation is refused as before.
  gltf.json["animations"][1] = gltf.json["animations"][0];
  EXPECT_EQ(refusal(gltf), "small.glb: no joint moves or is turned");
}

TEST(GltfReader, FollowsPointersToNodesAndSaysWhichOthersItLeavesOut) {
  SmallGltf gltf = test::bending_knee();
  const Motion named = read(gltf).motion;
  const auto point_to = [&](const std::string& pointer) {
    gltf.json["animations"][0]["channels"][0]["target"] = {
        {"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
  };
  point_to("/nodes/1/rotation");
  EXPECT_EQ(read(gltf).motion.clip.channels, named.clip.channels);
  gltf.move(0, "rotation", 0, 1);
  for (const char* other : {"/materials/0/emissiveFactor", "/nodes/1/extensions/visible",
                            "/nodes/x/rotation", "nodes/1/rotation"}) {
    point_to(other);
    const MotionFile file = read(gltf);
    ASSERT_EQ(file.warnings.size(), 1u) << other;
    EXPECT_EQ(file.warnings[0].message, "1 channel of the animation left out, which moves no node");
  }
  point_to("/nodes/9/rotation");
  EXPECT_EQ(refusal(gltf), "small.glb: has an animation of node 9, which it has not");
}

TEST(GltfReader, ReadsMorphWeightsByTheirInterpolation) {
  SmallGltf gltf = with_face();
  const std::size_t input = gltf.add<float>("SCALAR", {0, 1});
  gltf.move(3, "weights", input, gltf.add<float>("SCALAR", {0, 0.5F, 1, 1, 0.5F, 0}));
  const MotionFile linear = read(gltf);
  ASSERT_EQ(linear.tracks.size(), 3u);
  for (int t = 0; t < 11; ++t) {
    const auto frame = static_cast<std::size_t>(t);
    EXPECT_NEAR(track_named(linear, "Face.smile").values[frame], 0.1 * t, 1e-6);
    EXPECT_NEAR(track_named(linear, "Face.frown").values[frame], 0.5, 1e-6);
    EXPECT_NEAR(track_named(linear, "Face.target_2").values[frame], 1 - 0.1 * t, 1e-6);
  }
  EXPECT_FALSE(linear.tracks[0].steps);
  EXPECT_EQ(linear.tracks[0].kind, TrackKind::MorphWeight);

  gltf.json["animations"][0]["samplers"].back()["interpolation"] = "STEP";
  const MotionFile steps = read(gltf);
  EXPECT_TRUE(steps.tracks[0].steps);
  EXPECT_EQ(steps.tracks[0].values[9], 0);
  EXPECT_EQ(steps.tracks[0].values[10], 1);

  // Each key has in-tangents, values, out-tangents of all shapes.
  gltf.json["animations"][0]["samplers"].back()["interpolation"] = "CUBICSPLINE";
  gltf.json["animations"][0]["samplers"].back()["output"] =
      gltf.add<float>("SCALAR", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0});
  const MotionFile cubic = read(gltf);
  EXPECT_NEAR(cubic.tracks[0].values[5], 0.5, 1e-6);
  EXPECT_NEAR(cubic.tracks[0].values[2], 3 * 0.04 - 2 * 0.008, 1e-6);
}

TEST(GltfReader, LeavesOutMorphWeightsThatAreWrongAndSaysSo) {
  SmallGltf gltf = with_face();
  const std::size_t input = gltf.add<float>("SCALAR", {0, 1});
  SmallGltf odd = gltf;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  odd.move(3, "weights", input, odd.add<float>("SCALAR", {0, 0.5F, 1, 1, nan, 0}));
  SmallGltf few = gltf;
  few.move(3, "weights", input, few.add<float>("SCALAR", {0, 1}));
  SmallGltf meshless = gltf;
  meshless.move(2, "weights", input, meshless.add<float>("SCALAR", {0, 1}));
  for (const SmallGltf& wrong : {odd, few, meshless}) {
    const MotionFile without = read(wrong);
    EXPECT_TRUE(without.tracks.empty());
    EXPECT_EQ(without.motion.clip.frames(), 11);
    ASSERT_EQ(without.warnings.size(), 1u);
    EXPECT_NE(without.warnings[0].text().find("morph weights are not read"), std::string::npos);
  }
}

TEST(GltfReader, LeavesOutNodesThatOnlyDraw) {
  SmallGltf gltf = test::bending_knee();
  gltf.json["nodes"][2]["children"] = Json::array({3, 4});
  gltf.json["nodes"].push_back({{"name", "boot"}, {"mesh", 0}, {"translation", {0, 0, 1}}});
  gltf.json["nodes"].push_back({{"name", "toe"}, {"translation", {0, 0, 0.2}}});
  const Motion motion = read(gltf).motion;
  EXPECT_EQ(motion.skeleton.joint_count(), 3);
  ASSERT_TRUE(motion.skeleton.joint(2).end_site.has_value());
  EXPECT_LT((*motion.skeleton.joint(2).end_site - Vector3d(0, 0, 20)).norm(), kPlace);
}

TEST(GltfReader, SaysInOneSentenceWhatItCannotRead) {
  const SmallGltf good = test::bending_knee();
  const auto with = [&](const auto& change) {
    SmallGltf gltf = good;
    change(gltf.json);
    return refusal(gltf);
  };
  using Json = Json;
  EXPECT_EQ(refusal(std::string()), "small.glb:1:1: is not JSON from here on");
  EXPECT_EQ(refusal(std::string("{\n  \"asset\": }")), "small.glb:2:12: is not JSON from here on");
  EXPECT_EQ(refusal(std::string("[]")), "small.glb: is no glTF: its JSON is not an object");
  EXPECT_EQ(refusal(std::string("{}")), "small.glb: is no glTF 2.0: it states no version");
  EXPECT_EQ(with([](Json& j) { j["asset"]["version"] = "1.0"; }),
            "small.glb: is no glTF 2.0: its version is 1.0");
  EXPECT_EQ(with([](Json& j) { j["animations"].clear(); }),
            "small.glb: holds no animation, but may be put on a clip as its character");
  EXPECT_EQ(with([](Json& j) { j["nodes"] = 3; }), "small.glb: \"nodes\" is not a list of objects");
  EXPECT_EQ(with([](Json& j) { j["nodes"][2]["children"] = {0}; }),
            "small.glb: has a node that is below itself");
  EXPECT_EQ(with([](Json& j) {
              j["nodes"][0]["children"] = {1, 2};
            }),
            "small.glb: has node 2 below two nodes, or twice below one");
  EXPECT_EQ(with([](Json& j) {
              j["nodes"][0]["children"] = {1, 7};
            }),
            "small.glb: \"children\" names what is none of its 3 nodes");
  EXPECT_EQ(with([](Json& j) {
              j["nodes"][0]["translation"] = {1, 2};
            }),
            "small.glb: \"translation\" is not 3 numbers up to 1e9");
  EXPECT_EQ(with([](Json& j) {
              j["nodes"][0]["rotation"] = {0, 0, 0, 0};
            }),
            "small.glb: has a rotation of length 0");
  EXPECT_EQ(with([](Json& j) { j["animations"][0]["channels"][0]["target"]["node"] = 9; }),
            "small.glb: \"node\" names number 9 of only 3 nodes");
  EXPECT_EQ(with([](Json& j) { j["animations"][0]["samplers"][0].erase("output"); }),
            "small.glb: lacks a \"output\" that should name one of its accessors");
  EXPECT_EQ(with([](Json& j) { j["animations"][0]["samplers"][0]["interpolation"] = "SOFT"; }),
            "small.glb: has an unknown interpolation, \"SOFT\"");
  const std::string passage(5000, 'x');
  const std::string shown = std::string(37, 'x') + "...";
  EXPECT_EQ(with([&](Json& j) { j["animations"][0]["samplers"][0]["interpolation"] = passage; }),
            "small.glb: has an unknown interpolation, \"" + shown + '"');
  EXPECT_EQ(with([&](Json& j) { j["asset"]["version"] = passage; }),
            "small.glb: is no glTF 2.0: its version is " + shown);
  EXPECT_EQ(with([](Json& j) { j["accessors"][1]["count"] = 10; }),
            "small.glb: has an animation with 11 key times, but 10 values");
  EXPECT_EQ(with([](Json& j) { j["accessors"][1]["count"] = 12; }),
            "small.glb: has an accessor that reaches beyond bufferView 1");
  EXPECT_EQ(with([](Json& j) { j["accessors"][1]["count"] = 1e15; }),
            "small.glb: holds too many numbers to read");
  EXPECT_EQ(with([](Json& j) { j["meshes"] = 5; }),
            "small.glb: \"meshes\" is not a list of objects");
  EXPECT_EQ(with([](Json& j) {
              j["accessors"][1].erase("bufferView");
              j["accessors"][1]["count"] = 2'500'001;
            }),
            "small.glb: states more zeros that have no bytes than are read");
  EXPECT_EQ(with([](Json& j) { j["accessors"][1]["componentType"] = 5130; }),
            "small.glb: has an accessor of an unknown componentType");
  EXPECT_EQ(with([](Json& j) { j["accessors"][1]["type"] = "VEC3"; }),
            "small.glb: accessor 1 is not VEC4");
  EXPECT_EQ(with([](Json& j) { j["bufferViews"][1]["byteLength"] = 1e15; }),
            "small.glb: bufferView 1 reaches beyond its buffer");
  EXPECT_EQ(with([](Json& j) { j["buffers"][0]["byteLength"] = 1000000; }),
            "small.glb: buffer 0 has 220 of the 1000000 bytes it states");
  EXPECT_EQ(with([](Json& j) { j["buffers"][0]["uri"] = "data:,abc"; }),
            "small.glb: has a data URI without base64");
  EXPECT_EQ(with([](Json& j) { j["buffers"][0]["uri"] = "data:;base64,ab%c"; }),
            "small.glb: has a data URI that is not base64");
}

TEST(GltfReader, RefusesNumbersThatAreNotFinite) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity(), 2e9F}) {
    SmallGltf gltf = test::bending_knee();
    std::memcpy(gltf.data.data() + 60, &bad, sizeof(bad));
    EXPECT_EQ(refusal(gltf),
              "small.glb: accessor 1 holds a number that is not finite or beyond 1e9");
  }
}

TEST(GltfReader, RefusesTimesThatGoBackOrLastForever) {
  SmallGltf gltf = test::bending_knee();
  const auto with_last_time = [&](float time) {
    std::memcpy(gltf.data.data() + 40, &time, sizeof(time));
    return refusal(gltf);
  };
  EXPECT_EQ(with_last_time(0.5), "small.glb: has an animation whose key times go back");
  EXPECT_EQ(with_last_time(1e9), "small.glb: needs more than 4194304 frames");
  EXPECT_EQ(with_last_time(30000),
            "small.glb: asks for 900001 frames of 3 nodes, too many for a file of so few bytes");
}

TEST(GltfReader, RefusesJsonThatNestsTooDeep) {
  EXPECT_EQ(refusal(std::string(1'000'000, '[')), "small.glb: nests its JSON more than 64 deep");
}

TEST(GltfReader, RefusesEveryTruncation) {
  const std::string whole = test::bending_knee().glb();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    // A copy in memory of its own, so that the sanitizer sees its end.
    const std::string part(whole.data(), size);
    EXPECT_NE(refusal(part), "reads") << size;
  }
  EXPECT_EQ(refusal(whole), "reads");
}

TEST(GltfReader, ReadsOrSaysWhatIsWrongWhateverTheBytes) {
  const std::string whole = test::bending_knee().glb();
  Random random(7);
  for (int round = 0; round < 1000; ++round) {
    std::string bytes = whole;
    for (auto edits = 1 + random.below(4); edits > 0; --edits) {
      const auto at = static_cast<std::size_t>(random.below(bytes.size()));
      bytes[at] =
          static_cast<char>(random.below(2) == 0 ? '0' + random.below(75) : random.below(256));
    }
    const std::string message = refusal(bytes);
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

class GltfFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("mocapress-gltf-" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "below");
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// The message for a file whose buffer is at `uri`.
  std::string refusal_with(const std::string& uri) {
    SmallGltf gltf = test::bending_knee();
    gltf.json["buffers"][0]["uri"] = uri;
    const std::string message = refusal(gltf.json.dump(), (folder_ / "a.gltf").string());
    return message == "reads" ? message : message.substr((folder_ / "a.gltf: ").string().size());
  }

  fs::path folder_;
};

TEST_F(GltfFolder, IsWhereBuffersAreReadFromAndNowhereElse) {
  const std::string data = test::bending_knee().data;
  write_text(folder_ / "keys of a.bin", data + "padding");
  write_text(folder_ / "below/keys.bin", data);
  write_text(folder_.parent_path() / "outside.bin", data);
  EXPECT_EQ(refusal_with("keys%20of%20a.bin"), "reads");
  EXPECT_EQ(refusal_with("below/keys.bin"), "reads");
  EXPECT_EQ(refusal_with("gone.bin"), "refers to \"gone.bin\", which is not there");
  const auto elsewhere = [](const std::string& uri) {
    return "refers to \"" + uri + "\", but only files in its own folder are read";
  };
  std::vector<std::string> uris = {"../outside.bin",      "below/../../outside.bin",
                                   "%2E%2E/outside.bin",  (folder_ / "below/keys.bin").string(),
                                   "file:below/keys.bin", "https://example.org/keys.bin",
                                   "below/keys.bin%00",   "below"};
#ifndef _WIN32  // where the standard library makes no links
  fs::create_symlink("../outside.bin", folder_ / "link.bin");
  uris.push_back("link.bin");
#endif
  for (const std::string& uri : uris) EXPECT_EQ(refusal_with(uri), elsewhere(uri)) << uri;
  fs::remove(folder_.parent_path() / "outside.bin");
}

TEST(GltfCorpus, ReadsAsItShould) {
  const auto folder = test::corpus();
  if (!folder || !fs::exists(*folder / "gltf"))
    GTEST_SKIP() << "the corpus of real motions is not here";
  const MotionFile skin = read_motion(*folder / "gltf/simple_skin.gltf");
  EXPECT_EQ(skin.motion.skeleton.joint_count(), 2);
  // Twelve keys half a second apart; the second joint swings by a right angle to both sides.
  EXPECT_EQ(skin.motion.clip.seconds() - 1 / skin.motion.clip.sample_rate_hz, 5.5);
  expect_place(skin.motion, "node_2", 0, {0, 100, 0});
  // A cube with two shapes that stands still: a joint and its weights.
  const MotionFile cube = read_motion(*folder / "gltf/AnimatedMorphCube.gltf");
  EXPECT_EQ(cube.motion.skeleton.joint_count(), 1);
  EXPECT_TRUE(cube.motion.clip.channels.rowwise().norm().isConstant(
      cube.motion.clip.channels.row(0).norm(), 1e-9));
  ASSERT_EQ(cube.warnings.size(), 1u);
  EXPECT_EQ(cube.warnings[0].message,
            "the mesh reaches much further than the bones at 1 joint, first AnimatedMorphCube "
            "(129 cm, not 3): the surface there is the mesh");
  ASSERT_EQ(cube.tracks.size(), 2u);
  EXPECT_EQ(label(cube.tracks[0]), "AnimatedMorphCube.target_0");
  for (const ScalarTrack& track : cube.tracks)
    EXPECT_EQ(std::ssize(track.values), cube.motion.clip.frames());
}

}  // namespace
}  // namespace mocapress::gltf_reader_test
