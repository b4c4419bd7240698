// SPDX-License-Identifier: MIT
// After the glTF 2.0 specification, Khronos Group 2021 (ISO/IEC 12113:2022): sections 3.7 (meshes,
// skins) and 3.9 (materials).
#include "core/formats/gltf_meshes.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "core/formats/gltf_draco.h"

namespace mocapress {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

constexpr std::size_t kTriangles = 4;  // the primitive mode of triangles

Affine3d parent_from(const GltfFile& file, const Json& node) {
  if (const auto matrix = file.numbers(node, "matrix", 16))
    return Affine3d(Eigen::Map<const Eigen::Matrix4d>(matrix->data()));
  Affine3d local = Affine3d::Identity();
  if (const auto t = file.numbers(node, "translation", 3)) local.translate(Vector3d(t->data()));
  if (const auto r = file.numbers(node, "rotation", 4))
    local.rotate(Eigen::Quaterniond(r->data()).normalized());
  if (const auto s = file.numbers(node, "scale", 3)) local.scale(Vector3d(s->data()));
  return local;
}

std::vector<Vector3d> points_of(const std::vector<double>& values) {
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) points.emplace_back(&values[i]);
  return points;
}

/// KHR_texture_transform: maps texture coordinates to other ones.
class PlaceInPicture {
 public:
  PlaceInPicture(const GltfFile& file, const Json& texture)
      : set_(file.size(texture, "texCoord", 0)) {
    const Json* const stated = file.extension(texture, "KHR_texture_transform");
    if (stated == nullptr) return;
    set_ = file.size(*stated, "texCoord", set_);
    if (const auto offset = file.numbers(*stated, "offset", 2))
      moved_.translate(Eigen::Vector2d(offset->data()));
    // Counter-clockwise where the second coordinate points down, hence the sign.
    if (const auto angle = stated->find("rotation"); angle != stated->end() && angle->is_number())
      moved_.rotate(-angle->get<double>());
    if (const auto scale = file.numbers(*stated, "scale", 2))
      moved_.scale(Eigen::Vector2d(scale->data()));
  }

  std::string attribute() const { return "TEXCOORD_" + std::to_string(set_); }
  Eigen::Vector2d operator()(double across, double down) const {
    return moved_ * Eigen::Vector2d(across, down);
  }

 private:
  std::size_t set_;
  Eigen::Affine2d moved_ = Eigen::Affine2d::Identity();
};

/// A primitive packed by KHR_draco_mesh_compression, and the ids of its attributes.
struct PackedPrimitive {
  DracoMesh mesh;
  const Json* ids = nullptr;  // by an attribute's name
};

class MeshReader {
 public:
  MeshReader(GltfFile& file, const GltfTake& take, Warnings& warnings);

  std::vector<NodeMesh> read();

 private:
  std::vector<NodeMesh::Bone> bones_of(std::size_t node);
  std::vector<NodeMesh::Bone> bones_of_skin(std::size_t skin);
  void unpack(const Json& primitive);
  std::optional<std::vector<double>> attribute(const Json& attributes, const std::string& name,
                                               std::string_view type);
  NodeMesh mesh_of(const Json& primitive, std::vector<NodeMesh::Bone> bones, bool skinned);
  void read_triangles(const Json& primitive, NodeMesh& mesh);
  void read_weights(const Json& attributes, NodeMesh& mesh);
  void read_material(const Json& primitive, NodeMesh& mesh);
  void lay_picture(const Json& texture, const Json& attributes, NodeMesh& mesh);
  std::shared_ptr<const SkinPicture> picture(std::size_t image);

  const Json& node(std::size_t number) const { return file_.list("nodes")[number]; }

  GltfFile& file_;
  std::vector<int> parents_;        // for each of the file's nodes
  std::vector<int> index_in_take_;  // for each of the file's nodes; -1: not in the take
  Warnings& warnings_;
  std::optional<PackedPrimitive> packed_;                               // the primitive being read
  std::map<std::size_t, std::shared_ptr<const SkinPicture>> pictures_;  // pictures loaded so far
};

MeshReader::MeshReader(GltfFile& file, const GltfTake& take, Warnings& warnings)
    : file_(file), warnings_(warnings) {
  const std::size_t count = file.list("nodes").size();
  parents_.assign(count, -1);
  index_in_take_.assign(count, -1);
  for (std::size_t n = 0; n < count; ++n)
    for (const std::size_t child : file.indices(node(n), "children", "nodes"))
      parents_[child] = static_cast<int>(n);
  for (std::size_t i = 0; i < take.number_of_node.size(); ++i)
    index_in_take_[take.number_of_node[i]] = static_cast<int>(i);
}

