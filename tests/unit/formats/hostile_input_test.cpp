// SPDX-License-Identifier: MIT
// For any bytes a reader either reads or throws an InputError with a place, and nothing else.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/random.h"
#include "core/formats/amc.h"
#include "core/formats/bvh.h"
#include "core/formats/csv.h"
#include "tests/support/motion_texts.h"

namespace mocapress {
namespace {

using Reader = std::function<void(const std::string&)>;

void check_finite(const Motion& motion) {
  EXPECT_GT(motion.clip.frames(), 0);
  EXPECT_EQ(motion.clip.channels.cols(), motion.skeleton.channel_count());
  EXPECT_TRUE(motion.clip.channels.allFinite());
  for (const Joint& joint : motion.skeleton.joints()) EXPECT_TRUE(joint.offset.allFinite());
}

const Reader kReadBvh = [](const std::string& text) { check_finite(read_bvh("f", text).motion); };
const Reader kReadAsf = [](const std::string& text) {
  check_finite(read_amc("f", test::kSmallAmc, read_asf("f", text)).motion);
};
const Reader kReadAmc = [](const std::string& text) {
  check_finite(read_amc("f", text, read_asf("f", test::kSmallAsf)).motion);
};

const Reader kReadCurves = [](const std::string& text) {
  for (const ScalarTrack& track : read_csv_tracks("f", text, 3)) {
    EXPECT_EQ(track.values.size(), 3u);
    for (const float value : track.values) EXPECT_TRUE(std::isfinite(value));
  }
};

constexpr const char* kSmallCurves = "time_s,grip,blink\n0,0.25,0\n0.5,-1e-1,1\n1,7.5,0";

/// True if the text was read; a refusal must name a place.
bool reads_or_says_where(const Reader& read, const std::string& text) {
  try {
    read(text);
    return true;
  } catch (const InputError& error) {
    EXPECT_GT(error.line(), 0) << error.what();
    EXPECT_GT(error.column(), 0) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return false;
  }
}

void try_every_prefix(const Reader& read, const std::string& text) {
  for (std::size_t size = 0; size < text.size(); ++size)
    reads_or_says_where(read, text.substr(0, size));
  EXPECT_TRUE(reads_or_says_where(read, text));
}

/// Overwrites, removes and repeats parts of the text.
std::string mutated(std::string text, Random& random) {
  constexpr std::string_view kBytes = "0123456789.-+eE \n\r\t{}#:xyzXYZnaif\0\xFF\x80";
  for (auto edits = 1 + random.below(4); edits > 0; --edits) {
    const auto at = static_cast<std::size_t>(random.below(text.size()));
    const auto length = static_cast<std::size_t>(1 + random.below(12));
    switch (random.below(4)) {
      case 0:
        text[at] = kBytes[static_cast<std::size_t>(random.below(kBytes.size()))];
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      default:
        text.insert(static_cast<std::size_t>(random.below(text.size())), text.substr(at, length));
    }
    if (text.empty()) text = " ";
  }
  return text;
}

void try_mutations(const Reader& read, const std::string& text) {
  Random random(42);
  int survivors = 0;
  for (int i = 0; i < 5000; ++i) survivors += reads_or_says_where(read, mutated(text, random));
  EXPECT_GT(survivors, 50);  // else the mutations never pass the first lines
  EXPECT_LT(survivors, 4950);
}

TEST(HostileBvh, EveryPrefixReadsOrSaysWhere) {
  try_every_prefix(kReadBvh, test::kSmallBvh);
}
TEST(HostileAsf, EveryPrefixReadsOrSaysWhere) {
  try_every_prefix(kReadAsf, test::kSmallAsf);
}
TEST(HostileAmc, EveryPrefixReadsOrSaysWhere) {
  try_every_prefix(kReadAmc, test::kSmallAmc);
}

TEST(HostileCurves, EveryPrefixReadsOrSaysWhere) {
  try_every_prefix(kReadCurves, kSmallCurves);
}
TEST(HostileCurves, MutationsReadOrSayWhere) {
  try_mutations(kReadCurves, kSmallCurves);
}

TEST(HostileBvh, MutationsReadOrSayWhere) {
  try_mutations(kReadBvh, test::kSmallBvh);
}
TEST(HostileAsf, MutationsReadOrSayWhere) {
  try_mutations(kReadAsf, test::kSmallAsf);
}
TEST(HostileAmc, MutationsReadOrSayWhere) {
  try_mutations(kReadAmc, test::kSmallAmc);
}

TEST(HostileAsf, MeasuresThatWouldOverflowAreRefused) {
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"length 0.45", "length 1e-300"}, {"length 7", "length 1e300"}, {"-1 0", "-1e10 0"}})
    EXPECT_FALSE(reads_or_says_where(kReadAsf, test::replaced(test::kSmallAsf, from, to))) << to;
}

TEST(HostileBvh, NoiseIsRefused) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    std::string noise(static_cast<std::size_t>(random.below(300)), '\0');
    for (char& c : noise) c = static_cast<char>(random.below(256));
    EXPECT_FALSE(reads_or_says_where(kReadBvh, noise));
    EXPECT_FALSE(reads_or_says_where(kReadAmc, noise));
    EXPECT_FALSE(reads_or_says_where(kReadAsf, noise));
  }
}

}  // namespace
}  // namespace mocapress
