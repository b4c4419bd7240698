// SPDX-License-Identifier: MIT
// Animation curves for an FBX file to be written, with a key for each frame.
#pragma once

#include <array>
#include <cstdint>
#include <list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/fbx/fbx_output.h"

namespace mocapress {

class FbxCurveOutput {
 public:
  /// Numbers the objects from `first_id` on.
  FbxCurveOutput(std::vector<std::int64_t> key_ticks, std::list<FbxOutRecord>& objects,
                 std::list<FbxOutRecord>& connections, std::int64_t first_id)
      : key_ticks_(std::move(key_ticks)),
        objects_(objects),
        connections_(connections),
        next_id_(first_id) {}

  std::int64_t new_id() { return next_id_++; }
  /// Sets the key times of the curves that are added from now on.
  void set_key_ticks(std::vector<std::int64_t> ticks) { key_ticks_ = std::move(ticks); }
  FbxOutRecord& object(std::string_view type, std::int64_t id, std::string_view name,
                       std::string_view kind);
  /// Connects an object to another one, or to a property of it.
  void connect(std::int64_t child, std::int64_t parent, std::string_view property = {});

  /// Adds curves for a property of three numbers.
  void add(std::int64_t layer, std::int64_t object, std::string_view property,
           const std::array<std::vector<float>, 3>& values, const std::array<bool, 3>& steps = {});
  /// Adds a curve for a property of one number.
  void add(std::int64_t layer, std::int64_t object, std::string_view property,
           const std::vector<float>& values, bool steps);
  /// Adds a curve to an existing curve node.
  void add_curve(std::int64_t node, std::string_view axis, const std::vector<float>& values,
                 bool steps);

  /// The records of a curve's keys, with linear or constant interpolation.
  std::list<FbxOutRecord> keys(const std::vector<float>& values, bool steps) const;

 private:
  std::int64_t add_node(std::int64_t layer, std::int64_t object, std::string_view property,
                        const std::vector<std::string>& axes, const std::vector<float>& at_first);

  std::vector<std::int64_t> key_ticks_;
  std::list<FbxOutRecord>& objects_;
  std::list<FbxOutRecord>& connections_;
  std::int64_t next_id_;
};

/// The names of the three axes in connections of curves.
inline constexpr std::array<std::string_view, 3> kFbxCurveAxes = {"d|X", "d|Y", "d|Z"};

}  // namespace mocapress
