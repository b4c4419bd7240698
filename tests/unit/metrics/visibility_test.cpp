// SPDX-License-Identifier: MIT
#include "core/metrics/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/motion/body_tracks.h"
#include "resources/samples/generator/human_skeleton.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

constexpr double kRate = 120;

/// A root that travels freely, with one bone 100 cm upwards.
Skeleton stick(const char* end) {
  Skeleton skeleton;
  Joint root{.name = "root"};
  for (int i = 0; i < 3; ++i) root.channels.push_back(test::small_skeleton().channel_kind(i));
  skeleton.add(root);
  Joint top{.name = end, .parent = 0, .offset = {0, 100, 0}};
  top.end_site = {0, 20, 0};
  skeleton.add(top);
  return skeleton;
}

/// A clip that stands at height 0.
Clip still(int frames, double rate = kRate) {
  return {rate, Eigen::MatrixXd::Zero(frames, 3)};
}

/// A clip in which one coordinate of the root is place(seconds), in cm.
template <typename Place>
Clip moved(Clip clip, int coordinate, const Place& place) {
  for (int t = 0; t < clip.frames(); ++t)
    clip.channels(t, coordinate) += place(t / clip.sample_rate_hz);
  return clip;
}

Visibility compare(const Skeleton& skeleton, const Clip& original, const Clip& decoded,
                   const std::vector<ContactSpan>& contacts = {}) {
  return measure_visibility(skeleton, body_tracks(skeleton, original),
                            body_tracks(skeleton, decoded), original.sample_rate_hz, contacts);
}

double times(const Visibility& seen, Cue cue) {
  return seen.worst_of[static_cast<std::size_t>(cue)].times_noticed();
}

double wobble(double seconds, double hz, double cm) {
  return cm * std::sin(2 * std::numbers::pi * hz * seconds);
}

TEST(Visibility, OriginalAgainstItselfIsNotVisible) {
  for (const double rate : {1.0, 10.0, 20.0, 24.0, 59.94, 120.0, 1000.0})
    for (const int frames : {1, 2, 5, 24, 131}) {
      Motion motion = test::smooth_motion(frames);
      motion.clip.sample_rate_hz = rate;
      const Visibility seen =
          compare(motion.skeleton, motion.clip, motion.clip, {{3, 0, frames - 1}});
      EXPECT_EQ(seen.sight(), Sight::NotVisible);
      EXPECT_EQ(seen.worst().times_noticed(), 0);
      EXPECT_EQ(seen.velocity_error, 0);
      EXPECT_EQ(seen.visible_share, 0);
      EXPECT_EQ(reason(seen.worst(), motion.skeleton), "");
      EXPECT_EQ(seen.jitter_ratio.value_or(1), 1);
    }
}

TEST(Visibility, IsNoneWithoutFrames) {
  const Motion motion = test::smooth_motion(0);
  EXPECT_EQ(compare(motion.skeleton, motion.clip, motion.clip).sight(), Sight::NotVisible);
}

TEST(Visibility, AddedWobbleAboveTenHertzIsVisible) {
  const Skeleton skeleton = stick("top");
  for (const double rate : {60.0, 120.0, 240.0}) {
    const Clip original = still(200, rate);
    const Clip decoded = moved(original, 0, [](double s) { return wobble(s, 15, 0.5); });
    const Visibility seen = compare(skeleton, original, decoded);
    EXPECT_EQ(seen.sight(), Sight::Visible);
    EXPECT_EQ(seen.worst().cue, Cue::Jitter);
    EXPECT_NEAR(seen.worst().value, 0.5 / std::numbers::sqrt2, 0.1);
    EXPECT_EQ(reason(seen.worst(), skeleton).rfind("jitter of ", 0), 0u);
  }
}

