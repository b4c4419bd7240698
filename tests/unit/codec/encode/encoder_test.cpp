// SPDX-License-Identifier: MIT
#include "core/codec/encode/encoder.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <thread>

#include "core/base/error.h"
#include "core/codec/decode/decoder.h"
#include "core/metrics/rate.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

const Encoder& encoder() {
  static const Encoder shared(test::smooth_motion(600));
  return shared;
}

double ratio_of(const Encoding& encoding) {
  return compression_ratio(encoder().motion().clip, encoding.compressed.motion_bytes());
}

constexpr Method kMethods[] = {Method::PerChannel, Method::Standard, Method::Annealed,
                               Method::ClosedLoop};

TEST(Encoder, MeetsARatioWithinTwoPercentWithEveryMethodAndCoding) {
  for (const Method method : kMethods)
    for (const Coding coding : {Coding::Rle16, Coding::Deflate})
      for (const double ratio : {12.0, 25.0, 60.0}) {
        const Encoding encoding = encoder().encode({.method = method,
                                                    .coding = coding,
                                                    .weighting = Weighting::BoneEnds,
                                                    .target = {Target::Kind::Ratio, ratio}});
        EXPECT_NEAR(ratio_of(encoding) / ratio, 1, 0.02) << name(method) << ' ' << name(coding);
      }
}

TEST(Encoder, KeepsThePapersNumberOfCoefficients) {
  const Encoding encoding = encoder().encode({.method = Method::Annealed,
                                              .weighting = Weighting::BoneEnds,
                                              .target = {Target::Kind::CoefficientRatio, 20}});
  EXPECT_NEAR(*encoding.coefficient_ratio, 20, 0.05);
}

TEST(Encoder, StaysBelowEveryBound) {
  for (const Method method : kMethods) {
    const Encoding small = encoder().encode(
        {.method = method, .weighting = Weighting::BoneEnds, .target = {Target::Kind::Size, 2500}});
    EXPECT_LE(small.compressed.motion_bytes(), 2500u);
    EXPECT_GT(small.compressed.motion_bytes(), 2400u);
    const Encoding near = encoder().encode(
        {.method = method, .weighting = Weighting::BoneEnds, .target = {Target::Kind::Error, 0.5}});
    EXPECT_LE(near.distortion.eps_bone_ends, 0.5);
    EXPECT_GT(near.distortion.eps_bone_ends, 0.45);
    const Encoding bounded = encoder().encode({.method = method,
                                               .weighting = Weighting::BoneEnds,
                                               .target = {Target::Kind::MaxError, 2}});
    EXPECT_LE(bounded.distortion.max.cm, 2);
  }
}

TEST(Encoder, RefusesAnUnreachableTargetWithTheBestThatWasReached) {
  EXPECT_THROW(encoder().encode({.method = Method::Annealed,
                                 .weighting = Weighting::BoneEnds,
                                 .target = {Target::Kind::Ratio, 1e6}}),
               TargetMissed);
  EXPECT_THROW(encoder().encode({.method = Method::Annealed,
                                 .weighting = Weighting::BoneEnds,
                                 .target = {Target::Kind::Error, 1e-8}}),
               TargetMissed);
  try {
    encoder().encode({.method = Method::Standard,
                      .weighting = Weighting::BoneEnds,
                      .target = {Target::Kind::Size, 5}});
    FAIL();
  } catch (const TargetMissed& error) {
    EXPECT_NE(std::string(error.what()).find("the nearest is"), std::string::npos);
  }
}

TEST(Encoder, KeepingEverythingMeetsARatioThatAsksForLess) {
  const Encoding encoding = encoder().encode({.method = Method::Standard,
                                              .weighting = Weighting::BoneEnds,
                                              .target = {Target::Kind::Ratio, 1.01}});
  EXPECT_GE(ratio_of(encoding), 1.01);
  EXPECT_LT(encoding.distortion.max.cm, 0.2);
}

TEST(Encoder, DistortionIsThatOfTheDecodedBytes) {
  const Encoding encoding =
      encoder().encode({.method = Method::Annealed, .weighting = Weighting::BoneEnds});
  const Motion& motion = encoder().motion();
  EXPECT_EQ(decode(encoding.compressed).channels, encoding.decoded.channels);
  EXPECT_EQ(measure(motion.skeleton, motion.clip, encoding.decoded).eps_bone_ends,
            encoding.distortion.eps_bone_ends);
}

TEST(Encoder, AnnealedBeatsStandardAtTheSameSize) {
  const auto eps = [](Method method) {
    return encoder()
        .encode({.method = method,
                 .weighting = Weighting::BoneEnds,
                 .target = {Target::Kind::Ratio, 40}})
        .distortion.eps_bone_ends;
  };
  EXPECT_LT(eps(Method::Annealed), eps(Method::Standard));
}

TEST(Encoder, GivesTheSameBytesForTheSameSeedOnAnyNumberOfThreads) {
  const EncodeSettings options{.method = Method::Annealed,
                               .weighting = Weighting::BoneEnds,
                               .target = {Target::Kind::Ratio, 30},
                               .seed = 3};
  const Encoding many = encoder().encode(options);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(Encoder(test::smooth_motion(600)).encode(options).compressed.motion,
            many.compressed.motion);
}

TEST(Encoder, ServesSeveralThreadsAtATime) {
  const Encoder fresh(test::smooth_motion(200));
  std::vector<std::vector<std::byte>> results(4);
  {
    std::vector<std::jthread> threads;
    for (auto& result : results)
      threads.emplace_back(
          [&] { result = fresh.encode({.method = Method::Annealed}).compressed.motion; });
  }
  for (const auto& result : results) EXPECT_EQ(result, results.front());
}

TEST(Encoder, EndsEarlyWithTheBestSoFarWhenToldTo) {
  const Encoding encoding =
      encoder().encode({.method = Method::Annealed,
                        .weighting = Weighting::BoneEnds,
                        .target = {Target::Kind::Ratio, 30}},
                       [](const EncodeProgress& progress) { return progress.iteration < 5; });
  EXPECT_FALSE(encoding.complete);
  EXPECT_EQ(encoding.iterations, 5);
  EXPECT_GT(encoding.decoded.frames(), 0);
}

TEST(Encoder, ASearchCutShortIsNotCompleteEvenIfAnEarlierTrialWasBetter) {
  for (const double error_cm : {0.1, 0.3, 0.5, 1.0, 2.0}) {
    bool reached = false;
    const Encoding encoding = encoder().encode({.method = Method::Annealed,
                                                .weighting = Weighting::BoneEnds,
                                                .target = {Target::Kind::Error, error_cm}},
                                               [&](const EncodeProgress& progress) {
                                                 reached = reached || progress.pass > 0;
                                                 return progress.pass == 0;
                                               });
    EXPECT_EQ(encoding.complete, !reached) << error_cm;
  }
}

TEST(Encoder, TakesClipsOfAnyLength) {
  for (const int frames : {0, 1, 2, 3, 4, 5, 7}) {
    const Encoder tiny(test::smooth_motion(frames));
    const Encoding encoding = tiny.encode({.method = Method::Annealed,
                                           .weighting = Weighting::BoneEnds,
                                           .target = {Target::Kind::CoefficientRatio, 1}});
    EXPECT_EQ(encoding.decoded.frames(), frames);
    EXPECT_LT(encoding.distortion.max.cm, 0.1);
  }
}

}  // namespace
}  // namespace mocapress
