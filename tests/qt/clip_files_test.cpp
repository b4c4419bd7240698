// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/clip_files.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/studio/document/import_options_dialog.h"
#include "app/studio/document/session.h"
#include "core/base/file.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

class ClipFilesTest : public testing::Test {
 protected:
  ClipFilesTest() {
    QSettings().clear();
    write_motion(clip_.toStdU16String(), test::smooth_motion(150));
  }
  ~ClipFilesTest() override { QSettings().clear(); }

  void openAndSettle() {
    QSignalSpy settled(&session_, &Session::settled);
    files_.open(clip_);
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  }

  /// Changes and saves, so that the file's path is known, then changes again.
  void modify() {
    QSignalSpy saved(&session_, &Session::saved);
    session_.save(compressed_);
    ASSERT_TRUE(saved.count() > 0 || saved.wait(kPatience));
    QSignalSpy settled(&session_, &Session::settled);
    session_.setOptions({.target = {Target::Kind::Ratio, 12}});
    ASSERT_TRUE(settled.wait(kPatience));
    ASSERT_TRUE(session_.document().modified());
  }

  void answer(QMessageBox::StandardButton button) {
    auto* question = window_.findChild<QMessageBox*>();
    ASSERT_TRUE(question);
    question->button(button)->click();
  }

  QTemporaryDir directory_;
  QString clip_ = directory_.filePath(QStringLiteral("motion.bvh"));
  QString compressed_ = directory_.filePath(QStringLiteral("motion.mcpr"));
  QWidget window_;
  Session session_;
  ClipFiles files_{&session_, &window_};
};

using Files = ClipFilesTest;

TEST_F(Files, AsksNothingWhereNothingWouldBeLost) {
  bool left = false;
  openAndSettle();
  files_.leave([&] { left = true; });
  EXPECT_TRUE(left);
  EXPECT_FALSE(window_.findChild<QMessageBox*>());
}

TEST_F(Files, DiscardLeavesAndCancelStays) {
  bool left = false;
  openAndSettle();
  modify();
  files_.leave([&] { left = true; });
  EXPECT_FALSE(left);
  EXPECT_TRUE(window_.findChild<QMessageBox*>()->informativeText().contains("project keeps"));
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(left);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.findChild<QMessageBox*>(); }, kPatience));
  files_.leave([&] { left = true; });
  answer(QMessageBox::Discard);
  EXPECT_TRUE(left);
  EXPECT_TRUE(session_.document().modified());
}

TEST_F(Files, SaveLeavesOnceItIsSaved) {
  bool left = false;
  openAndSettle();
  modify();
  files_.leave([&] { left = true; });
  answer(QMessageBox::Save);
  EXPECT_FALSE(left);
  EXPECT_TRUE(QTest::qWaitFor([&] { return left; }, kPatience));
  EXPECT_FALSE(session_.document().modified());
}

TEST_F(Files, ASaveThatFailsStays) {
  bool left = false;
  openAndSettle();
  modify();
  ASSERT_TRUE(directory_.remove());
  QSignalSpy failed(&session_, &Session::saveFailed);
  files_.leave([&] { left = true; });
  answer(QMessageBox::Save);
  ASSERT_TRUE(failed.wait(kPatience));
  EXPECT_FALSE(left);
}

TEST_F(Files, RemembersWhatWasOpenedAndOpensItFirstNextTime) {
  openAndSettle();
  ASSERT_EQ(recentFiles().size(), 1);
  QMenu menu;
  files_.fillRecentMenu(&menu);
  ASSERT_EQ(menu.actions().size(), 1);
  EXPECT_EQ(menu.actions().front()->text(), QStringLiteral("motion.bvh"));

  Session next;
  ClipFiles files(&next, &window_);
  QSignalSpy opened(&next, &Session::opened);
  files.openFirst();
  ASSERT_TRUE(opened.wait(kPatience));
  EXPECT_EQ(next.document().title(), QStringLiteral("motion.bvh"));
}

TEST_F(Files, MissingFilesAreNotOpenedFirst) {
  openAndSettle();
  ASSERT_TRUE(directory_.remove());
  Session next;
  ClipFiles files(&next, &window_);
  QSignalSpy opened(&next, &Session::opened);
  files.openFirst();
  ASSERT_TRUE(opened.wait(kPatience));
  EXPECT_EQ(next.document().title(), QStringLiteral("human_walk.amc"));
}

