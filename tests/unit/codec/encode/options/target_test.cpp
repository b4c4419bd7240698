// SPDX-License-Identifier: MIT
#include "core/codec/encode/options/target.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

TEST(Target, OutOfReachTellsTheNearestWithItsUnit) {
  EXPECT_EQ(out_of_reach({Target::Kind::Error, 1e-9}, 0.0123456),
            "the target of 1e-09 cm is out of reach with this method: the nearest is 0.01235 cm");
  EXPECT_EQ(out_of_reach({Target::Kind::Size, 3}, 12345),
            "the target of 3 bytes is out of reach with this method: the nearest is 12345 bytes");
}

TEST(Target, ARatioOutOfReachTellsWhichFileIsTheSmaller) {
  EXPECT_EQ(out_of_reach({Target::Kind::Ratio, 25}, 79.22),
            "the target of 25:1 is out of reach with this method: the nearest is 79.22:1, a "
            "smaller file");
  EXPECT_EQ(out_of_reach({Target::Kind::Ratio, 1e6}, 812),
            "the target of 1e+06:1 is out of reach with this method: the nearest is 812:1, a "
            "larger file");
}

}  // namespace
}  // namespace mocapress
