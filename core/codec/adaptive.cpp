// SPDX-License-Identifier: MIT
#include "core/codec/adaptive.h"

#include <bit>
#include <cmath>
#include <map>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/codec/coefficient_coder.h"
#include "core/codec/range_coder.h"

namespace mocapress {
namespace {

struct EncodingBits {
  RangeEncoder encoder;
  bool code(bool bit, Probability one) {
    encoder.code(bit, one);
    return bit;
  }
  void refuse() {}
};

struct DecodingBits {
  RangeDecoder decoder;
  bool code(bool, Probability one) { return decoder.code(one); }
  [[noreturn]] void refuse() { throw FormatError(0, "a number out of bounds"); }
};

}  // namespace

namespace {

/// For each joint, another that is its like on the other side; -1 where there is none before it.
std::vector<int> mirrored_joints(const Skeleton& skeleton) {
  const int count = skeleton.joint_count();
  std::vector<std::vector<int>> children(static_cast<std::size_t>(count));
  for (int j = 0; j < count; ++j)
    if (const int parent = skeleton.joint(j).parent; parent >= 0)
      children[static_cast<std::size_t>(parent)].push_back(j);
  // Subtrees of the same number have the same shape: as many channels, the same subtrees below.
  std::map<std::vector<int>, int> shapes;
  std::vector<int> shape(static_cast<std::size_t>(count));
  for (int j = count - 1; j >= 0; --j) {
    std::vector<int> description = {static_cast<int>(skeleton.joint(j).channels.size())};
    for (const int child : children[static_cast<std::size_t>(j)])
      description.push_back(shape[static_cast<std::size_t>(child)]);
    shape[static_cast<std::size_t>(j)] =
        shapes.emplace(description, static_cast<int>(shapes.size())).first->second;
  }
  std::vector<int> mirror(static_cast<std::size_t>(count), -1);
  for (const std::vector<int>& siblings : children)
    for (std::size_t i = 0; i < siblings.size(); ++i) {
      const auto j = static_cast<std::size_t>(siblings[i]);
      const int other_parent = mirror[static_cast<std::size_t>(skeleton.joint(siblings[i]).parent)];
      if (other_parent >= 0) {
        const int other = children[static_cast<std::size_t>(other_parent)][i];
        if (other < siblings[i]) mirror[j] = other;
        continue;
      }
      for (std::size_t k = 0; k < i; ++k) {
        const auto other = static_cast<std::size_t>(siblings[k]);
        if (shape[other] == shape[j] && mirror[other] < 0) mirror[j] = siblings[k];
      }
    }
  return mirror;
}

}  // namespace

std::vector<SignalKin> channel_kin(const Skeleton& skeleton) {
  const std::vector<int> mirror = mirrored_joints(skeleton);
  std::vector<SignalKin> kin(static_cast<std::size_t>(skeleton.channel_count()));
  std::vector<int> last_of(static_cast<std::size_t>(skeleton.joint_count()), -1);
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Joint& joint = skeleton.joint(j);
    const int other = mirror[static_cast<std::size_t>(j)];
    int last = joint.parent < 0 ? -1 : last_of[static_cast<std::size_t>(joint.parent)];
    for (std::size_t i = 0; i < joint.channels.size(); ++i) {
      const int channel = skeleton.first_channel(j) + static_cast<int>(i);
      SignalKin& of_channel = kin[static_cast<std::size_t>(channel)];
      of_channel.sibling = last;
      if (other >= 0) of_channel.mirror = skeleton.first_channel(other) + static_cast<int>(i);
      last = channel;
    }
    last_of[static_cast<std::size_t>(j)] = last;
  }
  return kin;
}

void append_correction_kin(int count, std::vector<SignalKin>& kin) {
  const auto first = static_cast<int>(kin.size());
  for (int s = 0; s < count; ++s)
    kin.push_back(
        {.sibling = s % 3 == 0 ? -1 : first + s - 1, .mirror = s < 3 ? -1 : first + s - 3});
}

std::vector<std::byte> adaptive_encode(const QuantisedSignals& coded,
                                       const std::vector<SignalKin>& kin,
                                       const std::vector<Band>& bands) {
  EncodingBits bits;
  QuantisedSignals copy = coded;
  CoefficientModel model(static_cast<int>(kin.size()));
  CoefficientCoder(bits, kin, bands, model, copy).run();
  std::vector<std::byte> bytes = bits.encoder.finish();
  const auto scale = std::bit_cast<std::uint32_t>(coded.scale);
  bytes.insert(bytes.begin(),
               {static_cast<std::byte>(scale >> 16 & 0xFF), static_cast<std::byte>(scale >> 24)});
  return bytes;
}

QuantisedSignals adaptive_decode(std::span<const std::byte> bytes,
                                 const std::vector<SignalKin>& kin,
                                 const std::vector<Band>& bands) {
  ByteReader reader(bytes);
  const std::uint32_t scale = reader.read<std::uint16_t>();
  QuantisedSignals coded{.scale = std::bit_cast<float>(scale << 16), .fineness = {}, .values = {}};
  if (!std::isfinite(coded.scale) || coded.scale <= 0)
    throw FormatError(0, "the scale of steps is no positive number");
  DecodingBits bits{RangeDecoder(bytes.subspan(reader.offset()), reader.offset())};
  const Eigen::Index length = bands.back().first + bands.back().size;
  coded.fineness.resize(kin.size());
  coded.values.setZero(length, std::ssize(kin));
  CoefficientModel model(static_cast<int>(kin.size()));
  CoefficientCoder(bits, kin, bands, model, coded).run();
  bits.decoder.expect_end();
  return coded;
}

}  // namespace mocapress
