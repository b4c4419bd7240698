// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/jobs/result_cache.h"
#include "app/studio/compare/clip_curve.h"
#include "app/studio/document/session.h"
#include "app/studio/document/settings_field.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

EncodeSettings standard(double ratio) {
  return {.method = Method::Standard, .target = {Target::Kind::Ratio, ratio}};
}

TEST(SettingsKey, DiffersInEverythingThatChangesTheAnswer) {
  const EncodeSettings plain{.method = Method::Annealed};
  std::vector<EncodeSettings> others(15, plain);
  others[0].method = Method::Standard;
  others[1].coding = Coding::Rle16;
  others[2].weighting = Weighting::JointOrigins;
  others[3].target.value = 26;
  others[4].target.kind = Target::Kind::Size;
  others[5].seed = 2;
  others[6].correction = EncodeCorrection{};
  others[7].correction = EncodeCorrection{.ratio = 16};
  others[8].contacts = std::vector<ContactSpan>{{1, 2, 3}};
  others[9].effort = Effort::Best;
  others[10].importance.contacts = 20;
  others[11].importance.joints = {1, 4};
  others[12].ranges = {{1, 2, 3}};
  others[13].ranges = {{1, 2, 4}};
  others[14].loop = Loop::None;
  for (std::size_t i = 0; i < others.size(); ++i) {
    EXPECT_NE(settingsKey(others[i]), settingsKey(plain)) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(settingsKey(others[i]), settingsKey(others[j]));
  }
  EXPECT_EQ(settingsKey(plain), settingsKey({.method = Method::Annealed}));
}

TEST(SettingsField, TellsLimitsFromTheDistance) {
  const ClipSettings before;
  ClipSettings after;
  after.encode.limits.distance_m = 12;
  EXPECT_EQ(nameOf(firstDifference(before, after)), QStringLiteral("Viewing Distance"));
  EXPECT_NE(dragOf(before, after), QString());
  after.encode.limits.of(Cue::Slide).least = 3;
  EXPECT_EQ(nameOf(firstDifference(before, after)), QStringLiteral("Limits of Visibility"));
  EXPECT_EQ(dragOf(before, after), QString());
}

TEST(ResultCache, ForgetsWhatWasNotAskedForLongestWhenItIsFull) {
  ResultCache cache;
  const auto entry = [](std::size_t bytes) {
    DecodedClip clip;
    clip.file.resize(bytes);
    return std::make_shared<const DecodedClip>(std::move(clip));
  };
  const std::size_t third = ResultCache::kMostBytes / 3;
  for (const char* key : {"a", "b", "c"}) cache.add(key, entry(third));
  ASSERT_TRUE(cache.find("a"));
  cache.add("d", entry(third));
  EXPECT_TRUE(cache.find("a"));
  EXPECT_FALSE(cache.find("b"));
  EXPECT_LE(cache.bytes(), ResultCache::kMostBytes);
  cache.add("a", entry(1));
  EXPECT_EQ(cache.size(), 3u);
}

TEST(SettingsField, NamesWhatChanged) {
  const ClipSettings plain;
  const auto fieldOf = [&](auto edit) {
    ClipSettings edited = plain;
    edit(edited);
    return firstDifference(plain, edited);
  };
  using enum SettingsField;
  EXPECT_EQ(firstDifference(plain, plain), None);
  EXPECT_EQ(fieldOf([](ClipSettings& s) { s.encode.target.value = 3; }), Target);
  EXPECT_EQ(fieldOf([](ClipSettings& s) { s.encode.method = mocapress::Method::Annealed; }),
            Method);
  EXPECT_EQ(fieldOf([](ClipSettings& s) { s.encode.correction = EncodeCorrection{}; }), Correction);
  EXPECT_EQ(fieldOf([](ClipSettings& s) { s.contacts.begin_height = 9; }), Contacts);
  EXPECT_EQ(fieldOf([](ClipSettings& s) { s.encode.effort = mocapress::Effort::Best; }), Effort);
  EXPECT_EQ(fieldOf([](ClipSettings& s) { s.encode.ends = mocapress::Ends::Exact; }), Ends);
  EXPECT_EQ(fieldOf([](ClipSettings& s) { s.encode.importance.contacts = 9; }), Importance);
  EXPECT_EQ(fieldOf([](ClipSettings& s) { s.encode.ranges = {{1, 2, 3}}; }), Ranges);
  EXPECT_EQ(fieldOf([](ClipSettings& s) { s.encode.loop = mocapress::Loop::None; }), Loop);
  EXPECT_EQ(fieldOf([](ClipSettings& s) { s.preset = QStringLiteral("Mine"); }), Preset);
}