TEST_F(Files, OffersASkeletonForAnAmcThatIsThereOnly) {
  QSignalSpy failed(&files_, &ClipFiles::openFailed);
  const auto offers = [&](const QString& name) {
    files_.open(directory_.filePath(name));
    EXPECT_TRUE(failed.wait(kPatience));
    return failed.takeFirst()[1].toBool();
  };
  const QString alone = QStringLiteral("alone.amc");
  write_text(directory_.filePath(alone).toStdU16String(), ":FULLY-SPECIFIED\n");
  EXPECT_TRUE(offers(alone));
  EXPECT_FALSE(offers(QStringLiteral("none.amc")));
  EXPECT_FALSE(offers(QStringLiteral("none.bvh")));
}

/// Accepts the open file dialog with this name and kind.
void choose(QWidget& window, const QString& path, const QString& kind) {
  auto* dialog = window.findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  for (const QString& filter : dialog->nameFilters())
    if (filter.contains(kind)) {
      dialog->selectNameFilter(filter);
      emit dialog->filterSelected(filter);
    }
  dialog->selectFile(path);
  QMetaObject::invokeMethod(dialog, "accept");
}

QStringList kindsOffered(QWidget& window) {
  auto* dialog = window.findChild<QFileDialog*>();
  return dialog ? dialog->nameFilters() : QStringList();
}

TEST_F(Files, SaveAsAndExportOfferEveryFormat) {
  openAndSettle();
  for (const auto ask : {&ClipFiles::saveAs, &ClipFiles::exportMotion}) {
    (files_.*ask)();
    const QString offered = kindsOffered(window_).join(QLatin1Char(' '));
    for (const char* kind : {"*.mcpr", "*.bvh", "*.glb", "*.amc", "*.csv"})
      EXPECT_TRUE(offered.contains(QLatin1String(kind))) << kind;
    delete window_.findChild<QFileDialog*>();
  }
}

TEST_F(Files, ExportsTheMotionInEveryFormat) {
  openAndSettle();
  for (const char* kind : {"bvh", "glb", "amc", "csv"}) {
    const QString path = directory_.filePath(QStringLiteral("out.") + QLatin1String(kind));
    QSignalSpy exported(&files_, &ClipFiles::exported);
    files_.saveAs();
    choose(window_, path, QStringLiteral("*.") + QLatin1String(kind));
    ASSERT_TRUE(exported.count() > 0 || exported.wait(kPatience)) << kind;
    EXPECT_TRUE(QFileInfo::exists(path)) << kind;
    delete window_.findChild<QFileDialog*>();
  }
  EXPECT_TRUE(QFileInfo::exists(directory_.filePath(QStringLiteral("out.asf"))));
  const Motion again =
      read_motion(directory_.filePath(QStringLiteral("out.bvh")).toStdU16String()).motion;
  EXPECT_EQ(again.clip.frames(), 150);
  EXPECT_EQ(session_.document().title(), QStringLiteral("motion.bvh"));
}

TEST_F(Files, ExportsTheCharacterThatTheClipWears) {
  const QString character = QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/character.fbx");
  const QString moved = directory_.filePath(QStringLiteral("moved.fbx"));
  openAndSettle();
  files_.exportMotion();
  EXPECT_FALSE(kindsOffered(window_).last().contains(QStringLiteral("with this motion")));
  delete window_.findChild<QFileDialog*>();
  QSignalSpy settled(&session_, &Session::settled);
  files_.open(character);
  ASSERT_TRUE(settled.wait(kPatience));
  QSignalSpy exported(&files_, &ClipFiles::exported);
  files_.exportMotion();
  choose(window_, moved, QStringLiteral("character.fbx with this motion"));
  ASSERT_TRUE(exported.count() > 0 || exported.wait(kPatience));
  const MotionFile written = read_motion(moved.toStdU16String());
  EXPECT_NE(written.skin, nullptr);
  EXPECT_EQ(written.motion.clip.frames(), session_.document().frames());
}

TEST_F(Files, AsksBeforeTheCharacterIsReplaced) {
  const QString character = directory_.filePath(QStringLiteral("character.fbx"));
  ASSERT_TRUE(QFile::copy(QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/character.fbx"),
                          character));
  const QString walk = directory_.filePath(QStringLiteral("walk.bvh"));
  write_motion(walk.toStdU16String(), read_motion(character.toStdU16String()).motion);
  QSignalSpy settled(&session_, &Session::settled);
  files_.open(walk);
  ASSERT_TRUE(settled.wait(kPatience));
  QSignalSpy put(&session_, &Session::characterPut);
  session_.putCharacter(character);
  ASSERT_TRUE(put.count() > 0 || put.wait(kPatience));
  const std::string before = read_text(character.toStdU16String());
  files_.exportMotion();
  auto* dialog = window_.findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  dialog->selectNameFilter(kindsOffered(window_).last());
  emit dialog->fileSelected(character);  // past the dialog's own question
  answer(QMessageBox::No);
  EXPECT_EQ(read_text(character.toStdU16String()), before);
}

