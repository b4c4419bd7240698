// SPDX-License-Identifier: GPL-3.0-or-later
// The day of a reviewer in the real window, with a picture of each step in the build folder: from a
// folder of clips to a signed-off report and back by its links.
#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QTest>
#include <QTreeView>
#include <algorithm>

#include "app/studio/library/sign_off_export.h"
#include "core/base/base64.h"
#include "core/report/clip_link.h"
#include "tests/qt/studio_at_work.h"
#include "widgets/models/colours.h"
#include "widgets/models/library_tree.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/review_bar.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

using namespace test;

QByteArray contentOfFile(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TEST_F(StudioTour, AReviewerGoesFromAFolderToASignOffAndBackByItsLinks) {
  const QString folder = directory_.filePath(QStringLiteral("walks"));
  constexpr int kWalks = 3;
  writeWalks(folder, kWalks);
  Studio studio;
  Library& library = studio->library();
  library.begin(directory_.filePath(QStringLiteral("data")));
  LibraryPanel& panel = studio->libraryPanel();
  drop(*studio.operator->(), {QUrl::fromLocalFile(folder)});
  ASSERT_TRUE(QTest::qWaitFor([&] { return library.project().clips.size() == kWalks; }, kPatience));
  for (int row = 0; row < kWalks; ++row) studio.settleAfter([&] { library.openClip(row); });

  // The longest first, by a column that is not shown.
  const QList<QAction*> orders = panel.makeColumnMenu()->actions().last()->menu()->actions();
  orders.at(static_cast<int>(LibraryColumn::Length) + 1)->trigger();
  const std::vector<int> sorted = panel.tree()->clipsBelow({});
  EXPECT_EQ(sorted, (std::vector<int>{2, 1, 0}));

  // A note on a joint of the first clip is in the picture, on the timeline and in the list.
  studio.settleAfter([&] { library.openClip(sorted.front()); });
  studio->playback().seek(5);
  const QImage before = studio.picture(QStringLiteral("review-1-first"));
  library.setFrameNote(sorted.front(), -1, {.frame = 5, .joint = "lhand", .text = "hand pops"});
  runDueEvents();
  const QImage noted = studio.picture(QStringLiteral("review-2-noted"));
  const QColor note_colour(kFrameNoteColour);
  for (const QWidget* view : {static_cast<QWidget*>(studio->views().viewport),
                              static_cast<QWidget*>(studio->inspection().timeline)})
    EXPECT_GT(pixelsNear(noted, studio.areaOf(view), note_colour),
              pixelsNear(before, studio.areaOf(view), note_colour))
        << view->metaObject()->className();
  EXPECT_GT(
      differing(before.copy(studio.areaOf(panel.view())), noted.copy(studio.areaOf(panel.view()))),
      10);

  // One key a clip: each verdict opens the next.
  studio.settleAfter([&] { studio->actions().reject->trigger(); });
  EXPECT_EQ(library.currentRow(), sorted[1]);
  studio.settleAfter([&] { studio->actions().approve->trigger(); });
  EXPECT_EQ(library.currentRow(), sorted[2]);
  EXPECT_EQ(library.project().clips[2].review.verdict, Verdict::Rejected);
  EXPECT_EQ(library.project().clips[1].review.verdict, Verdict::Approved);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return panel.reviewed()->progress()->text() ==
               QStringLiteral("2 of 3 reviewed, 1 rejected");
      },
      kPatience))
      << qPrintable(panel.reviewed()->progress()->text());
  studio.picture(QStringLiteral("review-3-judged"));

  const auto* rows = studio->findChild<LibraryModel*>();
  const SignOff report = signOffOf(library, *rows);
  for (const char* kind : {"html", "pdf", "csv"})
    writeSignOff(directory_.filePath(QStringLiteral("sign-off.%1").arg(QLatin1String(kind))),
                 report);
  const QByteArray page = contentOfFile(directory_.filePath(QStringLiteral("sign-off.html")));
  EXPECT_TRUE(page.contains("2 of 3 reviewed: 1 approved, 1 rejected; 1 without a verdict."));
  EXPECT_TRUE(page.contains("hand pops"));
  EXPECT_TRUE(
      contentOfFile(directory_.filePath(QStringLiteral("sign-off.pdf"))).startsWith("%PDF-"));
  EXPECT_EQ(contentOfFile(directory_.filePath(QStringLiteral("sign-off.csv"))).count("\n"),
            kWalks + 1);

  // The note's link leads back to its clip, frame and joint.
  const QString link = QString::fromStdString(link_text(
      {.clip = library.project().clips[2].path.toStdString(), .frame = 5, .joint = "lhand"}));
  studio.settleAfter([&] { studio->open({link}); });
  EXPECT_EQ(library.currentRow(), 2);
  EXPECT_EQ(studio->playback().frame(), 5);
  EXPECT_EQ(library.project().clips.size(), std::size_t{kWalks});
  const QImage again = studio.picture(QStringLiteral("review-4-by-link"));
  EXPECT_GT(coloursIn(again, studio.areaOf(studio->views().viewport)), 500u);
}

