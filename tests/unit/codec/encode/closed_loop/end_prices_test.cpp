// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/end_prices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mocapress::end_prices_test {
namespace {

constexpr int kFrames = 200;
const std::vector<float> kOnes(64, 1);

ShortFunction ones(int first, int size) {
  return {first, size, kOnes.data()};
}

double price_of(const EndPrices& prices, const ShortFunction& function, double elsewhere) {
  return prices.price(prices.reach_of(function), elsewhere);
}

TEST(EndPrices, BeginWithHalfAtEitherEndAndTheWholeBetween) {
  const EndPrices prices(kFrames);
  EXPECT_EQ(price_of(prices, ones(0, 16), 3), 1.5);
  EXPECT_EQ(price_of(prices, ones(184, 16), 3), 1.5);
  EXPECT_EQ(price_of(prices, ones(16, 40), 3), 3);
  EXPECT_EQ(price_of(prices, ones(144, 40), 3), 3);
}

TEST(EndPrices, CountByTheShareOfAFunctionAtAnEnd) {
  const EndPrices prices(kFrames);
  double before = price_of(prices, ones(0, 16), 1);
  for (const int size : {24, 32, 64}) {
    const double price = price_of(prices, ones(0, size), 1);
    EXPECT_NEAR(price, 1 / (1 + 16.0 / size), 1e-6);
    EXPECT_DOUBLE_EQ(price_of(prices, ones(kFrames - size, size), 1), price);
    EXPECT_GT(price, before);
    before = price;
  }
}

TEST(EndPrices, FallWhereErrorsAreLargerAndRiseWhereTheyAreSmallerAtEachEndByItself) {
  EndPrices prices(kFrames);
  prices.observe({4, 0.5}, 1);
  EXPECT_DOUBLE_EQ(price_of(prices, ones(0, 16), 1), 0.5 * std::pow(4.0, -0.75));
  EXPECT_DOUBLE_EQ(price_of(prices, ones(184, 16), 1), 0.5 * std::pow(2.0, 0.75));
}

TEST(EndPrices, StayWithinAHundredthAndTheWhole) {
  EndPrices prices(kFrames);
  for (int i = 0; i < 5; ++i) prices.observe({100, 0.01}, 1);
  EXPECT_DOUBLE_EQ(price_of(prices, ones(0, 16), 1), 0.01);
  EXPECT_DOUBLE_EQ(price_of(prices, ones(184, 16), 1), 1);
}

TEST(EndPrices, AnEndWithoutErrorsKeepsItsPrice) {
  EndPrices prices(kFrames);
  prices.observe({0, 0}, 1);
  EXPECT_EQ(price_of(prices, ones(0, 16), 1), 0.5);
}

}  // namespace
}  // namespace mocapress::end_prices_test
