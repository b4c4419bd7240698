// SPDX-License-Identifier: MIT
// The objects of an FBX file (nodes, meshes, deformers, takes, curves), their properties and
// connections. Version 6 identifies objects by name, later versions by number.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/formats/fbx/fbx_records.h"

namespace mocapress {

/// Named values of an object. Missing ones come from the template of the object's type.
class FbxProperties {
 public:
  FbxProperties() = default;
  FbxProperties(const FbxRecords& records, const FbxRecord& object, const FbxProperties* defaults);

  bool has(std::string_view name) const { return find(name) != nullptr; }
  double number(std::string_view name, double otherwise) const;
  Eigen::Vector3d vector(std::string_view name, const Eigen::Vector3d& otherwise) const;
  /// True if a user made the property ('U' among its flags).
  bool is_custom(std::string_view name) const;

 private:
  /// The values that follow a property's name, types and flags.
  std::vector<FbxValue> values(std::string_view name) const;
  const FbxRecord* find(std::string_view name) const;

  const FbxRecords* records_ = nullptr;
  std::unordered_map<std::string_view, const FbxRecord*> own_;
  std::size_t first_value_ = 4;
  const FbxProperties* defaults_ = nullptr;
};

struct FbxObject {
  std::string type;  // the record's name: Model, Geometry, Deformer, AnimationCurve, ...
  std::string name;
  std::string kind;  // LimbNode, Mesh, Skin, ...
  const FbxRecord* record = nullptr;
};

struct FbxLink {
  std::size_t object = 0;
  std::string property;  // the parent's property; empty: the whole object
};

class FbxObjects {
 public:
  static constexpr std::size_t kScene = 0;  // parent of the topmost nodes

  explicit FbxObjects(FbxRecords& records);

  const std::vector<FbxObject>& all() const { return objects_; }
  const FbxObject& operator[](std::size_t object) const { return objects_[object]; }
  bool is(std::size_t object, std::string_view type) const { return objects_[object].type == type; }
  /// Links to children in the order of the file.
  const std::vector<FbxLink>& children(std::size_t object) const { return children_[object]; }
  const std::vector<FbxLink>& parents(std::size_t object) const { return parents_[object]; }
  /// The first child of the given type.
  std::optional<std::size_t> child(std::size_t object, std::string_view type) const;

  FbxProperties properties(std::size_t object) const;
  const FbxProperties& settings() const { return settings_; }  // settings of the file
  /// The number of connections that repeat an earlier one.
  int repeated_connections() const { return repeated_connections_; }

  /// Finds an object of a version 6 file by a name such as "Model::Top".
  std::optional<std::size_t> named(std::string_view full_name) const;

 private:
  void read_templates();
  void read_objects();
  void read_connections();
  std::optional<std::size_t> resolve(const FbxValue& value) const;

  FbxRecords& records_;
  std::vector<FbxObject> objects_;
  std::vector<std::vector<FbxLink>> children_;
  std::vector<std::vector<FbxLink>> parents_;
  std::unordered_map<std::int64_t, std::size_t> by_id_;
  std::unordered_map<std::string, std::size_t> by_name_;         // "Model::Top"
  std::map<std::string, FbxProperties, std::less<>> templates_;  // by type
  FbxProperties settings_;
  int repeated_connections_ = 0;
};

}  // namespace mocapress