TEST_F(Files, ExportsAReviewPageWithTheRemarksOnItsClip) {
  openAndSettle();
  files_.setRemarks([this](const QString& path) {
    EXPECT_EQ(path, session_.document().original()->path);
    return ReviewRemarks{.texts = {"approved by ana"}, .notes = {}};
  });
  QSignalSpy exported(&files_, &ClipFiles::exported);
  files_.exportReview();
  const QString page = directory_.filePath(QStringLiteral("page.html"));
  choose(window_, page, QStringLiteral("*.html"));
  ASSERT_TRUE(exported.count() > 0 || exported.wait(kPatience));
  EXPECT_NE(read_text(page.toStdU16String()).find("<li>approved by ana</li>"), std::string::npos);
}

TEST_F(Files, APageOfAClipWithoutItsOriginalIsRefusedInWords) {
  openAndSettle();
  modify();
  Session session;
  ClipFiles files(&session, &window_);
  QSignalSpy opened(&session, &Session::opened);
  files.open(compressed_);
  ASSERT_TRUE(opened.count() > 0 || opened.wait(kPatience));
  ASSERT_FALSE(session.document().original());
  QSignalSpy failed(&session, &Session::saveFailed);
  files.exportMotion();
  const QString page = directory_.filePath(QStringLiteral("page.html"));
  emit window_.findChild<QFileDialog*>()->fileSelected(page);  // a name that was typed
  ASSERT_TRUE(failed.count() > 0 || failed.wait(kPatience));
  EXPECT_TRUE(failed[0][0].toString().contains(
      QStringLiteral("page.html: cannot be written: its extension is none of")))
      << qPrintable(failed[0][0].toString());
  EXPECT_FALSE(QFileInfo::exists(page));
}

TEST_F(Files, AsksBeforeASkeletonIsReplaced) {
  openAndSettle();
  const QString skeleton = directory_.filePath(QStringLiteral("mine.asf"));
  write_text(skeleton.toStdU16String(), "mine");
  QSignalSpy exported(&files_, &ClipFiles::exported);
  files_.exportMotion();
  choose(window_, directory_.filePath(QStringLiteral("mine.amc")), QStringLiteral("*.amc"));
  answer(QMessageBox::No);
  EXPECT_EQ(read_text(skeleton.toStdU16String()), "mine");
  delete window_.findChild<QMessageBox*>();
  delete window_.findChild<QFileDialog*>();
  files_.exportMotion();
  choose(window_, directory_.filePath(QStringLiteral("mine.amc")), QStringLiteral("*.amc"));
  answer(QMessageBox::Yes);
  ASSERT_TRUE(exported.count() > 0 || exported.wait(kPatience));
  EXPECT_NE(read_text(skeleton.toStdU16String()), "mine");
}

TEST_F(Files, TheOriginalIsNotReplacedByItsCompressedMotionUnasked) {
  openAndSettle();
  const QString original = session_.document().original()->path;
  const std::string before = read_text(original.toStdU16String());
  QSignalSpy exported(&files_, &ClipFiles::exported);
  files_.exportMotion();
  auto* dialog = window_.findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_NE(dialog->selectedFiles().value(0), original);
  emit dialog->fileSelected(original);  // skips the dialog's own question
  answer(QMessageBox::No);
  EXPECT_EQ(exported.count(), 0);
  EXPECT_EQ(read_text(original.toStdU16String()), before);
}

TEST_F(Files, ReadsTheClipAgainByTheImportOptionsChosen) {
  openAndSettle();
  files_.chooseImportOptions();
  auto* dialog = window_.findChild<ImportOptionsDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_EQ(dialog->options(), ReadOptions());
  dialog->setOptions({.sample_rate_hz = 60.0, .cm_per_unit = 2.54});
  QSignalSpy settled(&session_, &Session::settled);
  dialog->accept();
  ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  EXPECT_EQ(session_.document().sampleRate(), 60);
  EXPECT_EQ(session_.document().source().cm_per_unit, 2.54);
}

}  // namespace
}  // namespace mocapress
