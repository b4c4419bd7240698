// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_meshes.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>

#include "core/base/base64.h"
#include "core/base/file.h"
#include "core/base/path_kind.h"
#include "core/base/utf8_path.h"

namespace mocapress {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

constexpr std::size_t kMostCorners = 4'000'000;  // polygon corners in all meshes
constexpr std::size_t kMostWeights = 32'000'000;

/// Makes a transform from column-major numbers, as FBX stores them.
Affine3d affine_of(const std::vector<double>& numbers) {
  return Affine3d(Eigen::Map<const Eigen::Matrix4d>(numbers.data()));
}

bool is_matrix(const std::vector<double>& numbers) {
  return numbers.size() == 16 &&
         std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

/// A corner of a polygon.
struct Corner {
  std::uint32_t point = 0;
  Vector3d normal = Vector3d::Zero();
  Eigen::Vector2d in_picture = Eigen::Vector2d::Zero();

  bool operator==(const Corner&) const = default;
};

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::size_t hash = corner.point;
    for (const double value : {corner.normal.x(), corner.normal.y(), corner.normal.z(),
                               corner.in_picture.x(), corner.in_picture.y()})
      hash = hash * 1'000'003 + std::hash<double>()(value);
    return hash;
  }
};

/// Values of a mesh by point, corner, polygon or as a whole: a LayerElement of the file.
class LayerElement {
 public:
  LayerElement() = default;
  LayerElement(FbxRecords& records, const FbxRecord& geometry, const char* name, const char* values,
               const char* indices, std::size_t width)
      : width_(width) {
    const FbxRecord* const element = records.find(geometry, name);
    if (element == nullptr) return;
    values_ = records.numbers(*element, values);
    indices_ = records.integers(*element, indices);
    const std::string mapping = records.text(*element, "MappingInformationType");
    if (mapping == "ByPolygonVertex")
      by_ = By::Corner;
    else if (mapping == "ByVertice" || mapping == "ByVertex" || mapping == "ByControlPoint")
      by_ = By::Point;
    else if (mapping == "ByPolygon")
      by_ = By::Polygon;
    else if (mapping == "AllSame")
      by_ = By::Whole;
    else
      values_.clear();
  }

  bool empty() const { return values_.empty() && indices_.empty(); }
  const std::vector<std::int64_t>& indices() const { return indices_; }

  /// A corner's values, `width_` of them; null: the file has too few values.
  const double* at(std::size_t corner, std::size_t point, std::size_t polygon) const {
    std::size_t place = by_ == By::Corner    ? corner
                        : by_ == By::Point   ? point
                        : by_ == By::Polygon ? polygon
                                             : 0;
    if (!indices_.empty()) {
      if (place >= indices_.size() || indices_[place] < 0) return nullptr;
      place = static_cast<std::size_t>(indices_[place]);
    }
    return place < values_.size() / width_ ? &values_[width_ * place] : nullptr;
  }

 private:
  enum class By { Corner, Point, Polygon, Whole };

  std::size_t width_ = 1;
  std::vector<double> values_;
  std::vector<std::int64_t> indices_;
  By by_ = By::Corner;
};

class FbxMeshReader {
 public:
  FbxMeshReader(FbxFile& file, const FbxTake& take, Warnings& warnings)
      : file_(file),
        records_(file.records),
        objects_(file.objects),
        take_(take),
        warnings_(warnings) {}

  std::vector<NodeMesh> read();

 private:
  struct Material {
    Eigen::Vector3f colour = kPlainSkin;
    std::shared_ptr<const SkinPicture> picture;
  };

  void read_mesh(std::size_t model, std::size_t geometry);
  void bind(std::size_t model, std::size_t geometry, NodeMesh& mesh);
  void hang(std::size_t model, NodeMesh& mesh) const;
  void read_weights(const FbxRecord& cluster, std::size_t bone, NodeMesh& mesh);
  Affine3d file_from_node(std::size_t model) const;
  Material material_of(std::size_t material, std::size_t model);
  std::optional<std::size_t> texture_of(std::size_t material, std::size_t model) const;
  std::shared_ptr<const SkinPicture> picture_of_texture(std::size_t texture);
  std::shared_ptr<const SkinPicture> read_picture(const std::string& stated, std::size_t texture);

