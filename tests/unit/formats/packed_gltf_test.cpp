// SPDX-License-Identifier: MIT
// glTF as written by gltfpack (EXT_meshopt_compression, KHR_mesh_quantization) and glTF-Transform
// (KHR_draco_mesh_compression). Needs both libraries.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/file.h"
#include "core/formats/gltf_reader.h"
#include "core/formats/gltf_writer.h"
#include "core/motion/forward_kinematics.h"
#include "tests/support/corpus.h"
#include "tests/support/same_motion.h"
#include "tests/support/small_gltf.h"

namespace mocapress::packed_gltf_test {
namespace {

namespace fs = std::filesystem;
using test::SmallGltf;

MotionFile read(const SmallGltf& gltf) {
  return read_gltf("small.glb", gltf.glb());
}

/// Packs a bufferView as gltfpack does: its bytes go into the chunk, and a placeholder buffer
/// states their unpacked size.
void pack(SmallGltf& gltf, std::size_t view, std::size_t stride, const char* filter = "NONE",
          const std::vector<unsigned char>& filtered = {}) {
  Json& stated = gltf.json["bufferViews"][view];
  const std::size_t begin = stated["byteOffset"];
  const std::size_t count = stated["byteLength"].get<std::size_t>() / stride;
  std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(count, stride));
  packed.resize(meshopt_encodeVertexBuffer(
      packed.data(), packed.size(),
      filtered.empty() ? reinterpret_cast<const unsigned char*>(gltf.data.data() + begin)
                       : filtered.data(),
      count, stride));
  std::fill_n(gltf.data.begin() + static_cast<std::ptrdiff_t>(begin), count * stride, '\x55');
  const std::size_t at = gltf.add_view(packed);
  const Json where = gltf.json["bufferViews"][at];
  gltf.json["bufferViews"].erase(at);
  if (gltf.json["buffers"].size() == 1)
    gltf.json["buffers"].push_back(
        {{"byteLength", 1U << 20U},
         {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
  gltf.json["bufferViews"][view]["buffer"] = 1;
  gltf.json["bufferViews"][view]["extensions"] = {{"EXT_meshopt_compression",
                                                   {{"buffer", 0},
                                                    {"byteOffset", where["byteOffset"]},
                                                    {"byteLength", where["byteLength"]},
                                                    {"byteStride", stride},
                                                    {"count", count},
                                                    {"mode", "ATTRIBUTES"},
                                                    {"filter", filter}}}};
}

/// The file of bending_knee() with packed times and rotations.
SmallGltf packed_knee() {
  SmallGltf gltf = test::bending_knee();
  pack(gltf, 0, 4);
  pack(gltf, 1, 16);
  return gltf;
}

TEST(MeshoptGltf, MovesAsItDidBeforeItWasPacked) {
  const Motion plain = read(test::bending_knee()).motion;
  const MotionFile packed = read(packed_knee());
  EXPECT_EQ(packed.motion.clip.channels, plain.clip.channels);
  EXPECT_EQ(packed.motion.clip.sample_rate_hz, plain.clip.sample_rate_hz);
  EXPECT_TRUE(packed.warnings.empty());
}

/// gltfpack stores rotations as three of their four numbers in 16 bits (filter QUATERNION).
TEST(MeshoptGltf, ReadsFilteredRotations) {
  SmallGltf gltf = test::bending_knee();
  std::vector<float> turns(44);
  std::memcpy(turns.data(), gltf.data.data() + 44, sizeof(float) * turns.size());
  std::vector<std::int16_t> integers(44);
  std::vector<unsigned char> filtered(88);
  meshopt_encodeFilterQuat(filtered.data(), 11, 8, 16, turns.data());
  const std::size_t output = gltf.add("VEC4", integers, 5122, true);
  pack(gltf, output, 8, "QUATERNION", filtered);
  gltf.json["animations"][0]["samplers"][0]["output"] = output;
  EXPECT_LT((read(gltf).motion.clip.channels - read(test::bending_knee()).motion.clip.channels)
                .cwiseAbs()
                .maxCoeff(),
            1e-4);
}

TEST(MeshoptGltf, IsRefusedInASentenceWhereItsBytesAreWrong) {
  const auto refusal = [](const auto& change) -> std::string {
    SmallGltf gltf = packed_knee();
    change(gltf.json["bufferViews"][1]["extensions"]["EXT_meshopt_compression"]);
    try {
      read(gltf);
    } catch (const InputError& error) {
      return error.what();
    }
    return "reads";
  };
  const std::string wrong = "small.glb: bufferView 1 is not what EXT_meshopt_compression makes";
  EXPECT_EQ(refusal([](Json&) {}), "reads");
  EXPECT_EQ(refusal([](Json& j) { j["count"] = 1'000'000'000'000; }),
            "small.glb: holds too many numbers to read");
  EXPECT_EQ(refusal([](Json& j) { j["count"] = 1'000'000; }), wrong);
  EXPECT_EQ(refusal([](Json& j) { j["byteStride"] = 0; }), wrong);
  EXPECT_EQ(refusal([](Json& j) { j["byteStride"] = 1024; }), wrong);
  EXPECT_EQ(refusal([](Json& j) { j["byteStride"] = 12; }), wrong);
  EXPECT_EQ(refusal([](Json& j) { j["mode"] = "TRIANGLES"; }), wrong);
  EXPECT_EQ(refusal([](Json& j) { j["filter"] = "SOFT"; }), wrong);
  EXPECT_EQ(refusal([](Json& j) { j["filter"] = "QUATERNION"; }), wrong);
  EXPECT_EQ(refusal([](Json& j) { j["byteLength"] = 3; }), wrong);
  EXPECT_EQ(refusal([](Json& j) { j["byteLength"] = 1'000'000; }),
            "small.glb: bufferView 1 reaches beyond its buffer");
}

/// Packed data stays packed when a motion is put into the file.
TEST(MeshoptGltf, TakesANewMotionAndKeepsTheRest) {
  const fs::path folder =
      fs::path(testing::TempDir()) / ("mocapress-packed-" + std::to_string(getpid()));
  fs::create_directories(folder);
  SmallGltf gltf = packed_knee();
  gltf.begin_animation("other");
  gltf.json["animations"][1] = gltf.json["animations"][0];
  gltf.json["animations"][1]["name"] = "other";
  write_text(folder / "source.glb", gltf.glb());
  MotionFile file = read_motion(folder / "source.glb");
  const Motion before = file.motion;
  file.motion.clip.channels.array() *= 0.5;
  for (const GltfContainer container : {GltfContainer::Glb, GltfContainer::Gltf}) {
    const std::string written =
        gltf_bytes_onto(folder / "source.glb", file.motion, container, folder, file.source);
    EXPECT_LT((read_gltf("again", written).motion.clip.channels - file.motion.clip.channels)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-6);
    EXPECT_EQ(read_gltf("again", written, {.take = "other"}).motion.clip.channels,
              before.clip.channels);
  }
  fs::remove_all(folder);
}

/// Positions of the skin's vertices at a frame.
std::vector<Eigen::Vector3d> posed(const MotionFile& file, int frame) {
  Pose pose;
  compute_pose(file.motion.skeleton, file.motion.clip.channels.row(frame), pose);
  std::vector<Eigen::Vector3d> places;
  for (const Skin::Vertex& vertex : file.skin->vertices) {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < vertex.carried_by.bones.size(); ++i) {
      const SkinBone& bone = file.skin->bones[vertex.carried_by.bones[i]];
      place += static_cast<double>(vertex.carried_by.weights[i]) *
               pose.to_world(bone.joint, bone.joint_from_bind * vertex.in_bind.cast<double>());
    }
    places.push_back(place);
  }
  return places;
}

/// The largest distance of one of `places` from the nearest of `others`.
double farthest(const std::vector<Eigen::Vector3d>& places, std::vector<Eigen::Vector3d> others) {
  const auto by_x = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.x() < b.x();
  };
  std::sort(others.begin(), others.end(), by_x);
  double farthest = 0;
  for (const Eigen::Vector3d& place : places) {
    double nearest = HUGE_VAL;
    const auto may_be_nearer = [&](const Eigen::Vector3d& other) {
      return std::abs(other.x() - place.x()) < nearest;
    };
    const auto middle = std::lower_bound(others.begin(), others.end(), place, by_x);
    for (auto at = middle; at != others.end() && may_be_nearer(*at); ++at)
      nearest = std::min(nearest, (*at - place).norm());
    for (auto at = middle; at != others.begin() && may_be_nearer(*std::prev(at)); --at)
      nearest = std::min(nearest, (*std::prev(at) - place).norm());
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

/// A triangle on the knee and the ankle, with or without Draco.
SmallGltf skinned_knee(bool packed) {
  SmallGltf gltf = test::bending_knee();
  const std::vector<float> places = {0, 0.5F, 0, 0.1F, 0.1F, 0, -0.1F, 0.1F, 0};
  const std::vector<std::uint8_t> joints = {1, 0, 0, 0, 1, 2, 0, 0, 2, 0, 0, 0};
  const std::vector<std::uint8_t> weights = {255, 0, 0, 0, 51, 204, 0, 0, 255, 0, 0, 0};
  Json attributes = {{"POSITION", gltf.add("VEC3", places)},
                     {"JOINTS_0", gltf.add("VEC4", joints, 5121)},
                     {"WEIGHTS_0", gltf.add("VEC4", weights, 5121, true)}};
  Json primitive = {{"attributes", attributes}};
  if (packed) {
    for (const auto& [name, accessor] : attributes.items()) {
      Json& stated = gltf.json["accessors"][accessor.get<std::size_t>()];
      std::fill_n(
          gltf.data.begin() +
              gltf.json["bufferViews"][stated["bufferView"].get<std::size_t>()]["byteOffset"]
                  .get<std::ptrdiff_t>(),
          12, '\x55');
      stated.erase("bufferView");
    }
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(1);
    const int position =
        builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int joint = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8);
    const int weight = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8);
    const draco::FaceIndex face(0);
    builder.SetAttributeValuesForFace(position, face, &places[0], &places[3], &places[6]);
    builder.SetAttributeValuesForFace(joint, face, &joints[0], &joints[4], &joints[8]);
    builder.SetAttributeValuesForFace(weight, face, &weights[0], &weights[4], &weights[8]);
    const auto mesh = builder.Finalize();
    draco::EncoderBuffer bytes;
    draco::Encoder encoder;
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 16);
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &bytes).ok());
    const std::size_t view =
        gltf.add_view(std::vector<char>(bytes.data(), bytes.data() + bytes.size()));
    primitive["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view},
        {"attributes",
         {{"POSITION", mesh->attribute(position)->unique_id()},
          {"JOINTS_0", mesh->attribute(joint)->unique_id()},
          {"WEIGHTS_0", mesh->attribute(weight)->unique_id()}}}};
  }
  gltf.json["meshes"] = {{{"primitives", {primitive}}}};
  gltf.json["nodes"].push_back({{"name", "body"}, {"mesh", 0}, {"skin", 0}});
  return gltf;
}

