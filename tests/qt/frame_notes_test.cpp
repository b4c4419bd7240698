// SPDX-License-Identifier: GPL-3.0-or-later
// Notes on frames, and the queue of clips that wait for a verdict.
#include "app/studio/library/frame_notes.h"

#include <gtest/gtest.h>

#include <QInputDialog>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/base/file.h"
#include "core/formats/motion_file.h"
#include "core/report/notes_file.h"
#include "tests/qt/patience.h"
#include "tests/qt/pixel_colour.h"
#include "tests/support/test_motion.h"
#include "widgets/models/colours.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/review_bar.h"
#include "widgets/timeline/note_strip.h"
#include "widgets/timeline/playback.h"

namespace mocapress {
namespace {

class NotesOnAClip : public testing::Test {
 protected:
  NotesOnAClip() {
    const QString path = directory_.filePath(QStringLiteral("clip.bvh"));
    write_motion(path.toStdU16String(), test::smooth_motion(120));
    QSignalSpy settled(&session_, &Session::settled);
    session_.open(path);
    EXPECT_TRUE(settled.count() > 0 || settled.wait(kPatience));
    playback_.setClip(120, 30);
    strip_.setFrames(120);
    strip_.resize(400, strip_.sizeHint().height());
  }

  void add(int frame, const std::string& joint, const std::string& text) {
    library_.setFrameNote(0, -1, {.frame = frame, .joint = joint, .text = text});
  }

  QTemporaryDir directory_;
  Session session_;
  LibraryModel model_;
  Library library_{&session_, &model_};
  Playback playback_;
  QWidget window_;
  NoteStrip strip_;
  FrameNotes notes_{&session_, &library_, &playback_, &strip_, &window_};
};

TEST_F(NotesOnAClip, AreInTheOrderOfFramesWithWhoAndWhen) {
  add(70, "lhand", "slides");
  add(10, "", "pops");
  const std::vector<FrameNote> notes = library_.frameNotes(0);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[0].text, "pops");
  EXPECT_EQ(notes[1].joint, "lhand");
  EXPECT_FALSE(notes[1].time.empty());
  EXPECT_TRUE(library_.frameNotes(-1).empty());
}

TEST_F(NotesOnAClip, AreStepsAndOutliveAVerdict) {
  add(10, "", "pops");
  library_.setFrameNote(0, 0, {.frame = 10, .text = "pops a little"});
  EXPECT_EQ(library_.frameNotes(0).front().text, "pops a little");
  library_.setVerdict({0}, Verdict::Rejected);
  EXPECT_EQ(library_.frameNotes(0).size(), 1u);
  library_.setFrameNote(0, 0, {});
  EXPECT_TRUE(library_.frameNotes(0).empty());
  library_.history()->undo();
  library_.history()->undo();
  library_.history()->undo();
  EXPECT_EQ(library_.frameNotes(0).front().text, "pops");
}

TEST_F(NotesOnAClip, ANoteIsWrittenWhereItStandsOnceTheDialogCloses) {
  add(70, "", "slides");
  emit strip_.editRequested(0);
  auto* dialog = window_.findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  add(10, "", "pops");  // comes first now
  dialog->setTextValue(QStringLiteral("slides a little"));
  dialog->accept();
  const std::vector<FrameNote> notes = library_.frameNotes(0);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[0].text, "pops");
  EXPECT_EQ(notes[1].text, "slides a little");
}

TEST_F(NotesOnAClip, AMarkGoesToItsFrameAndJoint) {
  EXPECT_TRUE(strip_.isHidden());
  add(60, "lhand", "slides");
  EXPECT_FALSE(strip_.isHidden());
  const TimeAxis axis{2.0 * kStripMargin, 400.0 - kStripMargin, 120};
  QTest::mouseClick(&strip_, Qt::LeftButton, {},
                    {static_cast<int>(axis.xOf(60.5)), strip_.height() / 2});
  EXPECT_EQ(playback_.frame(), 60);
  EXPECT_EQ(session_.document().currentJoint(), session_.document().skeleton()->find("lhand"));
}

TEST_F(NotesOnAClip, TheNextOneFollowsTheFrameThatIsShown) {
  add(10, "", "a");
  add(60, "", "b");
  for (const int frame : {10, 60, 10}) {
    notes_.showNext();
    EXPECT_EQ(playback_.frame(), frame);
  }
}

