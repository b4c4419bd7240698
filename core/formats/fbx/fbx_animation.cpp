// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_animation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mocapress {
namespace {

constexpr double kPercent = 0.01;

bool is_of_node(const FbxMovement& movement) {
  return movement.property.starts_with("Lcl ");
}

}  // namespace

std::size_t fbx_axis(std::string_view property) {
  if (property.ends_with("|Y") || property == "Y") return 1;
  if (property.ends_with("|Z") || property == "Z") return 2;
  return 0;
}

Eigen::Vector3d FbxMovement::at(double ticks) const {
  Eigen::Vector3d value = still;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (curves[axis]) value(axis) = curves[axis]->at(ticks);
  return value;
}

bool FbxMovement::moves() const {
  return std::ranges::any_of(curves, [](const auto& curve) { return curve && curve->moves(); });
}

bool FbxMovement::has_keys() const {
  return std::ranges::any_of(curves, [](const auto& curve) { return curve.has_value(); });
}

void add_layered(FbxLayered& movements, const FbxMovement& movement) {
  if (movements.empty() || movements.back()->layer != movement.layer)
    movements.push_back(&movement);
  else if (!movements.back()->has_keys() && movement.has_keys())
    movements.back() = &movement;
}

double FbxLayer::weight_at(double ticks) const {
  return weight_curve ? std::clamp(kPercent * weight_curve->at(ticks), 0.0, 1.0) : weight;
}

double FbxTakeInfo::value_at(const FbxLayered& movements, std::size_t axis, double rest,
                             double ticks) const {
  double value = rest;
  for (const FbxMovement* const movement : movements) {
    const double still = movement->still(axis);
    const auto& curve = movement->curves[axis];
    if (!curve && !std::isfinite(still)) continue;
    const double own = curve ? curve->at(ticks) : still;
    const FbxLayer& layer = layers[movement->layer];
    value = movement->layer == 0 ? own : layer.over(value, own, layer.weight_at(ticks));
  }
  return value;
}

FbxAnimation::FbxAnimation(FbxRecords& records, const FbxObjects& objects, double ticks_per_second)
    : records_(records), objects_(objects), ticks_per_second_(ticks_per_second) {
  if (records.version() >= 7000)
    find_takes();
  else
    find_takes_of_records();
}

void FbxAnimation::find_takes() {
  for (std::size_t o = 0; o < objects_.all().size(); ++o) {
    if (!objects_.is(o, "AnimationStack")) continue;
    FbxTakeInfo take{.name = objects_[o].name, .object = o};
    const FbxProperties properties = objects_.properties(o);
    const auto ticks = [&](const char* name) {
      return std::llround(std::clamp(properties.number(name, 0), -9e18, 9e18));
    };
    if (properties.has("LocalStop") && ticks("LocalStop") > ticks("LocalStart"))
      take.span = {ticks("LocalStart"), ticks("LocalStop")};
    bool any_solo = false;
    for (const FbxLink& link : objects_.children(o)) {
      if (!objects_.is(link.object, "AnimationLayer")) continue;
      take.layers.push_back(layer_of(link.object));
      any_solo |= objects_.properties(link.object).number("Solo", 0) != 0;
    }
    for (FbxLayer& layer : take.layers) {
      const FbxProperties of = objects_.properties(layer.object);
      layer.is_silent = of.number("Mute", 0) != 0 || (any_solo && of.number("Solo", 0) == 0);
    }
    takes_.push_back(std::move(take));
  }
}

void FbxAnimation::find_takes_of_records() {
  const FbxRecord* const list = records_.find(records_.top(), "Takes");
  if (list == nullptr) return;
  for (const FbxRecord* record = records_.first_child(*list); record != nullptr;
       record = records_.next(*record)) {
    if (record->name != "Take") continue;
    FbxTakeInfo take{.layers = {{}}, .record = record};
    if (const auto name = records_.value(*record, 0); name && name->kind == FbxValue::Kind::Text)
      take.name = std::string(name->text);
    const std::vector<std::int64_t> span = records_.integers(*record, "LocalTime");
    if (span.size() == 2 && span[1] > span[0]) take.span = {span[0], span[1]};
    takes_.push_back(std::move(take));
  }
}

FbxLayer FbxAnimation::layer_of(std::size_t object) {
  FbxLayer layer{.object = object};
  const FbxProperties properties = objects_.properties(object);
  const double blend = properties.number("BlendMode", 0);
  layer.blend = blend == 0   ? FbxLayer::Blend::Add
                : blend == 2 ? FbxLayer::Blend::Mix
                             : FbxLayer::Blend::Replace;
  layer.weight = std::clamp(kPercent * properties.number("Weight", 100), 0.0, 1.0);
  layer.turns_by_angle = properties.number("RotationAccumulationMode", 0) != 0;
  layer.scales_by_sum = properties.number("ScaleAccumulationMode", 0) != 0;
  for (const FbxLink& link : objects_.children(object))
    if (link.property == "Weight" && objects_.is(link.object, "AnimationCurveNode"))
      layer.weight_curve = movement_of(link.object, 0).curves[0];
  return layer;
}

/// Reads the movement that a curve node holds, whatever property it moves.
FbxMovement FbxAnimation::movement_of(std::size_t curve_node, std::size_t layer) {
  FbxMovement movement{.layer = layer, .curve_node = curve_node};
  const FbxProperties properties = objects_.properties(curve_node);
  constexpr const char* kAxes[] = {"d|X", "d|Y", "d|Z"};
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    movement.still(axis) = properties.number(kAxes[axis], movement.still(axis));
  for (const FbxLink& link : objects_.children(curve_node)) {
    if (!objects_.is(link.object, "AnimationCurve")) continue;
    FbxCurve curve(records_, *objects_[link.object].record, ticks_per_second_);
    if (!curve.keys().empty()) movement.curves[fbx_axis(link.property)] = std::move(curve);
  }
  return movement;
}

