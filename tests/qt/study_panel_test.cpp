// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/study_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDropEvent>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "core/codec/methods/compression_method.h"

namespace mocapress {
namespace {

class StudyPanelTest : public testing::Test {
 protected:
  StudyPanelTest() {
    QObject::connect(&panel_, &StudyPanel::settingsChanged,
                     [this](const StudySettings& settings) { told_.push_back(settings); });
    panel_.setSettings(usualStudySettings());
  }

  QListWidgetItem* method(const char* name) {
    for (int i = 0; i < panel_.methods()->count(); ++i) {
      QListWidgetItem* item = panel_.methods()->item(i);
      if (item->data(Qt::UserRole).toString() == QLatin1String(name)) return item;
    }
    return nullptr;
  }

  StudyPanel panel_;
  std::vector<StudySettings> told_;
};

TEST_F(StudyPanelTest, OffersEveryMethodWithItsNote) {
  EXPECT_TRUE(told_.empty()) << "only of what the user does";
  ASSERT_EQ(panel_.methods()->count(), static_cast<int>(compression_methods().size()));
  for (const CompressionMethod& compression_method : compression_methods()) {
    const QListWidgetItem* item = method(std::string(compression_method.name).c_str());
    ASSERT_TRUE(item);
    EXPECT_GT(item->toolTip().size(), static_cast<qsizetype>(compression_method.note.size()));
  }
}

TEST_F(StudyPanelTest, TellsOfMethodsInTheOrderTheyStand) {
  method("linear")->setCheckState(Qt::Checked);
  ASSERT_EQ(told_.size(), 1u);
  method("pca")->setCheckState(Qt::Unchecked);
  const QStringList wanted = {QStringLiteral("annealed"),    QStringLiteral("standard"),
                              QStringLiteral("haar"),        QStringLiteral("linear"),
                              QStringLiteral("closed-loop"), QStringLiteral("subsample")};
  EXPECT_EQ(told_.back().methods, wanted);
}

TEST_F(StudyPanelTest, FeetAreHeldWhereAskedFor) {
  auto* hold = panel_.findChild<QCheckBox*>();
  hold->click();
  EXPECT_EQ(told_.back().ik_ratio, 16.0);
  hold->click();
  EXPECT_FALSE(told_.back().ik_ratio);
}

TEST_F(StudyPanelTest, TheButtonRunsOrCancels) {
  QSignalSpy run(&panel_, &StudyPanel::runRequested);
  QSignalSpy cancel(&panel_, &StudyPanel::cancelRequested);
  panel_.runButton()->click();
  EXPECT_EQ(run.count(), 0) << "there is nothing to run";
  panel_.setRunning(false, true);
  panel_.runButton()->click();
  EXPECT_EQ(run.count(), 1);
  panel_.setRunning(true, true);
  panel_.runButton()->click();
  EXPECT_EQ(run.count(), 1);
  EXPECT_EQ(cancel.count(), 1);
}

TEST(StudyClips, TakesWhatIsDroppedOnItAndRemovesWhatIsSelected) {
  StudyClips clips;
  clips.setClips({QStringLiteral("/a/one.bvh"), QStringLiteral("/a/two.bvh")});
  clips.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&clips));
  QSignalSpy dropped(&clips, &StudyClips::dropped);
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QStringLiteral("/b")),
                QUrl(QStringLiteral("https://example.org/walk.bvh"))});
  QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&clips, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&clips, &drop);
  ASSERT_EQ(dropped.count(), 1);
  EXPECT_EQ(dropped[0][0].toStringList(), QStringList{QStringLiteral("/b")});

  QSignalSpy removed(&clips, &StudyClips::removeRequested);
  auto* list = clips.findChild<QListWidget*>();
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Delete);
  EXPECT_EQ(removed.count(), 0);
  list->item(1)->setSelected(true);
  QTest::keyClick(list, Qt::Key_Delete);
  ASSERT_EQ(removed.count(), 1);
  EXPECT_EQ(removed[0][0].toStringList(), QStringList{QStringLiteral("/a/two.bvh")});
}

}  // namespace
}  // namespace mocapress
