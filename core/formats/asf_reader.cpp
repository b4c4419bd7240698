// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <numbers>
#include <unordered_map>

#include "core/base/printable.h"
#include "core/formats/asf.h"
#include "core/formats/text_cursor.h"
#include "core/runtime/format/format_limits.h"

namespace mocapress {
namespace {

constexpr std::array<int, 3> kXyz = {0, 1, 2};
constexpr double kSmallestLengthUnit = 1e-6;  // keeps centimetres finite

/// A bone as its begin ... end block describes it, in file units. For the root, `direction` is its
/// position and `axis` its orientation.
struct ReadBone {
  Token at;
  std::string name;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double length = 0;
  bool has_direction = false;
  bool has_length = false;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  std::vector<int> axis_order = {kXyz.begin(), kXyz.end()};
  std::vector<std::optional<ChannelKind>> dof;  // unset for "l"
  int parent = -1;
  std::vector<int> children;
};

/// The channel of a word "tx" ... "rz"; an empty channel for "l"; unset for other words.
std::optional<std::optional<ChannelKind>> dof_named(std::string_view word) {
  if (equals_ignoring_case(word, "l")) return std::optional<ChannelKind>();
  for (int kind = 0; kind < kChannelKinds; ++kind)
    if (equals_ignoring_case(word, short_name(static_cast<ChannelKind>(kind))))
      return static_cast<ChannelKind>(kind);
  return std::nullopt;
}

/// The axes named by a permutation of "XYZ"; the axis turned about first is in front.
std::optional<std::vector<int>> axes_of_order(std::string_view order) {
  std::vector<int> axes;
  for (const char letter : order)
    for (int axis = 0; axis < 3; ++axis)
      if (letter == "XYZ"[axis] || letter == "xyz"[axis]) axes.push_back(axis);
  if (order.size() != 3 || !std::ranges::is_permutation(axes, kXyz)) return std::nullopt;
  return axes;
}

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& radians, const std::vector<int>& order) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  for (const int axis : order) rotation = axis_rotation(axis, radians(axis)) * rotation;
  return rotation;
}

class AsfReader {
 public:
  AsfReader(const std::string& file, std::string_view text, std::optional<double> cm_per_unit)
      : cursor_(file, text, "", '#'), cm_per_unit_(cm_per_unit), bones_(1) {
    bones_.front().name = "root";
  }

  AsfSkeleton read();

 private:
  void read_section();
  void read_units();
  void read_root();
  void read_bones();
  void read_bone();
  void read_bone_property(ReadBone& bone, const Token& keyword);
  void read_hierarchy();
  void read_children(int line);
  int take_bone();

  Eigen::Vector3d take_vector(std::string_view what);
  void take_dof(ReadBone& bone, int line);
  std::vector<int> take_axis_order();
  bool in_section() const { return !cursor_.at_end() && !cursor_.peek().text.starts_with(':'); }

  std::vector<int> depth_first() const;
  AsfJoint joint_of(const ReadBone& bone, int parent_joint) const;

  TextCursor cursor_;
  std::optional<double> cm_per_unit_;
  double length_unit_ = 1;
  double radians_per_unit_ = std::numbers::pi / 180;
  std::vector<ReadBone> bones_;  // bone 0 is the root
  std::unordered_map<std::string_view, int> bone_named_ = {{"root", 0}};
};

AsfSkeleton AsfReader::read() {
  while (!cursor_.at_end()) read_section();
  cm_per_unit_ = cm_per_unit_.value_or(2.54 / length_unit_);
  AsfSkeleton skeleton{cursor_.file(), {}, *cm_per_unit_, radians_per_unit_};
  std::vector<int> joint_of_bone(bones_.size(), -1);
  for (const int b : depth_first()) {
    const ReadBone& bone = bones_[b];
    const int parent = bone.parent < 0 ? -1 : joint_of_bone[bone.parent];
    joint_of_bone[b] = static_cast<int>(skeleton.joints.size());
    skeleton.joints.push_back(joint_of(bone, parent));
  }
  return skeleton;
}

void AsfReader::read_section() {
  if (in_section()) cursor_.fail_expecting("a section such as :units or :bonedata");
  const Token section = cursor_.take();
  const auto is = [&](std::string_view name) { return equals_ignoring_case(section.text, name); };
  if (is(":units")) return read_units();
  if (is(":root")) return read_root();
  if (is(":bonedata")) return read_bones();
  if (is(":hierarchy")) return read_hierarchy();
  cursor_.skip_line(section.line);
  while (in_section()) cursor_.take_line();
}