/// Calls `receive` for each movement of a layer until it returns false; returns false if it did.
template <typename Take>
bool FbxAnimation::movements_of_layer(const FbxTakeInfo& take, std::size_t layer,
                                      const Take& receive) {
  for (const FbxLink& link : objects_.children(take.layers[layer].object)) {
    if (!objects_.is(link.object, "AnimationCurveNode")) continue;
    std::vector<const FbxLink*> moved;
    for (const FbxLink& parent : objects_.parents(link.object))
      if (!parent.property.empty() && !objects_.is(parent.object, "AnimationLayer"))
        moved.push_back(&parent);
    if (moved.empty()) continue;
    FbxMovement read = movement_of(link.object, layer);
    for (const FbxLink* const parent : moved) {
      FbxMovement movement = parent == moved.back() ? std::move(read) : read;
      movement.object = parent->object;
      movement.property = parent->property;
      if (!receive(std::move(movement))) return false;
    }
  }
  return true;
}

std::optional<FbxCurve> FbxAnimation::curve_of(const FbxRecord& channel) {
  FbxCurve curve = FbxCurve::of_channel(records_, channel, ticks_per_second_);
  return curve.keys().empty() ? std::nullopt : std::optional(std::move(curve));
}

/// Reads a take of version 6, whose records nest by node, transform, property and axis:
/// Model: "Model::Hips" { Channel: "Transform" { Channel: "T" { Channel: "X" { keys } } } }
template <typename Take>
bool FbxAnimation::movements_of_record(const FbxTakeInfo& take, const Take& receive) {
  const auto name_of = [&](const FbxRecord& channel) -> std::string {
    const auto name = records_.value(channel, 0);
    return name && name->kind == FbxValue::Kind::Text ? std::string(name->text) : std::string();
  };
  const auto for_each_channel = [&](const FbxRecord& in, const auto& receive_channel) {
    for (const FbxRecord* channel = records_.first_child(in); channel != nullptr;
         channel = records_.next(*channel))
      if (channel->name == "Channel" && !receive_channel(*channel, name_of(*channel))) return false;
    return true;
  };
  /// Receives the movement of a property of one number or of three axes.
  const auto receive_property = [&](std::size_t object, const FbxRecord& channel,
                                    const std::string& property) {
    FbxMovement movement{.object = object, .property = property};
    const auto default_of = [&](const FbxRecord& of) {
      const std::vector<double> number = records_.numbers(of, "Default");
      return number.empty() ? std::numeric_limits<double>::quiet_NaN() : number[0];
    };
    bool any = false;
    if (records_.find(channel, "Key") != nullptr) {
      movement.curves[0] = curve_of(channel);
      any = movement.curves[0].has_value();
    }
    for_each_channel(channel, [&](const FbxRecord& axis, const std::string& name) {
      const std::size_t a = fbx_axis(name);
      movement.still(a) = default_of(axis);
      movement.curves[a] = curve_of(axis);
      any = true;  // a channel without keys keeps its default in this take
      return true;
    });
    return !any || receive(std::move(movement));
  };
  for (const FbxRecord* record = records_.first_child(*take.record); record != nullptr;
       record = records_.next(*record)) {
    const auto full_name = records_.value(*record, 0);
    if (!full_name || full_name->kind != FbxValue::Kind::Text) continue;
    const FbxName name = fbx_name(full_name->text);
    const auto object = objects_.named(name.type + "::" + name.name);
    if (!object) continue;
    const bool goes_on =
        for_each_channel(*record, [&](const FbxRecord& channel, const std::string& property) {
          if (property != "Transform") return receive_property(*object, channel, property);
          return for_each_channel(channel, [&](const FbxRecord& part, const std::string& letter) {
            const std::string of = letter == "T"   ? "Lcl Translation"
                                   : letter == "R" ? "Lcl Rotation"
                                   : letter == "S" ? "Lcl Scaling"
                                                   : letter;
            return receive_property(*object, part, of);
          });
        });
    if (!goes_on) return false;
  }
  return true;
}

template <typename Take>
void FbxAnimation::for_each_movement(const FbxTakeInfo& take, const Take& receive) {
  if (take.record != nullptr) {
    movements_of_record(take, receive);
    return;
  }
  for (std::size_t layer = 0; layer < take.layers.size(); ++layer)
    if (!take.layers[layer].is_silent && !movements_of_layer(take, layer, receive)) return;
}

std::vector<FbxMovement> FbxAnimation::movements(std::size_t take) {
  std::vector<FbxMovement> movements;
  for_each_movement(takes_[take], [&](FbxMovement&& movement) {
    movements.push_back(std::move(movement));
    return true;
  });
  return movements;
}

bool FbxAnimation::moves(std::size_t take, bool nodes) {
  bool moves = false;
  for_each_movement(takes_[take], [&](FbxMovement&& movement) {
    moves = (!nodes || is_of_node(movement)) && movement.moves();
    return !moves;
  });
  return moves;
}

bool FbxAnimation::has_keys(std::size_t take) {
  bool has = false;
  for_each_movement(takes_[take], [&](FbxMovement&& movement) {
    has = movement.has_keys();
    return !has;
  });
  return has;
}

}  // namespace mocapress