TEST(DracoGltf, HasTheSkinItHadBeforeItWasPacked) {
  const MotionFile plain = read(skinned_knee(false));
  const MotionFile packed = read(skinned_knee(true));
  ASSERT_TRUE(plain.skin && packed.skin);
  EXPECT_TRUE(packed.warnings == plain.warnings);
  ASSERT_EQ(packed.skin->vertices.size(), plain.skin->vertices.size());
  for (const int frame : {0, 5, 10})
    EXPECT_LT(farthest(posed(plain, frame), posed(packed, frame)), 0.01);
}

TEST(DracoGltf, LeavesTheMotionReadableWhereItsBytesAreWrong) {
  SmallGltf gltf = skinned_knee(true);
  const Json& view = gltf.json["bufferViews"].back();
  const auto begin = view["byteOffset"].get<std::size_t>();
  for (std::size_t at = begin; at < gltf.data.size(); ++at) {
    SmallGltf changed = gltf;
    changed.data[at] = static_cast<char>(changed.data[at] ^ 0xFF);
    EXPECT_EQ(read(changed).motion.clip.frames(), 11);
  }
  gltf.data[begin] = 'd';
  const MotionFile file = read(gltf);
  EXPECT_FALSE(file.skin);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_EQ(file.warnings[0].message,
            "its character is not read: has a mesh that is not what KHR_draco_mesh_compression "
            "makes");
}

