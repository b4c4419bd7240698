// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "core/formats/bvh.h"
#include "core/motion/forward_kinematics.h"
#include "tests/support/motion_texts.h"

namespace mocapress::bvh_reader_test {
namespace {

using test::kSmallBvh;
using test::replaced;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRounding = 1e-9;  // cm
const ReadOptions kCentimetres{.cm_per_unit = 1.0};

MotionFile read(const std::string& text) {
  return read_bvh("f.bvh", text);
}

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "reads";
}

/// The warning of a file that has exactly one.
std::string warning_of(const std::string& text) {
  const Warnings warnings = read(text).warnings;
  return warnings.size() == 1 ? warnings.front().text() : std::to_string(warnings.size());
}

/// A joint whose channels all are 90 degrees, with the end site (1, 2, 3).
std::string quarter_turns(const std::string& channels) {
  return "HIERARCHY ROOT r { OFFSET 0 0 0 CHANNELS 3 " + channels +
         " End Site { OFFSET 1 2 3 } } MOTION Frames: 1 Frame Time: 0.01\n90 90 90\n";
}

TEST(Bvh, ReadsASmallFileAsItStands) {
  const auto [motion, warnings, source, states_rate, skin, takes, tracks] = read(kSmallBvh);
  EXPECT_TRUE(warnings.empty());
  ASSERT_EQ(motion.skeleton.joint_count(), 2);
  EXPECT_EQ(motion.skeleton.joint(0).name, "Hips");
  EXPECT_EQ(motion.skeleton.joint(1).parent, 0);
  EXPECT_EQ(motion.skeleton.joint(1).offset, Eigen::Vector3d(0, 40, 0));
  EXPECT_EQ(motion.skeleton.joint(1).end_site, Eigen::Vector3d(0, 60, 0));
  EXPECT_EQ(motion.skeleton.channel_name(3), "Hips.rz");
  EXPECT_EQ(motion.skeleton.channel_name(6), "Spine.rx");
  EXPECT_EQ(motion.clip.frames(), 2);
  EXPECT_EQ(motion.clip.sample_rate_hz, 120);
  EXPECT_EQ(motion.clip.channels(1, 1), 5);
  EXPECT_NEAR(motion.clip.channels(1, 8), 6 * kDegree, kRounding);
}

// Computed by hand, the last channel applied first. Rx(90): (x, y, z) -> (x, -z, y). Ry(90): -> (z,
// y, -x). Rz(90): -> (-y, x, z).
TEST(Bvh, MultipliesRotationsInFileOrderForAllSixOrders) {
  struct Case {
    const char* channels;
    Eigen::Vector3d end;
  };
  const std::array<Case, 6> cases = {{{"Xrotation Yrotation Zrotation", {3, -2, 1}},
                                      {"Xrotation Zrotation Yrotation", {-2, 1, 3}},
                                      {"Yrotation Xrotation Zrotation", {1, -3, 2}},
                                      {"Yrotation Zrotation Xrotation", {2, 1, -3}},
                                      {"Zrotation Xrotation Yrotation", {-1, 3, 2}},
                                      {"Zrotation Yrotation Xrotation", {3, 2, -1}}}};
  for (const Case& order : cases) {
    const Motion motion = read_bvh("f", quarter_turns(order.channels), kCentimetres).motion;
    Pose pose;
    compute_pose(motion.skeleton, motion.clip.channels.row(0), pose);
    const Eigen::Vector3d end = pose.to_world(0, *motion.skeleton.joint(0).end_site);
    EXPECT_NEAR((end - order.end).norm(), 0, kRounding) << order.channels;
  }
}

TEST(Bvh, MixesOrdersWithinAFile) {
  const std::string text =
      "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 3 Xrotation Yrotation Zrotation\n"
      "JOINT b { OFFSET 1 2 3 CHANNELS 3 Zrotation Yrotation Xrotation\n"
      "JOINT c { OFFSET 1 2 3 CHANNELS 1 Yrotation End Site { OFFSET 1 2 3 } } } }\n"
      "MOTION Frames: 1 Frame Time: 0.01\n90 90 90 90 90 90 90\n";
  const Motion motion = read_bvh("f", text, kCentimetres).motion;
  Pose pose;
  compute_pose(motion.skeleton, motion.clip.channels.row(0), pose);
  // b is at XYZ(1,2,3) = (3,-2,1). c: XYZ(ZYX(1,2,3)) = XYZ(3,2,-1) = (-1,-2,3), from b.
  EXPECT_NEAR((pose.origin[1] - Eigen::Vector3d(3, -2, 1)).norm(), 0, kRounding);
  EXPECT_NEAR((pose.origin[2] - Eigen::Vector3d(2, -4, 4)).norm(), 0, kRounding);
  // The end: Ry(1,2,3) = (3,2,-1), ZYX -> (-1,2,-3), XYZ -> (-3,-2,-1), from c.
  const Eigen::Vector3d end = pose.to_world(2, *motion.skeleton.joint(2).end_site);
  EXPECT_NEAR((end - Eigen::Vector3d(-1, -6, 3)).norm(), 0, kRounding);
}

TEST(Bvh, ReadsTheSameFileInOtherSpellings) {
  const Motion plain = read(kSmallBvh).motion;
  const std::string exponents = replaced(kSmallBvh, "11 21 31", "+1.1e1 2100E-2 .31e+2");
  for (const std::string& text :
       {replaced(kSmallBvh, "\n", "\r\n"), replaced(kSmallBvh, "\n", "\r"),
        replaced(kSmallBvh, " ", " \t "), exponents, replaced(kSmallBvh, "Hips\n{", "Hips {"),
        replaced(kSmallBvh, "Frames: 2", "FRAMES :2"), "\xEF\xBB\xBF" + kSmallBvh,
        replaced(kSmallBvh, "rotation", "ROTATION"), kSmallBvh + "\n\n  \n",
        kSmallBvh.substr(0, kSmallBvh.size() - 1), replaced(kSmallBvh, "10 20 30", "10\n20\n30")}) {
    const auto [motion, warnings, source, states_rate, skin, takes, tracks] = read(text);
    EXPECT_TRUE(warnings.empty()) << text;
    EXPECT_EQ(motion.skeleton.joint(0).name, "Hips") << text;
    EXPECT_TRUE(motion.clip.channels.isApprox(plain.clip.channels, kRounding)) << text;
  }
}

TEST(Bvh, ReadsJointsWithoutChannelsOrEndSitesAndSeveralRoots) {
  const std::string text =
      "HIERARCHY\nROOT a b { CHANNELS 2 Yposition Zrotation JOINT fixed { OFFSET 0 170 0 } }\n"
      "ROOT prop { OFFSET 1 1 1 }\nMOTION\nFrames: 1\nFrame Time: 0.01\n7 90\n";
  const auto [motion, warnings, source, states_rate, skin, takes, tracks] = read(text);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(motion.skeleton.joint(0).name, "a b");
  EXPECT_EQ(motion.skeleton.joint(2).parent, -1);
  EXPECT_EQ(motion.skeleton.channel_count(), 2);
  EXPECT_FALSE(motion.skeleton.joint(1).end_site);
}

TEST(Bvh, UnwrapsAngles) {
  const Motion motion =
      read(replaced(replaced(kSmallBvh, "1 2 3\n", "1 2 179\n"), "4 5 6\n", "4 5 -179\n")).motion;
  EXPECT_NEAR(motion.clip.channels(1, 8), 181 * kDegree, kRounding);
}

TEST(Bvh, ReadsEveryRowWhateverTheHeaderCounts) {
  for (const std::string count : {"1", "3", "0", "2000000000", "1e18"}) {
    const std::string text = replaced(kSmallBvh, "Frames: 2", "Frames: " + count);
    EXPECT_EQ(read(text).motion.clip.frames(), 2);
    EXPECT_EQ(warning_of(text).find("f.bvh:17: the header says "), 0u) << warning_of(text);
  }
}

TEST(Bvh, DropsALastFrameThatIsCut) {
  const std::string cut =
      replaced(kSmallBvh.substr(0, kSmallBvh.size() - 3), "Frames: 2", "Frames: 1");
  EXPECT_EQ(read(cut).motion.clip.frames(), 1);
  EXPECT_EQ(warning_of(cut), "f.bvh:20: the file ends within its last frame, which is dropped");
  EXPECT_EQ(read(replaced(cut + " -", "\n-", "")).motion.clip.frames(), 1);
}

TEST(Bvh, RefusesAShortOrLongRowInOneSentence) {
  EXPECT_EQ(
      error_of(replaced(kSmallBvh, "1 2 3 10 20 30 1 2 3", "1 2 3 10 20 30 1 2")),
      "f.bvh:20:3: expected a new line after the 9 values of the frame that begins in line 19, "
      "found '5'");
  EXPECT_EQ(error_of(replaced(kSmallBvh, "30 1 2 3", "30 1 2 3 4")),
            "f.bvh:19:22: expected a new line after the 9 values of the frame that begins in line "
            "19, found '4'");
}

TEST(Bvh, RefusesJunkWithItsPlace) {
  EXPECT_EQ(error_of(""), "f.bvh:1:1: expected HIERARCHY, found the end of the file");
  EXPECT_EQ(error_of(replaced(kSmallBvh, "20 30 1", "20 0xdead 1")),
            "f.bvh:19:13: expected a channel's value, found '0xdead'");
  EXPECT_EQ(error_of(replaced(kSmallBvh, "OFFSET 0 40 0", "OFFSET 0 nan 0")),
            "f.bvh:8:14: expected a coordinate of OFFSET, found 'nan'");
  EXPECT_EQ(error_of(replaced(kSmallBvh, "CHANNELS 3 X", "CHANNELS 4 X")),
            "f.bvh:10:5: expected 4 channels such as Xposition or Zrotation, found 'End'");
  EXPECT_EQ(error_of(replaced(kSmallBvh, "3 Xrotation Y", "3 Yrotation Y")),
            "f.bvh:9:26: channel 'Yrotation' twice in one joint");
  EXPECT_EQ(error_of(replaced(kSmallBvh, "Frames: 2", "Frames: many")),
            "f.bvh:17:9: expected the number of frames, found 'many'");
  EXPECT_EQ(error_of(kSmallBvh.substr(0, kSmallBvh.find("1 2 3 10"))),
            "f.bvh:19:1: no complete frame follows");
}

TEST(Bvh, SkipsComments) {
  const std::string text =
      "# made by hand\n" +
      replaced(replaced(replaced(kSmallBvh, "JOINT Spine\n", "JOINT Spine  # the back\n"),
                        "OFFSET 0 40 0\n", "OFFSET 0 40 0 # up\n"),
               "1 2 3 10", "# frame 1\n1 2 3 10");
  const MotionFile file = read(text);
  EXPECT_TRUE(file.warnings.empty());
  EXPECT_EQ(file.motion.skeleton.joint(1).name, "Spine");
  EXPECT_EQ(file.motion.clip.channels, read(kSmallBvh).motion.clip.channels);
  // A # within a name begins no comment.
  EXPECT_EQ(read(replaced(kSmallBvh, "Spine", "Spine#2")).motion.skeleton.joint(1).name, "Spine#2");
}

TEST(Bvh, ReadsEndSiteAsOneWord) {
  const MotionFile file = read(replaced(kSmallBvh, "End Site", "EndSite"));
  EXPECT_TRUE(file.warnings.empty());
  EXPECT_EQ(*file.motion.skeleton.joint(1).end_site, Eigen::Vector3d(0, 60, 0));
}

TEST(Bvh, LosesNoFrameToAnEndSignOrZeros) {
  const std::string without_end = kSmallBvh.substr(0, kSmallBvh.size() - 1);
  for (const std::string& text : {kSmallBvh, without_end})
    for (const std::string& padding :
         {std::string("\x1A"), std::string("\x1A\x1A"), std::string(5, '\0')}) {
      const MotionFile file = read(text + padding);
      EXPECT_TRUE(file.warnings.empty());
      EXPECT_EQ(file.motion.clip.frames(), 2);
    }
}

TEST(Bvh, NamesDecimalCommasAndUtf16) {
  EXPECT_EQ(error_of(replaced(kSmallBvh, "20 30 1", "20,5 30 1")),
            "f.bvh:19:10: numbers have a decimal comma, such as '20,5': a decimal point is read");
  EXPECT_EQ(error_of(replaced(kSmallBvh, "OFFSET 0 40 0", "OFFSET 0 40,25 0")),
            "f.bvh:8:14: numbers have a decimal comma, such as '40,25': a decimal point is read");
  std::string wide;
  for (const char c : kSmallBvh) wide += {c, '\0'};
  const std::string refusal = "f.bvh:1:1: is UTF-16: save it as UTF-8 to have it read";
  EXPECT_EQ(error_of("\xFF\xFE" + wide), refusal);
  EXPECT_EQ(error_of(wide), refusal);
  EXPECT_EQ(error_of("\xFE\xFF" + ('\0' + wide)), refusal);
}

TEST(Bvh, KeepsScalesAsTracksAndSaysSo) {
  const std::string text = replaced(replaced(replaced(kSmallBvh, "CHANNELS 3 Xrotation",
                                                      "CHANNELS 6 Xscale YScale Zscale Xrotation"),
                                             "20 30 1 2 3", "20 30 1 1.5 1 1 2 3"),
                                    "21 31 4 5 6", "21 31 1 2.5 1 4 5 6");
  const MotionFile file = read(text);
  EXPECT_EQ(file.motion.clip.channels, read(kSmallBvh).motion.clip.channels);
  ASSERT_EQ(file.tracks.size(), 1u);
  EXPECT_EQ(file.tracks[0].kind, TrackKind::ScaleY);
  EXPECT_EQ(file.tracks[0].node, "Spine");
  EXPECT_EQ(file.tracks[0].values, (std::vector<float>{1.5F, 2.5F}));
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_EQ(file.warnings[0].message, "1 channel of scale kept as tracks, which move no joint");
  EXPECT_EQ(error_of(replaced(text, "Zscale", "Xscale")),
            "f.bvh:9:30: channel 'Xscale' twice in one joint");
}

TEST(Bvh, RepairsValuesThatAreNoNumbers) {
  const std::string text = replaced(kSmallBvh, "4 5 6 11", "-nan 1e300 1.#QNAN 11");
  const auto [motion, warnings, source, states_rate, skin, takes, tracks] = read(text);
  EXPECT_EQ(motion.clip.channels(1, 0), motion.clip.channels(0, 0));
  EXPECT_EQ(motion.clip.channels(1, 1), motion.clip.channels(0, 1));
  EXPECT_EQ(motion.clip.channels(1, 2), motion.clip.channels(0, 2));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].message.find("3 values not finite"), 0u);
}