TEST(Visibility, RemovedWobbleIsNotVisible) {
  const Skeleton skeleton = stick("top");
  const Clip original = moved(still(200), 0, [](double s) { return wobble(s, 15, 0.5); });
  const Visibility seen = compare(skeleton, original, still(200));
  EXPECT_EQ(times(seen, Cue::Jitter), 0);
  EXPECT_LT(*seen.jitter_ratio, 1e-9);
}

/// Rounding alone would be 1e25 times the trembling of an original that does not tremble.
TEST(Visibility, HasNoJitterRatioIfTheOriginalHasNone) {
  const Skeleton skeleton = stick("top");
  const Clip evenly = moved(still(200), 0, [](double s) { return 100 * s; });
  const Clip shaken = moved(evenly, 0, [](double s) { return wobble(s, 15, 0.5); });
  EXPECT_FALSE(compare(skeleton, evenly, shaken).jitter_ratio.has_value());
}

TEST(Visibility, JudgesJitterRelativeToTheOriginals) {
  const Skeleton skeleton = stick("top");
  const auto shaken = [](double cm) {
    return moved(still(200), 0, [cm](double s) { return wobble(s, 15, cm); });
  };
  EXPECT_GT(times(compare(skeleton, still(200), shaken(0.6)), Cue::Jitter),
            3 * times(compare(skeleton, shaken(2), shaken(2.1)), Cue::Jitter));
  EXPECT_NEAR(*compare(skeleton, shaken(1), shaken(3)).jitter_ratio, 9, 0.1);
}

TEST(Visibility, KnowsNoJitterAtTwentyHertzAndBelow) {
  const Skeleton skeleton = stick("top");
  const Clip decoded = moved(still(100, 20), 0, [](double s) { return wobble(s, 9, 0.5); });
  const Visibility seen = compare(skeleton, still(100, 20), decoded);
  EXPECT_FALSE(seen.jitter_ratio.has_value());
  EXPECT_EQ(times(seen, Cue::Jitter), 0);
}

TEST(Visibility, ALoweredRootIsBelowTheFloor) {
  const Skeleton skeleton = stick("top");
  const Visibility seen =
      compare(skeleton, still(120), moved(still(120), 1, [](double) { return -3; }));
  EXPECT_NEAR(seen.floor_depth, 3, 1e-5);
  EXPECT_EQ(seen.worst().cue, Cue::Floor);
  EXPECT_EQ(seen.worst().joint, 0);
  EXPECT_EQ(seen.visible_share, 1);
  EXPECT_EQ(
      compare(skeleton, still(120), moved(still(120), 1, [](double) { return 3; })).floor_depth, 0);
}

TEST(Visibility, ALiftedFootFloats) {
  const Skeleton skeleton = stick("top");
  const Clip lifted = moved(still(120), 1, [](double) { return 1.5; });
  const Visibility seen = compare(skeleton, still(120), lifted, {{0, 24, 71}});
  EXPECT_NEAR(seen.contacts->worst_lift_cm, 1.5, 1e-9);
  EXPECT_EQ(seen.worst().cue, Cue::Lift);
  EXPECT_EQ(seen.sight(), Sight::Borderline);
  EXPECT_EQ(seen.table.times_noticed(0, 0), 0);  // before the foot stands
  EXPECT_FALSE(compare(skeleton, still(120), lifted).contacts.has_value());
}

TEST(Visibility, TheTableHasCueAndThresholdOfEachJoint) {
  const Skeleton skeleton = stick("top");
  const Clip lifted = moved(still(120), 1, [](double) { return 1.5; });
  const Visibility seen = compare(skeleton, still(120), lifted, {{0, 24, 71}});
  const WorstSight foot = seen.table.at(30);
  EXPECT_EQ(foot, seen.table.at(30, 0));
  EXPECT_EQ(foot.cue, Cue::Lift);
  EXPECT_EQ(foot.frame, 30);
  EXPECT_EQ(reason(foot, skeleton), "lift of root at frame 31: 1.5 cm, noticed from 1 cm");
  EXPECT_EQ(reason(seen.table.at(30, 1), skeleton), "");
}