  FbxFile& file_;
  FbxRecords& records_;
  const FbxObjects& objects_;
  const FbxTake& take_;
  Warnings& warnings_;
  std::map<std::string, std::shared_ptr<const SkinPicture>> pictures_;
  std::vector<NodeMesh> meshes_;
  std::size_t corners_ = 0;
  std::size_t weights_ = 0;
};

std::vector<NodeMesh> FbxMeshReader::read() {
  for (std::size_t o = 1; o < objects_.all().size(); ++o) {
    if (!objects_.is(o, "Model")) continue;
    const FbxRecord& record = *objects_[o].record;
    if (records_.find(record, "PolygonVertexIndex") != nullptr) read_mesh(o, o);  // version 6
    for (const FbxLink& link : objects_.children(o))
      if (objects_.is(link.object, "Geometry") && objects_[link.object].kind == "Mesh")
        read_mesh(o, link.object);
  }
  return std::move(meshes_);
}

/// Reads a mesh. Each different combination of point, normal and texture coordinate that some
/// polygon uses becomes a vertex; polygons become triangle fans.
void FbxMeshReader::read_mesh(std::size_t model, std::size_t geometry) {
  const FbxRecord& record = *objects_[geometry].record;
  const std::vector<double> points = records_.numbers(record, "Vertices");
  const std::vector<std::int64_t> ends = records_.integers(record, "PolygonVertexIndex");
  if (points.empty() || ends.empty()) return;
  corners_ += ends.size();
  if (corners_ > kMostCorners)
    records_.fail("has meshes of more than " + std::to_string(kMostCorners) + " corners");
  const std::size_t count = points.size() / 3;
  const LayerElement normals(records_, record, "LayerElementNormal", "Normals", "NormalsIndex", 3);
  const LayerElement places(records_, record, "LayerElementUV", "UV", "UVIndex", 2);
  const LayerElement of_polygon(records_, record, "LayerElementMaterial", "Materials", "", 1);

  NodeMesh bound;  // bones, and a weight for each point of the file
  for (std::size_t p = 0; p < count; ++p) bound.positions.emplace_back(&points[3 * p]);
  bind(model, geometry, bound);
  if (bound.bones.empty()) return;
  std::vector<std::size_t> materials;
  for (const FbxLink& link : objects_.children(model))
    if (objects_.is(link.object, "Material")) materials.push_back(link.object);

  struct Part {
    NodeMesh mesh;
    std::unordered_map<Corner, std::uint32_t, CornerHash> known;
  };
  std::map<std::size_t, Part> parts;  // by material number
  std::size_t polygon = 0;
  std::size_t first = 0;
  for (std::size_t c = 0; c < ends.size(); ++c) {
    if (ends[c] >= 0 && c + 1 < ends.size()) continue;
    const double* const stated = of_polygon.at(first, 0, polygon);
    const bool is_number =
        stated != nullptr && *stated >= 0 && *stated < static_cast<double>(materials.size());
    const std::size_t material = is_number ? static_cast<std::size_t>(*stated) : 0;
    Part& part = parts[material];
    std::vector<std::uint32_t> fan;
    for (std::size_t k = first; k <= c; ++k) {
      const std::int64_t index = ends[k] < 0 ? -(ends[k] + 1) : ends[k];
      if (index >= static_cast<std::int64_t>(count))
        records_.fail(record, "has a polygon with a point that its mesh has not");
      Corner corner{.point = static_cast<std::uint32_t>(index)};
      if (const double* const normal = normals.at(k, corner.point, polygon))
        corner.normal = Vector3d(normal);
      if (const double* const place = places.at(k, corner.point, polygon))
        corner.in_picture = {place[0], 1 - place[1]};  // in FBX the origin is at the lower left
      const auto [known, is_new] =
          part.known.emplace(corner, static_cast<std::uint32_t>(part.mesh.positions.size()));
      if (is_new) {
        part.mesh.positions.push_back(bound.positions[corner.point]);
        part.mesh.normals.push_back(corner.normal);
        part.mesh.in_picture.push_back(corner.in_picture);
        if (!bound.weights.empty()) part.mesh.weights.push_back(bound.weights[corner.point]);
      }
      fan.push_back(known->second);
    }
    for (std::size_t k = 2; k < fan.size(); ++k)
      part.mesh.triangles.push_back({fan[0], fan[k - 1], fan[k]});
    first = c + 1;
    ++polygon;
  }
  for (auto& [number, part] : parts) {
    NodeMesh& mesh = part.mesh;
    mesh.bones = bound.bones;
    mesh.file_from_mesh = bound.file_from_mesh;
    if (normals.empty()) mesh.normals.clear();
    Material material;
    if (number < materials.size()) material = material_of(materials[number], model);
    mesh.colour = material.colour;
    if (!places.empty()) mesh.picture = material.picture;
    if (!mesh.picture) mesh.in_picture.clear();
    meshes_.push_back(std::move(mesh));
  }
}

