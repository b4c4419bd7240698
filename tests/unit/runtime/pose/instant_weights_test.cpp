// SPDX-License-Identifier: MIT
// Compares weights with the transform that they are derived from.
#include "core/runtime/pose/instant_weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/runtime/pose/lifting_line.h"
#include "core/runtime/pose/pose_sampler.h"

namespace mocapress {
namespace {

using runtime::Wavelet;

std::vector<double> random_line(Random& random, int length) {
  std::vector<double> line(static_cast<std::size_t>(length));
  for (double& value : line) value = 2 * random.unit() - 1;
  return line;
}

/// The decomposition of a signal: samples at each level, and the details of each.
struct Levels {
  std::vector<std::vector<double>> details;  // the finest first
  std::vector<std::vector<double>> samples;  // element n: n levels left out

  Levels(Wavelet wavelet, int length, int levels, Random& random) {
    std::vector<int> lengths = {length};
    for (int k = 0; k < levels && lengths.back() >= runtime::kCoarsest; ++k) {
      details.push_back(random_line(random, runtime::odds_in(lengths.back())));
      lengths.push_back(runtime::evens_in(lengths.back()));
    }
    samples.resize(lengths.size());
    samples.back() = random_line(random, lengths.back());
    for (std::size_t k = details.size(); k-- > 0;) {
      std::vector<double> evens = samples[k + 1];
      samples[k].resize(static_cast<std::size_t>(lengths[k]));
      join_line(wavelet, lengths[k], evens.data(), details[k].data(), samples[k].data());
    }
  }
};

double weighed(const std::vector<double>& rows, int row, double weight) {
  if (row >= 0 && row < std::ssize(rows)) return weight * rows[static_cast<std::size_t>(row)];
  EXPECT_EQ(weight, 0);
  return 0;
}

TEST(InstantWeights, EqualTheInverseTransformAtEveryFrameOfEveryLength) {
  Random random(1);
  for (const Wavelet wavelet : {Wavelet::Haar, Wavelet::Linear, Wavelet::Cubic})
    for (int length = 1; length <= 300; length += length < 140 ? 1 : 53) {
      const Levels levels(wavelet, length, runtime::kMostKeptBands, random);
      for (int frame = 0; frame < length; ++frame) {
        const float share = frame + 1 < length && frame % 3 != 0 ? 0.375F : 0.0F;
        runtime::InstantWeights weights;
        weights.set(*runtime::poses_of(MCPR_PATH_PLAIN), wavelet, length, frame, share,
                    runtime::kMostKeptBands, 0x3F);
        ASSERT_EQ(weights.levels, std::ssize(levels.details));
        const double expected =
            levels.samples[0][static_cast<std::size_t>(frame)] * (1 - share) +
            (share > 0 ? levels.samples[0][static_cast<std::size_t>(frame) + 1] * share : 0);
        double details = 0;
        for (int b = 0;; ++b) {
          const auto at = static_cast<std::size_t>(b);
          double sum = details;
          const runtime::SampleWeights& samples = weights.samples[b];
          for (int i = 0; i < runtime::kSampleWindow; ++i)
            sum += weighed(levels.samples[at], samples.first_row + i, samples.of_row[i]);
          ASSERT_NEAR(sum, expected, 1e-3) << length << " " << frame << " " << b;
          if (b == weights.levels) break;
          const double scale = std::exp2(-15 - b / 2 + (b + 1) / 2.0) * weights.unit;
          const runtime::BandWeights& band = weights.band[b];
          for (int i = 0; i < runtime::kDetailWindow; ++i) {
            const int row = band.first_row + i;
            details += weighed(levels.details[at], row, band.of_row[2 + i] * scale);
            EXPECT_EQ(band.of_entry[row & 15], band.of_row[2 + i] * (4 >> (b / 2)));
            if (band.of_row[2 + i] == 0) continue;
            if (b == 0) {
              EXPECT_LT(i, runtime::kFinestWindow) << length << " " << frame;
            }
            EXPECT_GE(row, band.first_used);
            EXPECT_LE(row, band.last_used);
          }
        }
      }
    }
}

}  // namespace
}  // namespace mocapress