TEST(Visibility, ASlidingFootIsVisibleFromWhereItWasSeen) {
  const Skeleton skeleton = stick("top");
  const auto slides = [&](double cm) {
    const Clip decoded = moved(still(240), 0, [cm](double s) { return cm * s / 2; });
    const Visibility seen = compare(skeleton, still(240), decoded, {{0, 0, 239}});
    EXPECT_NEAR(seen.contacts->worst_slide_cm, cm, 0.06 * cm);
    return sight_of(times(seen, Cue::Slide));
  };
  EXPECT_EQ(slides(1), Sight::NotVisible);
  EXPECT_EQ(slides(2), Sight::Borderline);
  EXPECT_EQ(slides(2.3), Sight::Visible);
}

TEST(Visibility, AFootThatOnlyTremblesStands) {
  const Skeleton skeleton = stick("top");
  const Clip decoded = moved(still(240), 0, [](double s) { return wobble(s, 10, 0.3); });
  EXPECT_LT(compare(skeleton, still(240), decoded, {{0, 0, 239}}).contacts->worst_slide_cm, 0.01);
}

TEST(Visibility, AllowsLargerErrorsOfFasterMovements) {
  const Skeleton skeleton = stick("top");
  const auto error = [&](double speed) {
    const Clip original = moved(still(240), 0, [&](double s) { return speed * s; });
    const Clip decoded = moved(original, 0, [](double s) { return 6 * s; });
    return times(compare(skeleton, original, decoded), Cue::Velocity);
  };
  EXPECT_NEAR(error(0), 6 / SightLimits().of(Cue::Velocity).least, 1e-6);
  EXPECT_NEAR(error(200), 6 / (SightLimits().of(Cue::Velocity).share * 200), 1e-6);
}

TEST(Visibility, BodyErrorsBelongToTheRootAndLimbErrorsToTheJoint) {
  const Motion motion = test::smooth_motion(240);
  const int hand = motion.skeleton.find("rhand");
  Clip decoded = motion.clip;
  const int above = motion.skeleton.joint(hand).parent;
  for (int t = 0; t < 240; ++t)
    decoded.channels(t, motion.skeleton.first_channel(above)) += wobble(t / kRate, 2, 0.2);
  EXPECT_EQ(compare(motion.skeleton, motion.clip, decoded).worst().joint, hand);
  decoded = moved(motion.clip, 0, [](double s) { return wobble(s, 1, 20); });
  const Visibility seen = compare(motion.skeleton, motion.clip, decoded);
  EXPECT_EQ(seen.worst().joint, 0);
  EXPECT_EQ(seen.worst().cue, Cue::Velocity);
}

/// A body thrown at 300 cm/s upwards and `speed` along x.
Clip thrown(double speed) {
  return moved(moved(still(72), 0, [&](double s) { return speed * s; }), 1,
               [](double s) { return 300 * s - 981 * s * s / 2; });
}

TEST(Visibility, InTheAirAddedSpeedIsSeenSoonerThanRemovedOne) {
  const Skeleton skeleton = stick("top");
  const Visibility faster = compare(skeleton, thrown(200), thrown(210));
  const Visibility slower = compare(skeleton, thrown(200), thrown(190));
  EXPECT_NEAR(*faster.flight_error, 10, 1e-6);
  EXPECT_NEAR(times(faster, Cue::Flight), 2 * times(slower, Cue::Flight), 1e-6);
  const Visibility higher =
      compare(skeleton, thrown(200), moved(thrown(200), 1, [](double s) { return 10 * s; }));
  EXPECT_NEAR(times(faster, Cue::Flight), 2 * times(higher, Cue::Flight), 1e-6);
  EXPECT_FALSE(compare(skeleton, still(72), still(72)).flight_error.has_value());
}

