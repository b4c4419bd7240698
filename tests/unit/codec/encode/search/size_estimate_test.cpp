// SPDX-License-Identifier: MIT
#include "core/codec/encode/search/size_estimate.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "tests/support/test_motion.h"

namespace mocapress::test {
namespace {

EncodeSettings draft_of(const Target& target) {
  return {.method = Method::ClosedLoop,
          .coding = Coding::Adaptive,
          .weighting = Weighting::BoneEnds,
          .target = target,
          .effort = Effort::Draft};
}

TEST(SizeEstimate, IsNearTheCodedBytes) {
  const Encoder encoder(smooth_motion(600));
  for (const double eps_cm : {0.05, 0.2, 1.0}) {
    const Encoding coded = encoder.encode(draft_of({Target::Kind::Error, eps_cm}));
    const QuantisedSignals values = AdaptiveSegments(coded.compressed).next();
    const auto bytes = static_cast<double>(coded.compressed.motion.size());
    const auto estimate =
        static_cast<double>(estimated_bytes(values, signal_neighbours(coded.compressed)));
    EXPECT_NEAR(estimate / bytes, 1, 0.25) << eps_cm << ": " << bytes;
  }
}

TEST(SizeEstimate, IsSmallForZeros) {
  QuantisedSignals nothing;
  nothing.step_exponent.assign(12, 0);
  nothing.values = Eigen::MatrixXi::Zero(500, 12);
  EXPECT_LT(estimated_bytes(nothing, std::vector<SignalNeighbours>(12)), 40);
  nothing.values.resize(0, 12);
  EXPECT_LT(estimated_bytes(nothing, std::vector<SignalNeighbours>(12)), 40);
}

TEST(SizeEstimate, ADraftIsTheSameWithoutBytes) {
  const Encoder encoder(smooth_motion(400));
  EncodeSettings options = draft_of({Target::Kind::Error, 0.3});
  const Encoding coded = encoder.encode(options);
  options.size_will_do = true;
  Encoding shown = encoder.encode(options);
  ASSERT_TRUE(shown.compressed.likely_bytes);
  EXPECT_TRUE(shown.compressed.motion.empty());
  EXPECT_THROW(write_container(shown.compressed), Error);
  EXPECT_NEAR(shown.distortion.eps_bone_ends, coded.distortion.eps_bone_ends, 1e-4);
  EXPECT_LT((shown.decoded.channels - coded.decoded.channels).cwiseAbs().maxCoeff(), 1e-3);
  code_motion(shown.compressed);
  EXPECT_EQ(shown.compressed.motion, coded.compressed.motion);
  EXPECT_EQ(shown.compressed.motion_bytes(), coded.compressed.motion_bytes());
  EXPECT_FALSE(shown.compressed.likely_bytes);
  EXPECT_EQ(decode(shown.compressed).channels, coded.decoded.channels);
}

TEST(SizeEstimate, LeadsADraftToASize) {
  const Encoder encoder(smooth_motion(400));
  EncodeSettings options = draft_of({Target::Kind::Size, 1500});
  options.size_will_do = true;
  Encoding shown = encoder.encode(options);
  ASSERT_TRUE(shown.compressed.likely_bytes);
  EXPECT_NEAR(static_cast<double>(shown.compressed.motion_bytes()), 1500, 300);
  code_motion(shown.compressed);
  EXPECT_NEAR(static_cast<double>(shown.compressed.motion_bytes()), 1500, 500);
}

TEST(SizeEstimate, IsOfDraftsAlone) {
  const Encoder encoder(smooth_motion(100));
  EncodeSettings options = draft_of({Target::Kind::Error, 0.3});
  options.size_will_do = true;
  options.effort = Effort::Default;
  EXPECT_FALSE(encoder.encode(options).compressed.likely_bytes);
}

}  // namespace
}  // namespace mocapress::test
