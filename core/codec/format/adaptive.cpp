// SPDX-License-Identifier: MIT
#include "core/codec/format/adaptive.h"

#include <bit>

#include "core/codec/format/format_error.h"
#include "core/codec/format/range_coder.h"
#include "core/runtime/format/learned_priors.h"
#include "core/runtime/format/range_decoder.h"

namespace mocapress {
namespace {

runtime::Bytes bytes_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), 0};
}

}  // namespace

CoefficientModel::CoefficientModel(int signal_count, Untaught)
    : contexts_(static_cast<std::size_t>(runtime::ContextLayout(signal_count).end)),
      model_(signal_count, contexts_.data()) {
  model_.begin_untaught();
}

CoefficientModel CoefficientModel::untaught(int signal_count) {
  return {signal_count, Untaught()};
}

CoefficientModel::CoefficientModel(int signal_count) : CoefficientModel(signal_count, Untaught()) {
  model_.begin();
}

std::vector<SignalNeighbours> channel_neighbours(const Skeleton& skeleton) {
  const int joints = skeleton.joint_count();
  std::vector<std::int16_t> parents;
  std::vector<std::uint8_t> channel_counts;
  for (const Joint& joint : skeleton.joints()) {
    parents.push_back(static_cast<std::int16_t>(joint.parent));
    channel_counts.push_back(static_cast<std::uint8_t>(joint.channels.size()));
  }
  std::vector<SignalNeighbours> neighbours(skeleton.channel_count());
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
                                       const std::vector<SignalNeighbours>& neighbours,
                                       std::span<const std::byte> learned) {
  CheckedRangeEncoder bits;
  QuantisedSignals copy = coded;
  CoefficientModel model(static_cast<int>(neighbours.size()));
  require(runtime::learn(bytes_of(learned), *model));
  code_coefficients(bits, neighbours, *model, copy);
  std::vector<std::byte> bytes = bits.finish();
  const auto scale = std::bit_cast<std::uint32_t>(coded.scale);
  bytes.insert(bytes.begin(),
               {static_cast<std::byte>(scale >> 16 & 0xFF), static_cast<std::byte>(scale >> 24)});
  return bytes;
}

QuantisedSignals adaptive_decode(std::span<const std::byte> bytes,
                                 const std::vector<SignalNeighbours>& neighbours, int length,
                                 std::size_t base_offset, std::span<const std::byte> learned,
                                 int bands_left_out) {
  const auto signal_count = static_cast<int>(neighbours.size());
  QuantisedSignals coded;
  coded.step_exponent.resize(neighbours.size());
  coded.values.resize(length, signal_count);
  CoefficientModel model(signal_count);
  const runtime::Bands bands(length);
  const OwnMemory<runtime::CoderNotes> notes(bands, signal_count);
  require(runtime::decode_coefficients(
      {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), base_offset},
      neighbours.data(), bands, *model,
      {length, signal_count, coded.step_exponent.data(), coded.values.data()}, *notes, coded.scale,
      bytes_of(learned), bands_left_out));
  return coded;
}

std::size_t bytes_without_bands(std::span<const std::byte> bytes,
                                const std::vector<SignalNeighbours>& neighbours, int length,
                                int bands_left_out) {
  runtime::Cursor scale = bytes_of(bytes).cursor();
  QuantisedSignals coded{runtime::read_scale(scale), std::vector(neighbours.size(), 0),
                         Eigen::MatrixXi::Zero(length, std::ssize(neighbours))};
  CoefficientModel model(static_cast<int>(neighbours.size()));
  const std::size_t first = scale.offset();
  const runtime::Bytes coded_bits = bytes_of(bytes.subspan(first));
  runtime::RangeDecoder bits(coded_bits.data, coded_bits.size);
  code_coefficients(bits, neighbours, *model, coded, bands_left_out);
  return first + bits.position();
}

}  // namespace mocapress
