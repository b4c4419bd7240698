// SPDX-License-Identifier: MIT
#include "core/runtime/format/bits.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/random.h"

namespace mocapress::runtime {
namespace {

TEST(Bits, RiceCodesRoundTripWithEveryShift) {
  Random random(1);
  for (int shift = 0; shift <= kMostRiceShift; ++shift) {
    std::vector<std::uint32_t> numbers = {0, 1, 15, 16, 0xFFFFFFFF, 0x80000000};
    for (int i = 0; i < 100; ++i)
      numbers.push_back(static_cast<std::uint32_t>(random.below(std::uint64_t{1} << (i % 33))));
    std::vector<std::byte> bytes(numbers.size() * 10 + kReadAhead);
    BitWriter writer(bytes.data());
    BitWriter counter(nullptr);
    std::uint64_t expected = 0;
    for (const std::uint32_t v : numbers) {
      writer.put_rice(v, shift);
      counter.put_rice(v, shift);
      expected += static_cast<std::uint64_t>(rice_bits(v, shift));
    }
    EXPECT_EQ(writer.bits(), expected);
    EXPECT_EQ(counter.bits(), expected);
    BitReader reader(bytes.data());
    for (const std::uint32_t v : numbers) EXPECT_EQ(reader.rice(shift), v) << "shift " << shift;
  }
}

}  // namespace
}  // namespace mocapress::runtime
