// SPDX-License-Identifier: MIT
// The coding of a skeleton's bytes: FORMAT.md, JNTS. Writing and reading share this code.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "core/runtime/format/memory.h"
#include "core/runtime/format/mixed_bit.h"

namespace mocapress::runtime {

/// Finds out which field of a joint record the next byte belongs to.
class JointFields {
 public:
  enum Field : std::uint8_t {
    NameLength = 0,
    Name = 1,
    Parent = 2,  // 2 and 3: two bytes
    Offset = 4,  // 4 ... 7: the four bytes of an f32
    Flags = 8,
    Axes = 9,      // 9 ... 12
    EndSite = 13,  // 13 ... 16
    ChannelCount = 17,
    Channel = 18,
  };
  static constexpr int kCount = 19;

  /// Number of the next byte's context: its field, plus its place within a number of several bytes.
  int field() const { return static_cast<int>(field_) + index_ % width(field_); }

  void follow(std::uint8_t byte) {
    if (field_ == Flags) flags_ = byte;
    ++index_;
    if (field_ == NameLength) return enter(Name, byte);
    if (field_ == ChannelCount) return enter(Channel, byte);
    if (--left_ == 0) next_field();
  }

 private:
  static int width(Field field) {
    return field == Parent ? 2 : field == Offset || field == Axes || field == EndSite ? 4 : 1;
  }

  void enter(Field field, int size) {
    field_ = field;
    left_ = size;
    index_ = 0;
    if (size == 0) next_field();
  }

  void next_field() {
    switch (field_) {
      case Name:
        return enter(Parent, 2);
      case Parent:
        return enter(Offset, 12);
      case Offset:
        return enter(Flags, 1);
      case Flags:
        return enter(Axes, (flags_ & 1) != 0 ? 16 : 0);
      case Axes:
        return enter(EndSite, (flags_ & 2) != 0 ? 12 : 0);
      case EndSite:
        return enter(ChannelCount, 1);
      default:
        return enter(NameLength, 1);
    }
  }

  Field field_ = NameLength;
  int left_ = 1;
  int index_ = 0;
  std::uint8_t flags_ = 0;
};

/// Codes the bytes of records bit by bit. A bit is predicted from bits that came earlier in the
/// same field after the same bytes. `Fields` tells the field of each byte.
template <typename Fields>
class RecordByteCoder {
 public:
  static constexpr int kOrders = 5;
  static constexpr std::uint32_t kSlots = 1 << 14;  // for each of the kOrders kinds of contexts

  explicit RecordByteCoder(Memory& memory) : slots_(memory.take<AdaptiveBit>(kOrders * kSlots)) {}

  /// Reuses the slots of another coder, which is not used afterwards.
  explicit RecordByteCoder(AdaptiveBit* slots) : slots_(slots) {}
  AdaptiveBit* slots() const { return slots_; }

  /// Codes `count` bytes: an encoder writes those in `bytes`, a decoder reads into `bytes`. `Bits`
  /// as in CoefficientCoder.
  template <typename Bits>
  void run(Bits& bits, std::uint8_t* bytes, std::uint32_t count) {
    std::fill_n(slots_, kOrders * kSlots, AdaptiveBit());
    for (MixingWeights& set : weights_) set.of.fill(kFirstWeight);
    Fields fields;
    for (std::uint32_t i = 0; i < count && !bits.failed(); ++i) {
      const auto before = [&](std::uint32_t back) { return i >= back ? bytes[i - back] : 0U; };
      const auto field = static_cast<std::uint32_t>(fields.field());
      const std::uint32_t last = before(1);
      const std::uint32_t two = last | before(2) << 8;
      const std::uint32_t three = two | before(3) << 16;
      const std::array<std::uint32_t, kOrders> keys = {field, field | last << 8, field | two << 8,
                                                       three, field | three << 8};
      bytes[i] = code_byte(bits, bytes[i], keys, field);
      fields.follow(bytes[i]);
    }
  }

 private:
  static constexpr std::int32_t kFirstWeight = 65536 * 4 / 10;

  template <typename Bits>
  std::uint8_t code_byte(Bits& bits, std::uint8_t byte,
                         const std::array<std::uint32_t, kOrders>& keys, std::uint32_t field) {
    std::uint32_t node = 1;  // a one, followed by the bits of the byte that are already coded
    while (node < 256) {
      std::array<AdaptiveBit*, kOrders> contexts;
      for (std::uint32_t order = 0; order < kOrders; ++order)
        contexts[order] = slots_ + order * kSlots + slot(keys[order], node);
      MixedBit mixed(contexts, weights_[field]);
      const bool wanted = (byte >> (8 - std::bit_width(node)) & 1) != 0;
      const bool bit = bits.code(wanted, mixed.one());
      mixed.follow(bit);
      node = node << 1 | static_cast<std::uint32_t>(bit);
    }
    return static_cast<std::uint8_t>(node);
  }

  static std::uint32_t slot(std::uint32_t key, std::uint32_t node) {
    const std::uint32_t hash = (key * 0x9E3779B1U ^ node * 0x85EBCA6BU) * 0xC2B2AE35U;
    return hash >> 18;
  }

  AdaptiveBit* slots_;
  std::array<MixingWeights, Fields::kCount> weights_;
};

using JointByteCoder = RecordByteCoder<JointFields>;

}  // namespace mocapress::runtime
