// SPDX-License-Identifier: MIT
#include "core/compare/contender.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/codec/container.h"
#include "core/compare/compared_file.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

constexpr double kRawBytes = 120 * 21 * 4;

class EveryContender : public testing::Test {
 protected:
  static void SetUpTestSuite() { encoder = new ContenderEncoder(test::smooth_motion(120)); }
  static void TearDownTestSuite() { delete encoder; }

  static Compression compress(const Contender& contender, Target target,
                              Weighting weighting = Weighting::BoneEnds) {
    return encoder->compress(contender, {.weighting = weighting, .target = target});
  }
  static const ContenderEncoder* encoder;
};
const ContenderEncoder* EveryContender::encoder = nullptr;

TEST(Contenders, AreNamedInTheOrderOfThePaper) {
  std::vector<std::string_view> names;
  for (const Contender& contender : contenders()) {
    names.push_back(contender.name);
    EXPECT_EQ(find_contender(contender.name), &contender);
    EXPECT_FALSE(contender.title.empty());
    EXPECT_FALSE(contender.note.empty());
  }
  EXPECT_THAT(names, testing::ElementsAre("annealed", "standard", "per-channel", "haar", "linear",
                                          "closed-loop", "pca", "subsample", "quaternion",
                                          "liu-mcmillan", "arikan"));
  EXPECT_EQ(find_contender("magic"), nullptr);
}

TEST(Contenders, OfWaveletsSetMethodAndBasisAndOthersNothing) {
  EncodeOptions options;
  EXPECT_TRUE(choose_wavelets(*find_contender("haar"), options));
  EXPECT_EQ(options.method, Method::Standard);
  EXPECT_EQ(options.basis, Basis::Haar);
  EXPECT_FALSE(choose_wavelets(*find_contender("pca"), options));
  EXPECT_EQ(options.basis, Basis::Haar);
}

TEST_F(EveryContender, ComesNearARatio) {
  for (const Contender& contender : contenders()) {
    const Compression made = compress(contender, {Target::Kind::Ratio, 6});
    const double ratio = kRawBytes / static_cast<double>(made.motion_bytes);
    const bool coarse = contender.name == "pca" || contender.name == "subsample";
    EXPECT_NEAR(ratio / 6, 1, coarse ? 0.25 : 0.05) << contender.name;
  }
}

TEST_F(EveryContender, KeepsAnErrorASizeAndALargestError) {
  for (const Contender& contender : contenders()) {
    const Weighting weighting = Weighting::JointOrigins;
    const auto error = compress(contender, {Target::Kind::Error, 0.6}, weighting).distortion;
    EXPECT_LE(error.eps(weighting), 0.6) << contender.name;
    EXPECT_GT(error.eps(weighting), 0.1) << contender.name << " wastes";
    EXPECT_LE(compress(contender, {Target::Kind::Size, 2500}).motion_bytes, 2500u)
        << contender.name;
    EXPECT_LE(compress(contender, {Target::Kind::MaxError, 2}).distortion.max.cm, 2)
        << contender.name;
  }
}

TEST_F(EveryContender, SaysWhenATargetIsOutOfReach) {
  for (const Contender& contender : contenders()) {
    EXPECT_THROW(compress(contender, {Target::Kind::Error, 1e-9}), TargetMissed);
    EXPECT_THROW(compress(contender, {Target::Kind::Size, 2}), TargetMissed);
    EXPECT_THROW(compress(contender, {Target::Kind::Ratio, 1e6}), TargetMissed);
  }
}

TEST_F(EveryContender, WritesAFileThatReadsAsWhatWasMeasured) {
  for (const Contender& contender : contenders()) {
    const Compression made = compress(contender, {Target::Kind::Ratio, 8}, Weighting::JointOrigins);
    const OpenedMcpr opened = read_mcpr(made.file);
    EXPECT_EQ(opened.method, contender.name);
    EXPECT_EQ(opened.of_wavelets, find_comparison_method(contender.name) == nullptr);
    EXPECT_EQ(opened.compressed.motion_bytes(), made.motion_bytes);
    EXPECT_EQ(opened.compressed.provenance.weighting, Weighting::JointOrigins);
    EXPECT_FLOAT_EQ(opened.compressed.provenance.eps_cm,
                    static_cast<float>(made.distortion.eps_joint_origins));
    // The file has the skeleton in 32-bit floats.
    const Motion& motion = encoder->wavelets().motion();
    EXPECT_NEAR(measure(motion.skeleton, motion.clip, opened.decoded).eps_bone_ends,
                made.distortion.eps_bone_ends, 1e-4)
        << contender.name;
  }
}

TEST_F(EveryContender, OfWaveletsAloneKnowsACoefficientRatio) {
  EXPECT_TRUE(compress(*find_contender("haar"), {Target::Kind::CoefficientRatio, 9})
                  .coefficient_ratio.has_value());
  EXPECT_THROW(compress(*find_contender("pca"), {Target::Kind::CoefficientRatio, 9}), Error);
  EXPECT_FALSE(
      compress(*find_contender("pca"), {Target::Kind::Ratio, 6}).coefficient_ratio.has_value());
  EXPECT_TRUE(compress(*find_contender("annealed"), {}).iterations.has_value());
  EXPECT_FALSE(compress(*find_contender("standard"), {}).iterations.has_value());
}

TEST_F(EveryContender, EndsEarlyWithTheBestSoFarWhenTold) {
  for (const char* name : {"annealed", "subsample"}) {
    int calls = 0;
    const Compression made =
        encoder->compress(*find_contender(name), {}, [&](const EncodeProgress&) {
          ++calls;
          return false;
        });
    EXPECT_EQ(calls, 1);
    EXPECT_FALSE(made.complete);
    EXPECT_EQ(made.decoded.frames(), 120);
  }
}

}  // namespace
}  // namespace mocapress