/// Binds the mesh by its skin's clusters, or else to the node that draws it.
void FbxMeshReader::bind(std::size_t model, std::size_t geometry, NodeMesh& mesh) {
  const Affine3d node_from_mesh = fbx_geometric_transform(objects_.properties(model));
  for (const FbxLink& skin : objects_.children(geometry)) {
    if (objects_[skin.object].kind != "Skin") continue;
    for (const FbxLink& cluster : objects_.children(skin.object)) {
      const FbxObject& of = objects_[cluster.object];
      const auto bone = objects_.child(cluster.object, "Model");
      const int node = bone ? take_.node_of_object[*bone] : -1;
      if (of.kind != "Cluster" || node < 0) continue;
      const std::vector<double> transform = records_.numbers(*of.record, "Transform");
      const std::vector<double> link = records_.numbers(*of.record, "TransformLink");
      Affine3d bone_from_node = Affine3d::Identity();
      if (is_matrix(transform))
        bone_from_node = affine_of(transform);
      else if (is_matrix(link) && std::abs(affine_of(link).linear().determinant()) > 1e-12)
        bone_from_node = affine_of(link).inverse() * file_from_node(model);
      mesh.bones.push_back({node, bone_from_node * node_from_mesh});
      if (is_matrix(link) && !mesh.file_from_mesh)
        mesh.file_from_mesh = Affine3d(take_.take.nodes.front().rest.rotation.toRotationMatrix()) *
                              affine_of(link) * bone_from_node * node_from_mesh;
      mesh.weights.resize(mesh.positions.size());
      read_weights(*of.record, mesh.bones.size() - 1, mesh);
    }
  }
  if (!mesh.bones.empty()) return;
  hang(model, mesh);
  for (NodeMesh::Bone& bone : mesh.bones)
    bone.node_from_mesh = bone.node_from_mesh * node_from_mesh;
}

/// Attaches the mesh of a node outside the take to its nearest ancestor in the take.
void FbxMeshReader::hang(std::size_t model, NodeMesh& mesh) const {
  Affine3d carrier_from_node = Affine3d::Identity();
  std::size_t at = model;
  for (int steps = 0; take_.node_of_object[at] < 0; ++steps) {
    const LocalTransform local = FbxTransform(objects_.properties(at)).local();
    Affine3d parent_from_node = Affine3d::Identity();
    parent_from_node.translate(local.translation).rotate(local.rotation).scale(local.scale);
    carrier_from_node = parent_from_node * carrier_from_node;
    const auto& parents = objects_.parents(at);
    const auto above = std::ranges::find_if(parents, [&](const FbxLink& link) {
      return link.property.empty() && objects_.is(link.object, "Model");
    });
    if (steps > 1000) return;
    at = above != parents.end() ? above->object : FbxObjects::kScene;
  }
  mesh.bones = {{take_.node_of_object[at], carrier_from_node}};
}

void FbxMeshReader::read_weights(const FbxRecord& cluster, std::size_t bone, NodeMesh& mesh) {
  const std::vector<std::int64_t> points = records_.integers(cluster, "Indexes");
  const std::vector<double> weights = records_.numbers(cluster, "Weights");
  if (points.size() != weights.size())
    records_.fail(cluster, "has a bone with more or fewer weights than points");
  weights_ += points.size();
  if (weights_ > kMostWeights)
    records_.fail("has more than " + std::to_string(kMostWeights) + " weights");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] < 0 || points[i] >= std::ssize(mesh.positions))
      records_.fail(cluster, "has a bone with a weight of a point that its mesh has not");
    if (weights[i] > 0) mesh.weights[points[i]].emplace_back(bone, weights[i]);
  }
}