TEST(Bvh, GuessesARateWhereFrameTimeIsNonsense) {
  for (const char* nonsense : {"0", "-1", "nan", "1e-30"}) {
    const std::string text = replaced(kSmallBvh, "0.0083333", nonsense);
    EXPECT_EQ(read(text).motion.clip.sample_rate_hz, 30) << nonsense;
    EXPECT_NE(warning_of(text).find("cannot be right"), std::string::npos) << nonsense;
    const MotionFile told = read_bvh("f", text, {.sample_rate_hz = 50.0, .cm_per_unit = {}});
    EXPECT_EQ(told.motion.clip.sample_rate_hz, 50);
    EXPECT_TRUE(told.warnings.empty());
  }
  EXPECT_EQ(read(replaced(kSmallBvh, "0.0083333", "60")).motion.clip.sample_rate_hz, 60);
}

TEST(Bvh, GuessesTheUnitFromTheHeightUnlessTold) {
  const std::string metres = replaced(
      replaced(replaced(kSmallBvh, "0 90 0", "0 0 0"), "0 40 0", "0 .7 0"), "0 60 0", "0 1 0");
  const auto [motion, warnings, source, states_rate, skin, takes, tracks] = read(metres);
  EXPECT_NEAR(motion.skeleton.joint(1).offset.y(), 70, kRounding);
  EXPECT_NEAR(motion.clip.channels(0, 0), 100, kRounding);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].message,
            "no unit of length is given: a rest pose 1.7 units tall is taken to have 100 cm to the "
            "unit");
  const MotionFile told = read_bvh("f", metres, {.sample_rate_hz = {}, .cm_per_unit = 2.0});
  EXPECT_NEAR(told.motion.skeleton.joint(1).offset.y(), 1.4, kRounding);
  EXPECT_TRUE(told.warnings.empty());
}

