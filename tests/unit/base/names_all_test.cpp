// SPDX-License-Identifier: MIT
#include "core/base/names_all.h"

#include <gtest/gtest.h>

namespace mocapress::test {
namespace {

enum class Colour { Red, Green, Blue };

constexpr const char* kTwo[] = {"red", "green"};
constexpr const char* kThree[] = {"red", "green", "blue"};
constexpr const char* kFour[] = {"red", "green", "blue", "black"};

TEST(NamesAll, AcceptsTheTableThatNamesEveryEnumeratorAndNoOther) {
  EXPECT_TRUE(names_all<Colour>(kThree));
#ifdef __GNUC__
  EXPECT_FALSE(names_all<Colour>(kTwo));
  EXPECT_FALSE(names_all<Colour>(kFour));
#endif
}

}  // namespace
}  // namespace mocapress::test