class History : public testing::Test {
 protected:
  History() {
    session_.setOptions(standard(10));
    const QString path = directory_.filePath(QStringLiteral("clip.bvh"));
    write_motion(path.toStdU16String(), test::smooth_motion(120));
    settleAfter([&] { session_.open(path); });
  }

  template <typename Act>
  void settleAfter(Act act) {
    QSignalSpy settled(&session_, &Session::settled);
    act();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  }

  double target() { return session_.document().options().target.value; }

  QTemporaryDir directory_;
  Session session_;
};

TEST_F(History, UndoAndRedoBringSettingsAndTheirAnswersBackAtOnce) {
  settleAfter([&] { session_.setOptions(standard(20)); });
  EncodeSettings per_channel = standard(20);
  per_channel.method = Method::PerChannel;
  settleAfter([&] { session_.setOptions(per_channel); });
  const DecodedPtr last = session_.document().decoded();

  QSignalSpy settled(&session_, &Session::settled);
  session_.history()->undo();
  EXPECT_EQ(session_.document().options().method, Method::Standard);
  EXPECT_EQ(settled.count(), 1);  // comes from the cache
  EXPECT_NE(session_.document().decoded(), last);
  session_.history()->redo();
  EXPECT_EQ(session_.document().decoded(), last);
}

TEST_F(History, ADragOfTheSliderIsOneStep) {
  for (int ratio = 11; ratio <= 30; ++ratio) session_.setOptions(standard(ratio));
  EXPECT_EQ(session_.history()->count(), 1);
  session_.history()->undo();
  EXPECT_DOUBLE_EQ(target(), 10);
  session_.history()->redo();
  EXPECT_DOUBLE_EQ(target(), 30);
}

TEST_F(History, FiguresOfASlotAreNotThoseOfTheOther) {
  settleAfter([&] { session_.setOptions(standard(20)); });
  settleAfter([&] { session_.switchSlot(); });
  session_.setOptions(standard(30));  // B's, and left before there is an answer
  settleAfter([&] { session_.switchSlot(); });
  ASSERT_TRUE(session_.slotFigures(0));
  EXPECT_NEAR(session_.slotFigures(0)->ratio, 20, 1);
  session_.switchSlot();
  EXPECT_FALSE(session_.slotFigures(1)) << "what is shown is still what A made";
  ASSERT_TRUE(session_.slotFigures(0));
  EXPECT_NEAR(session_.slotFigures(0)->ratio, 20, 1);
}

TEST_F(History, EveryContactEditIsAStepOfItsOwn) {
  session_.setContacts({{4, 10, 20}});
  session_.setContacts({{4, 10, 25}});
  EXPECT_EQ(session_.history()->count(), 2);
  session_.history()->undo();
  EXPECT_EQ(session_.document().contacts(), (std::vector<ContactSpan>{{4, 10, 20}}));
  session_.history()->undo();
  EXPECT_FALSE(session_.document().options().contacts);
}

TEST_F(History, CareInARangeIsAStepAndOfOneClip) {
  const std::vector<ImportantRange> care = {{10, 40, 3}};
  session_.setRanges(care);
  session_.setLoop(Loop::None);
  EXPECT_EQ(session_.history()->count(), 2);
  session_.history()->undo();
  EXPECT_FALSE(session_.document().options().loop);
  EXPECT_EQ(session_.document().options().ranges, care);
  const QString path = directory_.filePath(QStringLiteral("other.bvh"));
  write_motion(path.toStdU16String(), test::smooth_motion(100, 2));
  const auto shows = [this](int frames) {
    return QTest::qWaitFor([=, this] { return session_.document().frames() == frames; }, kPatience);
  };
  session_.open(path);
  ASSERT_TRUE(shows(100));
  EXPECT_TRUE(session_.document().options().ranges.empty());
  session_.open(directory_.filePath(QStringLiteral("clip.bvh")));
  ASSERT_TRUE(shows(120));
  EXPECT_EQ(session_.document().options().ranges, care);
}

TEST_F(History, BeginsAnewWithAnotherClip) {
  settleAfter([&] { session_.setOptions(standard(20)); });
  const QString path = directory_.filePath(QStringLiteral("other.bvh"));
  write_motion(path.toStdU16String(), test::smooth_motion(100, 2));
  settleAfter([&] { session_.open(path); });
  EXPECT_FALSE(session_.history()->canUndo());
}