/// The node's transform at rest.
Affine3d FbxMeshReader::file_from_node(std::size_t model) const {
  NodeMesh on;
  hang(model, on);
  if (on.bones.empty()) return Affine3d::Identity();
  std::vector<NodePlacement> placements;
  const NodePlacement file = file_placement(1, UpAxis::Y);
  for (const AnimatedNode& node : take_.take.nodes)
    placements.push_back(below(node.parent < 0 ? file : placements[node.parent], node.rest));
  const NodePlacement& carrier = placements[on.bones.front().node];
  Affine3d file_from_carrier(carrier.world_from_node);
  file_from_carrier.translation() = carrier.origin;
  return file_from_carrier * on.bones.front().node_from_mesh;
}

FbxMeshReader::Material FbxMeshReader::material_of(std::size_t object, std::size_t model) {
  Material material;
  if (const auto texture = texture_of(object, model))
    material.picture = picture_of_texture(*texture);
  const FbxProperties properties = objects_.properties(object);
  const char* const name = properties.has("DiffuseColor") ? "DiffuseColor" : "Diffuse";
  // With a picture, ignores the material's colour: programs write any grey there.
  if (material.picture) {
    material.colour = material_colour(Eigen::Vector3f::Ones(), true);
  } else if (properties.has(name)) {
    const double factor =
        properties.has("DiffuseColor") ? properties.number("DiffuseFactor", 1) : 1;
    material.colour =
        material_colour((factor * properties.vector(name, Vector3d::Ones())).cast<float>(), false);
  }
  return material;
}

/// The texture of the material's colour or else, as in version 6, of the node.
std::optional<std::size_t> FbxMeshReader::texture_of(std::size_t material,
                                                     std::size_t model) const {
  constexpr std::string_view kColours[] = {"DiffuseColor", "Maya|baseColor", "Maya|base_color_map",
                                           "3dsMax|Parameters|base_color_map",
                                           "Maya|TEX_color_map"};
  for (const std::string_view property : kColours)
    for (const FbxLink& link : objects_.children(material))
      if (link.property == property && objects_.is(link.object, "Texture")) return link.object;
  return objects_.child(model, "Texture");
}

std::shared_ptr<const SkinPicture> FbxMeshReader::picture_of_texture(std::size_t texture) {
  std::string stated = records_.text(*objects_[texture].record, "RelativeFilename");
  if (stated.empty()) stated = records_.text(*objects_[texture].record, "FileName");
  if (const auto known = pictures_.find(stated); known != pictures_.end()) return known->second;
  return pictures_[stated] = read_picture(stated, texture);
}

std::shared_ptr<const SkinPicture> FbxMeshReader::read_picture(const std::string& stated,
                                                               std::size_t texture) {
  const std::string& file = records_.file();
  // Paths come from another machine, so only the file name counts.
  const std::string name = stated.substr(stated.find_last_of("/\\") + 1);
  if (const auto video = objects_.child(texture, "Video"))
    if (const FbxRecord* const content = records_.find(*objects_[*video].record, "Content")) {
      std::string bytes;
      for (const FbxValue& value : records_.values(*content))
        if (value.kind == FbxValue::Kind::Text)
          bytes += records_.is_binary() ? std::string(value.text) : bytes_of_base64(value.text);
      if (!bytes.empty()) return picture_of(file, stated, std::move(bytes), warnings_);
    }
  const std::filesystem::path folder = utf8_path(file).parent_path();
  const std::filesystem::path beside = (folder.empty() ? "." : folder) / utf8_path(name);
  const auto place = real_path(beside);
  if (!name.empty() && place && path_kind(*place) == PathKind::File &&
      place->parent_path() == real_path(beside.parent_path()))
    return picture_of(file, name, read_text(beside), warnings_);
  warnings_.push_back(
      {file, 0, "the picture " + name + " is not shown: it is not beside the file"});
  return nullptr;
}

}  // namespace

std::vector<NodeMesh> fbx_meshes(FbxFile& file, const FbxTake& take, Warnings& warnings) {
  return FbxMeshReader(file, take, warnings).read();
}

const FbxRecord* fbx_shape_named(const FbxRecords& records, const FbxRecord& model,
                                 std::string_view name) {
  for (const FbxRecord* record = records.first_child(model); record != nullptr;
       record = records.next(*record))
    if (record->name == "Shape")
      if (const auto stated = records.value(*record, 0); stated && stated->text == name)
        return record;
  return nullptr;
}

}  // namespace mocapress
