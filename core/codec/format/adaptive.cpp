// SPDX-License-Identifier: MIT
#include "core/codec/format/adaptive.h"

#include <bit>
#include <cmath>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/codec/encode/coefficient_model.h"
#include "core/codec/format/range_coder.h"

namespace mocapress {

std::vector<SignalNeighbours> channel_neighbours(const Skeleton& skeleton) {
  const int joints = skeleton.joint_count();
  std::vector<std::int16_t> parents;
  std::vector<std::uint8_t> channel_counts;
  for (const Joint& joint : skeleton.joints()) {
    parents.push_back(static_cast<std::int16_t>(joint.parent));
    channel_counts.push_back(static_cast<std::uint8_t>(joint.channels.size()));
  }
  std::vector<SignalNeighbours> neighbours(static_cast<std::size_t>(skeleton.channel_count()));
  OwnMemory<runtime::NeighbourFinder>(joints)->find({joints, parents.data(), channel_counts.data()},
                                                    neighbours.data());
  return neighbours;
}

void append_correction_neighbours(int count, std::vector<SignalNeighbours>& neighbours) {
  const auto first = static_cast<int>(neighbours.size());
  neighbours.resize(neighbours.size() + static_cast<std::size_t>(count));
  runtime::set_correction_neighbours(first, count, neighbours.data() + first);
}

std::vector<std::byte> adaptive_encode(const QuantisedSignals& coded,
                                       const std::vector<SignalNeighbours>& neighbours) {
  RangeEncoder bits;
  QuantisedSignals copy = coded;
  CoefficientModel model(static_cast<int>(neighbours.size()));
  code_coefficients(bits, neighbours, *model, copy);
  std::vector<std::byte> bytes = bits.finish();
  const auto scale = std::bit_cast<std::uint32_t>(coded.scale);
  bytes.insert(bytes.begin(),
               {static_cast<std::byte>(scale >> 16 & 0xFF), static_cast<std::byte>(scale >> 24)});
  return bytes;
}

QuantisedSignals adaptive_decode(std::span<const std::byte> bytes,
                                 const std::vector<SignalNeighbours>& neighbours, int length,
                                 std::size_t base_offset) {
  ByteReader reader(bytes, base_offset);
  const std::uint32_t scale = reader.read<std::uint16_t>();
  QuantisedSignals coded{
      .scale = std::bit_cast<float>(scale << 16), .step_exponent = {}, .values = {}};
  if (!std::isfinite(coded.scale) || coded.scale <= 0)
    throw FormatError(base_offset, "the scale of steps is no positive number");
  const std::span<const std::byte> coded_bits = bytes.last(reader.remaining());
  runtime::RangeDecoder bits(reinterpret_cast<const std::uint8_t*>(coded_bits.data()),
                             coded_bits.size());
  coded.step_exponent.resize(neighbours.size());
  coded.values.setZero(length, std::ssize(neighbours));
  CoefficientModel model(static_cast<int>(neighbours.size()));
  code_coefficients(bits, neighbours, *model, coded);
  const std::size_t offset = reader.offset() + bits.position();
  if (bits.exhausted()) throw FormatError(offset, "the coded bits end early");
  if (bits.refused()) throw FormatError(offset, "a number out of bounds");
  if (!bits.is_at_end()) throw FormatError(offset, "bytes after the coded bits");
  return coded;
}

}  // namespace mocapress
