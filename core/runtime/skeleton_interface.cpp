// SPDX-License-Identifier: MIT
// The part of the C interface that compares skeletons and maps one onto another.
#include <cstring>

#include "core/runtime/decode/clip.h"
#include "core/runtime/format/bank.h"
#include "core/runtime/format/bank_skeleton.h"
#include "core/runtime/format/packed_clip.h"
#include "core/runtime/format/result.h"
#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/pose/cooked_clip.h"

namespace mocapress::runtime {
namespace {

constexpr mcpr_result no_map(const char* message) {
  return failure(MCPR_ARGUMENT, 0, message);
}

/// The joints of a clip: a resident clip's own, or those of a skeleton item in a bank.
class ClipJoints {
 public:
  explicit ClipJoints(const mcpr_clip* clip) : clip_(clip) {
    mcpr_clip_info info;
    mcpr_clip_describe(clip, &info);
    joints_ = info.joints;
  }
  explicit ClipJoints(const BankSkeleton& skeleton)
      : skeleton_(skeleton), joints_(skeleton.joints()) {}

  std::uint32_t count() const { return joints_; }

  mcpr_joint operator[](std::uint32_t number) const {
    mcpr_joint joint{};
    if (clip_ != nullptr)
      mcpr_clip_joint(clip_, number, &joint, nullptr);
    else
      joint = skeleton_.described(number);
    if (joint.name == nullptr) joint.name = "";  // in a bank that was not checked
    return joint;
  }

  std::int16_t find(const char* name) const {
    for (std::uint32_t j = 0; j < joints_; ++j)
      if (std::strcmp((*this)[j].name, name) == 0) return static_cast<std::int16_t>(j);
    return -1;
  }

