// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/batch_queue_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "widgets/panels/batch_queue_view.h"
#include "widgets/panels/preset_chooser.h"
#include "widgets/panels/preset_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>

namespace mocapress {
namespace {

using ClipState = QueuedClip::State;

class BatchQueue : public testing::Test {
 protected:
  BatchQueue() {
    model_.add({{.source = {"/a/walk.bvh", "a", {}}},
                {.source = {"/a/run.bvh", "a", {}}},
                {.source = {"/b/jump.amc", "b", {}}}});
  }

  QString text(int row, int column) const {
    return model_.data(model_.index(row, column), Qt::DisplayRole).toString();
  }

  BatchQueueModel model_;
  QAbstractItemModelTester tester_{&model_, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(BatchQueue, HasEveryClipOnce) {
  model_.add({{.source = {"/a/run.bvh", "", {}}}, {.source = {"/c/new.bvh", "", {}}}});
  ASSERT_EQ(model_.rowCount(), 4);
  EXPECT_EQ(text(3, BatchQueueModel::Clip), QStringLiteral("new"));
  model_.remove({0, 2});
  ASSERT_EQ(model_.rowCount(), 2);
  EXPECT_EQ(text(0, BatchQueueModel::Clip), QStringLiteral("run"));
  EXPECT_EQ(text(1, BatchQueueModel::Clip), QStringLiteral("new"));
}

TEST_F(BatchQueue, FilesOfOneNameAreToldApartByTheirFoldersWhileThereAreSeveral) {
  EXPECT_EQ(text(0, BatchQueueModel::Clip), QStringLiteral("walk"));
  model_.add({{.source = {"/b/walk.bvh", "b", {}}}});
  EXPECT_EQ(text(0, BatchQueueModel::Clip), QStringLiteral("a/walk.bvh"));
  EXPECT_EQ(text(1, BatchQueueModel::Clip), QStringLiteral("run"));
  EXPECT_EQ(text(3, BatchQueueModel::Clip), QStringLiteral("b/walk.bvh"));
  model_.remove({0});
  EXPECT_EQ(text(2, BatchQueueModel::Clip), QStringLiteral("walk"));
}

TEST_F(BatchQueue, SettingsNameRangesWithMoreCare) {
  Settings careful = model_.presetOf(1);
  careful.ranges = {{20, 60, 3}, {80, 90, 2}};
  model_.setOwn({1}, careful);
  EXPECT_TRUE(text(1, BatchQueueModel::Preset).startsWith(text(0, BatchQueueModel::Preset)));
  EXPECT_TRUE(text(1, BatchQueueModel::Preset).contains(QStringLiteral("2 care range")));
}

TEST_F(BatchQueue, ALockedClipKeepsItsSettingsWhenThoseOfAllChange) {
  const Settings crowd = built_in_presets()[2];
  const Settings archive = built_in_presets()[3];
  model_.setOwn({1}, archive);
  model_.setCommon(crowd);
  EXPECT_EQ(model_.presetOf(0), crowd);
  EXPECT_EQ(model_.presetOf(1), archive);
  model_.setOwn({1}, std::nullopt);
  EXPECT_EQ(model_.presetOf(1), crowd);
}

TEST_F(BatchQueue, OnlyClipsWhoseSettingsChangeAreWaitingAgain) {
  for (int row = 0; row < 3; ++row) model_.setEnded(row, Measurement{.ratio = 20}, "");
  model_.setOwn({1}, model_.common());  // locks the clip and changes nothing else
  EXPECT_EQ(model_.count(ClipState::Done), 3);
  model_.setCommon(built_in_presets()[2]);
  EXPECT_EQ(model_.count(ClipState::Done), 1);
  EXPECT_EQ(model_.clips()[1].state, ClipState::Done);
}

TEST_F(BatchQueue, ShowsProgressAndResultOfAClip) {
  model_.setProgress(0, {ClipProgress::Stage::Encoding, 0.43});
  EXPECT_EQ(text(0, BatchQueueModel::State), QStringLiteral("Compressing, 43 %"));
  EXPECT_DOUBLE_EQ(
      model_.data(model_.index(0, BatchQueueModel::State), BatchQueueModel::kProgressRole)
          .toDouble(),
      0.43);
  model_.setEnded(
      0, Measurement{.ratio = 52.26, .body = {.surface = {.rms = 0.4987, .max = {.cm = 4.321}}}},
      "");
  EXPECT_EQ(text(0, BatchQueueModel::State), QStringLiteral("✓ Verified"));
  EXPECT_EQ(text(0, BatchQueueModel::Ratio), QStringLiteral("52.3:1"));
  EXPECT_EQ(text(0, BatchQueueModel::Eps), QStringLiteral("0.499"));
  EXPECT_EQ(text(0, BatchQueueModel::Max), QStringLiteral("4.32"));
  model_.setEnded(1, {}, "/a/run.bvh:3:1: expected ROOT");
  EXPECT_EQ(text(1, BatchQueueModel::State), QStringLiteral("✗ expected ROOT"));
  EXPECT_EQ(model_.data(model_.index(1, BatchQueueModel::State), Qt::ToolTipRole).toString(),
            QStringLiteral("/a/run.bvh:3:1: expected ROOT"));
  EXPECT_EQ(text(1, BatchQueueModel::Ratio), QStringLiteral("–"));
}

TEST_F(BatchQueue, VerifiedSaysWhatTheReaderWarnedOf) {
  model_.setEnded(0, Measurement{.ratio = 20}, "", {"walk.bvh:9: the file ends early", "another"});
  EXPECT_EQ(model_.clips()[0].state, ClipState::Done);
  EXPECT_TRUE(text(0, BatchQueueModel::State).startsWith(QStringLiteral("✓ Verified, 2 warning")));
  EXPECT_EQ(model_.data(model_.index(0, BatchQueueModel::State), Qt::ToolTipRole).toString(),
            QStringLiteral("walk.bvh:9: the file ends early\nanother"));
  model_.setEnded(0, Measurement{.ratio = 20}, "");
  EXPECT_EQ(text(0, BatchQueueModel::State), QStringLiteral("✓ Verified"));
}

TEST_F(BatchQueue, ARejectedClipIsLeftOutUntilItIsTicked) {
  const auto ticked = [this](int row) {
    return model_.data(model_.index(row, BatchQueueModel::Clip), Qt::CheckStateRole).toInt() ==
           Qt::Checked;
  };
  const QString walk = QStringLiteral("/a/walk.bvh");
  const std::string key = settings_hash(model_.presetOf(0), {});
  const auto said = [&](Verdict verdict, const char* note) {
    return LibraryReview{{verdict, note, "ann", "2026-11-27T01:39:46Z", "1", key}, "1"};
  };
  model_.setReviews({{walk, said(Verdict::Rejected, "slides")}, {QStringLiteral("/x.bvh"), {}}});
  EXPECT_TRUE(model_.clips()[0].left_out);
  EXPECT_FALSE(ticked(0));
  EXPECT_TRUE(ticked(1));
  EXPECT_EQ(text(0, BatchQueueModel::Review), QStringLiteral("✕ rejected: slides"));
  EXPECT_EQ(text(0, BatchQueueModel::State), QStringLiteral("Left out"));
  EXPECT_EQ(model_.count(ClipState::Waiting), 2);
  EXPECT_EQ(model_.countLeftOut(), 1);

  QSignalSpy toggled(&model_, &BatchQueueModel::includeToggled);
  const QModelIndex clip = model_.index(0, BatchQueueModel::Clip);
  EXPECT_TRUE(model_.flags(clip) & Qt::ItemIsUserCheckable);
  model_.setData(clip, Qt::Checked, Qt::CheckStateRole);
  ASSERT_EQ(toggled.count(), 1);
  EXPECT_EQ(toggled[0], (QList<QVariant>{0, true}));

  model_.setLeftOut({0}, false);
  model_.setReviews({{walk, said(Verdict::Rejected, "slides a lot")}});
  EXPECT_FALSE(model_.clips()[0].left_out) << "the user asked for it";
  model_.setReviews({{walk, said(Verdict::Approved, "")}});
  EXPECT_EQ(text(0, BatchQueueModel::Review), QStringLiteral("✓ approved"));
  model_.setReviews({{walk, said(Verdict::Rejected, "")}});
  EXPECT_TRUE(model_.clips()[0].left_out) << "rejected anew";
}

TEST_F(BatchQueue, ShowsTheVerdictColumnOnceAClipHasAVerdict) {
  const BatchQueueView view(&model_);
  EXPECT_TRUE(view.isColumnHidden(BatchQueueModel::Review));
  LibraryReview review;
  review.review.note = "look again";
  model_.setReviews({{QStringLiteral("/a/run.bvh"), review}});
  EXPECT_FALSE(view.isColumnHidden(BatchQueueModel::Review));
  model_.remove({1});
  EXPECT_TRUE(view.isColumnHidden(BatchQueueModel::Review));
}

TEST_F(BatchQueue, StoppedClipsWaitAgain) {
  model_.setProgress(0, {});
  model_.setEnded(1, Measurement{}, "");
  model_.stopWorking();
  EXPECT_EQ(model_.clips()[0].state, ClipState::Waiting);
  EXPECT_EQ(model_.clips()[1].state, ClipState::Done);
}

class PresetEditorTest : public testing::Test {
 protected:
  PresetEditorTest() {
    QObject::connect(&editor_, &PresetEditor::presetChanged,
                     [this](const Settings& preset) { told_.push_back(preset); });
  }

  PresetEditor editor_;
  std::vector<Settings> told_;
};

TEST_F(PresetEditorTest, EmitsOnlyForChangesByTheUser) {
  for (const Settings& preset : built_in_presets()) editor_.setPreset(preset);
  EXPECT_TRUE(told_.empty());
  emit editor_.chooser()->box()->activated(2);
  ASSERT_EQ(told_.size(), 1u);
  EXPECT_EQ(told_[0], built_in_presets()[2]);
}

TEST_F(PresetEditorTest, ShowsAChangedSettingAsAChangeOfThePreset) {
  editor_.setPreset(built_in_presets()[1]);
  editor_.value()->setValue(0.35);
  ASSERT_EQ(told_.size(), 1u);
  EXPECT_EQ(told_[0].target.value, 0.35);
  EXPECT_EQ(told_[0].name, "Gameplay");
  EXPECT_EQ(editor_.chooser()->box()->currentText(), QStringLiteral("Gameplay, modified"));
  editor_.holdFeet()->click();
  ASSERT_TRUE(told_.back().correction);
  EXPECT_FALSE(told_.back().correction->ratio) << "the encoder finds it";
  editor_.setPreset(built_in_presets()[1]);
  EXPECT_EQ(editor_.chooser()->box()->currentText(), QStringLiteral("Gameplay"));
}

TEST_F(PresetEditorTest, AnotherKindOfTargetBeginsWithAUsualValue) {
  editor_.setPreset(built_in_presets()[1]);
  editor_.kind()->setCurrentIndex(editor_.kind()->findData(static_cast<int>(Target::Kind::Ratio)));
  emit editor_.kind()->activated(editor_.kind()->currentIndex());
  ASSERT_EQ(told_.size(), 1u);
  EXPECT_EQ(told_[0].target, (Target{Target::Kind::Ratio, 30}));
}

TEST_F(PresetEditorTest, TheWeightingIsThePresetsUntilAnotherIsChosen) {
  QComboBox* const box = editor_.weighting();
  Settings preset = built_in_presets()[1];
  preset.weighting = Weighting::Shell;
  editor_.setPreset(preset);
  EXPECT_EQ(box->currentData().toInt(), static_cast<int>(Weighting::Shell));
  box->setCurrentIndex(box->findData(static_cast<int>(Weighting::Skin)));
  emit box->activated(box->currentIndex());
  ASSERT_EQ(told_.size(), 1u);
  EXPECT_EQ(told_[0].weighting, Weighting::Skin);
  preset.weighting = Weighting::Skin;
  EXPECT_EQ(told_[0], preset);
}

}  // namespace
}  // namespace mocapress
