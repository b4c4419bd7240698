// SPDX-License-Identifier: MIT
#include "core/codec/format/room.h"

#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/methods/compression_method.h"
#include "tests/support/test_motion.h"

namespace mocapress::room_test {
namespace {

using testing::HasSubstr;

std::string refusal(const ClipShape& shape) {
  try {
    check_room(shape);
  } catch (const Error& error) {
    return error.what();
  }
  return "fits";
}

Skeleton joints(int count, int channels = 3) {
  Skeleton skeleton;
  for (int j = 0; j < count; ++j)
    skeleton.add({.name = "j",
                  .parent = (j + 1) / 2 - 1,
                  .channels = std::vector<ChannelKind>(static_cast<std::size_t>(channels),
                                                       ChannelKind::RotationX)});
  return skeleton;
}

TEST(Room, AcceptsEachLimitAndRefusesOneMore) {
  const SegmentLayout one = SegmentLayout::whole(1);
  const Skeleton few = joints(4, 4);  // 16 channels
  EXPECT_EQ(refusal({joints(4096), 120, one}), "fits");
  EXPECT_THAT(refusal({joints(4097), 120, one}), HasSubstr("4097 joints, at most 4096"));
  EXPECT_THAT(refusal({joints(0), 120, one}), HasSubstr("no joints"));
  EXPECT_THAT(refusal({joints(2, 7), 120, one}), HasSubstr("7 channels, at most 6"));
  EXPECT_EQ(refusal({few, 120, SegmentLayout::whole(1 << 22)}), "fits");
  EXPECT_THAT(refusal({joints(1), 120, SegmentLayout::whole((1 << 22) + 1)}),
              HasSubstr("4194305 frames, at most 4194304"));
  EXPECT_THAT(refusal({joints(1, 6), 120, SegmentLayout::whole(1 << 22), 4}),
              HasSubstr("75497472 values"));
  EXPECT_THAT(refusal({few, 120, {1 << 22, 12288, 48}}), HasSubstr("values"))
      << "frames that two segments share count twice";
  EXPECT_THAT(refusal({few, 120, one, 33}), HasSubstr("33 effectors, at most 32"));
  for (const double rate : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THAT(refusal({few, rate, one}), HasSubstr("sample rate"));
}

TEST(Room, RefusesNamesAndOffsetsThatTheFileCannotHold) {
  const auto refusal_of = [](const Joint& joint) {
    Skeleton skeleton;
    skeleton.add(joint);
    return refusal({skeleton, 120, SegmentLayout::whole(1)});
  };
  EXPECT_EQ(refusal_of({.name = std::string(255, 'n')}), "fits");
  EXPECT_THAT(refusal_of({.name = std::string(256, 'n')}), HasSubstr("256 bytes, at most 255"));
  EXPECT_THAT(refusal_of({.name = "far", .offset = Eigen::Vector3d(0, 1e39, 0)}),
              HasSubstr("joint 'far'"));
  EXPECT_THAT(refusal_of({.name = "end", .end_site = Eigen::Vector3d(0, 1e39, 0)}),
              HasSubstr("joint 'end'"));
}

TEST(Room, IsCheckedBeforeEncoding) {
  Motion motion = test::smooth_motion(20);
  motion.skeleton.add({.name = std::string(300, 'n'), .parent = 0});
  const MethodEncoder encoder(motion);
  for (const CompressionMethod& compression_method : compression_methods()) {
    int steps = 0;
    try {
      encoder.compress(compression_method,
                       {.weighting = Weighting::BoneEnds, .target = {Target::Kind::Ratio, 4}},
                       [&](const EncodeProgress&) { return ++steps > 0; });
      ADD_FAILURE() << compression_method.name;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("300 bytes")) << compression_method.name;
    }
    EXPECT_EQ(steps, 0) << compression_method.name;
  }
}

}  // namespace
}  // namespace mocapress::room_test
