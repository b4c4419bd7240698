// SPDX-License-Identifier: MIT
#include "core/formats/node_skin.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>

namespace mocapress {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

constexpr double kSameBind = 1e-4;       // largest difference of matrix elements
constexpr double kFlat = 1e-12;          // determinant too small for an inverse
constexpr double kFarthestVertex = 1e9;  // cm
constexpr std::size_t kMostPictureBytes = std::size_t{64} << 20;

bool same_bind(const Affine3d& a, const Affine3d& b) {
  return (a.matrix() - b.matrix()).norm() <= kSameBind * (1 + a.matrix().norm());
}

bool has_inverse(const Affine3d& transform) {
  return transform.matrix().allFinite() && std::abs(transform.linear().determinant()) > kFlat;
}

/// Normals with lengths that grow with the triangles, so that large ones weigh more.
std::vector<Vector3d> normals_of(const NodeMesh& mesh) {
  std::vector<Vector3d> normals(mesh.positions.size(), Vector3d::Zero());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3d twice_area =
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    for (const std::uint32_t corner : {a, b, c}) normals[corner] += twice_area;
  }
  return normals;
}

/// Marks the bones that carry a vertex.
std::vector<bool> used_bones(const NodeMesh& mesh) {
  std::vector<bool> used(mesh.bones.size(), mesh.weights.empty());
  for (const NodeMesh::Weights& weights : mesh.weights)
    for (const auto& [bone, weight] : weights)
      if (weight > 0) used[bone] = true;
  return used;
}

class SkinBuilder {
 public:
  SkinBuilder(const std::vector<NodeJoint>& nodes, const Affine3d& world_from_file)
      : nodes_(nodes), world_from_file_(world_from_file) {}

  /// Adds a mesh. Returns false if the skin would have too many bones.
  bool add(const NodeMesh& mesh);
  Skin take() { return std::move(skin_); }

 private:
  const NodeJoint& joint_of(const NodeMesh::Bone& bone) const { return nodes_[bone.node]; }
  Affine3d place_bound(const NodeMesh& mesh);
  std::optional<std::uint8_t> bone_of(const SkinBone& bone);
  int picture_at(const std::shared_ptr<const SkinPicture>& picture);

  const std::vector<NodeJoint>& nodes_;
  const Affine3d& world_from_file_;
  std::unordered_map<int, Affine3d> bind_world_from_node_;  // cm; for the bones so far
  Skin skin_;
};

/// The transform from the mesh's own frame to the world of the bind pose. If the file does not
/// state it, meshes that share a bone are put into one pose, which the first of them sets.
Affine3d SkinBuilder::place_bound(const NodeMesh& mesh) {
  std::optional<Affine3d> placed;
  if (mesh.file_from_mesh && has_inverse(*mesh.file_from_mesh))
    placed = world_from_file_ * *mesh.file_from_mesh;
  for (const NodeMesh::Bone& bone : mesh.bones)
    if (const auto known = bind_world_from_node_.find(bone.node);
        !placed && known != bind_world_from_node_.end())
      placed = known->second * bone.node_from_mesh;
  for (const NodeMesh::Bone& bone : mesh.bones)
    if (!placed && has_inverse(joint_of(bone).rest_world_from_node * bone.node_from_mesh))
      placed = joint_of(bone).rest_world_from_node * bone.node_from_mesh;
  if (!placed || !has_inverse(*placed)) placed = Affine3d::Identity();
  for (const NodeMesh::Bone& bone : mesh.bones)
    if (has_inverse(bone.node_from_mesh))
      bind_world_from_node_.emplace(bone.node, *placed * bone.node_from_mesh.inverse());
  return *placed;
}

std::optional<std::uint8_t> SkinBuilder::bone_of(const SkinBone& bone) {
  const auto same = std::ranges::find_if(skin_.bones, [&](const SkinBone& one) {
    return one.joint == bone.joint && same_bind(one.joint_from_bind, bone.joint_from_bind);
  });
  const auto index = static_cast<std::size_t>(same - skin_.bones.begin());
  if (index == Skin::kMostBones) return std::nullopt;
  if (same == skin_.bones.end()) skin_.bones.push_back(bone);
  return static_cast<std::uint8_t>(index);
}

int SkinBuilder::picture_at(const std::shared_ptr<const SkinPicture>& picture) {
  auto& all = skin_.pictures;
  const auto known = std::ranges::find(all, picture);
  const auto index = static_cast<int>(known - all.begin());
  if (known == all.end()) all.push_back(picture);
  return index;
}

