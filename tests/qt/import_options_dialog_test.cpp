// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/import_options_dialog.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

#include "app/jobs/clips.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

OriginalClip clipOf(SourceFormat::Kind kind, const ReadOptions& reading = {}) {
  OriginalClip clip;
  clip.path = QStringLiteral("/motions/walk");
  clip.reading = reading;
  clip.source = {.kind = kind, .cm_per_unit = 2.54, .root = TranslationConvention::Replaces};
  clip.encoder = std::make_shared<const Encoder>(test::smooth_motion(5));
  return clip;
}

TEST(ImportOptions, BeginWithWhatTheClipWasReadBy) {
  for (const ReadOptions& reading :
       {ReadOptions(), ReadOptions{.sample_rate_hz = 30.0, .cm_per_unit = 2.54 / 0.45},
        ReadOptions{.sample_rate_hz = 59.94,
        .cm_per_unit = 7.25,
        .up = UpAxis::Z,
        .bvh_root = TranslationConvention::Adds}})
    EXPECT_EQ(ImportOptionsDialog(clipOf(SourceFormat::Kind::Bvh, reading)).options(), reading);
}

TEST(ImportOptions, GoBackToWhatTheFileSays) {
  ImportOptionsDialog dialog(
      clipOf(SourceFormat::Kind::Bvh, {.cm_per_unit = 100.0, .up = UpAxis::Z}));
  dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
  EXPECT_EQ(dialog.options(), ReadOptions());
}

TEST(ImportOptions, TakeANumberOfOnesOwn) {
  ImportOptionsDialog dialog(clipOf(SourceFormat::Kind::Bvh));
  auto* unit = dialog.findChildren<QComboBox*>().front();
  auto* field = dialog.findChildren<QDoubleSpinBox*>().front();
  EXPECT_FALSE(field->isEnabled());
  unit->setCurrentIndex(unit->count() - 1);
  EXPECT_TRUE(field->isEnabled());
  EXPECT_EQ(dialog.options().cm_per_unit, 2.54);  // as the clip was read
  field->setValue(3);
  EXPECT_EQ(dialog.options().cm_per_unit, 3);
}

TEST(ImportOptions, SayWhatTheClipWasReadAs) {
  const ImportOptionsDialog dialog(clipOf(SourceFormat::Kind::Bvh));
  QString texts;
  for (const QLabel* label : dialog.findChildren<QLabel*>()) texts += label->text();
  EXPECT_TRUE(texts.contains(QStringLiteral("2.54"))) << qPrintable(texts);
  EXPECT_TRUE(texts.contains(QStringLiteral("replaces"))) << qPrintable(texts);
}

TEST(ImportOptions, NameTheDefaultRateOfAFileThatStatesNone) {
  OriginalClip clip = clipOf(SourceFormat::Kind::Acclaim);
  const auto rates = [&clip] {
    QStringList first;
    const ImportOptionsDialog dialog(clip);
    for (const QComboBox* chooser : dialog.findChildren<QComboBox*>())
      first << chooser->itemText(0);
    return first;
  };
  EXPECT_TRUE(rates().contains(QStringLiteral("As in the file")));
  clip.states_rate = false;
  EXPECT_FALSE(rates().contains(QStringLiteral("As in the file")));
  EXPECT_TRUE(rates().contains(QStringLiteral("120 Hz, CMU's: the file does not say")));
}

TEST(ImportOptions, AskOfTheRootOfABvhAlone) {
  for (const auto kind : {SourceFormat::Kind::Bvh, SourceFormat::Kind::Acclaim}) {
    const ImportOptionsDialog dialog(clipOf(kind));
    const auto choosers = dialog.findChildren<QComboBox*>();
    const bool hidden = std::any_of(choosers.begin(), choosers.end(),
                                    [](const QComboBox* one) { return one->isHidden(); });
    EXPECT_EQ(hidden, kind == SourceFormat::Kind::Acclaim);
  }
}

}  // namespace
}  // namespace mocapress