std::vector<NodeMesh> MeshReader::read() {
  std::vector<NodeMesh> meshes;
  const Json& stated = file_.list(file_.json(), "meshes");
  for (std::size_t n = 0; n < parents_.size(); ++n) {
    const std::size_t mesh = file_.size(node(n), "mesh", stated.size());
    if (mesh >= stated.size()) continue;
    const auto skin = file_.index(node(n), "skin", "skins");
    const std::vector<NodeMesh::Bone> bones = skin ? bones_of_skin(*skin) : bones_of(n);
    if (bones.empty()) continue;
    for (const Json& primitive : file_.list(stated[mesh], "primitives"))
      if (file_.size(primitive, "mode", kTriangles) == kTriangles)
        meshes.push_back(mesh_of(primitive, bones, skin.has_value()));
  }
  return meshes;
}

/// The bone that carries what a node draws: the nearest node of the take, the node itself or one
/// above.
std::vector<NodeMesh::Bone> MeshReader::bones_of(std::size_t number) {
  Affine3d carrier_from_mesh = Affine3d::Identity();
  int at = static_cast<int>(number);
  while (at >= 0 && index_in_take_[at] < 0) {
    carrier_from_mesh = parent_from(file_, node(static_cast<std::size_t>(at))) * carrier_from_mesh;
    at = parents_[at];
  }
  if (at < 0) return {};
  return {{index_in_take_[at], carrier_from_mesh}};
}

std::vector<NodeMesh::Bone> MeshReader::bones_of_skin(std::size_t number) {
  const Json& skin = file_.list("skins")[number];
  const std::vector<std::size_t> joints = file_.indices(skin, "joints", "nodes");
  const auto accessor = file_.index(skin, "inverseBindMatrices", "accessors");
  std::vector<double> matrices;
  if (accessor) matrices = file_.values(*accessor, "MAT4");
  if (accessor && matrices.size() < 16 * joints.size())
    file_.fail("has a skin with " + std::to_string(joints.size()) + " joints, but only " +
               std::to_string(matrices.size() / 16) + " bind matrices");
  std::vector<NodeMesh::Bone> bones;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    bones.push_back({index_in_take_[joints[j]], Affine3d::Identity()});
    if (accessor)
      bones.back().node_from_mesh = Affine3d(Eigen::Map<const Eigen::Matrix4d>(&matrices[16 * j]));
  }
  return bones;
}

/// Unpacks a Draco primitive, unless the file has the same data unpacked, too, for readers without
/// Draco.
void MeshReader::unpack(const Json& primitive) {
  packed_.reset();
  const Json* const draco = file_.extension(primitive, "KHR_draco_mesh_compression");
  if (draco == nullptr) return;
  const auto position = file_.index(primitive.at("attributes"), "POSITION", "accessors");
  if (position && file_.list("accessors")[*position].contains("bufferView")) return;
  const auto ids = draco->find("attributes");
  if (ids == draco->end() || !ids->is_object()) file_.fail("has a mesh packed without attributes");
  const std::string bytes =
      file_.bytes_of_view(file_.required_index(*draco, "bufferView", "bufferViews"));
  try {
    packed_ = {draco_unpacked(bytes), &*ids};
  } catch (const Error& error) {
    file_.fail(std::string("has a mesh that ") + error.what());
  }
  std::size_t numbers = packed_->mesh.corners.size();
  for (const auto& [id, attribute] : packed_->mesh.attributes) numbers += attribute.values.size();
  file_.spend(numbers);
}

/// The numbers of an attribute, vertex after vertex; unset if the mesh lacks it.
std::optional<std::vector<double>> MeshReader::attribute(const Json& attributes,
                                                         const std::string& name,
                                                         std::string_view type) {
  const auto accessor = file_.index(attributes, name.c_str(), "accessors");
  if (!accessor) return std::nullopt;
  if (!packed_ || !packed_->ids->contains(name)) return file_.values(*accessor, type);
  const auto found = packed_->mesh.attributes.find(file_.size(*packed_->ids, name.c_str(), 0));
  if (found == packed_->mesh.attributes.end() ||
      found->second.components != GltfFile::components_of(type))
    file_.fail("has a packed mesh without the attributes it states");
  return file_.as_stated(*accessor, found->second.values);
}

NodeMesh MeshReader::mesh_of(const Json& primitive, std::vector<NodeMesh::Bone> bones,
                             bool skinned) {
  NodeMesh mesh;
  mesh.bones = std::move(bones);
  const auto attributes = primitive.find("attributes");
  if (attributes == primitive.end() || !attributes->is_object()) return mesh;
  unpack(primitive);
  const auto positions = attribute(*attributes, "POSITION", "VEC3");
  if (!positions) return mesh;
  mesh.positions = points_of(*positions);
  if (const auto normals = attribute(*attributes, "NORMAL", "VEC3"))
    mesh.normals = points_of(*normals);
  if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size())
    file_.fail("has a mesh with more or fewer normals than positions");
  read_triangles(primitive, mesh);
  read_material(primitive, mesh);
  if (skinned) read_weights(*attributes, mesh);
  return mesh;
}

