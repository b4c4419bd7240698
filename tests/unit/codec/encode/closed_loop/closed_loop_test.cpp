// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/closed_loop.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/codec/decode/decoder.h"
#include "core/codec/encode/analysis/clip_analysis.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/metrics/distortion.h"
#include "core/metrics/rate.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

const ClipAnalysis& analysis() {
  static const ClipAnalysis shared(test::smooth_motion(400));
  return shared;
}

const ClosedLoop& loop() {
  return analysis().closed_loop(Basis::Cubic, Weighting::BoneEnds);
}

double exact_eps_of(const QuantisedSignals& coded) {
  const Motion& motion = analysis().motion();
  const Clip decoded{motion.clip.sample_rate_hz,
                     reconstruct(coded, analysis().in(Basis::Cubic).ranked.lifting)};
  return exact_eps(motion.skeleton, analysis().original_body(), decoded, Weighting::BoneEnds);
}

TEST(ClosedLoop, KnowsTheErrorItMakes) {
  for (const auto work :
       {ClosedLoopWork::Rounding, ClosedLoopWork::Compensation, ClosedLoopWork::Sweeps})
    for (const double scale : {0.02, 0.2, 1.5}) {
      const ClosedLoop::Result result = loop().quantise(scale, work);
      EXPECT_NEAR(result.eps_cm / exact_eps_of(result.coded), 1, 0.02) << scale;
    }
}

TEST(ClosedLoop, FinerScalesMakeLessError) {
  double before = 0;
  for (const double scale : {1e-4, 1e-3, 0.01, 0.1, 1.0, 10.0}) {
    const double eps = exact_eps_of(loop().quantise(scale).coded);
    EXPECT_GT(eps, before);
    EXPECT_LT(eps, scale);
    before = eps;
  }
}

TEST(ClosedLoop, SettlesAtTheErrorAskedFor) {
  for (const double eps_cm : {0.01, 0.03})
    for (const double scale : {2 * eps_cm, 4 * eps_cm}) {
      const ClosedLoop::Result result = loop().quantise_to(eps_cm, scale);
      EXPECT_NEAR(result.eps_cm / eps_cm, 1, 0.06) << eps_cm;
      EXPECT_GE(result.sweeps, 6);
      const double other = 0.98 * result.eps_cm;
      EXPECT_NEAR(loop().settle(result, other).eps_cm / other, 1, 0.06) << eps_cm;
    }
}

TEST(ClosedLoop, FitsAtItsFinestScale) {
  const ClosedLoop::Result result = loop().quantise(loop().finest_scale());
  EXPECT_LT(result.coded.values.cwiseAbs().maxCoeff(), kMostSteps);
  EXPECT_LT(exact_eps_of(result.coded), 1e-4);
}

TEST(ClosedLoop, FramesThatWeighMoreAreNearer) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(400);
  weights.segment(100, 20).setConstant(50);
  const auto error_there = [](const QuantisedSignals& coded) {
    const Motion& motion = analysis().motion();
    const Clip decoded{motion.clip.sample_rate_hz,
                       reconstruct(coded, analysis().in(Basis::Cubic).ranked.lifting)};
    return measure(motion.skeleton, analysis().original_body(), decoded)
        .distances.middleRows(100, 20)
        .norm();
  };
  EXPECT_LT(error_there(loop().quantise(1, ClosedLoopWork::Sweeps, weights).coded),
            0.75F * error_there(loop().quantise(1).coded));
}

TEST(ClosedLoop, IsTheSameForAnyNumberOfThreads) {
  const auto encoded = [] {
    const Encoder encoder(test::smooth_motion(200));
    return encoder
        .encode({.method = Method::ClosedLoop,
                 .weighting = Weighting::BoneEnds,
                 .target = {Target::Kind::Ratio, 40}})
        .compressed.motion;
  };
  const auto many = encoded();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(encoded(), many);
}