void AsfReader::read_units() {
  while (in_section()) {
    const Token key = cursor_.take();
    if (equals_ignoring_case(key.text, "length")) {
      const Token at = cursor_.peek();
      length_unit_ = cursor_.take_measure("the unit of length");
      if (length_unit_ < kSmallestLengthUnit)
        cursor_.fail(at, "expected a positive unit of length, found " + quoted(at));
    } else if (equals_ignoring_case(key.text, "angle")) {
      const bool radians = cursor_.next_is("rad") || cursor_.next_is("radians");
      if (!radians && !cursor_.next_is("deg") && !cursor_.next_is("degrees"))
        cursor_.fail_expecting("deg or rad");
      radians_per_unit_ = radians ? 1 : std::numbers::pi / 180;
    }
    cursor_.skip_line(key.line);
  }
}

void AsfReader::read_root() {
  ReadBone& root = bones_.front();
  root.at = cursor_.peek();
  while (in_section()) {
    const Token key = cursor_.take();
    if (equals_ignoring_case(key.text, "order"))
      take_dof(root, key.line);
    else if (equals_ignoring_case(key.text, "axis"))
      root.axis_order = take_axis_order();
    else if (equals_ignoring_case(key.text, "position"))
      root.direction = take_vector("a coordinate of position");
    else if (equals_ignoring_case(key.text, "orientation"))
      root.axis = take_vector("an angle of orientation");
    else
      cursor_.skip_line(key.line);
  }
}

void AsfReader::read_bones() {
  while (in_section()) {
    const Token begin = cursor_.peek();
    cursor_.expect("begin");
    if (bones_.size() == runtime::kMostJoints)
      cursor_.fail(begin, "more than " + std::to_string(runtime::kMostJoints) + " bones");
    read_bone();
  }
}

void AsfReader::read_bone() {
  ReadBone bone;
  bone.at = cursor_.peek();
  while (!cursor_.skip("end")) {
    if (!in_section()) cursor_.fail_expecting("the end of the bone");
    read_bone_property(bone, cursor_.take());
  }
  if (bone.name.empty()) cursor_.fail(bone.at, "this bone has no name");
  if (!bone.has_direction || !bone.has_length)
    cursor_.fail(bone.at, "bone '" + shortened(bone.name) + "' lacks its direction or length");
  bones_.push_back(std::move(bone));
}

void AsfReader::read_bone_property(ReadBone& bone, const Token& keyword) {
  const auto is = [&](std::string_view word) { return equals_ignoring_case(keyword.text, word); };
  if (is("name")) {
    if (!cursor_.on_line(keyword.line)) cursor_.fail(keyword, "expected a name after 'name'");
    const Token name = cursor_.take();
    if (name.text.size() > runtime::kMostNameBytes)
      cursor_.fail(name, "the name of a bone has more than " +
                             std::to_string(runtime::kMostNameBytes) + " bytes");
    bone.name = name.text;
    if (!bone_named_.emplace(name.text, static_cast<int>(bones_.size())).second)
      cursor_.fail(name, "a second bone named " + quoted(name));
  } else if (is("direction")) {
    bone.direction = take_vector("a coordinate of direction");
    bone.has_direction = true;
  } else if (is("length")) {
    bone.length = cursor_.take_measure("the length of the bone");
    bone.has_length = true;
  } else if (is("axis")) {
    bone.axis = take_vector("an angle of axis");
    if (cursor_.on_line(keyword.line)) bone.axis_order = take_axis_order();
  } else if (is("dof")) {
    take_dof(bone, keyword.line);
  } else {
    cursor_.skip_line(keyword.line);  // id, limits and their further lines, bodymass ...
  }
}

Eigen::Vector3d AsfReader::take_vector(std::string_view what) {
  Eigen::Vector3d vector;
  for (double& coordinate : vector) coordinate = cursor_.take_measure(what);
  return vector;
}

void AsfReader::take_dof(ReadBone& bone, int line) {
  while (cursor_.on_line(line)) {
    const auto dof = dof_named(cursor_.peek().text);
    if (!dof) cursor_.fail_expecting("tx, ty, tz, rx, ry, rz or l");
    if (std::ranges::find(bone.dof, *dof) != bone.dof.end())
      cursor_.fail(cursor_.peek(), quoted(cursor_.peek()) + " twice in one bone");
    bone.dof.push_back(*dof);
    cursor_.take();
  }
}

std::vector<int> AsfReader::take_axis_order() {
  const auto order = axes_of_order(cursor_.peek().text);
  if (!order) cursor_.fail_expecting("an order of axes such as XYZ");
  cursor_.take();
  return *order;
}

