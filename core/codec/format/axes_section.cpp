// SPDX-License-Identifier: MIT
#include "core/codec/format/axes_section.h"

#include <algorithm>

#include "core/base/byte_cursor.h"
#include "core/codec/format/format_error.h"
#include "core/runtime/format/turned_axes.h"

namespace mocapress {
namespace {

static_assert(kFixedTurns == runtime::kFixedTurns);

std::vector<std::size_t> joints_that_may(const Skeleton& skeleton) {
  std::vector<std::size_t> joints;
  for (std::size_t j = 0; j < skeleton.joints().size(); ++j)
    if (may_turn_axes(skeleton.joints()[j])) joints.push_back(j);
  return joints;
}

std::size_t flag_bytes(std::size_t joints) {
  return (joints + 7) / 8;
}

}  // namespace

bool may_turn_axes(const Joint& joint) {
  return joint.parent >= 0 && turns_freely(joint);
}

std::size_t axes_section_bytes(const Skeleton& coded) {
  const auto turned =
      static_cast<std::size_t>(std::ranges::count_if(coded.joints(), [](const Joint& joint) {
        return !joint.before.isIdentity(0) || !joint.after.isIdentity(0);
      }));
  if (turned == 0) return 0;
  return flag_bytes(joints_that_may(coded).size()) + runtime::kTurnedAxesBytes * turned;
}

std::vector<std::byte> write_axes(const Skeleton& skeleton, const RotationForms& forms) {
  const std::vector<std::size_t> joints = joints_that_may(skeleton);
  std::vector<std::byte> flags(flag_bytes(joints.size()));
  ByteWriter words;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const RotationForm& form = forms[joints[i]];
    if (!form.has_fixed_turns()) continue;
    flags[i / 8] |= std::byte{1} << (i % 8);
    runtime::TurnedAxes turned;
    std::copy_n(form.before.begin(), 3, turned.before);
    std::copy_n(form.after.begin(), 3, turned.after);
    words.write(turned.code());
  }
  ByteWriter writer;
  writer.append(flags);
  writer.append(words.bytes());
  return writer.release();
}

void read_axes(const runtime::Bytes& axes, const Skeleton& skeleton, RotationForms& forms) {
  require(runtime::read_turned_axes(
      axes, skeleton.joint_count(), [&](int j) { return may_turn_axes(skeleton.joint(j)); },
      [&](int j, const runtime::TurnedAxes& turned) {
        RotationForm& form = forms[j];
        std::copy_n(turned.before, 3, form.before.begin());
        std::copy_n(turned.after, 3, form.after.begin());
      }));
}

}  // namespace mocapress