TEST(ClosedLoop, TakesAThirdLessThanAnnealingForTheSameError) {
  const Encoder encoder(test::smooth_motion(400));
  const auto bytes = [&](Method method) {
    return static_cast<double>(encoder
                                   .encode({.method = method,
                                            .weighting = Weighting::BoneEnds,
                                            .target = {Target::Kind::Error, 0.3}})
                                   .compressed.motion_bytes());
  };
  EXPECT_LT(bytes(Method::ClosedLoop), 0.67 * bytes(Method::Annealed));
}

TEST(ClosedLoop, HoldsAHardBound) {
  const Encoder encoder(test::smooth_motion(300));
  const Encoding bounded = encoder.encode({.method = Method::ClosedLoop,
                                           .weighting = Weighting::BoneEnds,
                                           .target = {Target::Kind::MaxError, 1}});
  EXPECT_LE(bounded.distortion.max.cm, 1);
  EXPECT_GT(bounded.distortion.max.cm, 0.98);
}

TEST(ClosedLoop, CoarsensUpToTheBoundAndNotBeyond) {
  const Motion& motion = analysis().motion();
  const Eigen::MatrixXd& tracks = analysis().original_body();
  const auto furthest_cm = [&](const QuantisedSignals& coded) {
    const Clip decoded{motion.clip.sample_rate_hz,
                       reconstruct(coded, analysis().in(Basis::Cubic).ranked.lifting)};
    return measure(motion.skeleton, tracks, decoded).max.cm;
  };
  const auto kept = [](const QuantisedSignals& coded) {
    return (coded.values.array() != 0).count();
  };
  const QuantisedSignals fine = loop().quantise(0.5).coded;
  const double bound_cm = 1.5 * furthest_cm(fine);
  ErrorBound bound(motion, Weighting::BoneEnds,
                   Eigen::VectorXd::Constant(motion.clip.frames(), bound_cm));
  const QuantisedSignals coarse = loop().coarsen({.coded = fine}, bound).coded;
  EXPECT_LE(furthest_cm(coarse), bound_cm * (1 + 1e-6));
  EXPECT_GT(furthest_cm(coarse), 0.98 * bound_cm);
  EXPECT_LT(kept(coarse), 0.95 * static_cast<double>(kept(fine)));
}

TEST(ClosedLoop, EndsWhenToldTo) {
  int reports = 0;
  const ClosedLoop::Result result =
      loop().quantise(0.5, ClosedLoopWork::Sweeps, {}, [&](const ClosedLoopProgress& p) {
        EXPECT_EQ(p.sweep, ++reports);
        return reports < 2;
      });
  EXPECT_EQ(reports, 2);
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.coded.values.rows(), 400);
}

TEST(ClosedLoop, TakesClipsOfAnyLength) {
  for (const int frames : {1, 2, 3, 5, 17}) {
    const Encoder encoder(test::smooth_motion(frames));
    const Encoding encoding = encoder.encode({.method = Method::ClosedLoop,
                                              .weighting = Weighting::BoneEnds,
                                              .target = {Target::Kind::Error, 0.5}});
    EXPECT_LE(encoding.distortion.eps_bone_ends, 0.5) << frames;
    EXPECT_EQ(encoding.decoded.frames(), frames);
  }
}

TEST(ClosedLoop, KeepsTheCoefficientRatioOfThePaperToo) {
  const Encoder encoder(test::smooth_motion(400));
  const Encoding encoding = encoder.encode({.method = Method::ClosedLoop,
                                            .weighting = Weighting::BoneEnds,
                                            .target = {Target::Kind::CoefficientRatio, 20}});
  EXPECT_NEAR(*encoding.coefficient_ratio / 20, 1, 0.02);
}

TEST(ClosedLoop, AClipWithoutFramesIsEncodedToo) {
  Motion nothing = test::smooth_motion(2);
  nothing.clip.channels.resize(0, nothing.clip.channels.cols());
  const Encoding encoding = Encoder(nothing).encode({.method = Method::ClosedLoop,
                                                     .weighting = Weighting::BoneEnds,
                                                     .target = {Target::Kind::Error, 0.5}});
  EXPECT_EQ(decode(read_container(write_container(encoding.compressed))).frames(), 0);
}

}  // namespace
}  // namespace mocapress
