// SPDX-License-Identifier: MIT
// The local transforms of a node, at rest and frame by frame.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mocapress {

/// Ways in which a node inherits its parent's scale. The node's translation is scaled in any case.
enum class ScaleOfParent : std::uint8_t {
  Whole,   // glTF, and FBX's RSrs: the parent's full scale, which shears turned nodes
  ByAxis,  // FBX's RrSs: scales multiply axis by axis and apply before all rotations
  None     // FBX's Rrs: no scale, as with Maya's segment scale compensation
};

/// x_in_parent = translation + rotation * scale * x_in_node, in the file's unit, if `inherit` is
/// Whole.
struct LocalTransform {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  // any length except 0
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  ScaleOfParent inherit = ScaleOfParent::Whole;
};

/// One transform for each frame. A part that stays the same is stored once: most nodes only turn.
class LocalFrames {
 public:
  LocalFrames() = default;
  LocalFrames(const std::vector<LocalTransform>& frames) {  // NOLINT: implicit on purpose
    reserve(frames.size());
    for (const LocalTransform& local : frames) push_back(local);
  }

  /// Sets the number of frames to reserve memory for.
  void reserve(std::size_t frames) { room_ = frames; }
  void push_back(const LocalTransform& local) {
    append(local.translation, translations_);
    append(local.rotation, rotations_);
    append(local.scale, scales_);
    inherit_ = local.inherit;
    ++size_;
  }

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const LocalTransform operator[](std::size_t frame) const {  // const: assigning would be lost
    return {at(frame, translations_), at(frame, rotations_), at(frame, scales_), inherit_};
  }
  LocalTransform front() const { return (*this)[0]; }

  // Each holds one value for all frames, or one for each frame.
  const std::vector<Eigen::Vector3d>& translations() const { return translations_; }
  const std::vector<Eigen::Quaterniond>& rotations() const { return rotations_; }
  const std::vector<Eigen::Vector3d>& scales() const { return scales_; }

 private:
  template <typename Value>
  void append(const Value& value, std::vector<Value>& values) {
    if (size_ > 0 && values.size() == 1 && is_same(values.front(), value)) return;
    if (values.size() == 1) {  // it changes from now on
      values.reserve(room_);
      values.resize(size_, values.front());
    }
    values.push_back(value);
  }
  template <typename Value>
  static const Value& at(std::size_t frame, const std::vector<Value>& values) {
    return values[values.size() == 1 ? 0 : frame];
  }
  static bool is_same(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a == b; }
  static bool is_same(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    return a.coeffs() == b.coeffs();
  }

  std::size_t room_ = 0;
  std::size_t size_ = 0;
  std::vector<Eigen::Vector3d> translations_;
  std::vector<Eigen::Quaterniond> rotations_;
  std::vector<Eigen::Vector3d> scales_;
  ScaleOfParent inherit_ = ScaleOfParent::Whole;
};

}  // namespace mocapress
