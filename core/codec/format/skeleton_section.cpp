// SPDX-License-Identifier: MIT
#include "core/codec/format/skeleton_section.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "core/base/byte_cursor.h"
#include "core/codec/format/deflate.h"
#include "core/codec/format/format_limits.h"
#include "core/codec/format/joint_bytes.h"
#include "core/codec/format/own_memory.h"
#include "core/codec/format/range_coder.h"

namespace mocapress {
namespace {

using runtime::kMostBytesOfJoint;
using runtime::kMostDepth;
using runtime::kMostJoints;

enum JointFlags : std::uint8_t { kHasAxes = 1, kHasEndSite = 2 };

void write_vector(ByteWriter& writer, const Eigen::Vector3d& vector) {
  for (const double value : vector) writer.write(static_cast<float>(value));
}

double read_finite(ByteReader& reader) {
  const double value = reader.read<float>();
  if (!std::isfinite(value)) reader.fail("a number of the skeleton is not finite");
  return value;
}

Eigen::Vector3d read_vector(ByteReader& reader) {
  Eigen::Vector3d vector;
  for (double& value : vector) value = read_finite(reader);
  return vector;
}

Eigen::Matrix3d read_axes(ByteReader& reader) {
  std::array<double, 4> wxyz{};
  for (double& value : wxyz) value = read_finite(reader);
  const Eigen::Quaterniond axes(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  if (std::abs(axes.norm() - 1) > 1e-3) reader.fail("axes are no unit quaternion");
  return axes.normalized().toRotationMatrix();
}

Joint read_joint(ByteReader& reader, int index) {
  Joint joint;
  joint.name = reader.read_short_string();
  joint.parent = reader.read<std::int16_t>();
  if (joint.parent < -1 || joint.parent >= index) reader.fail("a parent after its child");
  joint.offset = read_vector(reader);
  const auto flags = reader.read<std::uint8_t>();
  if ((flags & ~(kHasAxes | kHasEndSite)) != 0) reader.fail("unknown flags of a joint");
  if ((flags & kHasAxes) != 0) joint.joint_from_axes = read_axes(reader);
  if ((flags & kHasEndSite) != 0) joint.end_site = read_vector(reader);
  const auto channels = reader.read<std::uint8_t>();
  if (channels > kChannelKinds) reader.fail("a joint of more than 6 channels");
  for (int c = 0; c < channels; ++c) {
    const auto kind = reader.read<std::uint8_t>();
    if (kind >= kChannelKinds) reader.fail("unknown kind of channel");
    joint.channels.push_back(static_cast<ChannelKind>(kind));
  }
  return joint;
}

/// All but the number of joints.
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

Skeleton read_joints(ByteReader& reader, int joints) {
  if (joints == 0 || joints > kMostJoints) reader.fail("between 1 and 4096 joints are allowed");
  Skeleton skeleton;
  std::vector<int> depths;  // of each joint, 1 at a root
  for (int j = 0; j < joints; ++j) {
    Joint joint = read_joint(reader, j);
    depths.push_back(joint.parent < 0 ? 1 : depths[static_cast<std::size_t>(joint.parent)] + 1);
    if (depths.back() > kMostDepth) reader.fail("joints are nested deeper than 1000");
    skeleton.add(std::move(joint));
  }
  reader.expect_end();
  return skeleton;
}

}  // namespace

std::vector<std::byte> encode_skeleton(const Skeleton& skeleton) {
  ByteWriter writer;
  writer.write(static_cast<std::uint16_t>(skeleton.joint_count()));
  writer.append(joint_bytes(skeleton));
  return deflate_bytes(writer.bytes());
}

Skeleton decode_skeleton(std::span<const std::byte> payload) {
  const auto bytes =
      inflate_bytes(payload, sizeof(std::uint16_t) + kMostBytesOfJoint * kMostJoints);
  ByteReader reader(bytes);
  const auto joints = reader.read<std::uint16_t>();
  return read_joints(reader, joints);
}

std::vector<std::byte> encode_joints(const Skeleton& skeleton) {
  std::vector<std::byte> bytes = joint_bytes(skeleton);
  ByteWriter writer;
  writer.write(static_cast<std::uint32_t>(bytes.size()));
  writer.write(static_cast<std::uint16_t>(skeleton.joint_count()));
  writer.write(static_cast<std::uint16_t>(skeleton.channel_count()));
  RangeEncoder bits;
  OwnMemory<runtime::JointByteCoder>()->run(bits, reinterpret_cast<std::uint8_t*>(bytes.data()),
                                            static_cast<std::uint32_t>(bytes.size()));
  writer.append(bits.finish());
  return writer.release();
}

Skeleton decode_joints(std::span<const std::byte> payload, std::size_t offset) {
  ByteReader head(payload, offset);
  const auto size = head.read<std::uint32_t>();
  const int joints = head.read<std::uint16_t>();
  const int channels = head.read<std::uint16_t>();
  if (joints == 0 || joints > kMostJoints) head.fail("between 1 and 4096 joints are allowed");
  if (size > kMostBytesOfJoint * static_cast<std::size_t>(joints))
    head.fail("more bytes than so many joints can have");
  std::vector<std::byte> bytes(size);
  const std::span<const std::byte> coded = head.take(head.remaining());
  runtime::RangeDecoder bits(reinterpret_cast<const std::uint8_t*>(coded.data()), coded.size());
  OwnMemory<runtime::JointByteCoder>()->run(bits, reinterpret_cast<std::uint8_t*>(bytes.data()),
                                            size);
  if (bits.failed() || !bits.is_at_end()) head.fail("the coded skeleton is damaged");
  ByteReader reader(bytes);
  Skeleton skeleton = read_joints(reader, joints);
  if (skeleton.channel_count() != channels) head.fail("not as many channels as JNTS promises");
  return skeleton;
}

}  // namespace mocapress