bool SkinBuilder::add(const NodeMesh& mesh) {
  const Affine3d bind_from_mesh = place_bound(mesh);
  const Affine3d mesh_from_bind = bind_from_mesh.inverse();
  const std::vector<bool> used = used_bones(mesh);
  std::vector<std::optional<std::uint8_t>> bones;  // unset: carries nothing, or belongs to no joint
  for (const NodeMesh::Bone& bone : mesh.bones) {
    bones.emplace_back();
    const NodeJoint& node = joint_of(bone);
    if (node.joint < 0 || !used[bones.size() - 1]) continue;
    bones.back() =
        bone_of({node.joint, node.joint_from_node * bone.node_from_mesh * mesh_from_bind});
    if (!bones.back()) return false;
  }
  const auto carrying = std::ranges::find_if(bones, [](const auto& b) { return !!b; });
  if (carrying == bones.end()) return true;

  const bool is_pictured = mesh.picture && mesh.in_picture.size() == mesh.positions.size() &&
                           std::ranges::all_of(mesh.in_picture, [](const Eigen::Vector2d& place) {
                             return place.allFinite();
                           });
  const int picture = is_pictured ? picture_at(mesh.picture) : -1;
  const std::vector<Vector3d> normals = mesh.normals.empty() ? normals_of(mesh) : mesh.normals;
  const Eigen::Matrix3d turn_normal = bind_from_mesh.linear().inverse().transpose();
  const auto first = static_cast<std::uint32_t>(skin_.vertices.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    std::vector<std::pair<std::uint8_t, double>> weights;
    if (!mesh.weights.empty())
      for (const auto& [bone, weight] : mesh.weights[v])
        if (bones[bone]) weights.emplace_back(*bones[bone], weight);
    if (weights.empty()) weights.emplace_back(**carrying, 1.0);
    const Vector3d normal = turn_normal * normals[v];
    const double length = normal.norm();
    skin_.vertices.push_back(
        {(bind_from_mesh * mesh.positions[v]).cast<float>(),
         length > 0 ? Eigen::Vector3f((normal / length).cast<float>()) : Eigen::Vector3f::UnitY(),
         mesh.colour, largest_weights(std::move(weights)),
         is_pictured ? Eigen::Vector2f(mesh.in_picture[v].cast<float>()) : Eigen::Vector2f::Zero(),
         picture});
  }
  for (const auto& [a, b, c] : mesh.triangles)
    skin_.triangles.push_back({first + a, first + b, first + c});
  return true;
}

bool is_possible(const Skin& skin) {
  const auto fits = [](const auto& place) {
    return place.allFinite() && static_cast<double>(place.cwiseAbs().maxCoeff()) <= kFarthestVertex;
  };
  return std::ranges::all_of(skin.vertices,
                             [&](const auto& vertex) { return fits(vertex.in_bind); }) &&
         std::ranges::all_of(
             skin.bones, [&](const SkinBone& bone) { return fits(bone.joint_from_bind.matrix()); });
}

}  // namespace

Eigen::Vector3f material_colour(const Eigen::Vector3f& linear, bool has_picture) {
  constexpr float kWhite = 0.99F;
  if (!linear.allFinite() || (!has_picture && linear.minCoeff() >= kWhite)) return kPlainSkin;
  // The sRGB curve of IEC 61966-2-1.
  return linear.unaryExpr([](float value) {
    const float in_range = std::clamp(value, 0.0F, 1.0F);
    return in_range <= 0.0031308F ? 12.92F * in_range
                                  : 1.055F * std::pow(in_range, 1 / 2.4F) - 0.055F;
  });
}

std::shared_ptr<const SkinPicture> picture_of(const std::string& file, const std::string& name,
                                              std::string bytes, Warnings& warnings) {
  const auto leave_out = [&](const char* why) {
    warnings.push_back({file, 0, "the picture " + name + " is not shown: " + why});
    return nullptr;
  };
  const std::string_view all = bytes;
  if (!all.starts_with("\x89PNG\r\n\x1A\n") && !all.starts_with("\xFF\xD8\xFF"))
    return leave_out("it is neither PNG nor JPEG");
  if (all.size() > kMostPictureBytes) return leave_out("it has more than 64 MiB");
  return std::make_shared<const SkinPicture>(SkinPicture{name, std::move(bytes)});
}

std::shared_ptr<const Skin> skin_of(const std::string& file, const std::vector<NodeMesh>& meshes,
                                    const std::vector<NodeJoint>& nodes,
                                    const Affine3d& world_from_file, Warnings& warnings) {
  const auto leave_out = [&](const std::string& why) {
    warnings.push_back({file, 0, "its character is not read: " + why});
    return nullptr;
  };
  std::size_t vertices = 0;
  for (const NodeMesh& mesh : meshes) vertices += mesh.positions.size();
  if (vertices > std::numeric_limits<std::uint32_t>::max())
    return leave_out("it has too many vertices");
  SkinBuilder builder(nodes, world_from_file);
  for (const NodeMesh& mesh : meshes)
    if (!builder.add(mesh))
      return leave_out("it has more than " + std::to_string(Skin::kMostBones) + " bones");
  Skin skin = builder.take();
  if (skin.empty()) return nullptr;
  if (!is_possible(skin)) return leave_out("a vertex is not finite, or farther than 1e9 cm away");
  return std::make_shared<const Skin>(std::move(skin));
}

}  // namespace mocapress
