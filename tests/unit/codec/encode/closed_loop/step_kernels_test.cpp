// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/step_kernels.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/random.h"
#include "core/codec/format/quantised_signals.h"

namespace mocapress::step_kernels_test {
namespace {

// As many as make up vectors of any length, and some that are left over.
constexpr int kMostNumbers = 21;

template <typename Number>
std::vector<Number> numbers(Random& random, int count) {
  std::vector<Number> numbers(static_cast<std::size_t>(count));
  for (Number& number : numbers) number = static_cast<Number>(20 * random.unit() - 10);
  return numbers;
}

TEST(StepKernels, TruncateTowardsZeroAfterAddingForAnyCount) {
  Random random(3);
  for (int count = 0; count <= kMostNumbers; ++count) {
    const auto coefficients = numbers<double>(random, count);
    const auto less = numbers<float>(random, count);
    std::vector<int> values(coefficients.size());
    cut_to_steps(coefficients.data(), less.data(), count, 3, 0.25, values.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double steps = 3 * (coefficients[i] - static_cast<double>(less[i]));
      EXPECT_EQ(values[i], static_cast<int>(steps < 0 ? steps - 0.25 : steps + 0.25)) << count;
    }
  }
}

TEST(StepKernels, CutNothingBeyondTheMostSteps) {
  const std::vector<double> coefficients = {1e300, -1e300, 4};
  const std::vector<float> less(3, 0);
  std::vector<int> values(3);
  cut_to_steps(coefficients.data(), less.data(), 3, 1, 0.5, values.data());
  EXPECT_EQ(values, (std::vector<int>{kMostSteps, -kMostSteps, 4}));
}

TEST(StepKernels, FindDifferencesForAnyNumberOfCoefficients) {
  Random random(5);
  for (int count = 0; count <= kMostNumbers; ++count) {
    const auto coefficients = numbers<double>(random, count);
    const auto values = numbers<int>(random, count);
    std::vector<float> differences(coefficients.size());
    find_differences(values.data(), count, 0.7, coefficients.data(), differences.data());
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_EQ(differences[i], static_cast<float>(values[i] * 0.7 - coefficients[i])) << count;
  }
}

TEST(StepKernels, VisitInTheirOrderWhatIsNotZeroOrSteep) {
  Random random(7);
  for (int count = 0; count <= kMostNumbers; ++count) {
    const int first = 2;
    const auto slopes = numbers<float>(random, first + count);
    const std::vector<float> curves(slopes.size(), 2);
    std::vector<int> values(slopes.size());
    for (int& value : values) value = random.below(4) == 0 ? 1 : 0;
    std::vector<int> expected;
    for (int c = first; c < first + count; ++c)
      if (const auto i = static_cast<std::size_t>(c);
          values[i] != 0 || std::abs(slopes[i]) >= 3 * curves[i])
        expected.push_back(c);
    std::vector<int> visited;
    visit_where({first, count}, values.data(), slopes.data(), curves.data(), 3,
                [&](int c) { visited.push_back(c); });
    EXPECT_EQ(visited, expected) << count;
  }
}

}  // namespace
}  // namespace mocapress::step_kernels_test