TEST(Bvh, TakesTranslationsThatRepeatTheOffsetForAbsolute) {
  const std::string absolute =
      replaced(replaced(kSmallBvh, "1 2 3 10", "1 91 3 10"), "4 5 6 11", "4 95 6 11");
  const auto [motion, warnings, source, states_rate, skin, takes, tracks] = read(absolute);
  EXPECT_NEAR(motion.clip.channels(0, 1), 1, kRounding);
  EXPECT_NEAR(motion.clip.channels(1, 1), 5, kRounding);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].message.find("taken to replace"), std::string::npos);
}

TEST(Bvh, ReadsTheRootAsItIsTold) {
  const auto height = [](const std::string& text, TranslationConvention convention) {
    const MotionFile file = read_bvh("f", text, {.bvh_root = convention});
    EXPECT_EQ(file.source.root, convention);
    EXPECT_TRUE(file.warnings.empty());
    return file.motion.skeleton.joint(0).offset.y() + file.motion.clip.channels(0, 1);
  };
  const std::string absolute = replaced(kSmallBvh, "1 2 3 10", "1 91 3 10");
  EXPECT_NEAR(height(kSmallBvh, TranslationConvention::Adds), 92, kRounding);
  EXPECT_NEAR(height(kSmallBvh, TranslationConvention::Replaces), 2, kRounding);
  EXPECT_NEAR(height(absolute, TranslationConvention::Adds), 181, kRounding);
  EXPECT_NEAR(height(absolute, TranslationConvention::Replaces), 91, kRounding);
}

