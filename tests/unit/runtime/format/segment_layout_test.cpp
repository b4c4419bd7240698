// SPDX-License-Identifier: MIT
#include "core/runtime/format/segment_layout.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace mocapress {
namespace {

using runtime::SegmentLayout;

SegmentLayout random_layout(Random& random) {
  const int length = 256 + static_cast<int>(random.below(400));
  const int overlap = 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(length / 2)));
  return {length + 1 + static_cast<int>(random.below(3000)), length, overlap};
}

TEST(SegmentLayout, EveryFrameIsInOneSegmentOrInTwoNeighbours) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const SegmentLayout layout = random_layout(random);
    ASSERT_GE(layout.count(), 2);
    ASSERT_GT(layout.frames_of(layout.count() - 1), layout.overlap);
    std::int64_t coded = 0;
    for (int k = 0; k < layout.count(); ++k) coded += layout.frames_of(k);
    EXPECT_EQ(coded, layout.coded_frames());
    for (int t = 0; t < layout.frames; ++t) {
      int last = -1;
      int holders = 0;
      for (int k = 0; k < layout.count(); ++k)
        if (t >= layout.first(k) && t < layout.first(k) + layout.frames_of(k)) {
          ++holders;
          last = k;
        }
      const SegmentLayout::Stretch stretch = layout.stretch_at(t);
      ASSERT_TRUE(holders == 1 || holders == 2) << layout.frames << ' ' << t;
      ASSERT_EQ(stretch.segment, last);
      ASSERT_EQ(stretch.shared, holders == 2 ? t - layout.first(last) : -1);
      ASSERT_GT(stretch.frames, 0);
      ASSERT_LE(stretch.frames, layout.frames - t);
      const SegmentLayout::Stretch end = layout.stretch_at(t + stretch.frames - 1);
      ASSERT_TRUE(end.segment == last && (end.shared >= 0) == (holders == 2));
    }
  }
}

TEST(SegmentLayout, AWholeClipIsOneStretch) {
  for (const int frames : {1, 2, 5000}) {
    const SegmentLayout whole = SegmentLayout::whole(frames);
    EXPECT_EQ(whole.count(), 1);
    EXPECT_EQ(whole.coded_frames(), frames);
    EXPECT_EQ(whole.stretch_at(frames - 1).frames, 1);
    EXPECT_EQ(whole.stretch_at(0).shared, -1);
  }
  EXPECT_EQ(SegmentLayout::whole(0).count(), 1);
}

TEST(SegmentLayout, SharesOfBothSegmentsSumToOneAndGrow) {
  for (const int overlap : {1, 2, 31, 48, 4096}) {
    const SegmentLayout layout{100'000, 20'000, overlap};
    float before = 0;
    for (int i = 0; i < overlap; ++i) {
      const float share = runtime::share_of_later(layout, i);
      EXPECT_GT(share, before);
      EXPECT_LT(share, 1);
      EXPECT_FLOAT_EQ(share + runtime::share_of_later(layout, overlap - 1 - i), 1);
      EXPECT_EQ(runtime::blended(3.7F, 3.7F, share), 3.7F);
      EXPECT_FLOAT_EQ(runtime::blended(0, 1, share), share);
      EXPECT_NEAR(runtime::blended(1, 0, share), 1 - share, 1e-7);
      before = share;
    }
  }
}

TEST(SegmentLayout, NoFrameIsInThreeSegments) {
  EXPECT_TRUE(runtime::may_be_segments(1000, 256, 128));
  EXPECT_TRUE(runtime::may_be_segments(257, 256, 1));
  EXPECT_FALSE(runtime::may_be_segments(1000, 256, 129));
  EXPECT_FALSE(runtime::may_be_segments(1000, 256, 0));
  EXPECT_FALSE(runtime::may_be_segments(1000, 255, 10));
  EXPECT_FALSE(runtime::may_be_segments(1000, 1000, 10));
  EXPECT_FALSE(runtime::may_be_segments(1000, 0xFFFFFFFF, 0x80000000));
}

}  // namespace
}  // namespace mocapress