TEST_F(History, IsThereAgainWithItsClipAndMixesWithNoOther) {
  const QString first = directory_.filePath(QStringLiteral("clip.bvh"));
  const QString second = directory_.filePath(QStringLiteral("other.bvh"));
  write_motion(second.toStdU16String(), test::smooth_motion(100, 2));
  settleAfter([&] { session_.setOptions(standard(20)); });
  settleAfter([&] { session_.switchSlot(); });
  settleAfter([&] { session_.setOptions(standard(30)); });
  settleAfter([&] { session_.open(second); });
  settleAfter([&] { session_.setOptions(standard(40)); });
  EXPECT_EQ(session_.history()->count(), 1);
  settleAfter([&] { session_.open(first); });
  EXPECT_DOUBLE_EQ(target(), 30);
  EXPECT_EQ(session_.document().tuning().active, 1);
  EXPECT_EQ(session_.history()->count(), 3);
  settleAfter([&] { session_.history()->undo(); });
  settleAfter([&] { session_.history()->undo(); });
  EXPECT_EQ(session_.document().tuning().active, 0);
  EXPECT_DOUBLE_EQ(target(), 20);
  settleAfter([&] { session_.history()->redo(); });
  settleAfter([&] { session_.open(second); });
  EXPECT_DOUBLE_EQ(target(), 40);
  settleAfter([&] { session_.history()->undo(); });
  EXPECT_DOUBLE_EQ(target(), 30) << "what it began with";
}

TEST_F(History, ForgetsAClipThatChangedOnDisk) {
  const QString path = directory_.filePath(QStringLiteral("clip.bvh"));
  settleAfter([&] { session_.setContacts({{4, 100, 119}}); });
  const QString other = directory_.filePath(QStringLiteral("other.bvh"));
  write_motion(other.toStdU16String(), test::smooth_motion(100, 2));
  settleAfter([&] { session_.open(other); });
  write_motion(path.toStdU16String(), test::smooth_motion(90));
  settleAfter([&] { session_.open(path); });
  EXPECT_FALSE(session_.history()->canUndo());
}

TEST_F(History, ImportanceIsAStepAndADragOfItOne) {
  for (const double weight : {1.0, 5.0, 20.0}) session_.setImportance({.contacts = weight});
  EXPECT_EQ(session_.history()->count(), 1);
  EXPECT_EQ(session_.document().options().importance.contacts, 20);
  session_.history()->undo();
  EXPECT_TRUE(session_.document().options().importance.is_even());
}

TEST_F(History, ImportanceOutlivesTheClipByTheNamesOfJoints) {
  const Skeleton skeleton = *session_.document().skeleton();
  Importance importance{
      .joints = std::vector<double>(static_cast<std::size_t>(skeleton.joint_count()), 1.0),
      .contacts = 3};
  importance.joints[static_cast<std::size_t>(skeleton.find("lhand"))] = 5;
  session_.setImportance(importance);
  settleAfter([&] {
    session_.open(QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/human_walk.amc"));
  });
  const Skeleton& human = *session_.document().skeleton();
  const auto& carried = session_.document().options().importance;
  ASSERT_EQ(std::ssize(carried.joints), human.joint_count());
  EXPECT_EQ(carried.joints[static_cast<std::size_t>(human.find("lhand"))], 5);
  EXPECT_EQ(carried.contacts, 3);
}

TEST_F(History, TheCurveOfTheClipFillsAndOutlivesAnotherTarget) {
  ClipCurve curve(&session_);
  QSignalSpy changed(&curve, &ClipCurve::changed);
  settleAfter([&] { session_.setOptions(standard(20)); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return changed.count() > 0 && !curve.busy(); }, kPatience));
  const std::size_t points = curve.ratios().size();
  EXPECT_GE(points, 8u);
  ASSERT_EQ(curve.curves().size(), 1u);
  EXPECT_GE(curve.curves().front().line.size(), 4u);
  settleAfter([&] { session_.setOptions(standard(33)); });
  EXPECT_GT(curve.ratios().size(), points);
  const std::vector<double> measured = curve.ratios();
  const QString own = session_.document().original()->path;
  settleAfter([&] {
    session_.open(QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/human_walk.amc"));
  });
  EXPECT_NE(curve.ratios(), measured);
  QSignalSpy opened(&session_, &Session::opened);
  session_.open(own);
  ASSERT_TRUE(opened.wait(kPatience));
  EXPECT_EQ(curve.ratios(), measured) << "they are there again with their clip";
  settleAfter([&] { session_.setOptions(standard(34)); });
  EncodeSettings joints = standard(33);
  joints.weighting = Weighting::JointOrigins;
  settleAfter([&] { session_.setOptions(joints); });
  EXPECT_LE(curve.ratios().size(), 2u);  // other points had another weighting
}

}  // namespace
}  // namespace mocapress
