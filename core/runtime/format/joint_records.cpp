// SPDX-License-Identifier: MIT
#include "core/runtime/format/joint_records.h"

#include <cmath>

#include "core/runtime/format/range_decoder.h"

namespace mocapress::runtime {
namespace {

bool read_finite(Cursor& cursor, int count, float* values) {
  bool finite = true;
  for (int i = 0; i < count; ++i) {
    values[i] = cursor.read<float>();
    finite = finite && std::isfinite(values[i]);
  }
  return finite;
}

bool read_axes(Cursor& cursor, Matrix3& axes) {
  float wxyz[4];
  if (!read_finite(cursor, 4, wxyz)) return false;
  double squares = 0;
  for (const float value : wxyz) squares += static_cast<double>(value) * static_cast<double>(value);
  const double size = std::sqrt(squares);
  if (std::abs(size - 1) > 1e-3) return false;
  double unit[4];
  for (int i = 0; i < 4; ++i) unit[i] = static_cast<double>(wxyz[i]) / size;
  axes = rotation_of(unit[0], unit[1], unit[2], unit[3]);
  return true;
}

}  // namespace

mcpr_result read_joint(Cursor& cursor, int index, JointRecord& record) {
  const std::size_t start = cursor.offset();
  const auto refuse = [&](const char* message) { return failure(MCPR_INVALID, start, message); };
  JointModel& joint = record.model;
  record.name_length = cursor.read<std::uint8_t>();
  record.name = cursor.take(record.name_length);
  joint.parent = cursor.read<std::int16_t>();
  if (joint.parent < -1 || joint.parent >= index) return refuse("a joint stands before its parent");
  float offset[3];
  if (!read_finite(cursor, 3, offset)) return refuse("a number of the skeleton is not finite");
  joint.offset = vector_of(offset);
  const auto flags = cursor.read<std::uint8_t>();
  if ((flags & ~3) != 0) return refuse("a joint has unknown flags");
  joint.has_axes = (flags & 1) != 0;
  joint.has_end_site = (flags & 2) != 0;
  if (joint.has_axes) {
    if (!read_axes(cursor, joint.parent_from_axes))
      return refuse("the axes are not a unit quaternion");
    joint.axes_from_joint = transposed(joint.parent_from_axes);
  }
  if (joint.has_end_site && !read_finite(cursor, 3, joint.end_site))
    return refuse("a number of the skeleton is not finite");
  joint.channels = cursor.read<std::uint8_t>();
  if (joint.channels > kMostChannelsOfJoint) return refuse("a joint has more than 6 channels");
  for (int c = 0; c < joint.channels; ++c) {
    joint.kinds[c] = cursor.read<std::uint8_t>();
    if (joint.kinds[c] > 5) return refuse("unknown kind of channel");
  }
  if (cursor.failed()) return refuse("the skeleton ends early");
  return kOk;
}

mcpr_result decode_joint_bytes(const FileSections& sections, JointByteCoder& coder,
                               std::uint8_t* bytes) {
  const Bytes& coded = sections.coded_joints;
  RangeDecoder bits(coded.data, coded.size);
  coder.run(bits, bytes, sections.joint_bytes);
  if (bits.failed() || !bits.is_at_end())
    return failure(MCPR_INVALID, coded.offset + bits.position(), "the coded skeleton is damaged");
  return kOk;
}

}  // namespace mocapress::runtime