TEST(Visibility, ATurnedHeadIsVisibleAndAHandLater) {
  const auto turned = [](const char* end) {
    Skeleton skeleton = stick(end);
    const Eigen::MatrixXd original = body_tracks(skeleton, still(60));
    Skeleton other;
    other.add(skeleton.joint(0));
    Joint top = skeleton.joint(1);
    top.channels = {test::smooth_motion(1).skeleton.channel_kind(3)};
    other.add(top);
    Clip clip{kRate, Eigen::MatrixXd::Zero(60, 4)};
    clip.channels.col(3).setConstant(3 * std::numbers::pi / 180);
    return measure_visibility(skeleton, original, body_tracks(other, clip), kRate, {});
  };
  const Visibility head = turned("Head");
  EXPECT_NEAR(*head.worst_head, 3, 1e-6);
  EXPECT_EQ(head.worst().cue, Cue::Head);
  EXPECT_EQ(head.sight(), Sight::Borderline);
  const Visibility hand = turned("LeftHand");
  EXPECT_NEAR(*hand.worst_hand, 3, 1e-6);
  EXPECT_EQ(hand.sight(), Sight::NotVisible);
  EXPECT_FALSE(turned("tail").worst_head.has_value());
}

/// The sample's human, whose head turns as well as their root, `times` as large.
Skeleton human(double times) {
  const Skeleton usual = samples::human_skeleton();
  Skeleton skeleton;
  for (Joint joint : usual.joints()) {
    joint.offset *= times;
    if (joint.end_site) *joint.end_site *= times;
    skeleton.add(joint);
  }
  return skeleton;
}

TEST(Visibility, HeadsAndHandsMayTurnFurtherTheSmallerTheFigureIs) {
  const auto turned = [](double times, const char* joint) {
    const Skeleton skeleton = human(times);
    const int channels = skeleton.channel_count();
    const Clip clip{kRate, Eigen::MatrixXd::Zero(60, channels)};
    Clip other = clip;
    const int first = skeleton.first_channel(skeleton.find(joint));
    other.channels.col(first).setConstant(3 * std::numbers::pi / 180);
    return compare(skeleton, clip, other);
  };
  for (const auto& [cue, joint] : {std::pair(Cue::Head, "head"), {Cue::Hand, "lhand"}}) {
    const double grown_up = times(turned(1, joint), cue);
    EXPECT_GT(grown_up, 0);
    EXPECT_NEAR(times(turned(0.6, joint), cue), 0.6 * grown_up, 1e-6);
    EXPECT_NEAR(times(turned(10, joint), cue), 10 * grown_up, 1e-5);
  }
  EXPECT_NEAR(times(turned(1, "head"), Cue::Head), 3 / SightLimits().of(Cue::Head).least, 0.03);
}

TEST(Visibility, SaysFromWhatDistanceItIsMeant) {
  EXPECT_EQ(sight_text(Sight::NotVisible, 15), "not visible from 15 m");
  EXPECT_EQ(sight_text(Sight::Borderline, 2.5), "borderline from 2.5 m");
}

TEST(Visibility, ALongerLimbIsAnErrorOfPlace) {
  const auto stretched = [](double cm) {
    Skeleton longer;
    longer.add(stick("top").joint(0));
    Joint top = stick("top").joint(1);
    top.offset.y() += cm;
    longer.add(top);
    const Skeleton skeleton = stick("top");
    return measure_visibility(skeleton, body_tracks(skeleton, still(60)),
                              body_tracks(longer, still(60)), kRate, {});
  };
  EXPECT_EQ(stretched(1).sight(), Sight::NotVisible);
  EXPECT_EQ(stretched(20).worst().cue, Cue::Place);
  EXPECT_EQ(stretched(20).sight(), Sight::Visible);
}

