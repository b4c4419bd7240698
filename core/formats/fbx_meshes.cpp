// SPDX-License-Identifier: MIT
#include "core/formats/fbx_meshes.h"

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/texture.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <unordered_set>

#include "core/base/file.h"

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

/// Pictures of a scene by the paths that its materials say, each read once.
class PictureReader {
 public:
  PictureReader(const aiScene& scene, const FbxPictures& pictures)
      : scene_(scene), pictures_(pictures) {}

  /// Null: there is none, or it is not there, which a warning says.
  std::shared_ptr<const SkinPicture> of(const aiMaterial& material) {
    aiString path;
    if (material.GetTexture(aiTextureType_DIFFUSE, 0, &path) != AI_SUCCESS &&
        material.GetTexture(aiTextureType_BASE_COLOR, 0, &path) != AI_SUCCESS)
      return nullptr;
    const std::string stated = path.C_Str();
    if (const auto known = known_.find(stated); known != known_.end()) return known->second;
    return known_[stated] = read(stated);
  }

 private:
  std::shared_ptr<const SkinPicture> read(const std::string& stated) {
    if (const aiTexture* texture = scene_.GetEmbeddedTexture(stated.c_str());
        texture != nullptr && texture->mHeight == 0)
      return picture_of(
          pictures_.file, stated,
          std::string(reinterpret_cast<const char*>(texture->pcData), texture->mWidth),
          pictures_.warnings);
    // Paths are those of another machine: what counts is the name.
    const std::string name = stated.substr(stated.find_last_of("/\\") + 1);
    const std::filesystem::path folder = std::filesystem::path(pictures_.file).parent_path();
    const std::filesystem::path beside = (folder.empty() ? "." : folder) / name;
    std::error_code error;
    const bool is_there = !name.empty() && std::filesystem::is_regular_file(beside, error) &&
                          std::filesystem::canonical(beside, error).parent_path() ==
                              std::filesystem::canonical(beside.parent_path(), error);
    if (is_there) return picture_of(pictures_.file, name, read_text(beside), pictures_.warnings);
    pictures_.warnings.push_back(
        {pictures_.file, 0, "the picture " + name + " is not shown: it is not beside the file"});
    return nullptr;
  }

  const aiScene& scene_;
  const FbxPictures& pictures_;
  std::map<std::string, std::shared_ptr<const SkinPicture>> known_;
};

void add_material(const aiScene& scene, const aiMesh& mesh, PictureReader& pictures,
                  NodeMesh& result) {
  if (mesh.mMaterialIndex >= scene.mNumMaterials) return;
  const aiMaterial& material = *scene.mMaterials[mesh.mMaterialIndex];
  if (mesh.HasTextureCoords(0)) result.picture = pictures.of(material);
  if (result.picture)
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)  // which begin at the lower left corner
      result.in_picture.emplace_back(mesh.mTextureCoords[0][v].x,
                                     1 - static_cast<double>(mesh.mTextureCoords[0][v].y));
  aiColor3D diffuse(1, 1, 1);
  // What a picture is multiplied by is seldom meant: programs write any grey there.
  if (!result.picture && material.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse) != AI_SUCCESS) return;
  result.colour = material_colour({diffuse.r, diffuse.g, diffuse.b}, result.picture != nullptr);
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

NodeMesh mesh_of(const aiScene& scene, const aiMesh& mesh, PictureReader& pictures) {
  NodeMesh result;
  add_material(scene, mesh, pictures, result);
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    result.positions.push_back(point_of(mesh.mVertices[v]));
    if (mesh.HasNormals()) result.normals.push_back(point_of(mesh.mNormals[v]));
  }
  add_triangles(mesh, result);
  return result;
}

}  // namespace

std::vector<NodeMesh> fbx_meshes(const aiScene& scene, const std::vector<AnimatedNode>& nodes,
                                 const std::unordered_map<const aiNode*, int>& index_of,
                                 const FbxPictures& pictures) {
  PictureReader picture_reader(scene, pictures);
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
      NodeMesh result = mesh_of(scene, mesh, picture_reader);
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
