// SPDX-License-Identifier: MIT
#include "core/formats/fbx_meshes.h"

#include <assimp/material.h>
#include <assimp/mesh.h>

#include <cstdint>
#include <string>
#include <unordered_set>

#include "core/formats/material_colour.h"

namespace mocapress {
namespace {

Eigen::Vector3d point_of(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

Eigen::Affine3d affine_of(const aiMatrix4x4& m) {
  Eigen::Matrix4d matrix;
  for (unsigned row = 0; row < 4; ++row)
    for (unsigned column = 0; column < 4; ++column)
      matrix(row, column) = static_cast<double>(m[row][column]);
  return Eigen::Affine3d(matrix);
}

Eigen::Vector3f colour_of(const aiScene& scene, const aiMesh& mesh) {
  aiColor3D diffuse;
  if (mesh.mMaterialIndex >= scene.mNumMaterials ||
      scene.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_COLOR_DIFFUSE, diffuse) != AI_SUCCESS)
    return kPlainSkin;
  return material_colour({diffuse.r, diffuse.g, diffuse.b});
}

/// A polygon becomes a fan of triangles; points and lines are left out.
void add_triangles(const aiMesh& mesh, NodeMesh& result) {
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    for (unsigned k = 2; k < face.mNumIndices; ++k) {
      const std::array<std::uint32_t, 3> corners = {face.mIndices[0], face.mIndices[k - 1],
                                                    face.mIndices[k]};
      if (corners[0] < mesh.mNumVertices && corners[1] < mesh.mNumVertices &&
          corners[2] < mesh.mNumVertices)
        result.triangles.push_back(corners);
    }
  }
}

Eigen::Affine3d file_from(const aiNode& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  for (const aiNode* above = &node; above != nullptr; above = above->mParent)
    transform = affine_of(above->mTransformation) * transform;
  return transform;
}

void add_bones(const aiMesh& mesh, const std::unordered_map<std::string, int>& node_named,
               NodeMesh& result) {
  result.weights.resize(mesh.mNumVertices);
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    const aiBone& bone = *mesh.mBones[b];
    const auto node = node_named.find(bone.mName.C_Str());
    if (node == node_named.end()) continue;
    result.bones.push_back({node->second, affine_of(bone.mOffsetMatrix)});
    for (unsigned w = 0; w < bone.mNumWeights; ++w)
      if (const aiVertexWeight& weight = bone.mWeights[w]; weight.mVertexId < mesh.mNumVertices)
        result.weights[weight.mVertexId].emplace_back(result.bones.size() - 1,
                                                      static_cast<double>(weight.mWeight));
  }
}

NodeMesh mesh_of(const aiScene& scene, const aiMesh& mesh) {
  NodeMesh result;
  result.colour = colour_of(scene, mesh);
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    result.positions.push_back(point_of(mesh.mVertices[v]));
    if (mesh.HasNormals()) result.normals.push_back(point_of(mesh.mNormals[v]));
  }
  add_triangles(mesh, result);
  return result;
}

}  // namespace

std::vector<NodeMesh> fbx_meshes(const aiScene& scene, const std::vector<AnimatedNode>& nodes,
                                 const std::unordered_map<const aiNode*, int>& index_of) {
  std::unordered_map<std::string, int> node_named;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    node_named.emplace(nodes[n].name, static_cast<int>(n));  // of one name the first
  std::vector<NodeMesh> meshes;
  std::unordered_set<unsigned> with_bones;
  std::vector<const aiNode*> waiting = {scene.mRootNode};
  while (!waiting.empty()) {
    const aiNode& node = *waiting.back();
    waiting.pop_back();
    for (unsigned c = 0; c < node.mNumChildren; ++c) waiting.push_back(node.mChildren[c]);
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
      if (node.mMeshes[m] >= scene.mNumMeshes) continue;
      const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
      if (mesh.HasBones() && !with_bones.insert(node.mMeshes[m]).second) continue;
      NodeMesh result = mesh_of(scene, mesh);
      result.file_from_mesh = file_from(node);
      if (mesh.HasBones())
        add_bones(mesh, node_named, result);
      else if (const auto known = index_of.find(&node); known != index_of.end())
        result.bones = {{known->second, Eigen::Affine3d::Identity()}};
      else if (const auto parent = index_of.find(node.mParent); parent != index_of.end())
        result.bones = {{parent->second, affine_of(node.mTransformation)}};
      meshes.push_back(std::move(result));
    }
  }
  return meshes;
}

}  // namespace mocapress
