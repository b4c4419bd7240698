// SPDX-License-Identifier: MIT
// The takes of an FBX file: layers of curves that move properties of objects. Version 7 stores them
// as objects, version 6 as records by name.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/fbx/fbx_curves.h"
#include "core/formats/fbx/fbx_objects.h"

namespace mocapress {

/// One layer's movement of one property.
struct FbxMovement {
  std::size_t object = 0;
  std::string property;  // "Lcl Rotation", "DeformPercent", ...
  std::size_t layer = 0;
  std::size_t curve_node = 0;  // version 7: the node that holds the curves
  // Values of axes without a curve; NaN: the axis keeps its value at rest.
  Eigen::Vector3d still = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::array<std::optional<FbxCurve>, 3> curves;  // a single number uses the first

  Eigen::Vector3d at(double ticks) const;
  bool moves() const;
  bool has_keys() const;
};

/// The movements of one property in ascending order of layers, at most one for each layer.
using FbxLayered = std::vector<const FbxMovement*>;

/// Adds a movement, whose layer must be that of the last one or higher. Of two on the same layer,
/// keeps the first that has keys, or else the first.
void add_layered(FbxLayered& movements, const FbxMovement& movement);

struct FbxLayer {
  enum class Blend { Add, Replace, Mix };

  Blend blend = Blend::Add;
  double weight = 1;
  std::optional<FbxCurve> weight_curve;  // percent
  bool turns_by_angle = false;           // true: layers add angles; false: they combine rotations
  bool scales_by_sum = false;            // true: layers add scales; false: they multiply them
  bool is_silent = false;
  std::size_t object = 0;  // version 7

  double weight_at(double ticks) const;
  /// Combines the value of the layers below with this layer's `own` by the blend mode and the
  /// layer's weight at that time.
  template <typename Value>
  Value over(const Value& below, const Value& own, double at_weight) const {
    if (blend == Blend::Replace) return own;
    if (blend == Blend::Add) return below + at_weight * own;
    return (1 - at_weight) * below + at_weight * own;
  }
};

struct FbxTakeInfo {
  std::string name;
  std::optional<std::pair<std::int64_t, std::int64_t>> span;  // ticks
  std::vector<FbxLayer> layers;
  std::size_t object = 0;             // version 7
  const FbxRecord* record = nullptr;  // version 6

  /// The value of an axis after all layers; the first layer replaces the value at rest.
  double value_at(const FbxLayered& movements, std::size_t axis, double rest, double ticks) const;
};

/// The axis that a curve moves: 1 for "d|Y" or "Y", 2 for "d|Z" or "Z", else 0, also for a property
/// of one number.
std::size_t fbx_axis(std::string_view property);

class FbxAnimation {
 public:
  FbxAnimation(FbxRecords& records, const FbxObjects& objects, double ticks_per_second);

  const std::vector<FbxTakeInfo>& takes() const { return takes_; }

  /// All movements of a take, layer by layer.
  std::vector<FbxMovement> movements(std::size_t take);
  /// True if the take moves a node or, with `nodes` false, moves anything. Stops at the first
  /// movement found.
  bool moves(std::size_t take, bool nodes);
  /// True if the take has a curve with a key. Stops at the first such curve.
  bool has_keys(std::size_t take);

 private:
  template <typename Take>
  void for_each_movement(const FbxTakeInfo& take, const Take& receive);
  template <typename Take>
  bool movements_of_layer(const FbxTakeInfo& take, std::size_t layer, const Take& receive);
  template <typename Take>
  bool movements_of_record(const FbxTakeInfo& take, const Take& receive);
  FbxMovement movement_of(std::size_t curve_node, std::size_t layer);
  void find_takes();
  void find_takes_of_records();
  FbxLayer layer_of(std::size_t object);
  std::optional<FbxCurve> curve_of(const FbxRecord& channel);

  FbxRecords& records_;
  const FbxObjects& objects_;
  double ticks_per_second_;
  std::vector<FbxTakeInfo> takes_;
};

}  // namespace mocapress
