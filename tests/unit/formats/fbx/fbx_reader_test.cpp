// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "core/base/file.h"
#include "core/formats/fbx/fbx_reader.h"
#include "core/formats/fbx/fbx_scene.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"
#include "tests/support/corpus.h"

namespace mocapress::fbx_reader_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr long long kTicks = 46186158000;  // a second of FBX

/// A take whose knee turns about x from 0 to `degrees`, with keys at these frames of 30 Hz.
struct Take {
  std::string name = "First";
  double degrees = 90;
  std::vector<int> frames = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
};

std::string property(const std::string& name, const std::string& type, const std::string& values) {
  return "P: \"" + name + "\", \"" + type + "\", \"\", \"\"," + values + "\n";
}

std::string model(int id, const std::string& name, const std::string& properties) {
  return "Model: " + std::to_string(id) + ", \"Model::" + name +
         "\", \"LimbNode\" {\nVersion: 232\nProperties70: {\n" + properties + "}\n}\n";
}

std::string list(const std::string& name, const std::vector<std::string>& values) {
  std::string text = name + ": *" + std::to_string(values.size()) + " {\na: ";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? "," : "") + values[i];
  return text + "\n}\n";
}

std::string curve(int id, const Take& take) {
  std::vector<std::string> times;
  std::vector<std::string> values;
  for (const int frame : take.frames) {
    times.push_back(std::to_string(frame * kTicks / 30));
    values.push_back(std::to_string(take.degrees * frame / take.frames.back()));
  }
  return "AnimationCurve: " + std::to_string(id) +
         ", \"AnimCurve::\", \"\" {\nDefault: 0\nKeyVer: 4008\n" + list("KeyTime", times) +
         list("KeyValueFloat", values) + list("KeyAttrFlags", {"260"}) +
         list("KeyAttrDataFloat", {"0", "0", "0", "0"}) +
         list("KeyAttrRefCount", {std::to_string(values.size())}) + "}\n";
}

/// An ASCII FBX of hips, a knee 40 cm below whose frame is turned by 90 degrees about z, and a foot
/// 40 cm along its x. `of_knee`: further properties of the knee.
std::string fbx_text(const std::vector<Take>& takes, const std::string& of_knee = "", int up = 1) {
  const auto id = [](std::size_t take, int object) {
    return std::to_string(100 * (static_cast<int>(take) + 1) + object);
  };
  std::string text =
      "; FBX 7.4.0 project file\nFBXHeaderExtension: {\nFBXHeaderVersion: 1003\nFBXVersion: "
      "7400\n}\nGlobalSettings: {\nVersion: 1000\nProperties70: {\n" +
      property("UpAxis", "int", std::to_string(up)) + property("UnitScaleFactor", "double", "2") +
      property("TimeMode", "enum", "6") + "}\n}\nObjects: {\n" +
      model(1, "rig:Hips", property("Lcl Translation", "Lcl Translation", "0,90,0")) +
      model(2, "rig:Knee",
            property("Lcl Translation", "Lcl Translation", "0,-40,0") +
                property("RotationActive", "bool", "1") +
                property("PreRotation", "Vector3D", "0,0,90") + of_knee) +
      model(3, "rig:Foot", property("Lcl Translation", "Lcl Translation", "40,0,0"));
  std::string connections = "C: \"OO\",1,0\nC: \"OO\",2,1\nC: \"OO\",3,2\n";
  for (std::size_t t = 0; t < takes.size(); ++t) {
    text += "AnimationStack: " + id(t, 0) + ", \"AnimStack::" + takes[t].name +
            "\", \"\" {\n}\nAnimationLayer: " + id(t, 1) +
            ", \"AnimLayer::Base\", \"\" {\n}\nAnimationCurveNode: " + id(t, 2) +
            ", \"AnimCurveNode::R\", \"\" {\nProperties70: {\n" + property("d|X", "Number", "0") +
            property("d|Y", "Number", "0") + property("d|Z", "Number", "0") + "}\n}\n" +
            curve(std::stoi(id(t, 3)), takes[t]);
    connections += "C: \"OO\"," + id(t, 1) + "," + id(t, 0) + "\nC: \"OO\"," + id(t, 2) + "," +
                   id(t, 1) + "\nC: \"OP\"," + id(t, 2) + ",2, \"Lcl Rotation\"\nC: \"OP\"," +
                   id(t, 3) + "," + id(t, 2) + ", \"d|X\"\n";
  }
  return text + "}\nConnections: {\n" + connections + "}\n";
}