/// The project's own sample, packed by gltfpack -c and by glTF-Transform's draco.
TEST(PackedGltfCorpus, ReadsLikeThePlainCharacter) {
  const auto folder = test::corpus();
  if (!folder || !fs::exists(*folder / "gltf/character_meshopt.glb"))
    GTEST_SKIP() << "the corpus of real motions is not here";
  const fs::path sample = fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.glb";
  constexpr double kQuantised = 0.1;  // cm; gltfpack keeps 14 bits of positions, 12 of rotations
  const MotionFile plain = read_motion(sample);
  ASSERT_TRUE(plain.skin);
  std::vector<std::string> names;
  for (const Joint& joint : plain.motion.skeleton.joints()) names.push_back(joint.name);
  for (const char* name : {"gltf/character_meshopt.glb", "gltf/character_draco.glb"}) {
    SCOPED_TRACE(name);
    const MotionFile packed = read_motion(*folder / name);
    ASSERT_TRUE(packed.skin);
    EXPECT_TRUE(packed.warnings.empty());
    EXPECT_EQ(packed.motion.clip.frames(), plain.motion.clip.frames());
    EXPECT_EQ(packed.motion.clip.sample_rate_hz, plain.motion.clip.sample_rate_hz);
    for (int joint = 0; joint < plain.motion.skeleton.joint_count(); ++joint)
      EXPECT_GE(packed.motion.skeleton.find(names[static_cast<std::size_t>(joint)]), 0);
    EXPECT_EQ(packed.skin->triangles.size(), plain.skin->triangles.size());
    std::vector<std::string> own_names;
    for (const Joint& joint : packed.motion.skeleton.joints()) own_names.push_back(joint.name);
    const MotionFile again =
        read_gltf("again", gltf_bytes_onto(*folder / name, packed.motion, GltfContainer::Glb,
                                           fs::path(testing::TempDir()), packed.source));
    EXPECT_LT(test::largest_move(packed.motion, again.motion, own_names), 0.001);
    ASSERT_TRUE(again.skin);
    EXPECT_LT(farthest(posed(packed, 90), posed(again, 90)), 0.001);
    for (const int frame : {0, 90, 179}) {
      EXPECT_LT(farthest(posed(plain, frame), posed(packed, frame)), kQuantised) << frame;
      EXPECT_LT(farthest(posed(packed, frame), posed(plain, frame)), kQuantised) << frame;
    }
  }
}

}  // namespace
}  // namespace mocapress::packed_gltf_test
