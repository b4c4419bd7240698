// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_curves.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace mocapress::fbx_curves_test {
namespace {

constexpr std::int64_t kSecond = 46186158000;

std::string list(const std::string& name, const std::vector<std::string>& values) {
  std::string text = name + ": *" + std::to_string(values.size()) + " {\na: ";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? "," : "") + values[i];
  return text + "\n}\n";
}

struct Attribute {
  int flags = 4;
  float a = 0;
  float b = 0;
  float c = std::bit_cast<float>(218434821);  // both weights 0.3333
};

/// A key each second.
FbxCurve curve(const std::vector<std::string>& values, const std::vector<Attribute>& attributes,
               const std::string& more = "") {
  std::vector<std::string> times;
  std::vector<std::string> flags;
  std::vector<std::string> data;
  std::vector<std::string> counts;
  for (std::size_t k = 0; k < values.size(); ++k)
    times.push_back(std::to_string(static_cast<std::int64_t>(k) * kSecond));
  for (const Attribute& attribute : attributes) {
    flags.push_back(std::to_string(attribute.flags));
    for (const float value : {attribute.a, attribute.b, attribute.c, 0.0F})
      data.push_back(std::to_string(std::bit_cast<std::int32_t>(value)));
    counts.push_back(attributes.size() == 1 ? std::to_string(values.size()) : "1");
  }
  const std::string text = "FBXHeaderExtension: {\nFBXVersion: 7400\n}\nCurve: {\n" +
                           list("KeyTime", times) + list("KeyValueFloat", values) +
                           list("KeyAttrFlags", flags) + list("KeyAttrDataFloat", data) +
                           list("KeyAttrRefCount", counts) + more + "}\n";
  FbxRecords records("f", text);
  return {records, *records.find(records.top(), "Curve"), kFbxTicks};
}

double at(const FbxCurve& curve, double seconds) {
  return curve.at(seconds * kFbxTicks);
}

TEST(FbxCurve, StepsToItsOwnValueOrToTheNext) {
  const FbxCurve own = curve({"1", "5"}, {{.flags = 2}});
  EXPECT_EQ(at(own, 0.99), 1);
  EXPECT_EQ(at(own, 1), 5);
  EXPECT_EQ(at(curve({"1", "5"}, {{.flags = 2 | 0x100}}), 0.01), 5);
  EXPECT_TRUE(own.steps());
}

TEST(FbxCurve, GoesStraightWhereLinear) {
  EXPECT_NEAR(at(curve({"1", "5"}, {{.flags = 4}}), 0.25), 2, 1e-12);
}

TEST(FbxCurve, AnswersTimesInAnyOrder) {
  std::vector<std::string> values;
  for (int k = 0; k < 40; ++k) values.push_back(std::to_string(k * k));
  const FbxCurve asked = curve(values, {{.flags = 4}});
  for (const int key : {0, 1, 2, 30, 31, 39, 12, 13, 11, 0, 20, 25})
    EXPECT_NEAR(at(asked, key + (key < 39 ? 0.5 : 0.0)),
                key < 39 ? (key * key + (key + 1) * (key + 1)) / 2.0 : 1521.0, 1e-9)
        << key;
}

TEST(FbxCurve, FollowsTheSlopesOfItsUser) {
  const FbxCurve hermite = curve({"0", "1"}, {{.flags = 8 | 0x400, .a = 3, .b = -2}});
  const auto expected = [](double t) {  // Hermite's
    return 3 * (t * t * t - 2 * t * t + t) + (3 * t * t - 2 * t * t * t) - 2 * (t * t * t - t * t);
  };
  for (const double t : {0.1, 0.5, 0.8}) EXPECT_NEAR(at(hermite, t), expected(t), 1e-4);
}

TEST(FbxCurve, HasWeightsAsSharesOfTheTime) {
  // Inner points at (0.9, 0) and (0.9, 1): late and steep.
  const auto weights = std::bit_cast<float>(std::uint32_t{9000 | 1000U << 16});
  const FbxCurve late =
      curve({"0", "1"}, {{.flags = 8 | 0x400 | 0x1000000 | 0x2000000, .c = weights}});
  EXPECT_LT(at(late, 0.5), 0.15);
  // At s = 1/2 time is (3 * 0.9 + 3 * 0.9 + 1) / 8 and value 1/2.
  EXPECT_NEAR(at(late, 0.8), 0.5, 1e-9);
}

TEST(FbxCurve, IsFlatAtThePeaksOfProgressiveClamping) {
  const int automatic = 8 | 0x100 | 0x2000 | 0x4000;
  const FbxCurve peak = curve({"0", "1", "0"}, {{.flags = automatic}});
  EXPECT_NEAR(at(peak, 0.5), 0.5, 1e-12);
  EXPECT_LE(at(peak, 0.95), 1);
  const FbxCurve rising = curve({"0", "1", "2"}, {{.flags = automatic}});
  EXPECT_GT(at(rising, 0.9), 0.85);  // slope 1 at the inner key
}

