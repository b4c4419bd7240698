// SPDX-License-Identifier: MIT
#include "core/formats/gltf_writer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>

#include "core/base/file.h"
#include "core/formats/gltf_reader.h"
#include "core/motion/forward_kinematics.h"
#include "tests/support/corpus.h"
#include "tests/support/same_motion.h"
#include "tests/support/small_gltf.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using test::SmallGltf;

constexpr double kMove = 1e-4;  // cm

/// The largest movement (cm) that writing and reading causes.
double round_trip(const Motion& motion, GltfContainer container, const SourceFormat& source = {}) {
  const std::string bytes = gltf_bytes(motion, container, source);
  const MotionFile again = read_gltf("again.glb", bytes);
  EXPECT_TRUE(again.warnings.empty()) << again.warnings.front().text();
  EXPECT_EQ(again.motion.clip.frames(), motion.clip.frames());
  EXPECT_NEAR(again.motion.clip.sample_rate_hz, motion.clip.sample_rate_hz,
              1e-6 * motion.clip.sample_rate_hz);
  EXPECT_EQ(again.motion.skeleton.joint_count(), motion.skeleton.joint_count());
  return test::largest_move(motion, again.motion, without_namespace(gltf_names(motion.skeleton)));
}

Json json_of_file(const std::string& bytes) {
  return GltfFile("written.glb", bytes).json();
}

TEST(GltfWriter, GivesBackWhatItWrote) {
  const Motion motion = test::smooth_motion(40);
  EXPECT_LT(round_trip(motion, GltfContainer::Glb), kMove);
  EXPECT_LT(round_trip(motion, GltfContainer::Gltf), kMove);
}