TEST_F(NotesOnAClip, ANoteOnTheRangeKeepsItAndBringsItBack) {
  notes_.addOnRange();
  EXPECT_EQ(window_.findChild<QInputDialog*>(), nullptr) << "no range is chosen";
  playback_.setRange(std::pair(20, 50));
  notes_.addOnRange();
  auto* dialog = window_.findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->labelText(), QStringLiteral("Frames 21–51"));
  dialog->setTextValue(QStringLiteral("slides"));
  dialog->accept();
  const FrameNote note = library_.frameNotes(0).front();
  EXPECT_EQ(note.frame, 20);
  EXPECT_EQ(note.last_frame, 50);

  const QImage picture = strip_.grab().toImage();
  const TimeAxis axis{2.0 * kStripMargin, 400.0 - kStripMargin, 120};
  const auto is_marked = [&](int frame) {
    const int x = static_cast<int>(axis.xOf(frame + 0.5));
    return difference(picture.pixel(x, picture.height() - 2), kFrameNoteColour) < 12;
  };
  EXPECT_TRUE(is_marked(22));
  EXPECT_TRUE(is_marked(50));
  EXPECT_FALSE(is_marked(18));
  EXPECT_FALSE(is_marked(53));

  playback_.setRange(std::nullopt);
  playback_.seek(0);
  notes_.showNext();
  EXPECT_EQ(playback_.range(), std::optional(std::pair(20, 50)));
  EXPECT_EQ(playback_.frame(), 20);
}

TEST_F(NotesOnAClip, AMarkOnTheFirstAndLastFrameIsWhole) {
  strip_.setFrames(60);
  strip_.setNotes({{0, {}, {}}, {59, {}, {}}});
  const QImage picture = strip_.grab().toImage();
  const TimeAxis axis{2.0 * kStripMargin, 400.0 - kStripMargin, 60};
  for (const int frame : {0, 59}) {
    const int middle = static_cast<int>(axis.xOf(frame + 0.5));
    for (const int x : {middle - 3, middle + 3})
      EXPECT_LT(difference(picture.pixel(x, picture.height() / 2), kFrameNoteColour), 12)
          << frame << ' ' << x;
  }
}

TEST_F(NotesOnAClip, IsStaleOnceItsSettingsHaveChanged) {
  add(10, "lhand", "slides");
  const ProjectClip& clip = library_.project().clips.front();
  EXPECT_FALSE(staleNote(clip, clip.review.notes.front()));
  EncodeSettings finer = session_.document().options();
  finer.target.value /= 2;
  QSignalSpy settled(&session_, &Session::settled);
  session_.setOptions(finer);
  EXPECT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  EXPECT_EQ(staleNote(clip, clip.review.notes.front()), "the settings changed");
  EXPECT_NE(library_.remarksOn(clip.key()).notes.front().text.find("stale: the settings changed"),
            std::string::npos);
}

TEST_F(NotesOnAClip, TravelBesideTheClipAndKeepOtherPeoples) {
  const QString path = session_.document().original()->path;
  const FrameNote of_ann{.frame = 3, .text = "pops", .reviewer = "ann of another room"};
  write_notes(path.toStdU16String(), {{"", {of_ann}}});
  add(10, "lhand", "slides");
  QSignalSpy noted(&library_, &Library::noted);
  library_.writeNotes();
  ASSERT_TRUE(noted.wait(kPatience));
  EXPECT_EQ(read_notes(path.toStdU16String()).at("").size(), 2u);
  EXPECT_EQ(library_.frameNotes(0).size(), 1u);
  library_.readNotes();
  ASSERT_TRUE(noted.wait(kPatience));
  EXPECT_EQ(library_.frameNotes(0).front(), of_ann);
  library_.history()->undo();
  EXPECT_EQ(library_.frameNotes(0).size(), 1u);

  LibraryModel rows;
  Session session;
  Library other(&session, &rows);
  other.add({path});
  EXPECT_TRUE(QTest::qWaitFor([&] { return other.frameNotes(0).size() == 2; }, kPatience));
}

