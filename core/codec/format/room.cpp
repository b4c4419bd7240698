// SPDX-License-Identifier: MIT
#include "core/codec/format/room.h"

#include <cmath>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/kinds.h"

namespace mocapress {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error("this clip cannot be written as .mcpr: " + what);
}

[[noreturn]] void refuse(auto count, const char* what, auto most) {
  refuse(std::to_string(count) + ' ' + what + ", at most " + std::to_string(most) +
         " are possible");
}

bool fits_floats(const Eigen::Vector3d& vector) {
  return vector.cast<float>().allFinite();
}

void check_joint(const Joint& joint) {
  const std::string name = '\'' + joint.name.substr(0, 40) + '\'';
  if (joint.name.size() > runtime::kMostNameBytes)
    refuse("the name of joint " + name + "... has " + std::to_string(joint.name.size()) +
           " bytes, at most " + std::to_string(runtime::kMostNameBytes) + " are possible");
  if (std::ssize(joint.channels) > runtime::kMostChannelsOfJoint)
    refuse("joint " + name + " has " + std::to_string(joint.channels.size()) +
           " channels, at most " + std::to_string(runtime::kMostChannelsOfJoint) + " are possible");
  if (!fits_floats(joint.offset) || (joint.end_site && !fits_floats(*joint.end_site)))
    refuse("joint " + name + " is too far away for 32-bit floats");
}

void check_depth(const Skeleton& skeleton) {
  std::vector<int> depths;
  for (const Joint& joint : skeleton.joints()) {
    depths.push_back(joint.parent < 0 ? 1 : depths[joint.parent] + 1);
    if (depths.back() > runtime::kMostDepth)
      refuse("joints are nested deeper than " + std::to_string(runtime::kMostDepth));
  }
}

}  // namespace

void check_room(const ClipShape& clip) {
  const Skeleton& skeleton = clip.skeleton;
  if (skeleton.joint_count() == 0) refuse("it has no joints");
  if (skeleton.joint_count() > runtime::kMostJoints)
    refuse(skeleton.joint_count(), "joints", runtime::kMostJoints);
  for (const Joint& joint : skeleton.joints()) check_joint(joint);
  check_depth(skeleton);
  if (!std::isfinite(clip.sample_rate_hz) || clip.sample_rate_hz <= 0)
    refuse("its sample rate is not a positive number");
  if (static_cast<std::uint32_t>(clip.segments.frames) > runtime::kMostFrames)
    refuse(clip.segments.frames, "frames", runtime::kMostFrames);
  if (clip.effectors > runtime::kMostEffectors)
    refuse(clip.effectors, "effectors", runtime::kMostEffectors);
  const auto values = static_cast<std::uint64_t>(clip.segments.coded_frames()) *
                      static_cast<std::uint64_t>(skeleton.channel_count() + 3 * clip.effectors);
  if (values > runtime::kMostValues)
    refuse(values, "values (frames times channels)", runtime::kMostValues);
}

void check_room(std::uint64_t values, std::uint64_t file_bytes) {
  if (values > runtime::most_values_of(file_bytes))
    refuse(values, "values are too many for a motion of so few bytes",
           runtime::most_values_of(file_bytes));
}

}  // namespace mocapress
