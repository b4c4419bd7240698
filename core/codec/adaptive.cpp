// SPDX-License-Identifier: MIT
#include "core/codec/adaptive.h"

#include <bit>
#include <cmath>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/codec/coefficient_model.h"
#include "core/codec/range_coder.h"

namespace mocapress {
namespace {

struct EncodingBits {
  RangeEncoder encoder;
  bool code(bool bit, Probability one) {
    encoder.code(bit, one);
    return bit;
  }
  void fail() {}
};

struct DecodingBits {
  RangeDecoder decoder;
  bool code(bool, Probability one) { return decoder.code(one); }
  [[noreturn]] void fail() { throw FormatError(0, "a number out of bounds"); }
};

}  // namespace

std::vector<SignalKin> channel_kin(const Skeleton& skeleton) {
  std::vector<SignalKin> kin(static_cast<std::size_t>(skeleton.channel_count()));
  std::vector<int> last_of(static_cast<std::size_t>(skeleton.joint_count()), -1);
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Joint& joint = skeleton.joint(j);
    int last = joint.parent < 0 ? -1 : last_of[static_cast<std::size_t>(joint.parent)];
    for (std::size_t i = 0; i < joint.channels.size(); ++i) {
      const int c = skeleton.first_channel(j) + static_cast<int>(i);
      kin[static_cast<std::size_t>(c)].sibling = last;
      last = c;
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
  CoefficientCoder<EncodingBits>(bits, kin, bands, copy).run();
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
  CoefficientCoder<DecodingBits>(bits, kin, bands, coded).run();
  bits.decoder.expect_end();
  return coded;
}

}  // namespace mocapress
