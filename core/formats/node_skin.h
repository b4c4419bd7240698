// SPDX-License-Identifier: MIT
// The meshes of FBX and glTF, as the skin of the joints that a motion is made of.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/motion/skin.h"

namespace mocapress {

/// A mesh as in its file, in its own frame and the file's unit.
struct NodeMesh {
  struct Bone {
    int node;                        // index into the NodeTake's nodes
    Eigen::Affine3d node_from_mesh;  // at the bind pose
  };
  // Indices of bones and their weights.
  using Weights = std::vector<std::pair<std::size_t, double>>;

  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> normals;                 // empty: computed from the triangles
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of existing vertices
  std::vector<Bone> bones;                              // a single bone carries the mesh rigidly
  std::vector<Weights> weights;                         // for each vertex; empty: all on bone 0
  // The mesh's place in the bind pose, in the file's axes and unit. Unset: found from the rest
  // poses of its bones.
  std::optional<Eigen::Affine3d> file_from_mesh;
  Eigen::Vector3f colour = kPlainSkin;  // sRGB
  std::shared_ptr<const SkinPicture> picture;
  std::vector<Eigen::Vector2d> in_picture;  // see Skin::Vertex; empty: no picture
};

/// The colour of a material in sRGB, from linear red, green and blue. White without a picture
/// becomes kPlainSkin, since files use pure white where a picture has the colours.
Eigen::Vector3f material_colour(const Eigen::Vector3f& linear, bool has_picture);

/// The picture that these bytes hold. Null, with a warning for `file`, if they cannot be a PNG or
/// JPEG.
std::shared_ptr<const SkinPicture> picture_of(const std::string& file, const std::string& name,
                                              std::string bytes, Warnings& warnings);

/// The joint that carries a node.
struct NodeJoint {
  int joint = -1;  // -1: none
  // Includes scales, which joints lack, and the change from the file's unit to cm.
  Eigen::Affine3d joint_from_node = Eigen::Affine3d::Identity();
  Eigen::Affine3d rest_world_from_node = Eigen::Affine3d::Identity();  // likewise; y up
};

/// Joins the meshes into one skin, in cm and y up. Meshes that no joint carries are left out. Null
/// if none is left, or if a warning says why not.
std::shared_ptr<const Skin> skin_of(const std::string& file, const std::vector<NodeMesh>& meshes,
                                    const std::vector<NodeJoint>& nodes,
                                    const Eigen::Affine3d& world_from_file, Warnings& warnings);

}  // namespace mocapress
