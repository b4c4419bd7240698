// SPDX-License-Identifier: MIT
#include "core/report/review_clip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "core/batch/verification.h"
#include "core/codec/methods/compression_method.h"
#include "core/report/markup.h"
#include "tests/support/test_motion.h"

namespace mocapress::test {
namespace {

std::vector<std::byte> base64_decoded(std::string_view text) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::byte> bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char letter : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<unsigned>(kLetters.find(letter));
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<std::byte>(bits >> held));
  }
  return bytes;
}

/// The files in a script: original, compressed.
std::array<std::vector<std::byte>, 2> files_in(const std::string& script) {
  std::array<std::vector<std::byte>, 2> files;
  std::size_t at = script.find(", \"");
  for (std::vector<std::byte>& file : files) {
    at = script.find('"', at) + 1;
    const std::size_t end = script.find('"', at);
    file = base64_decoded(std::string_view(script).substr(at, end - at));
    at = end + 1;
  }
  return files;
}

class ReviewClip : public testing::Test {
 protected:
  Encoding compressed_by(std::string_view method) const {
    return original_.compress(
        *find_compression_method(method),
        {.weighting = Weighting::BoneEnds, .target = {Target::Kind::Error, 1}});
  }

  const MethodEncoder original_{smooth_motion(150)};
};

TEST_F(ReviewClip, HoldsTheOriginalToAHundredthOfACentimetreAndTheFileItself) {
  const Encoding made = compressed_by("closed-loop");
  const auto [original, compressed] =
      files_in(review_clip("walk", original_.wavelets(), made.file, nullptr));
  const Verification found = verify(original, original_.wavelets());
  EXPECT_EQ(found.by, "runtime");
  EXPECT_LE(found.distortion.eps_bone_ends, 0.01);
  EXPECT_EQ(compressed, made.file);
}

TEST_F(ReviewClip, ListsTheFactsOfTheResult) {
  const Encoding made = compressed_by("closed-loop");
  for (const Weighting weighting : {Weighting::Surface, Weighting::BoneEnds}) {
    const double largest_cm = made.distortion.worst(weighting).cm;
    EXPECT_THAT(review_facts("closed-loop", 20, made.distortion, weighting, made.visibility),
                testing::ElementsAre(method_title("closed-loop"), ratio_text(20),
                                     "largest error " + format_significant(largest_cm) + " cm",
                                     testing::StartsWith("errors ")));
  }
}

TEST_F(ReviewClip, CodesAnewWhatNoEnginePlays) {
  const Encoding made = compressed_by("pca");
  ASSERT_EQ(verify(made.file, original_.wavelets()).by, "library");
  const auto [original, compressed] =
      files_in(review_clip("walk", original_.wavelets(), made.file, &made.decoded));
  const Encoder decoded({original_.wavelets().motion().skeleton, made.decoded});
  const Verification found = verify(compressed, decoded);
  EXPECT_EQ(found.by, "runtime");
  EXPECT_LE(found.distortion.eps_bone_ends, 0.01);
}

}  // namespace
}  // namespace mocapress::test
