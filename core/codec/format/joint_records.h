// SPDX-License-Identifier: MIT
// The decoded bytes of a skeleton: FORMAT.md, SKEL.
#pragma once

#include "core/codec/format/cursor.h"
#include "core/codec/format/joint_model.h"
#include "core/codec/format/result.h"

namespace mocapress::runtime {

/// One joint as it stands in the file.
struct JointRecord {
  JointModel model;  // without first_channel and the place of the name
  const std::uint8_t* name = nullptr;
  std::uint8_t name_length = 0;
};

/// Reads joint number `index`. The offset of a failure is in the decoded bytes.
mcpr_result read_joint(Cursor& cursor, int index, JointRecord& record);

}  // namespace mocapress::runtime
