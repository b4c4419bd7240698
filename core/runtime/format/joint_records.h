// SPDX-License-Identifier: MIT
// The skeleton in a file: FORMAT.md, JNTS.
#pragma once

#include "core/runtime/format/cursor.h"
#include "core/runtime/format/file_sections.h"
#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/joint_bytes.h"
#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/result.h"

namespace mocapress::runtime {

/// A joint as stored in the file.
struct JointRecord {
  JointModel model;  // `name` within it is not set
  const std::uint8_t* name = nullptr;
  std::uint8_t name_length = 0;
};

/// Parses joint number `index`. The offset of a failure refers to the decoded bytes.
mcpr_result read_joint(Cursor& cursor, int index, JointRecord& record);

/// Decodes the bytes of all joints, `sections.joint_bytes` of them.
mcpr_result decode_joint_bytes(const FileSections& sections, JointByteCoder& coder,
                               std::uint8_t* bytes);

/// Parses all joints, parents first. Checks depth, number of channels and size of the whole
/// skeleton. Calls visit(index, record). `depths` has room for one number per joint.
template <typename Visit>
mcpr_result read_joints(const FileSections& sections, const std::uint8_t* bytes,
                        std::uint16_t* depths, const Visit& visit) {
  const std::size_t offset = sections.coded_joints.offset;
  const auto refuse = [&](const char* message) { return failure(MCPR_INVALID, offset, message); };
  Cursor cursor(bytes, sections.joint_bytes);
  std::uint32_t channels = 0;
  for (int j = 0; j < static_cast<int>(sections.joints); ++j) {
    JointRecord record;
    const mcpr_result result = read_joint(cursor, j, record);
    if (failed(result)) return failure(result.status, offset, result.message);
    const int parent = record.model.parent;
    depths[j] = static_cast<std::uint16_t>(parent < 0 ? 1 : depths[parent] + 1);
    if (depths[j] > kMostDepth) return refuse("joints are nested deeper than 1000");
    record.model.first_channel = static_cast<std::uint16_t>(channels);
    channels += record.model.channels;
    visit(j, record);
  }
  if (!cursor.at_end()) return refuse("bytes after the last joint");
  if (channels != sections.channels) return refuse("not as many channels as JNTS states");
  return kOk;
}

}  // namespace mocapress::runtime