TEST(Bvh, SaysWhatItsSourceWas) {
  EXPECT_EQ(read(kSmallBvh).source,
            (SourceFormat{.kind = SourceFormat::Kind::Bvh, .root = TranslationConvention::Adds}));
  const MotionFile told = read_bvh("f", replaced(kSmallBvh, "OFFSET 0 90 0", "OFFSET 0 0 0"),
                                   {.sample_rate_hz = {}, .cm_per_unit = 2.54, .up = UpAxis::Z});
  EXPECT_EQ(told.source,
            (SourceFormat{.kind = SourceFormat::Kind::Bvh, .cm_per_unit = 2.54, .up = UpAxis::Z}));
}

TEST(Bvh, StandsUpWhereZIsUp) {
  const Motion lying = read(kSmallBvh).motion;
  const Motion standing = read_bvh("f", kSmallBvh, {.up = UpAxis::Z}).motion;
  const Pose was = rest_pose(lying.skeleton);
  const Pose is = rest_pose(standing.skeleton);
  for (std::size_t j = 0; j < was.origin.size(); ++j) {
    const Eigen::Vector3d& p = was.origin[j];
    EXPECT_LT((is.origin[j] - Eigen::Vector3d(p.x(), p.z(), -p.y())).norm(), kRounding);
  }
}