/// The same with a face, whose smile goes from 0 to 50 % in the first take.
std::string with_smile(std::string text) {
  const std::string connections = "}\nConnections: {\n";
  text.insert(
      text.find(connections),
      "Geometry: 20, \"Geometry::Mesh\", \"Mesh\" {\n" +
          list("Vertices", {"0", "0", "0", "1", "0", "0", "0", "1", "0"}) +
          list("PolygonVertexIndex", {"0", "1", "-3"}) +
          "}\nGeometry: 21, \"Geometry::smile\", \"Shape\" {\nVersion: 100\n" +
          list("Indexes", {"0"}) + list("Vertices", {"0", "1", "0"}) +
          list("Normals", {"0", "0", "0"}) +
          "}\nDeformer: 22, \"Deformer::\", \"BlendShape\" {\nVersion: 100\n}\n"
          "Deformer: 23, \"SubDeformer::smile\", \"BlendShapeChannel\" {\nVersion: 100\n"
          "DeformPercent: 0\n" +
          list("FullWeights", {"100"}) +
          "}\nModel: 24, \"Model::Face\", \"Mesh\" {\nVersion: 232\n}\n"
          "AnimationCurveNode: 105, \"AnimCurveNode::DeformPercent\", \"\" {\nProperties70: {\n" +
          property("d|DeformPercent", "Number", "0") + "}\n}\n" + curve(106, {.degrees = 50}));
  text.insert(text.find(connections) + connections.size(),
              "C: \"OO\",20,24\nC: \"OO\",24,0\nC: \"OO\",22,20\nC: \"OO\",23,22\nC: \"OO\",21,23\n"
              "C: \"OO\",105,101\nC: \"OP\",105,23, \"DeformPercent\"\n"
              "C: \"OP\",106,105, \"d|DeformPercent\"\n");
  return text;
}

/// The same with a second layer in the first take, which moves that node by a curve of its own.
std::string with_layer(std::string text, const std::string& node,
                       const std::string& moved = "Lcl Rotation") {
  const std::string connections = "}\nConnections: {\n";
  text.insert(text.find(connections),
              "AnimationLayer: 110, \"AnimLayer::Added\", \"\" {\n}\n"
              "AnimationCurveNode: 111, \"AnimCurveNode::R\", \"\" {\nProperties70: {\n" +
                  property("d|X", "Number", "0") + "}\n}\n" + curve(112, {.degrees = 20}));
  text.insert(text.size() - 2, "C: \"OO\",110,100\nC: \"OO\",111,110\nC: \"OP\",111," + node +
                                   ", \"" + moved + "\"\nC: \"OP\",112,111, \"d|X\"\n");
  return text;
}

std::vector<std::string> texts(const MotionFile& file) {
  std::vector<std::string> texts;
  for (const Warning& warning : file.warnings) texts.push_back(warning.message);
  return texts;
}

