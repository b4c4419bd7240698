// SPDX-License-Identifier: MIT
// Animation curves on their way into an FBX file: a key each frame.
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
  /// Objects get numbers from `first_id` on.
  FbxCurveOutput(std::vector<std::int64_t> key_ticks, std::list<FbxOutRecord>& objects,
                 std::list<FbxOutRecord>& connections, std::int64_t first_id)
      : key_ticks_(std::move(key_ticks)),
        objects_(objects),
        connections_(connections),
        next_id_(first_id) {}

  std::int64_t new_id() { return next_id_++; }
  FbxOutRecord& object(std::string_view type, std::int64_t id, std::string_view name,
                       std::string_view kind);
  /// An object to another, or to its property.
  void connect(std::int64_t child, std::int64_t parent, std::string_view property = {});

  /// A property of three numbers.
  void add(std::int64_t layer, std::int64_t object, std::string_view property,
           const std::array<std::vector<float>, 3>& values);
  /// A property of one number.
  void add(std::int64_t layer, std::int64_t object, std::string_view property,
           const std::vector<float>& values, bool steps);
  /// A curve of a curve node that is there.
  void add_curve(std::int64_t node, std::string_view axis, const std::vector<float>& values,
                 bool steps);

  /// The records of a curve that hold its keys, straight from one to the next or in steps.
  std::list<FbxOutRecord> keys(const std::vector<float>& values, bool steps) const;

 private:
  std::int64_t add_node(std::int64_t layer, std::int64_t object, std::string_view property,
                        const std::vector<std::string>& axes, const std::vector<float>& at_first);

  std::vector<std::int64_t> key_ticks_;
  std::list<FbxOutRecord>& objects_;
  std::list<FbxOutRecord>& connections_;
  std::int64_t next_id_;
};

/// The axes of a property of three numbers, as curves are connected to it.
inline constexpr std::array<std::string_view, 3> kFbxCurveAxes = {"d|X", "d|Y", "d|Z"};

}  // namespace mocapress
