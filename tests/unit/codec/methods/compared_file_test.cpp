// SPDX-License-Identifier: MIT
#include "core/codec/methods/compared_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/baselines/rivals.h"
#include "core/codec/format/container.h"
#include "core/codec/methods/compression_method.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

CompressedClip pca_clip() {
  const Motion motion = test::smooth_motion(40);
  CompressedClip clip;
  clip.skeleton = motion.skeleton;
  clip.frames = 40;
  clip.motion = kPca.analyse(motion, Weighting::BoneEnds)->encode(4);
  clip.provenance.weighting = Weighting::JointOrigins;
  clip.provenance.eps_cm = 1.5F;
  return clip;
}

TEST(ComparedFile, ReadsBackWhatWasWritten) {
  const CompressedClip clip = pca_clip();
  const OpenedMcpr opened = read_mcpr(write_compared(kPca, clip));
  EXPECT_EQ(opened.method, "pca");
  EXPECT_FALSE(opened.of_wavelets);
  EXPECT_FALSE(opened.coding().has_value());
  EXPECT_EQ(opened.compressed.motion, clip.motion);
  EXPECT_EQ(opened.compressed.frames, 40);
  EXPECT_EQ(opened.compressed.provenance.weighting, Weighting::JointOrigins);
  EXPECT_EQ(opened.compressed.provenance.eps_cm, 1.5F);
  EXPECT_EQ(opened.decoded.channels.rows(), 40);
  EXPECT_EQ(write_compared(kPca, opened.compressed), write_compared(kPca, clip));
}

TEST(ComparedFile, TheWaveletReaderNamesTheMethodItRefuses) {
  try {
    read_container(write_compared(kPca, pca_clip()));
    FAIL();
  } catch (const FormatError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("comparison method"));
  }
}

TEST(ComparedFile, RefusesEveryPrefix) {
  const auto file = write_compared(kPca, pca_clip());
  for (std::size_t size = 0; size < file.size(); ++size) {
    const std::vector<std::byte> prefix(file.begin(), file.begin() + static_cast<long>(size));
    EXPECT_THROW(read_mcpr(prefix), FormatError) << "of " << size << " bytes";
  }
}

TEST(ComparedFile, RefusesAMethodItDoesNotKnowByName) {
  CompressedClip clip = pca_clip();
  ByteWriter payload;
  payload.write_short_string("magic");
  payload.append(clip.motion);
  clip.motion = payload.release();
  try {
    read_mcpr(write_container(Container{clip, true}));
    FAIL();
  } catch (const FormatError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("magic"));
  }
}

TEST(ComparedFile, HasNoBasisCodingOrMethodOfWavelets) {
  CompressedClip clip = pca_clip();
  const auto file = write_compared(kPca, clip);
  clip.basis = Basis::Haar;
  clip.coding = Coding::Rle16;
  clip.provenance.method = Method::Standard;
  EXPECT_EQ(write_compared(kPca, clip), file);
}

TEST(ComparedFile, OpensWaveletsOfEveryMethodByItsName) {
  const MethodEncoder encoder(test::smooth_motion(60));
  for (const char* name :
       {"annealed", "standard", "per-channel", "haar", "linear", "closed-loop"}) {
    const Encoding made = encoder.compress(
        *find_compression_method(name),
        {.weighting = Weighting::BoneEnds, .target = {Target::Kind::CoefficientRatio, 5}});
    const OpenedMcpr opened = read_mcpr(made.file);
    EXPECT_EQ(opened.method, name);
    EXPECT_TRUE(opened.of_wavelets);
    EXPECT_EQ(opened.coding(),
              std::string_view(name) == "closed-loop" ? Coding::Adaptive : Coding::Deflate);
    EXPECT_EQ(opened.decoded.channels, made.decoded.channels);
  }
}

}  // namespace
}  // namespace mocapress
