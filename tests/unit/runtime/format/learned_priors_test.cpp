// SPDX-License-Identifier: MIT
#include "core/runtime/format/learned_priors.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/codec/format/adaptive.h"

namespace mocapress {
namespace {

using runtime::ContextLayout;

constexpr std::size_t kHead = 2 + runtime::MixingSets::kCount * runtime::MixingWeights::kMost;

runtime::Bytes bytes_of(const std::vector<std::uint8_t>& bytes) {
  return {bytes.data(), bytes.size(), 0};
}

/// Learned priors from clips with `signals` signals that change no weight.
std::vector<std::uint8_t> lesson(int signals) {
  std::vector<std::uint8_t> bytes(kHead);
  bytes[0] = static_cast<std::uint8_t>(signals);
  return bytes;
}

void tell(std::vector<std::uint8_t>& bytes, int skipped, std::uint8_t code) {
  for (; skipped >= 128; skipped >>= 7) bytes.push_back(static_cast<std::uint8_t>(skipped | 128));
  bytes.push_back(static_cast<std::uint8_t>(skipped));
  bytes.push_back(code);
}

TEST(LearnedPriors, ChangeTheListedContexts) {
  std::vector<std::uint8_t> bytes = lesson(3);
  bytes[2] = 0xFE;  // the first weight of the first set: -2 / 32
  tell(bytes, 7, 16 + 32 * 5);
  tell(bytes, 200, 0);
  CoefficientModel model(3);
  CoefficientModel before(3);
  ASSERT_EQ(learn(bytes_of(bytes), *model).status, MCPR_OK);
  EXPECT_EQ(model->weights[0].of[0], before->weights[0].of[0] - 4096);
  EXPECT_EQ(model->weights[0].of[1], before->weights[0].of[1]);
  EXPECT_EQ(model->contexts[7].one, runtime::squash(66));
  EXPECT_EQ(model->contexts[7].seen, 50);
  EXPECT_EQ(model->contexts[208].one, runtime::squash(-2046));
  EXPECT_EQ(model->contexts[208].seen, 3);
  for (int c = 0; c < model->layout.end; ++c)
    EXPECT_EQ(model->contexts[c].one == before->contexts[c].one, c != 7 && c != 208) << c;
}

TEST(LearnedPriors, SignalPriorsApplyOnlyToEqualSignalCounts) {
  const int shared = ContextLayout(3).shared;
  std::vector<std::uint8_t> bytes = lesson(3);
  tell(bytes, shared - 1, 5);
  tell(bytes, 0, 5);  // the first context of single signals
  for (const int signals : {2, 3, 4}) {
    CoefficientModel model(signals);
    CoefficientModel before(signals);
    ASSERT_EQ(learn(bytes_of(bytes), *model).status, MCPR_OK);
    EXPECT_EQ(model->contexts[shared - 1].seen, 3);
    EXPECT_EQ(model->contexts[shared].one != before->contexts[shared].one, signals == 3);
  }
}

TEST(LearnedPriors, WithoutBytesChangeNothing) {
  CoefficientModel model(3);
  CoefficientModel before(3);
  ASSERT_EQ(learn({}, *model).status, MCPR_OK);
  for (int c = 0; c < model->layout.end; ++c)
    ASSERT_EQ(model->contexts[c].one, before->contexts[c].one);
}

TEST(LearnedPriors, AreRefusedIfCutShortOrBeyondTheContexts) {
  std::vector<std::uint8_t> bytes = lesson(3);
  tell(bytes, ContextLayout(3).end - 1, 5);
  CoefficientModel model(3);
  EXPECT_EQ(check_learned(bytes_of(bytes)).status, MCPR_OK);
  EXPECT_EQ(learn(bytes_of(bytes), *model).status, MCPR_OK);
  for (std::size_t size = 1; size < bytes.size(); ++size) {
    const std::vector<std::uint8_t> cut(bytes.begin(),
                                        bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(check_learned(bytes_of(cut)).status == MCPR_OK, size == kHead) << size;
    EXPECT_EQ(learn(bytes_of(cut), *model).status == MCPR_OK, size == kHead) << size;
  }
  tell(bytes, 0, 5);
  EXPECT_EQ(check_learned(bytes_of(bytes)).status, MCPR_INVALID);
  std::vector<std::uint8_t> endless = lesson(3);
  endless.insert(endless.end(), 12, 0xFF);
  EXPECT_EQ(check_learned(bytes_of(endless)).status, MCPR_INVALID);
}

}  // namespace
}  // namespace mocapress