TEST_F(StudioTour, TheFileMenuExportsAReviewPageThatPlaysWhatIsSaved) {
  const QString folder = directory_.filePath(QStringLiteral("walks"));
  writeWalks(folder, 1);
  Studio studio;
  Library& library = studio->library();
  library.begin(directory_.filePath(QStringLiteral("data")));
  drop(*studio.operator->(), {QUrl::fromLocalFile(folder)});
  ASSERT_TRUE(QTest::qWaitFor([&] { return library.project().clips.size() == 1; }, kPatience));
  studio.settleAfter([&] { library.openClip(0); });
  library.setFrameNote(0, -1, {.frame = 5, .joint = "lhand", .text = "hand <pops>"});
  library.setVerdict({0}, Verdict::Rejected);

  QAction* action = studio->actions().export_review;
  action->setVisible(true);  // builds without the viewer hide it
  const QList<QMenu*> menus = studio->findChildren<QMenu*>();
  EXPECT_TRUE(std::any_of(menus.begin(), menus.end(), [&](QMenu* menu) {
    return menu->title() == QLatin1String("&File") && menu->actions().contains(action);
  }));
  ASSERT_TRUE(action->isEnabled());
  action->trigger();
  auto* dialog = studio->findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  studio.picture(QStringLiteral("review-page-1-dialog"));
  auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
  ASSERT_TRUE(name);
  QSignalSpy exported(&studio->files(), &ClipFiles::exported);
  name->setText(directory_.filePath(QStringLiteral("page")));
  QTest::keyClick(name, Qt::Key_Return);
  ASSERT_TRUE(exported.count() > 0 || exported.wait(kPatience));
  EXPECT_EQ(exported[0][0].toString(), QStringLiteral("page.html"));
  studio.picture(QStringLiteral("review-page-2-written"));

  const QByteArray page = contentOfFile(directory_.filePath(QStringLiteral("page.html")));
  EXPECT_TRUE(page.contains("<li>rejected"));
  EXPECT_TRUE(page.contains("hand &lt;pops&gt;"));
  EXPECT_FALSE(page.contains("<pops>"));
  const QString clip = directory_.filePath(QStringLiteral("saved.mcpr"));
  QSignalSpy saved(&studio->session(), &Session::saved);
  studio->session().save(clip);
  ASSERT_TRUE(saved.count() > 0 || saved.wait(kPatience));
  const std::string played = base64_of(contentOfFile(clip).toStdString());
  EXPECT_GT(played.size(), 500u);
  EXPECT_TRUE(page.contains('"' + QByteArray::fromStdString(played) + '"'));
}

}  // namespace
}  // namespace mocapress