std::string error_of(const std::string& bytes, const ReadOptions& options = {}) {
  try {
    read_fbx("f", bytes, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

Eigen::RowVector3d place(const MotionFile& file, const std::string& joint, int frame) {
  const Eigen::MatrixXd tracks = landmark_tracks(file.motion.skeleton, file.motion.clip);
  return tracks.block<1, 3>(frame, 3 * file.motion.skeleton.find(joint));
}

double angle(int frame) {  // in the usual take, radians
  return frame * 9 * std::numbers::pi / 180;
}

TEST(FbxReader, ReadsAsciiInItsUnitWithItsRate) {
  const MotionFile file = read_fbx("f", fbx_text({{}}));
  EXPECT_EQ(file.motion.clip.sample_rate_hz, 30);
  ASSERT_EQ(file.motion.clip.frames(), 11);
  EXPECT_EQ(file.source, (SourceFormat{.kind = SourceFormat::Kind::Fbx, .cm_per_unit = 2}));
  EXPECT_THAT(texts(file), IsEmpty());
  ASSERT_EQ(file.motion.skeleton.joint_count(), 3);
  EXPECT_EQ(file.motion.skeleton.joint(1).name, "Knee");
  for (int t = 0; t < 11; ++t)
    EXPECT_LT((place(file, "Foot", t) - Eigen::RowVector3d(0, 180, 0)).norm(), 1e-3);
  const Eigen::Matrix3d turned =
      joint_rotation(file.motion.skeleton.joint(1), file.motion.clip.channels.row(7));
  const Eigen::Matrix3d wanted =
      axis_rotation(2, std::numbers::pi / 2) * axis_rotation(0, angle(7));
  EXPECT_LT((turned - wanted).norm(), 1e-5);
}

TEST(FbxReader, ReadsMorphWeights) {
  const MotionFile file = read_fbx("f", with_smile(fbx_text({{}})));
  ASSERT_EQ(file.tracks.size(), 1u);
  EXPECT_EQ(label(file.tracks[0]), "Face.smile");
  EXPECT_EQ(file.tracks[0].kind, TrackKind::MorphWeight);
  ASSERT_EQ(file.tracks[0].values.size(), 11u);
  for (std::size_t t = 0; t < 11; ++t)
    EXPECT_NEAR(file.tracks[0].values[t], 0.05 * static_cast<double>(t), 1e-6);
  EXPECT_TRUE(read_fbx("f", fbx_text({{}})).tracks.empty());
}

TEST(FbxReader, ReadsWeightsAlone) {
  std::string text = with_smile(fbx_text({{.degrees = 0}}));
  for (const char* limb : {"LimbNode", "LimbNode", "LimbNode"})
    text.replace(text.find(limb), std::string(limb).size(), "Null");
  const MotionFile file = read_fbx("f", text);
  ASSERT_EQ(file.tracks.size(), 1u);
  EXPECT_NEAR(file.tracks[0].values[10], 0.5, 1e-6);
}

TEST(FbxReader, ReadsCustomPropertiesThatChange) {
  std::string text = with_smile(fbx_text({{}}, "P: \"grip\", \"Number\", \"\", \"AU\",0\n"));
  const std::string moved = "C: \"OP\",105,23, \"DeformPercent\"";
  text.replace(text.find(moved), moved.size(), "C: \"OP\",105,2, \"grip\"");
  const MotionFile file = read_fbx("f", text);
  ASSERT_EQ(file.tracks.size(), 1u);
  EXPECT_EQ(label(file.tracks[0]), "rig:Knee.grip");
  EXPECT_EQ(file.tracks[0].kind, TrackKind::Property);
  EXPECT_NEAR(file.tracks[0].values[10], 50, 1e-4);
}

TEST(FbxReader, TurnsAJointAboutItsPivot) {
  const MotionFile file =
      read_fbx("f", fbx_text({{}}, property("RotationPivot", "Vector3D", "0,5,0")));
  EXPECT_EQ(file.motion.skeleton.joint_count(), 3);
  for (int t = 0; t < 11; ++t) {
    const Eigen::RowVector3d foot(5 * std::cos(angle(t)), 95, -5 * std::sin(angle(t)));
    EXPECT_LT((place(file, "Foot", t) - 2 * foot).norm(), 1e-3) << t;
  }
}

TEST(FbxReader, TurnsOtherAxesUp) {
  const auto hips = [](int up, const ReadOptions& options = {}) -> Eigen::RowVector3d {
    return place(read_fbx("f", fbx_text({{}}, "", up), options), "Hips", 0);
  };
  EXPECT_LT((hips(2) - Eigen::RowVector3d(0, 0, -180)).norm(), 1e-4);
  EXPECT_LT((hips(0) - Eigen::RowVector3d(-180, 0, 0)).norm(), 1e-4);
  EXPECT_LT((hips(2, {.cm_per_unit = 1.0, .up = UpAxis::Y}) - Eigen::RowVector3d(0, 90, 0)).norm(),
            1e-4);
}

TEST(FbxReader, ChoosesAmongTakes) {
  const std::string text = fbx_text({{}, {.name = "Second", .frames = {0, 1, 2, 3}}});
  const MotionFile first = read_fbx("f", text);
  EXPECT_EQ(first.motion.clip.frames(), 11);
  EXPECT_THAT(texts(first), ElementsAre("take First is read; there are also Second"));
  EXPECT_THAT(first.takes.keys, ElementsAre("First", "Second"));
  EXPECT_EQ(first.takes.read, 0u);
  for (const char* take : {"Second", "2"}) {
    const MotionFile second = read_fbx("f", text, {.take = take});
    EXPECT_EQ(second.motion.clip.frames(), 4);
    EXPECT_THAT(texts(second), IsEmpty());
  }
  EXPECT_EQ(error_of(text, {.take = "Third"}), "f: has no take Third: there are First, Second");
}

TEST(FbxReader, SamplesKeysAtTheRateThatIsAskedForAndSaysWhereTheyAreSparse) {
  const std::string sparse = fbx_text({{.frames = {0, 4, 5, 10}}});
  const MotionFile file = read_fbx("f", sparse);
  EXPECT_EQ(file.motion.clip.frames(), 11);
  EXPECT_THAT(texts(file), ElementsAre(HasSubstr("4 of 11 frames carry keys")));
  const MotionFile finer = read_fbx("f", sparse, {.sample_rate_hz = 60.0});
  EXPECT_EQ(finer.motion.clip.frames(), 21);
  EXPECT_EQ(finer.motion.clip.sample_rate_hz, 60);
  EXPECT_THAT(texts(finer), IsEmpty());
  const Eigen::Matrix3d wanted =
      axis_rotation(2, std::numbers::pi / 2) * axis_rotation(0, angle(7));
  EXPECT_LT(
      (joint_rotation(finer.motion.skeleton.joint(1), finer.motion.clip.channels.row(14)) - wanted)
          .norm(),
      1e-5);
}

TEST(FbxReader, RefusesInOneSentence) {
  EXPECT_EQ(error_of(fbx_text({})),
            "f: holds no animation, but may be put on a clip as its character");
  EXPECT_EQ(error_of("").find("f: cannot be read as FBX: "), 0u);
  EXPECT_EQ(error_of("nonsense").find("f: cannot be read as FBX: "), 0u);
  std::string nested;
  for (int i = 0; i < 100000; ++i) nested += "FBX: {";
  EXPECT_EQ(error_of(nested), "f: nests records deeper than 64");
  EXPECT_EQ(error_of("; FBX 5.8.0 project file\n"), "f: is FBX 5.8: versions from 6.0 on are read");
}

TEST(FbxReader, RefusesNodesInACircle) {
  std::string text = fbx_text({{}});
  const std::string hangs = "C: \"OO\",1,0\n";
  text.replace(text.find(hangs), hangs.size(), "C: \"OO\",1,3\n");
  EXPECT_EQ(error_of(text), "f: its nodes hang in a circle");
}

TEST(FbxReader, TakesTheFirstOfSeveralParents) {
  std::string text = fbx_text({{}});
  text.insert(text.find("C: \"OO\",2,1"), "C: \"OO\",1,3\n");
  EXPECT_EQ(error_of(text), "read");
}

TEST(FbxReader, RefusesBinaryRecordsInRecordsWithoutEnd) {
  constexpr std::uint32_t kRecords = 100000;
  const auto bytes_of = [](std::uint32_t value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
  };
  std::string bytes("Kaydara FBX Binary  \0\x1a\0", 23);
  bytes += bytes_of(7400);
  const auto whole = static_cast<std::uint32_t>(bytes.size() + kRecords * (14 + 13));
  for (std::uint32_t i = 0; i < kRecords; ++i)
    bytes += bytes_of(whole - 13 * i) + bytes_of(0) + bytes_of(0) + "\1A";
  bytes.append(13 * (kRecords + 1), '\0');
  EXPECT_EQ(error_of(bytes), "f: nests records deeper than 64");
}

TEST(FbxReader, SurvivesEveryTruncation) {
  const std::string text = fbx_text({{}});
  for (std::size_t size = 0; size < text.size(); size += 13) {
    const std::string error = error_of(text.substr(0, size));
    EXPECT_EQ(error.find('\n'), error.npos) << error;
  }
}

class FbxCorpus : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = test::corpus();
    if (!folder || !std::filesystem::exists(*folder / "fbx"))
      GTEST_SKIP() << "the corpus of real motions is not here";
    folder_ = *folder / "fbx";
  }

  std::filesystem::path folder_;
};

TEST_F(FbxCorpus, AgreesWithBlender) {
  const std::map<std::string, int> first_key = {// Blender's frame
                                                {"85_12.fbx", 68},
                                                {"animation_with_skeleton.fbx", 1},
                                                {"huesitos.fbx", 1}};
  const auto all = nlohmann::json::parse(read_text(folder_ / "blender-3.4-positions.json"));
  for (const auto& [name, first] : first_key) {
    const MotionFile file = read_motion(folder_ / name);
    const Motion& motion = file.motion;
    EXPECT_EQ(motion.clip.sample_rate_hz, all.at(name).at("fps")) << name;
    const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
    for (const auto& [frame, joints] : all.at(name).at("joint_positions_in_metres_z_up").items()) {
      const int t = std::clamp(std::stoi(frame) - first, 0, motion.clip.frames() - 1);
      double largest = 0;
      Eigen::AlignedBox3d extent;
      int compared = 0;
      for (const auto& [joint, at] : joints.items()) {
        const Eigen::Vector3d cm(100 * at[0].get<double>(), 100 * at[2].get<double>(),
                                 -100 * at[1].get<double>());
        extent.extend(cm);
        const int j = motion.skeleton.find(joint);
        if (j < 0) {
          EXPECT_THAT(joint, HasSubstr("_end")) << name;  // the end of a bone is no joint of ours
          continue;
        }
        largest = std::max(largest, (tracks.block<1, 3>(t, 3 * j).transpose() - cm).norm());
        ++compared;
      }
      EXPECT_GE(compared, 9) << name;
      EXPECT_LT(largest, 1e-5 * extent.diagonal().norm()) << name << " frame " << frame;
    }
  }
}

TEST_F(FbxCorpus, HasAFileWithoutMotion) {
  EXPECT_EQ(error_of(read_text(folder_ / "Base.fbx")),
            "f: holds no animation, but may be put on a clip as its character");
}

TEST_F(FbxCorpus, SurvivesTruncationsAndDamage) {
  std::mt19937 random(1);
  for (const char* name : {"huesitos.fbx", "animation_with_skeleton.fbx"}) {
    const std::string bytes = read_text(folder_ / name);
    for (int i = 0; i < 60; ++i) {
      error_of(bytes.substr(0, random() % bytes.size()));
      std::string damaged = bytes;
      for (int k = 0; k < 4; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
      error_of(damaged);
    }
  }
}

Eigen::Matrix3d knee_turn(const std::string& text, int frame) {
  const MotionFile file = read_fbx("f", text);
  return axis_rotation(2, std::numbers::pi / 2).transpose() *
         joint_rotation(file.motion.skeleton.joint(1), file.motion.clip.channels.row(frame));
}

TEST(FbxReader, AddsLayers) {
  const std::string text = with_layer(fbx_text({{}}), "2");
  const double degrees = (90 + 20) * std::numbers::pi / 180;
  EXPECT_LT((knee_turn(text, 10) - axis_rotation(0, degrees)).norm(), 1e-6);
  EXPECT_LT((knee_turn(text, 5) - axis_rotation(0, degrees / 2)).norm(), 1e-6);
}

/// Gives the second layer properties.
std::string with_layer_properties(std::string text, const std::string& properties) {
  const std::string layer = "\"AnimLayer::Added\", \"\" {\n";
  return text.insert(text.find(layer) + layer.size(), "Properties70: {\n" + properties + "}\n");
}

TEST(FbxReader, MixesAndReplacesByLayersOfAWeight) {
  const auto layered = [](const std::string& properties) {
    return with_layer_properties(with_layer(fbx_text({{}}), "2"), properties);
  };
  const auto degrees = [](double angle) {
    return axis_rotation(0, angle * std::numbers::pi / 180);
  };
  const std::string half = property("Weight", "Number", "50");
  const std::string mix = property("BlendMode", "enum", "2");
  const std::string replace = property("BlendMode", "enum", "1");
  const std::string by_angle = property("RotationAccumulationMode", "enum", "1");
  EXPECT_LT((knee_turn(layered(half), 10) - degrees(100)).norm(), 1e-6);
  EXPECT_LT((knee_turn(layered(half + mix), 10) - degrees(55)).norm(), 1e-6);
  EXPECT_LT((knee_turn(layered(half + mix + by_angle), 10) - degrees(55)).norm(), 1e-6);
  EXPECT_LT((knee_turn(layered(half + replace), 10) - degrees(20)).norm(), 1e-6);
  EXPECT_LT((knee_turn(layered(property("Mute", "bool", "1")), 10) - degrees(90)).norm(), 1e-6);
  EXPECT_LT((knee_turn(layered(property("Solo", "bool", "1") + replace), 10) - degrees(20)).norm(),
            1e-6);
}

TEST(FbxReader, ReleasesTheCurvesOfNodesUnlessAskedToKeepThem) {
  const std::string text = fbx_text({{}});
  for (const FbxCurves curves : {FbxCurves::Release, FbxCurves::Keep}) {
    FbxFile file("f", text);
    const FbxTake take = read_fbx_take(file, {}, curves);
    ASSERT_EQ(take.movements.size(), 1u);
    EXPECT_EQ(take.movements[0].has_keys(), curves == FbxCurves::Keep);
  }
}

TEST(FbxReader, CombinesWeightsOfShapesByLayers) {
  const auto last = [](const std::string& properties) {
    const std::string text = with_layer(with_smile(fbx_text({{}})), "23", "DeformPercent");
    const MotionFile file = read_fbx("f", with_layer_properties(text, properties));
    EXPECT_EQ(file.tracks.size(), 1u);
    return file.tracks.at(0).values.at(10);
  };
  const std::string half = property("Weight", "Number", "50");
  EXPECT_NEAR(last(""), 0.7, 1e-6);
  EXPECT_NEAR(last(half), 0.6, 1e-6);
  EXPECT_NEAR(last(half + property("BlendMode", "enum", "2")), 0.35, 1e-6);
  EXPECT_NEAR(last(half + property("BlendMode", "enum", "1")), 0.2, 1e-6);
  EXPECT_NEAR(last(property("Mute", "bool", "1")), 0.5, 1e-6);
}

TEST(FbxReader, AddsALayerToAPropertyThatNoOtherLayerMoves) {
  const std::string grip = "P: \"grip\", \"Number\", \"\", \"AU\",3\n";
  const MotionFile file = read_fbx("f", with_layer(fbx_text({{}}, grip), "2", "grip"));
  ASSERT_EQ(file.tracks.size(), 1u);
  EXPECT_EQ(label(file.tracks[0]), "rig:Knee.grip");
  EXPECT_NEAR(file.tracks[0].values[0], 3, 1e-6);
  EXPECT_NEAR(file.tracks[0].values[10], 23, 1e-5);
}

TEST(FbxReader, TakesTheCurveNodeWithKeysIfOneBeforeItHasNone) {
  std::string text = with_smile(fbx_text({{}}));
  const std::string node = "AnimationCurveNode: 105";
  text.insert(text.find(node),
              "AnimationCurveNode: 104, \"AnimCurveNode::DeformPercent\", \"\" {\n}\n");
  const std::string connection = "C: \"OO\",105,101\n";
  text.insert(text.find(connection), "C: \"OO\",104,101\nC: \"OP\",104,23, \"DeformPercent\"\n");
  const MotionFile file = read_fbx("f", text);
  ASSERT_EQ(file.tracks.size(), 1u);
  EXPECT_NEAR(file.tracks[0].values[10], 0.5, 1e-6);
}

TEST(FbxReader, FollowsTheWeightOfALayerThatChanges) {
  std::string text = with_layer(fbx_text({{}}), "2");
  text.insert(text.find("}\nConnections: {\n"),
              "AnimationCurveNode: 113, \"AnimCurveNode::Weight\", \"\" {\n}\n" +
                  curve(114, {.degrees = 100}));
  text.insert(text.size() - 2, "C: \"OP\",113,110, \"Weight\"\nC: \"OP\",114,113, \"d|Weight\"\n");
  for (const int frame : {0, 5, 10}) {
    const double weight = frame / 10.0;
    const double degrees = 9 * frame + weight * 2 * frame;
    EXPECT_LT((knee_turn(text, frame) - axis_rotation(0, degrees * std::numbers::pi / 180)).norm(),
              1e-6)
        << frame;
  }
}

TEST(FbxReader, AddsTurnsOfLayersOneAfterTheOtherOrByAngle) {
  std::string text = with_layer(fbx_text({{}}), "2");
  const std::string of_layer = "112,111, \"d|X\"";
  text.replace(text.find(of_layer), of_layer.size(), "112,111, \"d|Y\"");
  const double y = 20 * std::numbers::pi / 180;
  const Eigen::Matrix3d base = axis_rotation(0, std::numbers::pi / 2);
  EXPECT_LT((knee_turn(text, 10) - base * axis_rotation(1, y)).norm(), 1e-6);
  const std::string layer = "\"AnimLayer::Added\", \"\" {\n";
  text.insert(text.find(layer) + layer.size(),
              "Properties70: {\n" + property("RotationAccumulationMode", "enum", "1") + "}\n");
  EXPECT_LT((knee_turn(text, 10) - axis_rotation(1, y) * base).norm(), 1e-6);
}

TEST(FbxReader, SaysWhatAnglesItReadsOtherwise) {
  EXPECT_THAT(texts(read_fbx("f", fbx_text({{}}, property("RotationOrder", "enum", "6")))),
              ElementsAre("1 node with spheric XYZ angles, which are read as XYZ angles"));
  EXPECT_THAT(texts(read_fbx("f", fbx_text({{}}, property("QuaternionInterpolate", "enum", "1")))),
              ElementsAre("1 node with quaternions between keys, which are read as angles"));
}

TEST(FbxReader, TakesTheFirstOfObjectsOfOneNumber) {
  std::string text = fbx_text({{}});
  text.insert(text.find("Model: 3,"), model(2, "rig:Other", ""));
  const MotionFile file = read_fbx("f", text);
  const Skeleton& skeleton = file.motion.skeleton;
  EXPECT_EQ(skeleton.joint(skeleton.find("Foot")).parent, skeleton.find("Knee"));
}

TEST(FbxReader, ReadsAMeshOnEachNodeThatDrawsIt) {
  std::string text = with_smile(fbx_text({{}}));
  text.insert(text.find("Model: 24,"), "Model: 25, \"Model::Again\", \"Mesh\" {\n}\n");
  text.insert(text.size() - 2, "C: \"OO\",25,3\nC: \"OO\",20,25\n");
  FbxFile file("f", text);
  EXPECT_EQ(read_fbx_take(file, {}).take.meshes.size(), 2u);
}

TEST(FbxReader, ReadsAPictureThatIsInTheFile) {
  std::string text = with_smile(fbx_text({{}}));
  text.insert(text.find("PolygonVertexIndex"),
              "LayerElementUV: 0 {\nMappingInformationType: \"ByPolygonVertex\"\n" +
                  list("UV", {"0", "0", "1", "0", "0", "1"}) + list("UVIndex", {"0", "1", "2"}) +
                  "}\n");
  text.insert(text.find("Model: 24,"),
              "Material: 30, \"Material::Paint\", \"\" {\n}\nTexture: 31, \"Texture::Paint\", \"\" "
              "{\nRelativeFilename: \"paint.png\"\n}\nVideo: 32, \"Video::Paint\", \"Clip\" "
              "{\nContent: , \"iVBORw0K\",\"GgohIQ==\"\n}\n");
  text.insert(text.size() - 2,
              "C: \"OO\",30,24\nC: \"OP\",31,30, \"DiffuseColor\"\nC: \"OO\",32,31\n");
  FbxFile file("f", text);
  const FbxTake take = read_fbx_take(file, {});
  ASSERT_EQ(take.take.meshes.size(), 1u);
  ASSERT_NE(take.take.meshes[0].picture, nullptr);
  EXPECT_EQ(take.take.meshes[0].picture->bytes, "\x89PNG\r\n\x1A\n!!");
  EXPECT_THAT(take.warnings, IsEmpty());
}

TEST(FbxReader, ReadsVisibilityThatChanges) {
  std::string text = with_smile(fbx_text({{}}));
  const std::string moved = "C: \"OP\",105,23, \"DeformPercent\"";
  text.replace(text.find(moved), moved.size(), "C: \"OP\",105,2, \"Visibility\"");
  const MotionFile file = read_fbx("f", text);
  ASSERT_EQ(file.tracks.size(), 1u);
  EXPECT_EQ(label(file.tracks[0]), "rig:Knee.Visibility");
}

TEST(FbxReader, SamplesAtARateOfTheFilesOwn) {
  std::string text = fbx_text({{.frames = {0, 4, 5, 10}}});
  const std::string usual = property("TimeMode", "enum", "6");
  text.replace(text.find(usual), usual.size(),
               property("TimeMode", "enum", "14") + property("CustomFrameRate", "double", "90"));
  const MotionFile file = read_fbx("f", text);
  EXPECT_EQ(file.motion.clip.sample_rate_hz, 90);
  EXPECT_EQ(file.motion.clip.frames(), 31);
}

TEST(FbxReader, ReadsAConnectionThatIsThereTwiceOnce) {
  std::string text = fbx_text({{}});
  text.insert(text.find("C: \"OO\",2,1"), "C: \"OO\",2,1\n");
  EXPECT_THAT(texts(read_fbx("f", text)),
              ElementsAre("1 connection stated again: each counts once"));
}

}  // namespace
}  // namespace mocapress::fbx_reader_test
