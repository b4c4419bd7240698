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

/// A mesh of a file, in its own frame and the file's unit.
struct NodeMesh {
  struct Bone {
    int node;                        // of NodeTake
    Eigen::Affine3d node_from_mesh;  // when it was bound
  };
  using Weights = std::vector<std::pair<std::size_t, double>>;  // which of the bones, how much

  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> normals;                 // empty: as the triangles lie
  std::vector<std::array<std::uint32_t, 3>> triangles;  // all of vertices there are
  std::vector<Bone> bones;                              // one alone: it hangs there as it is
  std::vector<Weights> weights;                         // of each vertex; empty: all on bone 0
  // Where the mesh was when it was bound, in the file's axes and unit. Unset: where the first of
  // its bones rests.
  std::optional<Eigen::Affine3d> file_from_mesh;
  Eigen::Vector3f colour = kPlainSkin;  // as screens have it
  std::shared_ptr<const SkinPicture> picture;
  std::vector<Eigen::Vector2d> in_picture;  // as Skin::Vertex has it; empty: no picture is laid on
};

/// The colour of a material as screens have it (sRGB), from linear red, green and blue. Pure white
/// is what files say where a picture has the colours: that becomes kPlainSkin where it has none.
Eigen::Vector3f material_colour(const Eigen::Vector3f& linear, bool has_picture);

/// Null, with a warning of `file`, unless the bytes may be those of a PNG or JPEG.
std::shared_ptr<const SkinPicture> picture_of(const std::string& file, const std::string& name,
                                              std::string bytes, Warnings& warnings);

/// Which joint carries a node.
struct NodeJoint {
  int joint = -1;  // -1: none does
  // Scales are in here, which joints lack; from the file's unit to cm.
  Eigen::Affine3d joint_from_node = Eigen::Affine3d::Identity();
  Eigen::Affine3d rest_world_from_node = Eigen::Affine3d::Identity();  // likewise; y up
};

/// The meshes as one, in cm and y up. Those that no joint carries are left out. Null where none is
/// left, or where a warning says why not.
std::shared_ptr<const Skin> skin_of(const std::string& file, const std::vector<NodeMesh>& meshes,
                                    const std::vector<NodeJoint>& nodes,
                                    const Eigen::Affine3d& world_from_file, Warnings& warnings);

}  // namespace mocapress
