// SPDX-License-Identifier: MIT
#include "core/codec/methods/compression_method.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/codec/format/container.h"
#include "core/codec/methods/compared_file.h"
#include "core/runtime/format/coded_error.h"
#include "tests/support/test_motion.h"

namespace mocapress::compression_method_test {
namespace {

constexpr double kRawBytes = 120 * 21 * 4;

class EveryMethod : public testing::Test {
 protected:
  static void SetUpTestSuite() { encoder = new MethodEncoder(test::smooth_motion(120)); }
  static void TearDownTestSuite() { delete encoder; }

  static Encoding compress(const CompressionMethod& compression_method, Target target,
                           Weighting weighting = Weighting::BoneEnds) {
    return encoder->compress(compression_method, {.weighting = weighting, .target = target});
  }
  static const MethodEncoder* encoder;
};
const MethodEncoder* EveryMethod::encoder = nullptr;

TEST(CompressionMethods, AreNamedInTheOrderOfThePaper) {
  std::vector<std::string_view> names;
  for (const CompressionMethod& compression_method : compression_methods()) {
    names.push_back(compression_method.name);
    EXPECT_EQ(find_compression_method(compression_method.name), &compression_method);
    EXPECT_FALSE(compression_method.title.empty());
    EXPECT_FALSE(compression_method.note.empty());
  }
  EXPECT_THAT(names, testing::ElementsAre("annealed", "standard", "per-channel", "haar", "linear",
                                          "closed-loop", "pca", "subsample", "quaternion",
                                          "liu-mcmillan", "arikan", "key-frames"));
  EXPECT_EQ(find_compression_method("magic"), nullptr);
}

TEST(CompressionMethods, WaveletMethodsSetMethodAndBasis) {
  EncodeSettings options;
  EXPECT_TRUE(choose_wavelets(*find_compression_method("haar"), options));
  EXPECT_EQ(options.method, Method::Standard);
  EXPECT_EQ(options.basis, Basis::Haar);
  EXPECT_FALSE(choose_wavelets(*find_compression_method("pca"), options));
  EXPECT_EQ(options.basis, Basis::Haar);
}

TEST_F(EveryMethod, ComesNearARatio) {
  for (const CompressionMethod& compression_method : compression_methods()) {
    const Encoding made = compress(compression_method, {Target::Kind::Ratio, 6});
    const double ratio = kRawBytes / static_cast<double>(made.compressed.motion_bytes());
    const bool coarse = compression_method.name == "pca" || compression_method.name == "subsample";
    EXPECT_NEAR(ratio / 6, 1, coarse ? 0.25 : 0.05) << compression_method.name;
  }
}

TEST_F(EveryMethod, KeepsAnErrorASizeAndALargestError) {
  for (const CompressionMethod& compression_method : compression_methods()) {
    const Weighting weighting = Weighting::JointOrigins;
    const auto error =
        compress(compression_method, {Target::Kind::Error, 0.6}, weighting).distortion;
    EXPECT_LE(error.eps(weighting), 0.6) << compression_method.name;
    EXPECT_GT(error.eps(weighting), 0.1) << compression_method.name << " wastes";
    EXPECT_LE(compress(compression_method, {Target::Kind::Size, 2500}).compressed.motion_bytes(),
              2500u)
        << compression_method.name;
    EXPECT_LE(compress(compression_method, {Target::Kind::MaxError, 2}).distortion.max.cm, 2)
        << compression_method.name;
  }
}

TEST_F(EveryMethod, SaysWhenATargetIsOutOfReach) {
  for (const CompressionMethod& compression_method : compression_methods()) {
    EXPECT_THROW(compress(compression_method, {Target::Kind::Error, 1e-9}), TargetMissed);
    EXPECT_THROW(compress(compression_method, {Target::Kind::Size, 2}), TargetMissed);
    EXPECT_THROW(compress(compression_method, {Target::Kind::Ratio, 1e6}), TargetMissed);
  }
}

TEST_F(EveryMethod, WritesAFileThatReadsAsWhatWasMeasured) {
  for (const CompressionMethod& compression_method : compression_methods()) {
    const Encoding made =
        compress(compression_method, {Target::Kind::Ratio, 8}, Weighting::JointOrigins);
    const OpenedMcpr opened = read_mcpr(made.file);
    EXPECT_EQ(opened.method, compression_method.name);
    EXPECT_EQ(opened.of_wavelets, find_comparison_method(compression_method.name) == nullptr);
    EXPECT_EQ(opened.compressed.motion_bytes(), made.compressed.motion_bytes());
    EXPECT_EQ(opened.compressed.provenance.weighting, Weighting::JointOrigins);
    EXPECT_EQ(opened.compressed.provenance.eps_cm,
              runtime::rounded_error(static_cast<float>(made.distortion.eps_joint_origins)));
    // The file has the skeleton in 32-bit floats.
    const Motion& motion = encoder->wavelets().motion();
    EXPECT_NEAR(measure(motion.skeleton, motion.clip, opened.decoded).eps_bone_ends,
                made.distortion.eps_bone_ends, 1e-4)
        << compression_method.name;
  }
}

TEST_F(EveryMethod, OnlyWaveletsKnowACoefficientRatio) {
  EXPECT_TRUE(compress(*find_compression_method("haar"), {Target::Kind::CoefficientRatio, 9})
                  .coefficient_ratio.has_value());
  EXPECT_THROW(compress(*find_compression_method("pca"), {Target::Kind::CoefficientRatio, 9}),
               Error);
  EXPECT_FALSE(compress(*find_compression_method("pca"), {Target::Kind::Ratio, 6})
                   .coefficient_ratio.has_value());
  EXPECT_TRUE(compress(*find_compression_method("annealed"), {}).iterations.has_value());
  EXPECT_FALSE(compress(*find_compression_method("standard"), {}).iterations.has_value());
}

TEST_F(EveryMethod, EndsEarlyWithTheBestSoFarWhenTold) {
  for (const char* name : {"annealed", "subsample"}) {
    int calls = 0;
    const Encoding made =
        encoder->compress(*find_compression_method(name), {}, [&](const EncodeProgress&) {
          ++calls;
          return false;
        });
    EXPECT_EQ(calls, 1);
    EXPECT_FALSE(made.complete);
    EXPECT_EQ(made.decoded.frames(), 120);
  }
}

}  // namespace
}  // namespace mocapress::compression_method_test