TEST(Visibility, TellsWhenByWindow) {
  const Skeleton skeleton = stick("top");
  const Clip decoded = moved(still(1200), 1, [](double s) { return s >= 5 && s < 6 ? -3 : 0; });
  const Visibility seen = compare(skeleton, still(1200), decoded);
  EXPECT_EQ(seen.table.windows(), 100);
  EXPECT_EQ(seen.table.window_frames, 12);
  EXPECT_EQ(seen.table.window_of(1199), 99);
  EXPECT_EQ(sight_of(seen.table.times_noticed(40, 0)), Sight::NotVisible);
  EXPECT_EQ(sight_of(seen.table.times_noticed(55, 0)), Sight::Visible);
  EXPECT_GT(seen.visible_share, 0.09);
  EXPECT_LT(seen.visible_share, 0.2);
}

TEST(Visibility, IsTheSameInBlocks) {
  const Motion motion = test::smooth_motion(130);
  const Eigen::MatrixXd original = body_tracks(motion.skeleton, motion.clip);
  Clip other = motion.clip;
  other.channels += 0.02 * test::smooth_motion(130, 3).clip.channels;
  const Eigen::MatrixXd decoded = body_tracks(motion.skeleton, other);
  const std::vector<ContactSpan> contacts = {{3, 0, 40}, {3, 60, 129}};
  const Visibility whole = measure_visibility(motion.skeleton, original, decoded, kRate, contacts);
  for (const int length : {1, 7, 12, 50, 129}) {
    VisibilityMeter meter(motion.skeleton, 130, kRate, contacts);
    for (int first = 0; first < 130; first += length) {
      const int count = std::min(length, 130 - first);
      meter.add(first, original.middleRows(first, count), decoded.middleRows(first, count));
    }
    const Visibility seen = meter.visibility();
    EXPECT_TRUE(seen.table.times_noticed.isApprox(whole.table.times_noticed, 1e-3F)) << length;
    EXPECT_NEAR(seen.worst().times_noticed(), whole.worst().times_noticed(), 1e-5);
    EXPECT_NEAR(seen.contacts->worst_slide_cm, whole.contacts->worst_slide_cm, 1e-9);
  }
}

// The claims of studies, on motions made up here: they test the model, and no person saw them.

/// A stick that swings a hand at the end of a bone: degrees at each time, about z.
Eigen::MatrixXd swinging(const char* end, double rate, const std::function<double(double)>& turn,
                         Skeleton& skeleton) {
  skeleton = Skeleton();
  skeleton.add(stick(end).joint(0));
  Joint shoulder{.name = "shoulder", .parent = 0, .offset = {0, 140, 0}};
  shoulder.channels = {ChannelKind::RotationZ};
  skeleton.add(shoulder);
  Joint hand{.name = end, .parent = 1, .offset = {60, 0, 0}};
  hand.channels = {ChannelKind::RotationZ};
  skeleton.add(hand);
  skeleton.add({.name = "finger", .parent = 2, .offset = {8, 0, 0}});
  Clip clip{rate, Eigen::MatrixXd::Zero(240, 5)};
  for (int t = 0; t < 240; ++t) clip.channels(t, 3) = turn(t / rate) * std::numbers::pi / 180;
  return body_tracks(skeleton, clip);
}

TEST(Visibility, AHandShiftedByATenthOfASecondIsNoticed) {  // Joerg et al. 2010
  Skeleton skeleton;
  const auto wave = [](double s) { return 30 * std::sin(2 * std::numbers::pi * s); };
  const Eigen::MatrixXd original = swinging("RightHand", kRate, wave, skeleton);
  const auto late = [&](double by) {
    const Eigen::MatrixXd shifted = swinging(
        "RightHand", kRate, [&](double s) { return wave(s - by); }, skeleton);
    return measure_visibility(skeleton, original, shifted, kRate, {}).worst();
  };
  EXPECT_GT(late(0.1).times_noticed(), 1);
  EXPECT_EQ(late(0.1).cue, Cue::Velocity);
  EXPECT_LT(late(0.001).times_noticed(), 1);
}

