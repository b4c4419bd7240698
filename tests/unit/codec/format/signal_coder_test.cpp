// SPDX-License-Identifier: MIT
#include "core/codec/format/signal_coder.h"

#include <gtest/gtest.h>

#include "core/codec/decode/decoder.h"
#include "core/codec/encode/analysis/clip_analysis.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

std::vector<std::byte> code(const BasisAnalysis& basis, int count) {
  return code_signals(basis.ranked, basis.scales, basis.standard.keep(count));
}

TEST(SignalCoder, AChannelKeptWholeIsNoSuddenExpense) {
  Motion motion = test::smooth_motion(128);
  // Exact with few Haar coefficients: nothing of it is left to be dropped soon.
  for (int t = 0; t < 128; ++t) motion.clip.channels(t, 4) = t / 8 % 3 == 0 ? 0.31 : 0.87;
  const BasisAnalysis haar(motion, Basis::Haar);
  std::size_t bytes = code(haar, 0).size();
  for (int count = 1; count < haar.ranked.total() / 4; ++count) {
    const std::size_t next = code(haar, count).size();
    EXPECT_LE(next, bytes + 24) << count;
    bytes = next;
  }
}

TEST(SignalCoder, KeepingEverythingLosesNothingThatCanBeSeen) {
  const Motion motion = test::smooth_motion(64);
  const BasisAnalysis cubic(motion, Basis::Cubic);
  const auto words = code(cubic, cubic.ranked.total());
  ByteReader reader(words);
  const Eigen::MatrixXd decoded =
      read_signals(reader, Basis::Cubic, 64, motion.skeleton.channel_count());
  reader.expect_end();
  EXPECT_LT((decoded - motion.clip.channels).cwiseAbs().maxCoeff(), 1e-4);
}

}  // namespace
}  // namespace mocapress
