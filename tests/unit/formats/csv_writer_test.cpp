// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/formats/csv.h"

namespace mocapress {
namespace {

TEST(Csv, NamesUnitsAndCountsTime) {
  Motion motion;
  motion.skeleton.add(
      {.name = "a,b", .channels = {ChannelKind::TranslationX, ChannelKind::RotationZ}});
  motion.clip.sample_rate_hz = 4;
  motion.clip.channels.resize(2, 2);
  motion.clip.channels << 1.5, -1e-12, 1e5, 0.123456789;
  EXPECT_EQ(csv_text(motion), "time_s,a_b.tx_cm,a_b.rz_rad\n0,1.5,0\n0.25,100000,0.123456789\n");
}

}  // namespace
}  // namespace mocapress