TEST(Visibility, LimbsUpToThreePerCentLongerAreNotNoticedAndTwentyAre) {  // Harrison et al. 2004
  Skeleton skeleton;
  const auto still_arm = [](double) { return 0; };
  const Eigen::MatrixXd original = swinging("RightHand", kRate, still_arm, skeleton);
  const auto longer = [&](double share) {
    Skeleton other;
    for (const Joint& joint : skeleton.joints()) {
      Joint bone = joint;
      if (joint.parent > 0) bone.offset *= 1 + share;
      other.add(bone);
    }
    const Clip clip{kRate, Eigen::MatrixXd::Zero(240, 5)};
    return measure_visibility(skeleton, original, body_tracks(other, clip), kRate, {})
        .worst()
        .times_noticed();
  };
  // The model judges limbs as attended, so that it is on the safe side of unattended ones (20 %).
  EXPECT_LE(longer(0.03), 1);
  EXPECT_GT(longer(0.2), 1);
}

TEST(Visibility, TremblingHandsWeighAboveTurnedOnes) {  // Adkins et al. 2023
  Skeleton skeleton;
  const Eigen::MatrixXd original = swinging(
      "RightHand", kRate, [](double) { return 0; }, skeleton);
  const auto with_hand = [&](const std::function<double(double)>& degrees) {
    Clip clip{kRate, Eigen::MatrixXd::Zero(240, 5)};
    for (int t = 0; t < 240; ++t) clip.channels(t, 4) = degrees(t / kRate) * std::numbers::pi / 180;
    return measure_visibility(skeleton, original, body_tracks(skeleton, clip), kRate, {});
  };
  constexpr double kDegrees = 3;  // RMS of both
  const double turned = with_hand([](double) { return kDegrees; }).worst().times_noticed();
  const double trembling =
      with_hand([](double s) { return wobble(s, 15, kDegrees * std::numbers::sqrt2); })
          .worst()
          .times_noticed();
  EXPECT_GT(trembling, 1.5 * turned);
}

TEST(Visibility, SlidesFromTwentyOneMillimetresOnAreVisible) {  // Prazak et al. 2011
  const Skeleton skeleton = stick("top");
  const auto slides = [&](double cm) {
    const Clip decoded = moved(still(240), 0, [cm](double s) { return cm * s / 2; });
    return sight_of(times(compare(skeleton, still(240), decoded, {{0, 0, 239}}), Cue::Slide));
  };
  EXPECT_EQ(slides(2.3), Sight::Visible);
  EXPECT_NE(slides(1.6), Sight::Visible);
}

TEST(Visibility, FromTheUnnoticedDistanceOnNothingIsNoticed) {
  const Motion motion = test::smooth_motion(130);
  Clip other = motion.clip;
  other.channels += 0.02 * test::smooth_motion(130, 3).clip.channels;
  const auto from = [&](double metres) {
    SightLimits limits;
    limits.distance_m = metres;
    return measure_visibility(motion.skeleton, body_tracks(motion.skeleton, motion.clip),
                              body_tracks(motion.skeleton, other), kRate, {{3, 0, 40}}, limits);
  };
  const double metres = from(5).unnoticed_from_m;
  EXPECT_GT(metres, 0);
  EXPECT_NEAR(from(20).unnoticed_from_m, metres, 1e-9);  // whatever the viewer's distance
  EXPECT_LE(from(metres).worst().times_noticed(), 1 + 1e-9);
  EXPECT_GT(from(0.95 * metres).worst().times_noticed(), 1);
  EXPECT_GT(from(2).worst().times_noticed(), from(4).worst().times_noticed());
}

TEST(Visibility, AViewersOwnLimitsReplaceTheBuiltInOnes) {
  const Skeleton skeleton = stick("top");
  SightLimits limits;
  limits.of(Cue::Floor).least = 6;
  const Clip lowered = moved(still(120), 1, [](double) { return -3; });
  const Visibility seen = measure_visibility(skeleton, body_tracks(skeleton, still(120)),
                                             body_tracks(skeleton, lowered), kRate, {}, limits);
  EXPECT_NEAR(times(seen, Cue::Floor), 0.5, 1e-6);
}

}  // namespace
}  // namespace mocapress
