// SPDX-License-Identifier: MIT
#include "core/wavelet/lifting.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>

#include "core/base/random.h"

namespace mocapress::lifting_test {
namespace {

constexpr double kTolerance = 1e-12;
constexpr Basis kBases[] = {Basis::Haar, Basis::Linear, Basis::Cubic};

std::vector<double> noise(int length, unsigned seed = 1) {
  Random random(seed);
  std::vector<double> samples(static_cast<std::size_t>(length));
  for (double& sample : samples) sample = random.unit() - 0.5;
  return samples;
}

std::vector<double> forward(const Lifting& lifting, std::vector<double> samples) {
  lifting.forward(samples, samples);
  return samples;
}

std::vector<double> polynomial(int length, int degree) {
  std::vector<double> samples;
  for (int t = 0; t < length; ++t) samples.push_back(std::pow(t / 10.0 - 1.5, degree));
  return samples;
}

TEST(Lifting, InverseRestoresEveryLengthFrom1To257) {
  for (const Basis basis : kBases)
    for (int length = 1; length <= 257; ++length) {
      const Lifting lifting(basis, length);
      const std::vector<double> samples = noise(length);
      std::vector<double> restored = forward(lifting, samples);
      lifting.inverse(restored, restored);
      for (std::size_t t = 0; t < samples.size(); ++t)
        ASSERT_NEAR(restored[t], samples[t], kTolerance) << name(basis) << " length " << length;
    }
}

TEST(Lifting, FloatsAreTransformedAlikeAndRestored) {
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
    for (const int length : {1, 2, 3, 4, 5, 6, 7, 8, 9, 50, 137, 256}) {
      const Lifting lifting(basis, length);
      const Eigen::VectorXd samples = Eigen::ArrayXd::LinSpaced(length, 0, 7).sin() + 0.3;
      const std::span<const double> signal(samples.data(), static_cast<std::size_t>(length));
      Eigen::VectorXd coefficients(length);
      lifting.forward(signal, {coefficients.data(), signal.size()});
      Eigen::VectorXf in_floats = samples.cast<float>();
      const std::span<float> floats(in_floats.data(), signal.size());
      lifting.forward(floats, floats);
      ASSERT_LT((in_floats.cast<double>() - coefficients).norm(), 1e-5) << length;
      lifting.inverse(floats, floats);
      ASSERT_LT((in_floats.cast<double>() - samples).norm(), 1e-5) << length;
    }
}

TEST(Lifting, BandsCoverEveryCoefficientCoarseToFine) {
  for (int length = 1; length <= 257; ++length) {
    const Lifting lifting(Basis::Cubic, length);
    int next = 0;
    for (const Band& band : lifting.bands()) {
      EXPECT_EQ(band.first, next);
      next += band.size;
    }
    EXPECT_EQ(next, length);
    EXPECT_LT(lifting.bands().front().size, 4);
  }
}

TEST(Lifting, DetailsOfAPolynomialVanishUpToTheDegreeOfTheBasis) {
  struct Case {
    Basis basis;
    int degree;  // highest degree that the prediction reproduces, borders included
  };
  for (const auto& [basis, degree] :
       {Case{Basis::Haar, 0}, Case{Basis::Linear, 1}, Case{Basis::Cubic, 3}}) {
    for (int length : {16, 33, 100}) {
      const Lifting lifting(basis, length);
      const Band finest = lifting.bands().back();
      const auto exact = forward(lifting, polynomial(length, degree));
      const auto beyond = forward(lifting, polynomial(length, degree + 1));
      double largest_beyond = 0;
      // The odd sample after the last even one lies on a line through two samples.
      const int guessed = basis == Basis::Cubic && length % 2 == 0 ? 1 : 0;
      for (int i = finest.first; i < finest.first + finest.size - guessed; ++i) {
        EXPECT_NEAR(exact[static_cast<std::size_t>(i)], 0, 1e-9) << name(basis) << ' ' << length;
        largest_beyond = std::max(largest_beyond, std::abs(beyond[static_cast<std::size_t>(i)]));
      }
      EXPECT_GT(largest_beyond, 1e-4);
    }
  }
}

TEST(Lifting, PredictsWithTheCubicWeightsOfThePaper) {
  std::vector<double> samples(16, 0.0);
  samples[6] = 1;  // an inner even sample: 9/16 to the odd ones beside it, -1/16 to the next
  const Lifting lifting(Basis::Cubic, 16);
  const auto coefficients = forward(lifting, samples);
  const auto detail = [&](int odd) {
    return coefficients[static_cast<std::size_t>(lifting.bands().back().first + odd)];
  };
  EXPECT_NEAR(detail(1), 1.0 / 16, kTolerance);
  EXPECT_NEAR(detail(2), -9.0 / 16, kTolerance);
  EXPECT_NEAR(detail(3), -9.0 / 16, kTolerance);
  EXPECT_NEAR(detail(4), 1.0 / 16, kTolerance);
}

TEST(Lifting, GoesOnInALineBeyondTheLastEvenSample) {
  std::vector<double> samples(16, 0.0);
  samples[12] = 1;
  samples[14] = 2;
  samples[15] = 5;
  const Lifting lifting(Basis::Cubic, 16);
  EXPECT_NEAR(forward(lifting, samples)[15], 5 - 2.5, kTolerance);
}

TEST(Lifting, UpdateKeepsTheMeanOfAnEvenSplit) {
  // Away from borders the update keeps the mean in the coarse samples, so a constant stays itself.
  const std::vector<double> constant(64, 2.5);
  const Lifting lifting(Basis::Cubic, 64);
  const auto coefficients = forward(lifting, constant);
  const Band coarse = lifting.bands().front();
  for (int i = 0; i < coarse.size; ++i)
    EXPECT_NEAR(coefficients[static_cast<std::size_t>(i)], 2.5, kTolerance);
}

TEST(Lifting, IsLinear) {
  const Lifting lifting(Basis::Cubic, 77);
  const auto a = noise(77, 1);
  const auto b = noise(77, 2);
  std::vector<double> sum;
  for (std::size_t t = 0; t < 77; ++t) sum.push_back(2 * a[t] - 3 * b[t]);
  const auto transformed_a = forward(lifting, a);
  const auto transformed_b = forward(lifting, b);
  const auto transformed = forward(lifting, sum);
  for (std::size_t t = 0; t < 77; ++t)
    EXPECT_NEAR(transformed[t], 2 * transformed_a[t] - 3 * transformed_b[t], 1e-12);
}

TEST(Lifting, NormsAreThoseOfTheSynthesisFunctionsEverywhere) {
  for (const Basis basis : kBases)
    for (const int length : {5, 37, 148, 401}) {
      const Lifting lifting(basis, length);
      const std::vector<double> norms = lifting.norms();
      for (int i = 0; i < length; ++i) {
        std::vector<double> function(static_cast<std::size_t>(length), 0.0);
        function[static_cast<std::size_t>(i)] = 1;
        lifting.inverse(function, function);
        double squares = 0;
        for (const double value : function) squares += value * value;
        EXPECT_NEAR(norms[static_cast<std::size_t>(i)], std::sqrt(squares), 1e-9)
            << name(basis) << " length " << length << " coefficient " << i;
      }
    }
}

TEST(Lifting, GainsGrowByTheRootOfTwoFromFineToCoarse) {
  const Lifting lifting(Basis::Cubic, 20);  // 20, 10, 5, 3
  const std::vector<double> gains = lifting.gains();
  EXPECT_NEAR(gains[19], std::sqrt(2.0), kTolerance);
  EXPECT_NEAR(gains[5], 2, kTolerance);
  EXPECT_NEAR(gains[3], std::sqrt(8.0), kTolerance);
  EXPECT_EQ(gains[0], gains[3]);
  EXPECT_EQ(Lifting(Basis::Cubic, 3).gains(), std::vector<double>(3, 1.0));
}

}  // namespace
}  // namespace mocapress::lifting_test
