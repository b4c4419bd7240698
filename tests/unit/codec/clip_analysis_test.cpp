// SPDX-License-Identifier: MIT
#include "core/codec/clip_analysis.h"

#include <gtest/gtest.h>

#include "core/codec/decoder.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(BasisAnalysis, AChannelKeptWholeIsNoSuddenExpense) {
  Motion motion = test::smooth_motion(128);
  // Exact with few Haar coefficients: nothing of it is left to be dropped soon.
  for (int t = 0; t < 128; ++t) motion.clip.channels(t, 4) = t / 8 % 3 == 0 ? 0.31 : 0.87;
  const BasisAnalysis haar(motion, Basis::Haar);
  std::size_t bytes = haar.rle16(haar.standard.keep(0)).size();
  for (int count = 1; count < haar.ranked.total() / 4; ++count) {
    const std::size_t next = haar.rle16(haar.standard.keep(count)).size();
    EXPECT_LE(next, bytes + 24) << count;
    bytes = next;
  }
}

TEST(BasisAnalysis, KeepingEverythingLosesNothingThatCanBeSeen) {
  const Motion motion = test::smooth_motion(64);
  const BasisAnalysis cubic(motion, Basis::Cubic);
  const auto bytes = cubic.rle16(cubic.standard.keep(cubic.ranked.total()));
  const Eigen::MatrixXd decoded = decode_signals(bytes, Coding::Rle16, Basis::Cubic, 64, 21);
  EXPECT_LT((decoded - motion.clip.channels).cwiseAbs().maxCoeff(), 1e-4);
}

}  // namespace
}  // namespace mocapress
