// SPDX-License-Identifier: MIT
#include "core/codec/format/skeleton_section.h"

#include <Eigen/Geometry>

#include "core/base/byte_cursor.h"
#include "core/codec/format/format_error.h"
#include "core/codec/format/range_coder.h"
#include "core/runtime/format/joint_records.h"
#include "core/runtime/own_memory.h"

namespace mocapress {
namespace {

enum JointFlags : std::uint8_t { kHasAxes = 1, kHasEndSite = 2 };

void write_vector(ByteWriter& writer, const Eigen::Vector3d& vector) {
  for (const double value : vector) writer.write(static_cast<float>(value));
}

Eigen::Vector3d vector_of(const float (&values)[3]) {
  return Eigen::Map<const Eigen::Vector3f>(values).cast<double>();
}

Joint joint_of(const runtime::JointRecord& record) {
  const runtime::JointModel& model = record.model;
  Joint joint;
  joint.name.assign(reinterpret_cast<const char*>(record.name), record.name_length);
  joint.parent = model.parent;
  for (int i = 0; i < 3; ++i) {
    joint.offset(i) = model.offset[i];
    for (int k = 0; k < 3 && model.has_axes; ++k)
      joint.joint_from_axes(i, k) = model.parent_from_axes(i, k);
  }
  if (model.has_end_site) joint.end_site = vector_of(model.end_site);
  for (int c = 0; c < model.channels; ++c)
    joint.channels.push_back(static_cast<ChannelKind>(model.kinds[c]));
  return joint;
}

}  // namespace

std::vector<std::byte> joint_bytes(const Skeleton& skeleton) {
  ByteWriter writer;
  for (const Joint& joint : skeleton.joints()) {
    writer.write_short_string(joint.name);
    writer.write(static_cast<std::int16_t>(joint.parent));
    write_vector(writer, joint.offset);
    const bool has_axes = !joint.joint_from_axes.isIdentity(0);
    writer.write(
        static_cast<std::uint8_t>((has_axes ? kHasAxes : 0) | (joint.end_site ? kHasEndSite : 0)));
    if (has_axes) {
      const Eigen::Quaterniond axes(joint.joint_from_axes);
      for (const double value : {axes.w(), axes.x(), axes.y(), axes.z()})
        writer.write(static_cast<float>(value));
    }
    if (joint.end_site) write_vector(writer, *joint.end_site);
    writer.write(static_cast<std::uint8_t>(joint.channels.size()));
    for (const ChannelKind kind : joint.channels) writer.write(static_cast<std::uint8_t>(kind));
  }
  return writer.release();
}

std::vector<std::byte> write_joints(const Skeleton& skeleton) {
  return write_joints(joint_bytes(skeleton), skeleton.joint_count(), skeleton.channel_count());
}

std::vector<std::byte> write_joints(std::vector<std::byte> bytes, int joints, int channels) {
  ByteWriter writer;
  writer.write(static_cast<std::uint32_t>(bytes.size()));
  writer.write(static_cast<std::uint16_t>(joints));
  writer.write(static_cast<std::uint16_t>(channels));
  RangeEncoder bits;
  OwnMemory<runtime::JointByteCoder>()->run(bits, reinterpret_cast<std::uint8_t*>(bytes.data()),
                                            static_cast<std::uint32_t>(bytes.size()));
  writer.append(bits.finish());
  return writer.release();
}

Skeleton read_joints(const runtime::FileSections& sections) {
  std::vector<std::uint8_t> bytes(sections.joint_bytes);
  require(
      runtime::decode_joint_bytes(sections, *OwnMemory<runtime::JointByteCoder>(), bytes.data()));
  std::vector<std::uint16_t> depths(sections.joints);
  Skeleton skeleton;
  require(runtime::read_joints(
      sections, bytes.data(), depths.data(),
      [&](int, const runtime::JointRecord& record) { skeleton.add(joint_of(record)); }));
  return skeleton;
}

}  // namespace mocapress
