// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numbers>
#include <unordered_set>

#include "core/base/error.h"
#include "core/formats/asf.h"
#include "core/formats/text_cursor.h"
#include "core/formats/text_writer.h"
#include "core/formats/zyx_angles.h"
#include "core/runtime/format/format_limits.h"

namespace mocapress {
namespace {

// Decimals of directions and axes: errors add up along a chain of bones.
constexpr int kDecimals = 9;

/// A bone of the file. Unlike a joint it has an end, at which its children start.
struct WrittenBone {
  std::string name;
  int parent = 0;
  Eigen::Vector3d end;           // cm, from the bone's start
  const Joint* joint = nullptr;  // null: the bone only leads to a child's place
};

class AsfWriter {
 public:
  AsfWriter(const Skeleton& skeleton, double cm_per_unit)
      : skeleton_(skeleton), cm_per_unit_(cm_per_unit) {}
  std::string write();

 private:
  void make_bones();
  void check_limits() const;
  void write_root();
  void write_bone(std::size_t index);
  void write_hierarchy();

  const Skeleton& skeleton_;
  double cm_per_unit_;
  std::vector<WrittenBone> bones_;  // bone 0 is the root, which has no length
  std::string text_;
};

/// The end of each joint's bone: the place of the first child that is not at the joint's own
/// origin, or else the end site.
std::vector<Eigen::Vector3d> bone_ends(const Skeleton& skeleton) {
  std::vector<Eigen::Vector3d> ends;
  for (const Joint& joint : skeleton.joints())
    ends.push_back(joint.end_site.value_or(Eigen::Vector3d::Zero()));
  for (int j = skeleton.joint_count() - 1; j > 0; --j) {
    const Joint& joint = skeleton.joint(j);
    if (!joint.offset.isZero(0)) ends[joint.parent] = joint.offset;
  }
  ends[0].setZero();
  return ends;
}

/// A joint's name as one word that readers do not take for a keyword, frame number or comment.
std::string bone_name(const std::string& name) {
  const std::string word = as_word(name, "");
  const bool misread = equals_ignoring_case(word, "begin") || equals_ignoring_case(word, "end") ||
                       word.find_first_of("#:") == 0 ||
                       word.find_first_not_of("0123456789") == word.npos;
  return misread ? "_" + word : word;
}

/// A joint's dof as " rx ry rz", in the order of an .amc line. The rotation applied first comes
/// first.
std::string dof_words(const Joint& joint) {
  std::string translations;
  std::string rotations;
  for (const ChannelKind kind : joint.channels) {
    const std::string word = ' ' + std::string(short_name(kind));
    if (is_rotation(kind))
      rotations.insert(0, word);
    else
      translations += word;
  }
  return translations + rotations;
}

std::string AsfWriter::write() {
  make_bones();
  check_limits();
  text_ = ":version 1.10\n:name mocapress\n:units\n  mass 1.0\n  length ";
  append_number(text_, 2.54 / cm_per_unit_, kDecimals);
  text_ += "\n  angle deg\n";
  write_root();
  text_ += ":bonedata\n";
  for (std::size_t b = 1; b < bones_.size(); ++b) write_bone(b);
  write_hierarchy();
  return std::move(text_);
}

void AsfWriter::make_bones() {
  const auto roots = std::ranges::count_if(skeleton_.joints(),
                                           [](const Joint& joint) { return joint.parent < 0; });
  if (roots != 1)
    throw WriteError("an .amc holds one figure with one root, but this clip has " +
                     std::to_string(roots) + " roots: .bvh and .glb can hold it");
  const std::vector<std::string> names = asf_names(skeleton_);
  const std::vector<Eigen::Vector3d> ends = bone_ends(skeleton_);
  std::unordered_set<std::string> taken(names.begin(), names.end());
  std::vector<int> bone_of_joint(names.size(), 0);
  bones_.push_back({names[0], -1, ends[0], &skeleton_.joint(0)});
  for (std::size_t j = 1; j < names.size(); ++j) {
    const Joint& joint = skeleton_.joints()[j];
    int parent = bone_of_joint[joint.parent];
    const Eigen::Vector3d way = joint.offset - bones_[parent].end;
    if (!way.isZero(0)) {
      bones_.push_back({unique_word("to_" + names[j], taken), parent, way, nullptr});
      parent = static_cast<int>(bones_.size()) - 1;
    }
    bone_of_joint[j] = static_cast<int>(bones_.size());
    bones_.push_back({names[j], parent, ends[j], &joint});
  }
  if (const auto& end = skeleton_.joint(0).end_site)
    bones_.push_back({unique_word("root_end", taken), 0, *end, nullptr});
}

/// Refuses skeletons that the readers here would refuse. Bones that only lead to a child count,
/// too.
void AsfWriter::check_limits() const {
  if (bones_.size() > runtime::kMostJoints)
    throw Error("an .asf of this skeleton would have " + std::to_string(bones_.size()) +
                " bones, at most " + std::to_string(runtime::kMostJoints) + " are possible");
  std::vector<int> depths;
  for (const WrittenBone& bone : bones_) {
    if (bone.name.size() > runtime::kMostNameBytes)
      throw Error("a bone's name would be too long for an .asf: " + bone.name);
    depths.push_back(bone.parent < 0 ? 1 : depths[bone.parent] + 1);
    if (depths.back() > runtime::kMostDepth)
      throw Error("in an .asf bones of this skeleton would be nested deeper than " +
                  std::to_string(runtime::kMostDepth));
  }
}

void AsfWriter::write_root() {
  const Joint& root = *bones_.front().joint;
  std::string axis;
  for (const ChannelKind kind : root.channels)
    if (is_rotation(kind)) axis.insert(axis.begin(), "XYZ"[axis_of(kind)]);
  for (const char letter : {'X', 'Y', 'Z'})
    if (axis.find(letter) == axis.npos) axis += letter;
  std::string order = dof_words(root);
  std::ranges::transform(order, order.begin(),
                         [](char c) { return c == ' ' ? c : static_cast<char>(c - 'a' + 'A'); });
  text_ += ":root\n  order" + order + "\n  axis " + axis + "\n  position";
  append_vector(text_, root.offset / cm_per_unit_, kDecimals);
  text_ += "\n  orientation 0 0 0\n";
}

void AsfWriter::write_bone(std::size_t index) {
  const WrittenBone& bone = bones_[index];
  const double length = bone.end.norm();
  text_ +=
      "  begin\n    id " + std::to_string(index) + "\n    name " + bone.name + "\n    direction";
  append_vector(text_, length > 0 ? (bone.end / length).eval() : Eigen::Vector3d::UnitX(),
                kDecimals);
  text_ += "\n    length ";
  append_number(text_, length / cm_per_unit_, kDecimals);
  text_ += "\n    axis";
  const Eigen::Matrix3d axes =
      bone.joint ? bone.joint->joint_from_axes : Eigen::Matrix3d::Identity();
  append_vector(text_, zyx_angles(axes, Eigen::Vector3d::Zero()) * 180 / std::numbers::pi,
                kDecimals);
  text_ += " XYZ\n";
  if (bone.joint && !bone.joint->channels.empty())
    text_ += "    dof" + dof_words(*bone.joint) + '\n';
  text_ += "  end\n";
}

void AsfWriter::write_hierarchy() {
  std::vector<std::string> children(bones_.size());
  for (std::size_t b = 1; b < bones_.size(); ++b)
    children[bones_[b].parent] += ' ' + bones_[b].name;
  text_ += ":hierarchy\n  begin\n";
  for (std::size_t b = 0; b < bones_.size(); ++b)
    if (!children[b].empty()) text_ += "    " + bones_[b].name + children[b] + '\n';
  text_ += "  end\n";
}

}  // namespace

Motion acclaim_motion(const Motion& motion) {
  return with_zyx_angles(motion, [](const Joint& joint) {
    const bool translates =
        std::ranges::any_of(joint.channels, [](ChannelKind kind) { return !is_rotation(kind); });
    return !joint.joint_from_axes.isIdentity(0) && (joint.parent < 0 || translates);
  });
}

std::vector<std::string> asf_names(const Skeleton& skeleton) {
  std::vector<std::string> names = {"root"};
  std::unordered_set<std::string> taken(names.begin(), names.end());
  for (int j = 1; j < skeleton.joint_count(); ++j)
    names.push_back(unique_word(bone_name(skeleton.joint(j).name), taken));
  return names;
}

double asf_cm_per_unit(const SourceFormat& source, const ReadOptions& options) {
  const bool acclaim = source.kind == SourceFormat::Kind::Acclaim;
  return options.cm_per_unit.value_or(acclaim ? source.cm_per_unit : kAsfCmPerUnit);
}

std::string asf_text(const Skeleton& skeleton, double cm_per_unit) {
  return AsfWriter(skeleton, cm_per_unit).write();
}

}  // namespace mocapress