/// A figure of hips, head and feet: at rest along `up`, turned about X by the root.
std::string figure(const std::string& up, const std::string& degrees_about_x) {
  const auto offset = [&](const char* length) {
    return "OFFSET " +
           (up == "z" ? "0 0 " + std::string(length) : "0 " + std::string(length) + " 0");
  };
  return "HIERARCHY ROOT Hips { OFFSET 0 0 0 CHANNELS 3 Xrotation Yrotation Zrotation"
         " JOINT Head { " +
         offset("70") + " CHANNELS 1 Yrotation End Site { " + offset("20") +
         " } } JOINT LeftFoot { " + offset("-85") + " CHANNELS 1 Yrotation End Site { " +
         offset("-5") + " } } } MOTION Frames: 2 Frame Time: 0.01\n" + degrees_about_x +
         " 0 0 0 0\n" + degrees_about_x + " 0 0 1 1\n";
}

TEST(Bvh, SaysHowAFigureThatStandsAlongZIsReadUpright) {
  EXPECT_NE(warning_of(figure("z", "0")).find("--up z"), std::string::npos);
  EXPECT_TRUE(read_bvh("f", figure("z", "0"), {.up = UpAxis::Z}).warnings.empty());
  // The option decides.
  EXPECT_TRUE(read_bvh("f", figure("z", "0"), {.up = UpAxis::Y}).warnings.empty());
  // Figures along Y, along Z only at rest, and lying down.
  EXPECT_TRUE(read(figure("y", "0")).warnings.empty());
  EXPECT_TRUE(read(figure("z", "-90")).warnings.empty());
  EXPECT_TRUE(read(figure("y", "90")).warnings.empty());
}

