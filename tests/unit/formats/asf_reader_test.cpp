// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <numbers>

#include "core/base/error.h"
#include "core/formats/asf.h"
#include "tests/support/motion_texts.h"

namespace mocapress::asf_reader_test {
namespace {

using test::kSmallAsf;
using test::replaced;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kCm = 2.54 / 0.45;
constexpr double kRounding = 1e-12;

AsfSkeleton read(const std::string& text) {
  return read_asf("f.asf", text);
}

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "reads";
}

TEST(Asf, OrdersJointsParentFirstWhateverTheOrderOfLines) {
  const AsfSkeleton skeleton = read(kSmallAsf);
  ASSERT_EQ(skeleton.joints.size(), 4u);
  EXPECT_EQ(skeleton.joints[0].joint.name, "root");
  EXPECT_EQ(skeleton.joints[1].joint.name, "thigh");
  EXPECT_EQ(skeleton.joints[2].joint.name, "shin");
  EXPECT_EQ(skeleton.joints[3].joint.name, "arm");
  EXPECT_EQ(skeleton.joints[2].joint.parent, 1);
  EXPECT_EQ(skeleton.joints[3].joint.parent, 0);
}

TEST(Asf, StartsABoneWhereItsParentEndsInCentimetres) {
  const AsfSkeleton skeleton = read(kSmallAsf);
  EXPECT_EQ(skeleton.joints[1].joint.offset, Eigen::Vector3d(0, 0, 0));
  EXPECT_NEAR((skeleton.joints[2].joint.offset - Eigen::Vector3d(0, -7 * kCm, 0)).norm(), 0,
              kRounding);
  EXPECT_FALSE(skeleton.joints[1].joint.end_site);
  EXPECT_NEAR((*skeleton.joints[2].joint.end_site - Eigen::Vector3d(0, -8 * kCm, 0)).norm(), 0,
              kRounding);
}

TEST(Asf, TurnsDofIntoChannelsInProductOrder) {
  const AsfSkeleton skeleton = read(kSmallAsf);
  using enum ChannelKind;
  EXPECT_EQ(skeleton.joints[1].joint.channels,
            (std::vector<ChannelKind>{RotationZ, RotationY, RotationX}));
  EXPECT_EQ(skeleton.joints[1].columns, (std::vector<int>{2, 1, 0}));
  EXPECT_EQ(skeleton.joints[2].joint.channels, (std::vector<ChannelKind>{RotationX}));
  EXPECT_TRUE(skeleton.joints[3].joint.channels.empty());
}

TEST(Asf, TurnsTheAxesInEveryOrder) {
  const double x = 10 * kDegree;
  const double y = 20 * kDegree;
  const double z = 30 * kDegree;
  const Eigen::Matrix3d rx = axis_rotation(0, x);
  const Eigen::Matrix3d ry = axis_rotation(1, y);
  const Eigen::Matrix3d rz = axis_rotation(2, z);
  const std::vector<std::pair<std::string, Eigen::Matrix3d>> cases = {
      {"XYZ", rz * ry * rx}, {"XZY", ry * rz * rx}, {"YXZ", rz * rx * ry},
      {"YZX", rx * rz * ry}, {"ZXY", ry * rx * rz}, {"zyx", rx * ry * rz}};
  for (const auto& [order, axes] : cases) {
    const AsfSkeleton skeleton =
        read(replaced(kSmallAsf, "axis 0 0 0 XYZ", "axis 10 20 30 " + order));
    EXPECT_NEAR((skeleton.joints[3].joint.joint_from_axes - axes).norm(), 0, kRounding) << order;
  }
}

TEST(Asf, TakesTheRootsOrderOfTurningFromAxisAndItsColumnsFromOrder) {
  std::string text = replaced(kSmallAsf, "order TX TY TZ RX RY RZ", "order RY TZ TX RX RZ");
  text = replaced(text, "axis XYZ\n", "axis ZXY\n");
  text = replaced(text, "position 0 0 0", "position 9 18 27");
  text = replaced(text, "orientation 0 0 0", "orientation 0 0 90");
  const AsfJoint root = read(text).joints[0];
  using enum ChannelKind;
  EXPECT_EQ(root.joint.channels, (std::vector<ChannelKind>{TranslationX, TranslationZ, RotationY,
                                                           RotationX, RotationZ}));
  EXPECT_EQ(root.columns, (std::vector<int>{2, 1, 0, 3, 4}));
  EXPECT_NEAR((root.joint.offset - kCm * Eigen::Vector3d(9, 18, 27)).norm(), 0, kRounding);
  EXPECT_NEAR((root.joint.joint_from_axes - axis_rotation(2, 90 * kDegree)).norm(), 0, kRounding);
}

TEST(Asf, ReadsItsUnits) {
  const AsfSkeleton inches = read(replaced(kSmallAsf, "length 0.45", "length 1"));
  EXPECT_NEAR(inches.joints[2].joint.offset.y(), -7 * 2.54, kRounding);
  std::string text = replaced(kSmallAsf, "angle deg", "angle rad");
  text = replaced(text, "axis 0 0 20 XYZ", "axis 0 0 0.5 XYZ");
  const AsfSkeleton radians = read(text);
  EXPECT_EQ(radians.radians_per_unit, 1);
  EXPECT_NEAR((radians.joints[1].joint.joint_from_axes - axis_rotation(2, 0.5)).norm(), 0,
              kRounding);
  EXPECT_EQ(read_asf("f", kSmallAsf, 3.0).joints[2].joint.offset.y(), -21);
}

TEST(Asf, KeepsTheColumnOfALengthButFeedsNothingWithIt) {
  const AsfSkeleton skeleton = read(replaced(kSmallAsf, "dof rx\n", "dof l rx\n"));
  EXPECT_EQ(skeleton.joints[2].dof.size(), 2u);
  EXPECT_EQ(skeleton.joints[2].columns, (std::vector<int>{1}));
}

TEST(Asf, RefusesWhatMakesNoSkeleton) {
  EXPECT_EQ(error_of("hello"),
            "f.asf:1:1: expected a section such as :units or :bonedata, found 'hello'");
  EXPECT_EQ(error_of(replaced(kSmallAsf, "    thigh shin\n", "")),
            "f.asf:17:5: bone 'shin' does not hang from the root in :hierarchy");
  EXPECT_EQ(error_of(replaced(kSmallAsf, "root thigh arm", "root thigh arm shin")),
            "f.asf:47:20: a second parent for 'shin'");
  EXPECT_EQ(error_of(replaced(kSmallAsf, "root thigh arm", "root thigh leg")),
            "f.asf:47:16: expected the name of a bone, found 'leg'");
  EXPECT_EQ(error_of(replaced(kSmallAsf, "name thigh", "name shin")),
            "f.asf:27:10: a second bone named 'shin'");
  EXPECT_EQ(error_of(replaced(kSmallAsf, "dof rx ry rz", "dof rx rx")),
            "f.asf:31:12: 'rx' twice in one bone");
  EXPECT_EQ(error_of(replaced(kSmallAsf, "length 0.45", "length 0")),
            "f.asf:6:10: expected a positive unit of length, found '0'");
  EXPECT_EQ(error_of(replaced(kSmallAsf, "    length 5\n", "")),
            "f.asf:37:5: bone 'arm' lacks its direction or length");
  const std::string without_length = replaced(kSmallAsf, "    length 5\n", "");
  EXPECT_EQ(error_of(replaced(without_length, "name arm", "name " + std::string(250, 'x'))),
            "f.asf:37:5: bone '" + std::string(37, 'x') + "...' lacks its direction or length");
  EXPECT_EQ(error_of(replaced(kSmallAsf, "axis XYZ", "axis XYX")),
            "f.asf:12:8: expected an order of axes such as XYZ, found 'XYX'");
}

TEST(Asf, RefusesACycleOffTheRoot) {
  EXPECT_NE(error_of(replaced(kSmallAsf, "root thigh arm", "shin thigh\n    root arm"))
                .find("does not hang from the root"),
            std::string::npos);
}

/// A chain of the root and so many bones, each below the one before.
std::string chain(int bones, std::size_t name_size = 0) {
  std::string data = ":units\n  length 1\n:root\n  order RX\n:bonedata\n";
  std::string hierarchy = ":hierarchy\n  begin\n";
  std::string parent = "root";
  for (int b = 1; b <= bones; ++b) {
    const std::string name = "b" + std::to_string(b) + std::string(name_size, 'n');
    data += "  begin\n    name " + name + "\n    direction 0 1 0\n    length 1\n  end\n";
    hierarchy += "    " + parent + ' ' + name + '\n';
    parent = name;
  }
  return data + hierarchy + "  end\n";
}

TEST(Asf, RefusesWhatNoFileMayHold) {
  EXPECT_EQ(error_of(chain(999)), "reads");
  EXPECT_NE(error_of(chain(1000)).find("nested deeper than 1000"), std::string::npos);
  EXPECT_NE(error_of(chain(4096)).find("more than 4096 bones"), std::string::npos);
  EXPECT_EQ(error_of(chain(1, 253)), "reads");
  EXPECT_NE(error_of(chain(1, 254)).find("more than 255 bytes"), std::string::npos);
  EXPECT_NE(error_of(replaced(kSmallAsf, "dof rx", "dof rx rx")).find("twice in one bone"),
            std::string::npos);
}

}  // namespace
}  // namespace mocapress::asf_reader_test