void MeshReader::read_triangles(const Json& primitive, NodeMesh& mesh) {
  std::vector<double> corners;
  if (packed_)
    corners.assign(packed_->mesh.corners.begin(), packed_->mesh.corners.end());
  else if (const auto indices = file_.index(primitive, "indices", "accessors"))
    corners = file_.values(*indices, "SCALAR");
  else
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      corners.push_back(static_cast<double>(v));
  const auto count = static_cast<double>(mesh.positions.size());
  if (std::ranges::any_of(corners, [&](double v) { return v < 0 || v >= count; }))
    file_.fail("has a triangle with a vertex that its mesh has not");
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    mesh.triangles.push_back({static_cast<std::uint32_t>(corners[i]),
                              static_cast<std::uint32_t>(corners[i + 1]),
                              static_cast<std::uint32_t>(corners[i + 2])});
}

/// Reads joints and weights, four for each vertex in each set.
void MeshReader::read_weights(const Json& attributes, NodeMesh& mesh) {
  mesh.weights.resize(mesh.positions.size());
  for (int set = 0;; ++set) {
    const std::string number = std::to_string(set);
    const auto joints = attribute(attributes, "JOINTS_" + number, "VEC4");
    const auto weights = attribute(attributes, "WEIGHTS_" + number, "VEC4");
    if (!joints || !weights) return;
    const std::vector<double>& bones = *joints;
    const std::vector<double>& shares = *weights;
    if (bones.size() != 4 * mesh.positions.size() || shares.size() != bones.size())
      file_.fail("has a mesh with more or fewer weights than positions");
    for (std::size_t i = 0; i < bones.size(); ++i) {
      if (!(shares[i] > 0)) continue;
      if (!(bones[i] >= 0 && bones[i] < static_cast<double>(mesh.bones.size())))
        file_.fail("has a vertex on a joint that its skin has not");
      mesh.weights[i / 4].emplace_back(static_cast<std::size_t>(bones[i]), shares[i]);
    }
  }
}

void MeshReader::read_material(const Json& primitive, NodeMesh& mesh) {
  const Json& materials = file_.list(file_.json(), "materials");
  const auto index = file_.index(primitive, "material", "materials");
  if (!index) return;
  const auto surface = materials[*index].find("pbrMetallicRoughness");
  if (surface == materials[*index].end() || !surface->is_object()) return;
  if (const auto texture = surface->find("baseColorTexture");
      texture != surface->end() && texture->is_object())
    lay_picture(*texture, primitive.at("attributes"), mesh);
  const auto factor = file_.numbers(*surface, "baseColorFactor", 4);
  if (factor || mesh.picture)
    mesh.colour = material_colour(factor ? Eigen::Map<const Vector3d>(factor->data()).cast<float>()
                                         : Eigen::Vector3f::Ones().eval(),
                                  mesh.picture != nullptr);
}

void MeshReader::lay_picture(const Json& texture, const Json& attributes, NodeMesh& mesh) {
  const std::size_t textures = file_.list("textures").size();
  const std::size_t index = file_.size(texture, "index", textures);
  const PlaceInPicture place(file_, texture);
  const auto places = attribute(attributes, place.attribute(), "VEC2");
  if (index >= textures || !places) return;
  const auto image = file_.index(file_.list("textures")[index], "source", "images");
  if (!image) return;
  mesh.picture = picture(*image);
  if (!mesh.picture) return;
  const std::vector<double>& values = *places;
  if (values.size() != 2 * mesh.positions.size())
    file_.fail("has a mesh with more or fewer places in its picture than positions");
  for (std::size_t i = 0; i < values.size(); i += 2)
    mesh.in_picture.push_back(place(values[i], values[i + 1]));
}

std::shared_ptr<const SkinPicture> MeshReader::picture(std::size_t number) {
  if (const auto known = pictures_.find(number); known != pictures_.end()) return known->second;
  std::shared_ptr<const SkinPicture>& found = pictures_[number];
  const Json& image = file_.list("images")[number];
  const std::string uri = file_.text(image, "uri");
  std::string name = file_.text(image, "name");
  if (name.empty()) name = uri.empty() || is_data_uri(uri) ? std::to_string(number) : uri;
  try {
    found = picture_of(
        file_.name(), name,
        uri.empty() ? file_.bytes_of_view(file_.required_index(image, "bufferView", "bufferViews"))
                    : file_.resource(uri),
        warnings_);
  } catch (const Error& error) {  // a bad picture is no reason to refuse the mesh
    warnings_.push_back(
        {file_.name(), 0, "the picture " + name + " is not shown: " + error.what()});
  }
  return found;
}

}  // namespace

std::vector<NodeMesh> gltf_meshes(GltfFile& file, const GltfTake& take, Warnings& warnings) {
  return MeshReader(file, take, warnings).read();
}

}  // namespace mocapress