TEST(GltfWriter, GivesBackEverySample) {
  for (const char* sample : {"human_walk.amc", "human_run.amc", "human_jump.amc"}) {
    const MotionFile file =
        read_motion(fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples" / sample);
    EXPECT_LT(round_trip(file.motion, GltfContainer::Glb, file.source), kMove) << sample;
  }
}

TEST(GltfWriter, GivesBackRealClips) {
  const auto folder = test::corpus();
  if (!folder) GTEST_SKIP() << "the corpus of real motions is not here";
  for (const char* clip : {"study/09_01.amc", "study/49_02.amc", "bvh/cmu_12_01_walk.bvh",
                           "bvh/iclone_006_05_60hz_100joints.bvh", "bvh/131_01.bvh"}) {
    const MotionFile file = read_motion(*folder / clip);
    EXPECT_LT(round_trip(file.motion, GltfContainer::Glb, file.source), kMove) << clip;
  }
}

TEST(GltfWriter, GivesBackWhatWasAGltf) {
  const MotionFile knee = read_gltf("knee.glb", test::bending_knee().glb());
  EXPECT_LT(round_trip(knee.motion, GltfContainer::Gltf, knee.source), kMove);
}

TEST(GltfWriter, TurnsFromFrameToFrameByTheShortWay) {
  // Three turns about x; the quaternions q and -q stand for the same rotation.
  Motion motion;
  motion.skeleton.add({.name = "wheel", .channels = {ChannelKind::RotationX}});
  motion.clip = {30, Eigen::VectorXd::LinSpaced(91, 0, 6 * 3.14159265358979)};
  GltfFile file("wheel.glb", gltf_bytes(motion, GltfContainer::Glb));
  const Json& animation = file.list("animations")[0];
  const auto output = animation["samplers"][0]["output"].get<std::size_t>();
  const std::vector<double> turns = file.values(output, "VEC4");
  for (std::size_t i = 4; i < turns.size(); i += 4)
    EXPECT_GT(turns[i] * turns[i - 4] + turns[i + 3] * turns[i - 1], 0.9);
}

TEST(GltfWriter, WritesTracksOnlyOfWhatMoves) {
  Motion motion = read_gltf("knee.glb", test::bending_knee().glb()).motion;
  const Json json = json_of_file(gltf_bytes(motion, GltfContainer::Glb));
  ASSERT_EQ(json["animations"][0]["channels"].size(), 1u);
  EXPECT_EQ(json["animations"][0]["channels"][0]["target"]["path"], "rotation");
  EXPECT_EQ(json["nodes"][1]["name"], "knee");
  EXPECT_EQ(json["animations"][0]["channels"][0]["target"]["node"], 1);
  EXPECT_EQ(json["skins"][0]["joints"], Json::parse("[0, 1, 2]"));
}

TEST(GltfWriter, KeepsTheFramesOfWhatStandsStill) {
  Motion motion = test::smooth_motion(12);
  motion.clip.channels.rowwise() = motion.clip.channels.row(5).eval();
  EXPECT_LT(round_trip(motion, GltfContainer::Glb), kMove);
}

TEST(GltfWriter, PutsANodeAboveTwoRoots) {
  Motion motion = test::smooth_motion(12);
  motion.skeleton.add({.name = "prop", .offset = {30, 5, 0}});
  const Json json = json_of_file(gltf_bytes(motion, GltfContainer::Glb));
  EXPECT_EQ(json["scenes"][0]["nodes"].size(), 1u);
  EXPECT_LT(round_trip(motion, GltfContainer::Glb), kMove);
}

TEST(GltfWriter, GivesEachJointANameOfItsOwnInUtf8) {
  Skeleton skeleton;
  for (const char* name : {"arm", "arm", "",
                           "le\xff"
                           "g",
                           "\u8155"})
    skeleton.add({.name = name});
  EXPECT_EQ(gltf_names(skeleton),
            (std::vector<std::string>{"arm", "arm_2", "joint", "le\uFFFDg", "\u8155"}));
}

TEST(GltfWriter, StandsAtRestWhereItsChannelsAreZeroOrAsASourceWithoutThatBegins) {
  Motion motion;
  motion.skeleton.add({.name = "bone", .channels = {ChannelKind::RotationX}});
  motion.clip = {30, Eigen::VectorXd::LinSpaced(5, 1, 2)};
  const auto rest = [&](SourceFormat::Kind kind) {
    return json_of_file(gltf_bytes(motion, GltfContainer::Glb, {kind}))["nodes"][0];
  };
  EXPECT_FALSE(rest(SourceFormat::Kind::Bvh).contains("rotation"));
  EXPECT_NEAR(rest(SourceFormat::Kind::Fbx)["rotation"][0].get<double>(), std::sin(0.5), 1e-12);
}

class GltfOnto : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("mocapress-gltf-onto-" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "elsewhere");
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// A file with everything that a writer must leave alone, and all kinds of nodes above a joint.
  static SmallGltf elaborate() {
    SmallGltf gltf = test::bending_knee();
    // The animation also scales the hips, moves a lamp and smiles.
    const std::size_t input = gltf.add<float>("SCALAR", {0, 1});
    gltf.move(0, "scale", input, gltf.add<float>("VEC3", {2, 2, 2, 2, 2, 2}));
    gltf.move(4, "translation", input, gltf.add<float>("VEC3", {0, 0, 0, 1, 2, 3}));
    gltf.move(5, "weights", input, gltf.add<float>("SCALAR", {0, 1}));
    gltf.begin_animation("wave");
    gltf.move(1, "rotation", input, gltf.add<float>("VEC4", {0, 0, 0, 1, 1, 0, 0, 0}));
    gltf.json["nodes"].push_back({{"name", "armature"},
                                  {"matrix", {0, 0, -3, 0, 0, 3, 0, 0, 3, 0, 0, 0, 1, 2, 3, 1}},
                                  {"children", {0}}});
    gltf.json["nodes"].push_back(
        {{"name", "lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    gltf.json["nodes"].push_back({{"name", "face"}, {"mesh", 0}, {"extras", {{"mood", 1.25}}}});
    gltf.json["nodes"][2]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.4, 0, 1};
    gltf.json["nodes"][2].erase("translation");
    gltf.json["scenes"][0]["nodes"] = {3, 4, 5};
    gltf.json["extras"] = {{"artist", "somebody"}, {"deep", {1, 2, {{"a", nullptr}}}}};
    gltf.json["images"].push_back({{"uri", "skin.png"}});
    return gltf;
  }

  std::string write_source(const SmallGltf& gltf) {
    write_text(folder_ / "skin.png", "\x89PNG and so on");
    write_text(folder_ / "source.glb", gltf.glb());
    return (folder_ / "source.glb").string();
  }

  fs::path folder_;
};

TEST_F(GltfOnto, MovesTheNodesOfTheSourceAsTheJointsOfTheMotionMove) {
  const std::string source = write_source(elaborate());
  MotionFile file = read_motion(source);
  // Replaces the motion by another.
  for (int c = 0; c < file.motion.skeleton.channel_count(); ++c)
    for (int t = 0; t < file.motion.clip.frames(); ++t)
      file.motion.clip.channels(t, c) += 0.3 * std::sin(0.5 * t + c);
  for (const GltfContainer container : {GltfContainer::Glb, GltfContainer::Gltf}) {
    const std::string written =
        gltf_bytes_onto(source, file.motion, container, folder_, file.source);
    const MotionFile again = read_gltf((folder_ / "again").string(), written);
    std::vector<std::string> names;
    for (const Joint& joint : file.motion.skeleton.joints()) names.push_back(joint.name);
    EXPECT_LT(test::largest_move(file.motion, again.motion, names), kMove);
    EXPECT_EQ(again.motion.clip.sample_rate_hz, 10);
  }
}

TEST_F(GltfOnto, BeginsAtTheTimeOfTheFirstKey) {
  SmallGltf gltf = test::bending_knee();
  for (std::size_t key = 0; key <= 10; ++key) {
    const auto time = 0.4F + static_cast<float>(key) / 10;
    std::memcpy(gltf.data.data() + 4 * key, &time, sizeof(time));
  }
  const std::string source = write_source(gltf);
  const MotionFile file = read_motion(source);
  GltfFile result("result.glb",
                  gltf_bytes_onto(source, file.motion, GltfContainer::Glb, folder_, file.source));
  const Json& sampler = result.json()["animations"][0]["samplers"][0];
  const std::vector<double> times = result.values(sampler["input"], "SCALAR");
  ASSERT_EQ(times.size(), 11u);
  EXPECT_NEAR(times.front(), 0.4, 1e-6);
  EXPECT_NEAR(times.back(), 1.4, 1e-6);
}

TEST_F(GltfOnto, ReplacesChannelsThatPointToTheirNode) {
  SmallGltf gltf = test::bending_knee();
  gltf.json["animations"][0]["channels"][0]["target"] = {
      {"path", "pointer"},
      {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/1/rotation"}}}}}};
  const std::string source = write_source(gltf);
  const MotionFile file = read_motion(source);
  const GltfFile result(
      "result.glb", gltf_bytes_onto(source, file.motion, GltfContainer::Glb, folder_, file.source));
  const Json& channels = result.json()["animations"][0]["channels"];
  ASSERT_EQ(channels.size(), 1u);
  EXPECT_EQ(channels[0]["target"], Json({{"node", 1}, {"path", "rotation"}}));
}

TEST_F(GltfOnto, LeavesEverythingElseAsItWas) {
  const SmallGltf gltf = elaborate();
  const std::string source = write_source(gltf);
  const MotionFile file = read_motion(source);
  const std::string written =
      gltf_bytes_onto(source, file.motion, GltfContainer::Glb, folder_, file.source);
  GltfFile result("result.glb", written);
  const Json& json = result.json();
  for (const char* same : {"asset", "scene", "scenes", "skins", "images", "extras"})
    EXPECT_EQ(json[same], gltf.json[same]) << same;
  EXPECT_EQ(json["animations"][1], gltf.json["animations"][1]);
  for (const std::size_t node : {0, 1, 3, 4, 5})
    EXPECT_EQ(json["nodes"][node], gltf.json["nodes"][node]);
  for (std::size_t a = 0; a < gltf.json["accessors"].size(); ++a)
    EXPECT_EQ(json["accessors"][a], gltf.json["accessors"][a]);
  EXPECT_EQ(result.buffer(0).substr(0, gltf.data.size()), gltf.data);
  // The lamp and the smile are unchanged.
  std::vector<std::string> kept;
  for (const Json& channel : json["animations"][0]["channels"])
    if (channel["target"]["node"] > 3) {
      kept.push_back(channel["target"]["path"]);
      const auto& sampler =
          json["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()];
      EXPECT_LT(sampler["output"].get<std::size_t>(), gltf.json["accessors"].size());
    }
  EXPECT_EQ(kept, (std::vector<std::string>{"translation", "weights"}));
}

TEST_F(GltfOnto, WritesMorphWeightsAndScalesOfTheTracks) {
  SmallGltf gltf = elaborate();
  gltf.json["meshes"] = Json::array(
      {{{"primitives", {{{"attributes", Json::object()}, {"targets", {Json::object()}}}}},
        {"extras", {{"targetNames", {"smile"}}}}}});
  const std::size_t input = gltf.add<float>("SCALAR", {0, 1});
  gltf.json["animations"][0]["samplers"].push_back(
      {{"input", input},
       {"output", gltf.add<float>("VEC3", {1, 1, 1, 2, 1, 0.5F})},
       {"interpolation", "LINEAR"}});
  gltf.json["animations"][0]["channels"].push_back(
      {{"sampler", gltf.json["animations"][0]["samplers"].size() - 1},
       {"target", {{"node", 1}, {"path", "scale"}}}});
  const std::string source = write_source(gltf);
  MotionFile file = read_motion(source);
  ASSERT_EQ(file.tracks.size(), 4u);  // a weight, three scales of the knee
  for (ScalarTrack& track : file.tracks)
    for (float& value : track.values) value = 0.5F * value + 0.25F;
  const std::string written = gltf_bytes_onto(source, file.motion, GltfContainer::Glb, folder_,
                                              file.source, {}, file.tracks);
  const MotionFile again = read_gltf((folder_ / "again").string(), written);
  ASSERT_EQ(again.tracks.size(), file.tracks.size());
  for (std::size_t t = 0; t < file.tracks.size(); ++t) {
    EXPECT_EQ(label(again.tracks[t]), label(file.tracks[t]));
    for (std::size_t f = 0; f < file.tracks[t].values.size(); ++f)
      EXPECT_NEAR(again.tracks[t].values[f], file.tracks[t].values[f], 1e-6);
  }
  std::vector<std::string> names;
  for (const Joint& joint : file.motion.skeleton.joints()) names.push_back(joint.name);
  EXPECT_LT(test::largest_move(file.motion, again.motion, names), 10 * kMove);
}

TEST(GltfWriter, GivesBackScalesWithoutMovingJoints) {
  const Motion motion = test::smooth_motion(40);
  const std::string joint = motion.skeleton.joint(2).name;
  ScalarTracks tracks;
  for (int axis = 0; axis < 3; ++axis) {
    tracks.push_back({.kind = scale_along(axis), .node = joint, .values = {}});
    for (int t = 0; t < 40; ++t)
      tracks.back().values.push_back(1 + 0.01F * static_cast<float>(t * (axis + 1)));
  }
  const MotionFile again =
      read_gltf("again.glb", gltf_bytes(motion, GltfContainer::Glb, {}, {}, tracks));
  EXPECT_LT(
      test::largest_move(motion, again.motion, without_namespace(gltf_names(motion.skeleton))),
      10 * kMove);
  ASSERT_EQ(again.tracks.size(), 3u);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t t = 0; t < 40; ++t)
      EXPECT_NEAR(again.tracks[axis].values[t], tracks[axis].values[t], 1e-5);
}

TEST_F(GltfOnto, TakesFilesAlongToAnotherFolder) {
  const std::string source = write_source(elaborate());
  const MotionFile file = read_motion(source);
  const Json json = json_of_file(gltf_bytes_onto(source, file.motion, GltfContainer::Gltf,
                                                 folder_ / "elsewhere", file.source));
  EXPECT_EQ(json["images"][0]["uri"], "data:image/png;base64,iVBORyBhbmQgc28gb24=");
}

TEST_F(GltfOnto, MakesOneChunkOfAllBuffersAndImagesOfAGltf) {
  SmallGltf gltf = test::bending_knee();
  gltf.json["buffers"].push_back({{"uri", "keys.bin"}, {"byteLength", gltf.data.size()}});
  gltf.json["buffers"][0] = {{"uri", "data:;base64,AAEC"}, {"byteLength", 3}, {"name", "first"}};
  for (Json& view : gltf.json["bufferViews"]) view["buffer"] = 1;
  gltf.json["images"].push_back({{"uri", "data:image/png;base64,iVBORw=="}});
  write_text(folder_ / "keys.bin", gltf.data);
  write_text(folder_ / "source.gltf", gltf.json.dump());
  const MotionFile file = read_motion(folder_ / "source.gltf");
  const std::string glb = gltf_bytes_onto(folder_ / "source.gltf", file.motion, GltfContainer::Glb,
                                          folder_, file.source);
  const Json json = json_of_file(glb);
  ASSERT_EQ(json["buffers"].size(), 1u);
  EXPECT_EQ(json["buffers"][0]["name"], "first");
  EXPECT_FALSE(json["buffers"][0].contains("uri"));
  EXPECT_FALSE(json["images"][0].contains("uri"));
  EXPECT_EQ(json["images"][0]["mimeType"], "image/png");
  const MotionFile again = read_gltf("again.glb", glb);
  EXPECT_LT(test::largest_move(file.motion, again.motion, {"hips", "knee", "ankle"}), kMove);
  GltfFile parts("again.glb", glb);
  const auto old_times = gltf.json["animations"][0]["samplers"][0]["input"].get<std::size_t>();
  EXPECT_EQ(parts.values(old_times, "SCALAR").size(), 11u);
}

TEST_F(GltfOnto, RefusesASourceWithoutAJointOfTheMotion) {
  const std::string source = write_source(elaborate());
  try {
    gltf_bytes_onto(source, test::smooth_motion(5), GltfContainer::Glb, folder_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), source + ": has no joint " + test::small_skeleton().joint(0).name +
                                ", which the motion has");
  }
}

TEST_F(GltfOnto, PutsARealCharacterBackToWhereItWas) {
  const auto corpus = test::corpus();
  if (!corpus) GTEST_SKIP() << "the corpus of real motions is not here";
  const fs::path source = *corpus / "gltf/simple_skin.gltf";
  const MotionFile file = read_motion(source);
  for (const GltfContainer container : {GltfContainer::Glb, GltfContainer::Gltf}) {
    const MotionFile again =
        read_gltf("again", gltf_bytes_onto(source, file.motion, container, folder_, file.source));
    EXPECT_LT(test::largest_move(file.motion, again.motion, {"node_1", "node_2"}), kMove);
  }
}

}  // namespace
}  // namespace mocapress