void AsfReader::read_hierarchy() {
  cursor_.expect("begin");
  while (!cursor_.skip("end")) {
    if (!in_section()) cursor_.fail_expecting("the end of the hierarchy");
    read_children(cursor_.peek().line);
  }
}

void AsfReader::read_children(int line) {
  const int parent = take_bone();
  while (cursor_.on_line(line)) {
    const Token at = cursor_.peek();
    const int child = take_bone();
    ReadBone& bone = bones_[child];
    if (child == 0 || bone.parent >= 0) cursor_.fail(at, "a second parent for " + quoted(at));
    bone.parent = parent;
    bones_[parent].children.push_back(child);
  }
}

int AsfReader::take_bone() {
  const auto found = bone_named_.find(cursor_.peek().text);
  if (found == bone_named_.end()) cursor_.fail_expecting("the name of a bone");
  cursor_.take();
  return found->second;
}

/// Every bone that the root leads to, parents first.
std::vector<int> AsfReader::depth_first() const {
  std::vector<int> order;
  std::vector<int> waiting = {0};
  std::vector<int> depths(bones_.size(), 1);
  while (!waiting.empty()) {
    const int b = waiting.back();
    waiting.pop_back();
    order.push_back(b);
    const ReadBone& bone = bones_[b];
    const int depth = depths[b];
    if (depth > runtime::kMostDepth)
      cursor_.fail(bone.at, "bone '" + shortened(bone.name) + "' is nested deeper than " +
                                std::to_string(runtime::kMostDepth));
    for (const int child : bone.children) depths[child] = depth + 1;
    waiting.insert(waiting.end(), bone.children.rbegin(), bone.children.rend());
  }
  if (order.size() == bones_.size()) return order;
  std::vector<bool> reached(bones_.size(), false);
  for (const int b : order) reached[b] = true;
  const auto lost = std::ranges::find(reached, false) - reached.begin();
  const ReadBone& bone = bones_[lost];
  cursor_.fail(bone.at,
               "bone '" + shortened(bone.name) + "' does not hang from the root in :hierarchy");
}

bool translates(const std::vector<std::optional<ChannelKind>>& dof) {
  return std::ranges::any_of(dof, [](const auto& kind) { return kind && !is_rotation(*kind); });
}

AsfJoint AsfReader::joint_of(const ReadBone& bone, int parent_joint) const {
  AsfJoint result;
  Joint& joint = result.joint;
  joint.name = bone.name;
  joint.parent = parent_joint;
  joint.joint_from_axes = rotation_of(bone.axis * radians_per_unit_, bone.axis_order);
  result.dof = bone.dof;
  if (bone.parent < 0) {
    joint.offset = bone.direction * *cm_per_unit_;
    result.feed_channels(bone.axis_order);
    return result;
  }
  const ReadBone& parent = bones_[bone.parent];
  if (bone.parent > 0) joint.offset = parent.direction * parent.length * *cm_per_unit_;
  const Eigen::Vector3d end = bone.direction * bone.length * *cm_per_unit_;
  if (bone.children.empty() && end.norm() > 0) joint.end_site = end;
  result.translates_along_axes = translates(bone.dof) && !joint.joint_from_axes.isIdentity(0);
  result.feed_channels(rotation_axes(bone.dof));
  return result;
}

}  // namespace

void AsfJoint::feed_channels(const std::vector<int>& rotation_axes) {
  joint.channels.clear();
  columns.clear();
  const auto feed = [&](ChannelKind kind, bool always) {
    const auto column = std::ranges::find(dof, kind);
    const bool given = column != dof.end();
    if (!given && !always) return;
    joint.channels.push_back(kind);
    columns.push_back(given ? static_cast<int>(column - dof.begin()) : -1);
  };
  for (const int axis : kXyz) feed(translation_about(axis), translates_along_axes);
  std::for_each(rotation_axes.rbegin(), rotation_axes.rend(),
                [&](int axis) { feed(rotation_about(axis), false); });
}

std::vector<int> rotation_axes(const std::vector<std::optional<ChannelKind>>& dof) {
  std::vector<int> axes;
  for (const auto& kind : dof)
    if (kind && is_rotation(*kind)) axes.push_back(axis_of(*kind));
  return axes;
}

AsfSkeleton read_asf(const std::string& file, std::string_view text,
                     std::optional<double> cm_per_unit) {
  return AsfReader(file, text, cm_per_unit).read();
}

}  // namespace mocapress
