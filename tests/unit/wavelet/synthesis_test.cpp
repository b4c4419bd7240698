// SPDX-License-Identifier: MIT
#include "core/wavelet/synthesis.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

TEST(Synthesis, FunctionsAreWhatTheInverseMakesOfOneCoefficient) {
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
    for (const int length : {1, 3, 4, 7, 50, 137, 300}) {
      const Lifting lifting(basis, length);
      const Synthesis synthesis(lifting);
      for (int c = 0; c < length; ++c) {
        Eigen::VectorXd expected = Eigen::VectorXd::Unit(length, c);
        const std::span<double> samples(expected.data(), static_cast<std::size_t>(length));
        lifting.inverse(samples, samples);
        const SynthesisFunction function = synthesis[c];
        ASSERT_GE(function.first, 0);
        ASSERT_LE(function.first + function.values.size(), length);
        expected.segment(function.first, function.values.size()) -= function.values;
        ASSERT_LT(expected.cwiseAbs().maxCoeff(), 1e-12) << length << ' ' << c;
      }
    }
}

TEST(Synthesis, CorrelationIsTheInnerProductWithEachFunction) {
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
    for (const int length : {1, 2, 3, 4, 5, 6, 7, 8, 50, 137}) {
      const Lifting lifting(basis, length);
      const Synthesis synthesis(lifting);
      const Eigen::VectorXd samples = Eigen::ArrayXd::LinSpaced(length, 0, 5).sin() + 0.3;
      Eigen::VectorXd products(length);
      lifting.correlate(std::span(samples.data(), static_cast<std::size_t>(length)),
                        std::span(products.data(), static_cast<std::size_t>(length)));
      for (int c = 0; c < length; ++c) {
        const SynthesisFunction function = synthesis[c];
        ASSERT_NEAR(products(c),
                    function.values.dot(samples.segment(function.first, function.values.size())),
                    1e-11)
            << length << ' ' << c;
      }
    }
}

TEST(Synthesis, ShortFunctionsAreTheSameInFloats) {
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
    for (const int length : {1, 3, 4, 7, 50, 137, 300}) {
      const Lifting lifting(basis, length);
      const Synthesis synthesis(lifting);
      const ShortFunctions short_functions(lifting);
      Eigen::VectorXd samples = Eigen::VectorXd::Zero(length + ShortFunction::kVector);
      samples.head(length) = Eigen::ArrayXd::LinSpaced(length, 0, 5).sin() + 0.3;
      const Eigen::VectorXf in_floats = samples.cast<float>();
      for (int c = 0; c < length; ++c) {
        const SynthesisFunction function = synthesis[c];
        const ShortFunction same = short_functions[c];
        ASSERT_EQ(same.first(), function.first);
        ASSERT_EQ(same.size(), function.values.size());
        ASSERT_LT((same.values().matrix() - function.values.cast<float>()).norm(), 1e-6);
        const auto under = samples.segment(function.first, function.values.size());
        ASSERT_NEAR(same.dot(in_floats.data()), function.values.dot(under), 1e-3);
        ASSERT_NEAR(same.dot_of_squares(in_floats.data()), function.values.cwiseAbs2().dot(under),
                    1e-3);
      }
    }
}

TEST(Synthesis, FloatsAreCorrelatedAlike) {
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
    for (const int length : {1, 2, 3, 4, 5, 6, 7, 8, 50, 137}) {
      const Lifting lifting(basis, length);
      const Eigen::VectorXd samples = Eigen::ArrayXd::LinSpaced(length, 0, 5).sin() + 0.3;
      Eigen::VectorXd products(length);
      lifting.correlate(std::span(samples.data(), static_cast<std::size_t>(length)),
                        std::span(products.data(), static_cast<std::size_t>(length)));
      Eigen::VectorXf in_floats = samples.cast<float>();
      const std::span<float> signal(in_floats.data(), static_cast<std::size_t>(length));
      lifting.correlate(signal, signal);
      ASSERT_LT((in_floats.cast<double>() - products).norm(), 1e-5 * products.norm());
    }
}

TEST(Synthesis, FunctionsAreShort) {
  const Lifting lifting(Basis::Cubic, 1000);
  const Synthesis synthesis(lifting);
  const Band& finest = lifting.bands().back();
  EXPECT_LE(synthesis[finest.first + finest.size / 2].values.size(), 15);
}

}  // namespace
}  // namespace mocapress
