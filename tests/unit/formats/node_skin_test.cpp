// SPDX-License-Identifier: MIT
// Compares skins of takes with the nodes' own transforms. A vertex is moved by its bone's world
// matrix times the inverse bind matrix, as FBX and glTF define it.
#include "core/formats/node_skin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/formats/node_motion.h"

namespace mocapress::node_skin_test {
namespace {

using Eigen::Affine3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;

constexpr int kFrames = 12;
constexpr double kPlace = 1e-4;  // cm; vertices are floats

Affine3d affine_of(const LocalTransform& local) {
  return Eigen::Translation3d(local.translation) * local.rotation * Eigen::Scaling(local.scale);
}

Quaterniond turn(double radians, const Vector3d& axis) {
  return Quaterniond(Eigen::AngleAxisd(radians, axis.normalized()));
}

AnimatedNode moving(const std::string& name, int parent, const LocalTransform& rest,
                    const Vector3d& axis) {
  AnimatedNode node{name, parent, true, rest, {}};
  for (int t = 0; t < kFrames; ++t) {
    LocalTransform local = rest;
    local.rotation = rest.rotation * turn(0.3 + std::sin(0.5 * t), axis);
    node.frames.push_back(local);
  }
  return node;
}

/// A leg under an armature that lies on its back and counts in metres, with scaled nodes between.
NodeTake leg() {
  NodeTake take;
  take.frames = kFrames;
  take.cm_per_unit = 2.54;
  const LocalTransform stand{
      {10, 20, 30}, turn(-std::numbers::pi / 2, Vector3d::UnitX()), {100, 100, 100}};
  take.nodes = {
      {"Armature", -1, false, stand, {}},
      moving("Hip", 0, {{0, 0, 0.9}, turn(0.7, {1, 2, 0}), {2, 2, 2}}, {1, 0, 0}),
      moving("Knee", 1, {{0.1, -0.4, 0}, turn(-1, {0, 2, 1}), {0.5, 0.5, 0.5}}, {0, 1, 1}),
      moving("Foot", 2, {{0, -0.4, 0.1}, turn(2, {3, 2, 1}), {1, 1, 1}}, {0, 0, 1})};
  return take;
}

/// The nodes' world transforms at a frame, or at rest for -1, in the file's unit.
std::vector<Affine3d> worlds(const NodeTake& take, int frame) {
  std::vector<Affine3d> worlds;
  for (const AnimatedNode& node : take.nodes) {
    const Affine3d above =
        node.parent < 0 ? Affine3d::Identity() : worlds[static_cast<std::size_t>(node.parent)];
    const bool rests = frame < 0 || node.frames.empty();
    worlds.push_back(above *
                     affine_of(rests ? node.rest : node.frames[static_cast<std::size_t>(frame)]));
  }
  return worlds;
}

/// Some vertices in a frame of their own, carried by hip, knee and foot. `bind` is the mesh's place
/// when it was bound to the nodes at rest.
NodeMesh trousers(const NodeTake& take, const Affine3d& bind) {
  NodeMesh mesh;
  mesh.positions = {{0, 0, 1}, {0.2, 0.5, 1}, {0.1, 0.3, 2}, {1, -1, 0.5}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  const std::vector<Affine3d> rest = worlds(take, -1);
  for (const int node : {3, 1, 2})
    mesh.bones.push_back({node, rest[static_cast<std::size_t>(node)].inverse() * bind});
  mesh.weights = {{{1, 1.0}}, {{1, 0.5}, {2, 0.25}, {0, 0.25}}, {{0, 3.0}, {2, 1.0}}, {{0, 0.7}}};
  return mesh;
}

Affine3d somewhere() {
  return Eigen::Translation3d(5, 6, 7) * turn(1, {1, 1, 0}) * Eigen::Scaling(40.0);
}

/// Expects every vertex, frame by frame, at the place that the nodes' matrices give. Meshes are in
/// the order of the skin.
void expect_exact(const NodeTake& take, const MotionFile& file) {
  ASSERT_TRUE(file.skin);
  for (int t = 0; t < kFrames; ++t) {
    const std::vector<Affine3d> world = worlds(take, t);
    Pose pose;
    compute_pose(file.motion.skeleton, file.motion.clip.channels.row(t), pose);
    const std::vector<Vector3d> found = skinned_positions(*file.skin, pose);
    std::size_t vertex = 0;
    for (const NodeMesh& mesh : take.meshes)
      for (std::size_t v = 0; v < mesh.positions.size(); ++v, ++vertex) {
        NodeMesh::Weights weights = {{0, 1.0}};
        if (!mesh.weights.empty()) weights = mesh.weights[v];
        Vector3d wanted = Vector3d::Zero();
        double sum = 0;
        for (const auto& [bone, weight] : weights) {
          const auto node = static_cast<std::size_t>(mesh.bones[bone].node);
          wanted += weight * (world[node] * mesh.bones[bone].node_from_mesh * mesh.positions[v]);
          sum += weight;
        }
        wanted *= take.cm_per_unit / sum;
        if (take.up == UpAxis::Z) wanted = Vector3d(wanted.x(), wanted.z(), -wanted.y());
        ASSERT_LT(vertex, found.size());
        EXPECT_LT((found[vertex] - wanted).norm(), kPlace * wanted.norm()) << vertex << " at " << t;
      }
    EXPECT_EQ(vertex, found.size());
  }
}

MotionFile read(const NodeTake& take) {
  return motion_of("f", take, {}, SourceFormat::Kind::Fbx);
}

TEST(NodeSkin, IsWhereTheNodesPutItWhateverTheirScales) {
  NodeTake take = leg();
  take.meshes = {trousers(take, somewhere())};
  expect_exact(take, read(take));
  take.up = UpAxis::Z;
  expect_exact(take, read(take));
}

TEST(NodeSkin, LiesInTheWorldOfTheBindPose) {
  NodeTake take = leg();
  take.meshes = {trousers(take, somewhere())};
  const MotionFile file = read(take);
  for (std::size_t v = 0; v < 4; ++v) {
    const Vector3d wanted = take.cm_per_unit * (somewhere() * take.meshes[0].positions[v]);
    EXPECT_LT((file.skin->vertices[v].in_bind.cast<double>() - wanted).norm(),
              1e-4 * wanted.norm());
    EXPECT_NEAR(file.skin->vertices[v].normal.norm(), 1, 1e-5);
  }
}

TEST(NodeSkin, LiesWhereTheFileSaysThatItWasBound) {
  NodeTake take = leg();
  take.meshes = {trousers(take, somewhere())};
  take.meshes[0].file_from_mesh = Eigen::Translation3d(0, 1, 0) * turn(2, {0, 1, 0});
  const MotionFile file = read(take);
  expect_exact(take, file);
  const Vector3d wanted =
      take.cm_per_unit * (*take.meshes[0].file_from_mesh * take.meshes[0].positions[1]);
  EXPECT_LT((file.skin->vertices[1].in_bind.cast<double>() - wanted).norm(), 1e-4);
}

TEST(NodeSkin, MergesMeshesThatShareTheirBones) {
  NodeTake take = leg();
  take.meshes = {trousers(take, somewhere()), trousers(take, Affine3d(Eigen::Scaling(3.0)))};
  const MotionFile file = read(take);
  expect_exact(take, file);
  EXPECT_EQ(file.skin->bones.size(), 3U);
  EXPECT_EQ(file.skin->triangles.back(), (std::array<std::uint32_t, 3>{5, 7, 6}));
}

TEST(NodeSkin, HangsAMeshWithoutBonesOnItsJoint) {
  NodeTake take = leg();
  take.nodes.push_back({"Hat rack", 3, false, {{0, 0.2, 0}, turn(1, {1, 0, 0}), {3, 3, 3}}, {}});
  NodeMesh hat = trousers(take, somewhere());
  hat.weights.clear();
  hat.bones = {{4, somewhere()}};
  take.meshes = {hat};
  expect_exact(take, read(take));
}

TEST(NodeSkin, LeavesOutWhatNoJointCarries) {
  NodeTake take = leg();
  NodeMesh floor = trousers(take, somewhere());
  floor.weights.clear();
  floor.bones = {{0, Affine3d::Identity()}};
  take.meshes = {floor};
  EXPECT_FALSE(read(take).skin);
}

TEST(NodeSkin, SaysWhenThereAreTooManyBones) {
  NodeTake take = leg();
  NodeMesh hat = trousers(take, somewhere());
  hat.weights.clear();
  for (std::size_t i = 0; i <= Skin::kMostBones; ++i) {
    hat.bones = {{3, Affine3d(Eigen::Translation3d(static_cast<double>(i), 0, 0))}};
    take.nodes.push_back({"hat", 3, true, {{static_cast<double>(i), 1, 0}, {}, {1, 1, 1}}, {}});
    take.nodes.back().rest.rotation = turn(1, {1, 0, 0});
    hat.bones[0].node = static_cast<int>(take.nodes.size()) - 1;
    take.meshes.push_back(hat);
  }
  const MotionFile file = read(take);
  EXPECT_FALSE(file.skin);
  EXPECT_THAT(file.warnings, Contains(Field(&Warning::message, HasSubstr("more than 256 bones"))));
}

TEST(MaterialColour, ConvertsLinearToSrgbAndIsPlainByDefault) {
  EXPECT_NEAR(material_colour({0.5F, 0.2F, 0}, false).x(), 0.735, 1e-3);
  EXPECT_EQ(material_colour({1, 1, 1}, false), kPlainSkin);
  EXPECT_NEAR(material_colour({1, 1, 1}, true).minCoeff(), 1, 1e-6);
}

}  // namespace
}  // namespace mocapress::node_skin_test
