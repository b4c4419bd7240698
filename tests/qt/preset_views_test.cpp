// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/preset_views.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/jobs/result_cache.h"
#include "app/studio/document/named_settings.h"
#include "app/studio/document/preset_shelf.h"
#include "app/studio/document/session.h"
#include "core/mocapress/encode_settings.h"
#include "core/motion/landmarks.h"
#include "resources/samples/generator/samples.h"
#include "tests/qt/patience.h"
#include "widgets/panels/preset_chooser.h"

namespace mocapress {
namespace {

TEST(ClipPreset, ComesBackFromTheSettingsItMade) {
  const Skeleton skeleton = samples::walk_clip().skeleton;
  std::vector<Settings> presets(built_in_presets().begin(), built_in_presets().end());
  presets.push_back({.name = "Mine",
                     .method = "annealed",
                     .coding = Coding::Rle16,
                     .weighting = Weighting::JointOrigins,
                     .target = {Target::Kind::Size, 9000},
                     .seed = 7,
                     .importance = {.factors = {{"feet", 4}, {"root", 2}}, .contacts = 3},
                     .correction = CorrectionSettings{.ratio = 9.0, .effectors = {"lhand"}}});
  presets.push_back({.name = "Tried harder", .effort = Effort::Best});
  for (const Settings& preset : presets) {
    const ClipSettings settings = withPreset({}, preset, skeleton);
    EXPECT_EQ(presetOf(settings, skeleton), preset) << preset.name;
    EXPECT_TRUE(isAsPreset(settings, preset, skeleton));
    EXPECT_FALSE(isAsPreset(settings, {.name = "Else", .seed = 99}, skeleton));
  }
}

TEST(ClipPreset, EditedContactsStayWithTheirClip) {
  const Skeleton skeleton = samples::walk_clip().skeleton;
  ClipSettings settings = usualSettings();
  settings.encode.contacts = std::vector<ContactSpan>{{3, 10, 20}};
  EXPECT_FALSE(presetOf(settings, skeleton).contacts);
  EXPECT_EQ(withPreset(settings, built_in_presets()[0], skeleton).encode.contacts,
            settings.encode.contacts);
  const Settings own = ownPresetOf(settings, skeleton);
  EXPECT_EQ(settingsKey(encode_settings(own, skeleton)), settingsKey(settings.encode));
}

class PresetsOfAClip : public testing::Test {
 protected:
  PresetsOfAClip() {
    settleAfter([&] {
      session_.open(QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/human_walk.amc"));
    });
  }

  template <typename Act>
  void settleAfter(Act act) {
    QSignalSpy settled(&session_, &Session::settled);
    act();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  }

  void choose(const char* name) {
    QComboBox* box = chooser_.box();
    const int index = box->findText(QString::fromLatin1(name));
    ASSERT_GE(index, 0) << name;
    box->setCurrentIndex(index);
    emit box->activated(index);
  }

  const EncodeSettings& options() { return session_.document().options(); }
  std::string shown() { return chooser_.box()->currentText().toStdString(); }

  QTemporaryDir directory_;
  Session session_;
  PresetShelf shelf_{directory_.filePath(QStringLiteral("presets.json"))};
  PresetChooser chooser_;
  QWidget window_;
  PresetViews views_{&session_, &shelf_, &chooser_, &window_};
};

TEST_F(PresetsOfAClip, BeginWithTheClosedLoopAsGameplay) {
  EXPECT_EQ(options().method, Method::ClosedLoop);
  EXPECT_EQ(options().target.kind, Target::Kind::Error);
  EXPECT_EQ(shown(), "Gameplay");
  const Skeleton& skeleton = *session_.document().skeleton();
  EXPECT_EQ(settingsKey(options()), settingsKey(encode_settings(built_in_presets()[1], skeleton)));
  EXPECT_FALSE(options().importance.joints.empty()) << "what it says of hands is of these hands";
}

TEST_F(PresetsOfAClip, ChoosingOneSetsAllOfItInOneStep) {
  const Settings mine{.name = "Mine",
                      .method = "annealed",
                      .target = {Target::Kind::Ratio, 12},
                      .importance = {.factors = {{"feet", 4}}},
                      .correction = CorrectionSettings{.ratio = 16.0}};
  shelf_.save(mine);
  const Importance before = options().importance;
  settleAfter([&] { choose("Mine"); });
  EXPECT_EQ(options().method, Method::Annealed);
  EXPECT_EQ(options().target.value, 12);
  EXPECT_EQ(options().correction->ratio, 16.0);
  EXPECT_NE(options().importance, before);
  EXPECT_EQ(session_.history()->undoText().toStdString(), "Preset");
  session_.history()->undo();
  EXPECT_EQ(shown(), "Gameplay");
  EXPECT_EQ(options().importance, before);
}

TEST_F(PresetsOfAClip, ShowThatASettingWasChangedUntilItIsUndone) {
  EncodeSettings changed = options();
  changed.target.value = 0.66;
  session_.setOptions(changed);
  EXPECT_EQ(shown(), "Gameplay, modified");
  session_.history()->undo();
  EXPECT_EQ(shown(), "Gameplay");
}

TEST_F(PresetsOfAClip, SavingNamesThemAndUndoRemovesTheName) {
  EncodeSettings changed = options();
  changed.target.value = 0.66;
  session_.setOptions(changed);
  shelf_.setHistory([this] { return session_.history(); });
  Settings named = chooser_.preset();
  named.name = "Nearby";
  views_.save(named);
  EXPECT_EQ(shown(), "Nearby");
  EXPECT_EQ(shelf_.all().back().target.value, 0.66);
  session_.history()->undo();
  EXPECT_EQ(shown(), "Gameplay, modified");
  EXPECT_EQ(shelf_.all().size(), built_in_presets().size());
  session_.history()->redo();
  EXPECT_EQ(shown(), "Nearby");
}

TEST_F(PresetsOfAClip, LeaveOutComparisonMethods) {
  shelf_.save({.name = "By PCA", .method = "pca"});
  shelf_.save({.name = "By r", .target = {Target::Kind::CoefficientRatio, 30}});
  EXPECT_LT(chooser_.box()->findText(QStringLiteral("By PCA")), 0);
  EXPECT_LT(chooser_.box()->findText(QStringLiteral("By r")), 0);
}

TEST_F(PresetsOfAClip, ThatNameAJointTheClipLacksAreAMessage) {
  shelf_.save({.name = "Tail", .importance = {.factors = {{"tail_3", 4}}}});
  QSignalSpy failed(&session_, &Session::compressFailed);
  choose("Tail");
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("tail_3")));
  EXPECT_EQ(shown(), "Gameplay");
}

TEST_F(PresetsOfAClip, ANameThatIsTakenLeavesTheHistoryAsItIs) {
  shelf_.setHistory([this] { return session_.history(); });
  EncodeSettings changed = options();
  changed.target.value = 0.66;
  session_.setOptions(changed);
  session_.history()->undo();
  Settings named = chooser_.preset();
  named.name = "Crowd";
  QSignalSpy noted(&shelf_, &PresetShelf::noted);
  views_.save(named);
  EXPECT_EQ(noted.count(), 1);
  EXPECT_TRUE(session_.history()->canRedo());
  EXPECT_FALSE(session_.history()->canUndo());
}

TEST_F(PresetsOfAClip, ChoosingThePresentPresetIsNoUndoStep) {
  choose("Gameplay");
  EXPECT_FALSE(session_.history()->canUndo());
}

TEST(NamedSettings, LeaveOutWhatTheClipOfNowDoesNotHave) {
  const Motion walk{samples::walk_clip()};
  const std::string joint = walk.skeleton.joint(2).name;
  const std::string point = landmarks(walk.skeleton)[3].name;
  NamedSettings settings = namedSettings(usualSettings(), {});
  settings.preset.correction = CorrectionSettings{.effectors = {"tail_3", joint}};
  settings.preset.contacts = {{point, 10, 20}, {"tail_3", 1, 2}, {point, 5, 1 << 20}};
  settings.preset.importance.factors = {{"feet", 4}, {"tail_3", 2}};
  const ClipSettings fit = settingsFor(settings, walk);
  EXPECT_EQ(fit.encode.correction->joints, std::vector<int>{2});
  EXPECT_EQ(fit.encode.contacts, (std::vector<ContactSpan>{{3, 10, 20}}));
  const NamedImportance importance = named(fit.encode.importance, walk.skeleton);
  EXPECT_EQ(importance.factors, (decltype(importance.factors){{"feet", 4}}));
}

}  // namespace
}  // namespace mocapress
