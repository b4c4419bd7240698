// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/range_actions.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "app/studio/compare/figures.h"
#include "app/studio/document/session.h"
#include "core/formats/motion_file.h"
#include "resources/samples/generator/samples.h"
#include "tests/qt/patience.h"
#include "widgets/timeline/playback.h"

namespace mocapress {
namespace {

class RangeActionsOnAWalk : public testing::Test {
 protected:
  RangeActionsOnAWalk() {
    const QString path = directory_.filePath(QStringLiteral("walk.bvh"));
    write_motion(path.toStdU16String(), samples::walk_clip());
    QSignalSpy settled(&session_, &Session::settled);
    session_.open(path);
    EXPECT_TRUE(settled.count() > 0 || settled.wait(kPatience));
    playback_.setClip(session_.document().frames(), session_.document().sampleRate());
  }

  /// The entries that a menu has once it is opened.
  static QList<QAction*> entriesOf(QMenu* menu) {
    emit menu->aboutToShow();
    return menu->actions();
  }

  const EncodeSettings& options() { return session_.document().options(); }

  QTemporaryDir directory_;
  Session session_;
  Playback playback_;
  RangeActions actions_{&session_, &playback_};
};

TEST_F(RangeActionsOnAWalk, WorkOnceARangeIsChosen) {
  EXPECT_FALSE(actions_.care()->isEnabled());
  EXPECT_FALSE(actions_.contacts()->isEnabled());
  EXPECT_TRUE(actions_.care()->menuAction()->toolTip().contains(QLatin1String("choose a range")));
  EXPECT_TRUE(actions_.loop()->isEnabled());
  playback_.setRange(std::pair(10, 30));
  EXPECT_TRUE(actions_.care()->isEnabled());
  EXPECT_TRUE(actions_.contacts()->isEnabled());
  EXPECT_EQ(actions_.care()->menuAction()->toolTip(), QStringLiteral("More Care in the Range"));
}

TEST_F(RangeActionsOnAWalk, GiveTheRangeAFactorAndShowWhichItHas) {
  playback_.setRange(std::pair(10, 30));
  entriesOf(actions_.care())[2]->trigger();
  EXPECT_EQ(options().ranges, (std::vector<ImportantRange>{{10, 30, 3}}));
  EXPECT_TRUE(entriesOf(actions_.care())[2]->isChecked());
  EXPECT_EQ(session_.history()->undoText(), QStringLiteral("Care in a Range"));
  entriesOf(actions_.care())[0]->trigger();
  EXPECT_TRUE(options().ranges.empty());
}

TEST_F(RangeActionsOnAWalk, SayThatTheRestGetsWorseIfTheTargetIsASize) {
  playback_.setRange(std::pair(10, 30));
  EncodeSettings settings = options();
  settings.target = {Target::Kind::Error, 0.5};
  session_.setOptions(settings);
  const auto errors = entriesOf(actions_.care()).size();
  settings.target = {Target::Kind::Ratio, 20};
  session_.setOptions(settings);
  const QList<QAction*> entries = entriesOf(actions_.care());
  EXPECT_GT(entries.size(), errors);
  EXPECT_TRUE(entries.back()->text().contains(QStringLiteral("get worse")));
  EXPECT_FALSE(entries.back()->isEnabled());
}

TEST_F(RangeActionsOnAWalk, LetAFootStandOrLiftIt) {
  playback_.setRange(std::pair(10, 30));
  const std::size_t found = session_.document().contacts().size();
  ASSERT_GT(found, 0u);
  const int foot = session_.document().contacts().front().landmark;
  const auto stands = [&] {
    for (const ContactSpan& span : session_.document().contacts())
      if (span.landmark == foot && span.first_frame <= 10 && span.last_frame >= 30) return true;
    return false;
  };
  entriesOf(actions_.contacts())[0]->trigger();
  EXPECT_TRUE(stands());
  entriesOf(actions_.contacts())[1]->trigger();
  EXPECT_FALSE(stands());
  for (const ContactSpan& span : session_.document().contacts())
    EXPECT_TRUE(span.landmark != foot || span.last_frame < 10 || span.first_frame > 30);
}

TEST_F(RangeActionsOnAWalk, SayWhetherTheClipIsALoop) {
  entriesOf(actions_.loop())[1]->trigger();
  EXPECT_EQ(options().loop, Loop::None);
  EXPECT_TRUE(entriesOf(actions_.loop())[1]->isChecked());
  entriesOf(actions_.loop())[0]->trigger();
  EXPECT_FALSE(options().loop);
  for (const bool is_loop : {true, false}) {
    QSignalSpy settled(&session_, &Session::settled);
    session_.setLoop(is_loop ? Loop::Follows : Loop::None);
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
    EXPECT_EQ(stateOf(session_.document()).endsWith(QStringLiteral("as a loop")), is_loop);
  }
}

}  // namespace
}  // namespace mocapress