TEST(Bvh, KeepsDuplicateNamesWithAWarning) {
  EXPECT_NE(
      warning_of(replaced(kSmallBvh, "JOINT Spine", "JOINT Hips")).find("1 joint with the name"),
      std::string::npos);
}

TEST(Bvh, LeavesOutEndSitesBesideOtherChildren) {
  const std::string text =
      replaced(kSmallBvh, "  JOINT Spine", "  End Site { OFFSET 1 1 1 }\n  JOINT Spine");
  EXPECT_FALSE(read(text).motion.skeleton.joint(0).end_site);
  EXPECT_NE(warning_of(text).find("1 End Site beside"), std::string::npos);
}

TEST(Bvh, RefusesEndlessNestingWithoutRecursing) {
  std::string text = "HIERARCHY ROOT r {";
  for (int i = 0; i < 200000; ++i) text += " JOINT j {";
  EXPECT_NE(error_of(text).find("joints are nested deeper than 1000"), std::string::npos);
}

TEST(Bvh, RefusesMoreJointsThanAnyFileMayHave) {
  const auto siblings = [](int joints) {
    std::string text = "HIERARCHY ROOT r { OFFSET 0 0 0 CHANNELS 1 Xrotation\n";
    for (int j = 1; j < joints; ++j) text += "JOINT j" + std::to_string(j) + " { OFFSET 0 1 0 }\n";
    return text + "} MOTION Frames: 1 Frame Time: 0.01\n1\n";
  };
  EXPECT_EQ(error_of(siblings(4096)), "reads");
  EXPECT_NE(error_of(siblings(4097)).find("f.bvh:4097:1: more than 4096 joints"), std::string::npos)
      << error_of(siblings(4097));
}

TEST(Bvh, RefusesNamesLongerThanAnyFileMayHave) {
  const auto named = [](std::size_t size) {
    return replaced(kSmallBvh, "Spine", std::string(size, 'n'));
  };
  EXPECT_EQ(error_of(named(255)), "reads");
  EXPECT_NE(error_of(named(256)).find("more than 255 bytes"), std::string::npos);
}

TEST(Bvh, RefusesMoreThanSixChannelsOfAJoint) {
  EXPECT_NE(error_of(replaced(kSmallBvh, "CHANNELS 6 Xposition", "CHANNELS 7 Xposition Xposition"))
                .find("twice in one joint"),
            std::string::npos);
}

}  // namespace
}  // namespace mocapress::bvh_reader_test