 private:
  const mcpr_clip* clip_ = nullptr;
  BankSkeleton skeleton_{{nullptr, 0, 0}};
  std::uint32_t joints_ = 0;
};

ClipJoints joints_of(const mcpr_cooked* cooked) {
  return ClipJoints(is_cooked(cooked) ? cooked->skeleton() : BankSkeleton({nullptr, 0, 0}));
}

/// Returns no joints if the bank is not a cooked one, or has no such clip.
ClipJoints joints_of(const mcpk_bank* bank, std::uint32_t clip) {
  BankEntry entry;
  const bool is_there =
      bank != nullptr && bank->is_cooked() && clip < bank->clips && read_entry(*bank, clip, entry);
  return ClipJoints(
      BankSkeleton(is_there ? bank->item(BankItem::Part, entry.kind) : Bytes{nullptr, 0, 0}));
}

/// FNV-1a.
class Hash {
 public:
  void add(const void* bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      value_ = (value_ ^ static_cast<const std::uint8_t*>(bytes)[i]) * 1099511628211U;
  }
  void add_point(const float (&point)[3]) {
    for (const float number : point) {
      const float positive_zero = number + 0.0F;
      add(&positive_zero, sizeof positive_zero);
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037U;
};

std::uint64_t hash_of(const ClipJoints& joints) {
  if (joints.count() == 0) return 0;
  Hash hash;
  for (std::uint32_t j = 0; j < joints.count(); ++j) {
    const mcpr_joint joint = joints[j];
    hash.add(joint.name, std::strlen(joint.name) + 1);
    hash.add(&joint.parent, sizeof joint.parent);
    hash.add_point(joint.offset);
    hash.add(&joint.has_end_site, sizeof joint.has_end_site);
    hash.add_point(joint.end_site);
  }
  return hash.value();
}

mcpr_result map_joints(const ClipJoints& joints, const mcpr_skeleton* skeleton, std::int16_t* map,
                       mcpr_map_gaps* gaps) {
  if (joints.count() == 0) return no_map("no clip, or it does not have its joints' names");
  if (skeleton == nullptr || map == nullptr || gaps == nullptr)
    return no_map("no skeleton, or no place was given for the map or its gaps");
  if (skeleton->joints > INT16_MAX || (skeleton->names == nullptr && skeleton->joints > 0))
    return no_map("more joints than 32767, or no names");
  *gaps = {};
  for (std::uint32_t j = 0; j < skeleton->joints; ++j) {
    if (skeleton->names[j] == nullptr) return no_map("a joint without a name");
    map[j] = joints.find(skeleton->names[j]);
    if (map[j] < 0) ++gaps->missing;
  }
  for (std::uint32_t c = 0; c < joints.count(); ++c) {
    bool is_used = false;
    for (std::uint32_t j = 0; j < skeleton->joints && !is_used; ++j)
      is_used = map[j] == static_cast<std::int32_t>(c);
    if (!is_used) ++gaps->unused;
  }
  for (std::uint32_t j = 0; skeleton->parents != nullptr && j < skeleton->joints; ++j) {
    const std::int16_t parent = skeleton->parents[j];
    if (parent < -1 || parent >= static_cast<std::int32_t>(skeleton->joints))
      return no_map("a parent that the skeleton does not have");
    constexpr std::int32_t kNoJoint = -2;  // no joint of the clip has this parent
    const std::int32_t wanted = parent < 0 ? -1 : map[parent] < 0 ? kNoJoint : map[parent];
    if (map[j] >= 0 && joints[static_cast<std::uint32_t>(map[j])].parent != wanted) ++gaps->moved;
  }
  return kOk;
}

}  // namespace
}  // namespace mocapress::runtime

namespace runtime = mocapress::runtime;

mcpr_status mcpr_cooked_joint(const mcpr_cooked* cooked, uint32_t joint, mcpr_joint* out,
                              mcpr_result* report) {
  const runtime::ClipJoints joints = runtime::joints_of(cooked);
  if (out == nullptr || joint >= joints.count())
    return runtime::tell(
        report, runtime::no_map("no such joint, or the clip was cooked without its skeleton"));
  *out = joints[joint];
  return runtime::tell(report, runtime::kOk);
}

uint64_t mcpr_skeleton_hash(const mcpr_clip* clip) {
  return runtime::hash_of(runtime::ClipJoints(clip));
}

uint64_t mcpr_cooked_skeleton_hash(const mcpr_cooked* cooked) {
  return runtime::hash_of(runtime::joints_of(cooked));
}

uint64_t mcpk_skeleton_hash(const mcpk_bank* bank, uint32_t clip) {
  return runtime::hash_of(runtime::joints_of(bank, clip));
}

int32_t mcpk_skeleton(const mcpk_bank* bank, uint32_t clip) {
  runtime::BankEntry entry;
  if (bank == nullptr || clip >= bank->clips || !runtime::read_entry(*bank, clip, entry)) return -1;
  const std::uint32_t number =
      bank->is_cooked() ? entry.kind : runtime::PackedSections(*bank, entry).joints_part();
  return number < bank->count(runtime::BankItem::Part) ? static_cast<std::int32_t>(number) : -1;
}

mcpr_status mcpr_map_joints(const mcpr_clip* clip, const mcpr_skeleton* skeleton, int16_t* map,
                            mcpr_map_gaps* gaps, mcpr_result* report) {
  return runtime::tell(report, runtime::map_joints(runtime::ClipJoints(clip), skeleton, map, gaps));
}

mcpr_status mcpr_map_cooked_joints(const mcpr_cooked* cooked, const mcpr_skeleton* skeleton,
                                   int16_t* map, mcpr_map_gaps* gaps, mcpr_result* report) {
  return runtime::tell(report,
                       runtime::map_joints(runtime::joints_of(cooked), skeleton, map, gaps));
}

mcpr_status mcpk_map_joints(const mcpk_bank* bank, uint32_t clip, const mcpr_skeleton* skeleton,
                            int16_t* map, mcpr_map_gaps* gaps, mcpr_result* report) {
  return runtime::tell(report,
                       runtime::map_joints(runtime::joints_of(bank, clip), skeleton, map, gaps));
}

mcpr_status mcpr_remap_pose(const int16_t* map, uint32_t joints, const mcpr_transform* bind,
                            const mcpr_transform* pose, uint32_t clip_joints, mcpr_transform* out,
                            mcpr_result* report) {
  if (map == nullptr || bind == nullptr || pose == nullptr || out == nullptr)
    return runtime::tell(report, runtime::no_map("no map, no bind pose, no pose, or no output"));
  for (std::uint32_t j = 0; j < joints; ++j) {
    if (map[j] >= static_cast<std::int64_t>(clip_joints))
      return runtime::tell(report, runtime::no_map("a joint that the pose does not have"));
    out[j] = map[j] < 0 ? bind[j] : pose[map[j]];
  }
  return runtime::tell(report, runtime::kOk);
}
