// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_curve_output.h"

namespace mocapress {
namespace {

/// The usual name of a property's curve node.
std::string_view node_name(std::string_view property) {
  if (property == "Lcl Translation") return "T";
  if (property == "Lcl Rotation") return "R";
  if (property == "Lcl Scaling") return "S";
  return property;
}

}  // namespace

FbxOutRecord& FbxCurveOutput::object(std::string_view type, std::int64_t id, std::string_view name,
                                     std::string_view kind) {
  objects_.push_back({.name = std::string(type)});
  return objects_.back().value(id).value(name).value(kind);
}

void FbxCurveOutput::connect(std::int64_t child, std::int64_t parent, std::string_view property) {
  connections_.push_back({.name = "C"});
  FbxOutRecord& connection = connections_.back();
  connection.value(std::string_view(property.empty() ? "OO" : "OP")).value(child).value(parent);
  if (!property.empty()) connection.value(property);
}

std::list<FbxOutRecord> FbxCurveOutput::keys(const std::vector<float>& values, bool steps) const {
  constexpr std::int32_t kConstant = 2;
  constexpr std::int32_t kLinear = 4;
  FbxOutRecord curve;
  curve.record("KeyTime").array(key_ticks_);
  curve.record("KeyValueFloat").array(values);
  // All keys share one interpolation without tangents.
  curve.record("KeyAttrFlags").array(std::vector<std::int32_t>{steps ? kConstant : kLinear});
  curve.record("KeyAttrDataFloat").array(std::vector<float>(4, 0.0F));
  curve.record("KeyAttrRefCount")
      .array(std::vector<std::int32_t>{static_cast<std::int32_t>(values.size())});
  return std::move(curve.records);
}

void FbxCurveOutput::add_curve(std::int64_t node, std::string_view axis,
                               const std::vector<float>& values, bool steps) {
  const std::int64_t id = new_id();
  FbxOutRecord& curve = object("AnimationCurve", id, fbx_full_name("", "AnimCurve"), "");
  curve.field("Default", static_cast<double>(values.front()));
  curve.field("KeyVer", std::int32_t{4008});
  curve.records.splice(curve.records.end(), keys(values, steps));
  connect(id, node, axis);
}

std::int64_t FbxCurveOutput::add_node(std::int64_t layer, std::int64_t object_id,
                                      std::string_view property,
                                      const std::vector<std::string>& axes,
                                      const std::vector<float>& at_first) {
  const std::int64_t node = new_id();
  FbxOutRecord& all =
      object("AnimationCurveNode", node, fbx_full_name(node_name(property), "AnimCurveNode"), "")
          .record("Properties70");
  for (std::size_t a = 0; a < axes.size(); ++a)
    all.property(axes[a], "Number", "", "A").value(static_cast<double>(at_first[a]));
  connect(node, layer);
  connect(node, object_id, property);
  return node;
}

void FbxCurveOutput::add(std::int64_t layer, std::int64_t object_id, std::string_view property,
                         const std::array<std::vector<float>, 3>& values,
                         const std::array<bool, 3>& steps) {
  const std::int64_t node =
      add_node(layer, object_id, property, {kFbxCurveAxes.begin(), kFbxCurveAxes.end()},
               {values[0].front(), values[1].front(), values[2].front()});
  for (std::size_t a = 0; a < 3; ++a) add_curve(node, kFbxCurveAxes[a], values[a], steps[a]);
}

void FbxCurveOutput::add(std::int64_t layer, std::int64_t object_id, std::string_view property,
                         const std::vector<float>& values, bool steps) {
  const std::string axis = "d|" + std::string(property);
  const std::int64_t node = add_node(layer, object_id, property, {axis}, {values.front()});
  add_curve(node, axis, values, steps);
}

}  // namespace mocapress
