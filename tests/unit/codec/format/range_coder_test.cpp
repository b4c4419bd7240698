// SPDX-License-Identifier: MIT
#include "core/codec/format/range_coder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <span>

#include "core/base/random.h"

namespace mocapress::range_coder_test {
namespace {

struct CodedBits {
  std::vector<bool> bits;
  std::vector<Probability> probabilities;
};

/// Bits that fall as their probabilities say, from nearly certain to even.
CodedBits random_bits(int count, std::uint64_t seed) {
  Random random(seed);
  CodedBits coded;
  for (int i = 0; i < count; ++i) {
    const auto one = static_cast<Probability>(1 + random.below(65535));
    coded.probabilities.push_back(random.below(3) == 0 ? std::min(one, Probability{20}) : one);
    coded.bits.push_back(random.below(65536) < coded.probabilities.back());
  }
  return coded;
}

std::vector<std::byte> encode(const CodedBits& coded) {
  RangeEncoder encoder;
  for (std::size_t i = 0; i < coded.bits.size(); ++i)
    encoder.code(coded.bits[i], coded.probabilities[i]);
  return encoder.finish();
}

/// The decoded values; unset if decoding was refused.
std::optional<std::vector<bool>> decode(std::span<const std::byte> bytes,
                                        const std::vector<Probability>& probabilities) {
  runtime::RangeDecoder decoder(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  std::vector<bool> bits;
  for (const Probability one : probabilities) bits.push_back(decoder.code(false, one));
  if (decoder.failed() || !decoder.is_at_end()) return std::nullopt;
  return bits;
}

TEST(RangeCoder, RestoresEveryLengthAndProbability) {
  for (int length = 0; length < 200; ++length) {
    const CodedBits coded = random_bits(length, static_cast<std::uint64_t>(length));
    EXPECT_EQ(decode(encode(coded), coded.probabilities), coded.bits) << length;
  }
  const CodedBits many = random_bits(30000, 7);
  EXPECT_EQ(decode(encode(many), many.probabilities), many.bits);
}

TEST(RangeCoder, WritesTheSameBytesWhereTheyAreChecked) {
  for (const int count : {0, 1, 7, 200, 30000}) {
    const CodedBits coded = random_bits(count, 11);
    CheckedRangeEncoder encoder;
    for (std::size_t i = 0; i < coded.bits.size(); ++i)
      encoder.code(coded.bits[i], coded.probabilities[i]);
    EXPECT_EQ(encoder.finish(), encode(coded)) << count;
  }
}

TEST(RangeCoder, RestoresTheLeastLikelyBits) {
  CodedBits unlikely;
  for (int i = 0; i < 500; ++i) {
    unlikely.bits.push_back(i % 2 == 0);
    unlikely.probabilities.push_back(i % 2 == 0 ? 1 : 65535);
  }
  EXPECT_EQ(decode(encode(unlikely), unlikely.probabilities), unlikely.bits);
}

TEST(RangeCoder, TakesAsManyBitsAsTheProbabilitiesAskFor) {
  const CodedBits coded = random_bits(30000, 3);
  double bits = 0;
  for (std::size_t i = 0; i < coded.bits.size(); ++i) {
    const double one = coded.probabilities[i] / 65536.0;
    bits -= std::log2(coded.bits[i] ? one : 1 - one);
  }
  EXPECT_LT(8.0 * static_cast<double>(encode(coded).size()), 1.001 * bits + 32);
}

TEST(RangeCoder, EveryTruncationAndAdditionIsRefusedOrDecodesToSomething) {
  const CodedBits coded = random_bits(600, 5);
  const auto bytes = encode(coded);
  int refused = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    refused += decode(std::span(bytes).first(size), coded.probabilities) ? 0 : 1;
  EXPECT_GT(refused, static_cast<int>(bytes.size()) / 2);
  auto longer = bytes;
  longer.resize(bytes.size() + 5);
  EXPECT_FALSE(decode(longer, coded.probabilities));
}

TEST(RangeCoder, WorkIsBoundedByTheBytes) {
  for (const Probability one : {1u, 16u, 65520u, 65535u}) {
    runtime::RangeDecoder decoder(nullptr, 0);
    for (int i = 0; i < 3'000'000 && !decoder.failed(); ++i) decoder.code(false, one);
    EXPECT_TRUE(decoder.exhausted());
  }
}

}  // namespace
}  // namespace mocapress::range_coder_test