TEST_F(NotesOnAClip, AreReadThoughTheFileBesideAnotherClipIsDamaged) {
  const QString path = session_.document().original()->path;
  const QString other = directory_.filePath(QStringLiteral("a.bvh"));
  write_motion(other.toStdU16String(), test::smooth_motion(20));
  write_text(directory_.filePath(QStringLiteral("a.notes.json")).toStdU16String(), "{");
  write_notes(path.toStdU16String(), {{"", {{.frame = 3, .text = "pops", .reviewer = "ann"}}}});
  library_.add({other});
  QSignalSpy failed(&library_, &Library::failed);
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() > 0; }, kPatience));
  library_.readNotes();
  EXPECT_TRUE(QTest::qWaitFor([&] { return failed.count() == 2; }, kPatience));
  EXPECT_EQ(library_.frameNotes(0).size(), 1u);
}

TEST_F(NotesOnAClip, ANoteThatWasDeletedLeavesTheFileBesideTheClip) {
  const QString path = session_.document().original()->path;
  add(10, "lhand", "slides");
  QSignalSpy noted(&library_, &Library::noted);
  library_.writeNotes();
  ASSERT_TRUE(noted.wait(kPatience));
  EXPECT_EQ(read_notes(path.toStdU16String()).at("").size(), 1u);
  library_.setFrameNote(0, 0, {});
  ASSERT_TRUE(library_.frameNotes(0).empty());
  library_.writeNotes();
  ASSERT_TRUE(noted.wait(kPatience));
  EXPECT_TRUE(read_notes(path.toStdU16String()).empty());
  library_.readNotes();
  ASSERT_TRUE(noted.wait(kPatience));
  EXPECT_TRUE(library_.frameNotes(0).empty());
}

TEST_F(NotesOnAClip, NotesThatTheLibraryNeverHadStayInTheFile) {
  const QString path = session_.document().original()->path;
  add(10, "lhand", "slides");
  FrameNote own = library_.frameNotes(0).front();
  library_.setFrameNote(0, 0, {});
  write_notes(path.toStdU16String(), {{"", {own}}});  // on another computer
  QSignalSpy noted(&library_, &Library::noted);
  library_.writeNotes();
  ASSERT_TRUE(noted.count() > 0 || noted.wait(kPatience));
  EXPECT_EQ(read_notes(path.toStdU16String()).at("").size(), 1u);
}

std::vector<LibraryEntry> fourClips() {
  std::vector<LibraryEntry> clips;
  for (const char* name : {"a", "b", "c", "d"})
    clips.push_back(
        {.path = QStringLiteral("/clips/%1.bvh").arg(QLatin1String(name)), .frames = 9});
  clips[0].review.verdict = Verdict::Approved;
  clips[1].review.verdict = Verdict::Rejected;
  clips[1].stale = Staleness::Settings;
  return clips;
}

TEST(ReviewQueue, GoesOnToWhatWaitsForAVerdict) {
  LibraryModel model;
  LibraryPanel panel(&model);
  std::vector<LibraryEntry> clips = fourClips();
  model.setEntries(clips);
  panel.setCurrent(0);
  EXPECT_EQ(panel.nextToReview(), 1) << "its verdict is stale";
  panel.setCurrent(3);
  EXPECT_EQ(panel.nextToReview(), 1) << "from the last to the first";
  clips[2].missing = true;
  clips[1].stale = Staleness::None;
  model.setEntries(clips);
  panel.setCurrent(3);
  EXPECT_EQ(panel.nextToReview(), -1) << "no other waits";
}

TEST(ReviewQueue, TellsHowManyAreReviewed) {
  LibraryModel model;
  ReviewBar bar(&model);
  EXPECT_TRUE(bar.isHidden());
  std::vector<LibraryEntry> clips = fourClips();
  clips[1].stale = Staleness::None;
  clips[2].missing = true;  // nobody has reviewed it, though it does not wait
  LibraryEntry unreadable{.path = QStringLiteral("/a/character.fbx")};
  unreadable.trouble = QStringLiteral("holds no animation");
  EXPECT_FALSE(wantsReview(unreadable));
  clips.push_back(unreadable);
  model.setEntries(clips);
  bar.resize(400, 30);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return bar.progress()->text() == QStringLiteral("2 of 4 reviewed, 1 rejected"); },
      kPatience))
      << qPrintable(bar.progress()->text());
  bar.resize(150, 30);
  EXPECT_EQ(bar.progress()->text(), QStringLiteral("2 of 4 reviewed"));
  EXPECT_EQ(bar.progress()->toolTip(), QStringLiteral("2 of 4 reviewed, 1 rejected"));
  QSignalSpy asked(&bar, &ReviewBar::nextRequested);
  bar.next()->click();
  EXPECT_EQ(asked.count(), 1);
}

}  // namespace
}  // namespace mocapress