TEST(FbxCurve, TurnsTcbIntoSlopes) {
  const FbxCurve plain =
      curve({"0", "1", "4"}, {{.flags = 8 | 0x200, .c = 0}});  // Catmull and Rom's: slope 2
  EXPECT_NEAR(at(plain, 1.0001) - at(plain, 0.9999), 2 * 0.0002, 1e-6);
  const FbxCurve tense = curve({"0", "1", "4"}, {{.flags = 8 | 0x200, .a = 1, .c = 0}});
  EXPECT_NEAR(at(tense, 1.0001) - at(tense, 0.9999), 0, 1e-6);
}

TEST(FbxCurve, GoesOnBeyondItsKeysAsTheFileSays) {
  const auto beyond = [](const std::string& type, double seconds) {
    return at(curve({"0", "1", "3"}, {{.flags = 4}},
                    "Pre-Extrapolation: {\nType: " + type + "\nRepetition: -1\n}\n" +
                        "Post-Extrapolation: {\nType: " + type + "\nRepetition: -1\n}\n"),
              seconds);
  };
  EXPECT_NEAR(beyond("C", 2.5), 3, 1e-9);
  EXPECT_NEAR(beyond("R", 2.5), 0.5, 1e-9);
  EXPECT_NEAR(beyond("R", -0.5), 2, 1e-9);
  EXPECT_NEAR(beyond("A", 2.5), 3.5, 1e-9);
  EXPECT_NEAR(beyond("A", -0.5), -1, 1e-9);
  EXPECT_NEAR(beyond("M", 2.5), 2, 1e-9);
  EXPECT_NEAR(beyond("M", -0.5), 0.5, 1e-9);
  EXPECT_NEAR(beyond("M", 4.5), 0.5, 1e-9);
  EXPECT_NEAR(beyond("K", 2.5), 4, 1e-9);
  EXPECT_NEAR(beyond("K", -0.5), -0.5, 1e-9);
}

TEST(FbxCurve, RepeatsAsOftenAsTheFileSays) {
  const FbxCurve twice =
      curve({"0", "1", "3"}, {{.flags = 4}}, "Post-Extrapolation: {\nType: R\nRepetition: 2\n}\n");
  EXPECT_NEAR(at(twice, 4.5), 0.5, 1e-9);
  EXPECT_NEAR(at(twice, 6.5), 3, 1e-9);
}

TEST(FbxCurve, IsFlatWhereAClampedKeyHasANeighbourOfItsValue) {
  const int clamped = 8 | 0x100 | 0x1000;
  EXPECT_NEAR(at(curve({"0", "1", "1", "1"}, {{.flags = clamped}}), 1.5), 1, 1e-12);
  EXPECT_GT(at(curve({"0", "1", "1", "1"}, {{.flags = 8 | 0x100}}), 1.5), 1.05);
}

TEST(FbxCurve, GoesByTheSlopesOfKeysThatStateVelocities) {
  const int user = 8 | 0x400;
  const FbxCurve plain = curve({"0", "1"}, {{.flags = user, .a = 3, .b = -2}});
  const FbxCurve fast =
      curve({"0", "1"}, {{.flags = user | 0x10000000 | 0x20000000, .a = 3, .b = -2}});
  for (const double t : {0.1, 0.5, 0.8}) EXPECT_EQ(at(fast, t), at(plain, t));
}

TEST(FbxCurve, LeavesOutKeysThatAreNoNumbers) {
  const FbxCurve holed = curve({"0", "nan", "2"}, {{.flags = 4}});
  EXPECT_EQ(holed.dropped(), 1);
  EXPECT_NEAR(at(holed, 1), 1, 1e-12);
}

TEST(FbxCurve, ReadsKeysOfVersion6) {
  const std::string text =
      "FBXHeaderExtension: {\nFBXVersion: 6100\n}\nChannel: \"X\" {\nKeyVer: 4005\nKey: "
      "0,0,U,s,3,-2,n," +
      std::to_string(kSecond) + ",1,L,\n" + std::to_string(2 * kSecond) + ",2,C,n," +
      std::to_string(3 * kSecond) + ",7,C,s\n}\n";
  FbxRecords records("f", text);
  const FbxCurve read =
      FbxCurve::of_channel(records, *records.find(records.top(), "Channel"), kFbxTicks);
  ASSERT_EQ(read.keys().size(), 4u);
  EXPECT_NEAR(at(read, 0.5), 0.375 - -0.25 + 0.5, 1e-4);
  EXPECT_NEAR(at(read, 1.5), 1.5, 1e-12);
  EXPECT_EQ(at(read, 2.5), 7);
}

}  // namespace
}  // namespace mocapress::fbx_curves_test
