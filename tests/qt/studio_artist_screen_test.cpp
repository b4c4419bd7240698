// SPDX-License-Identifier: GPL-3.0-or-later
// Half a day of a technical artist in the real window, with pictures in the build folder: from a
// folder of clips to a batch, and back the next day.
#include <gtest/gtest.h>

#include <QAction>
#include <QHeaderView>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "app/studio/batch/batch_session.h"
#include "app/studio/batch/batch_window.h"
#include "tests/qt/studio_at_work.h"
#include "widgets/models/library_columns.h"
#include "widgets/models/library_tree.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/encoding_bar.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/target_control.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

using namespace test;

TEST_F(StudioTour, AnArtistTunesAClipGivesItsSettingsToOthersAndExportsThem) {
  const QString folder = directory_.filePath(QStringLiteral("walks"));
  const QString data = directory_.filePath(QStringLiteral("data"));
  const QString out = directory_.filePath(QStringLiteral("out"));
  constexpr int kWalks = 4;
  writeWalks(folder, kWalks);
  std::size_t bytes = 0;
  {
    Studio studio;
    Library& library = studio->library();
    Session& session = studio->session();
    LibraryPanel& panel = studio->libraryPanel();
    library.begin(data);
    drop(*studio.operator->(), {QUrl::fromLocalFile(folder)});
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return library.project().clips.size() == kWalks; }, kPatience));
    studio.settleAfter([&] { library.openClip(0); });

    // The target by its slider, the worst frame by its key, and more care about it.
    EncodeSettings options = session.document().options();
    options.target = {Target::Kind::Ratio, 10};  // an engine reaches that of a short clip, too
    studio.settleAfter([&] { session.setOptions(options); });
    studio.settleAfter([&] {
      QTest::keyClick(studio->views().compression->target()->slider(), Qt::Key_PageDown);
    });
    EXPECT_NE(session.document().options().target.value, 10);
    studio->actions().next_worst->trigger();
    const int worst = studio->playback().frame();
    EXPECT_EQ(worst, session.document().decoded()->distortion->max.frame);
    studio.settleAfter([&] {
      session.setRanges({{std::max(worst - 5, 0), std::min(worst + 5, 59), 3}});
    });

    // Beside it stands an engine's way with the same bytes.
    studio->actions().pin_engine->trigger();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return studio->views().viewport->pinned().size() == 1; }, kPatience));
    studio->actions().view.mode[1]->trigger();
    studio->actions().view.front->trigger();
    studio.picture(QStringLiteral("artist-1-engine"));

    // The others get the settings, but not the range, and are compressed in the background.
    library.copySettings(0);
    library.pasteSettings({1, 2, 3});
    EXPECT_TRUE(library.project().clips[3].settings->preset.ranges.empty());
    panel.encoding()->button()->click();
    const auto is_done = [&] {
      for (const ProjectClip& clip : library.project().clips)
        if (!clip.outcome || outdated(clip) != Staleness::None) return false;
      return true;
    };
    ASSERT_TRUE(QTest::qWaitFor(is_done, kPatience));
    bytes = library.project().clips[3].outcome->motion_bytes;
    studio.picture(QStringLiteral("artist-2-all"));

    studio->actions().export_library->trigger();
    BatchSession* batch = studio->findChild<BatchWindow*>()->session();
    ASSERT_TRUE(QTest::qWaitFor([&] { return batch->queue()->rowCount() == kWalks; }, kPatience));
    batch->setSettings({.folder = out});
    batch->start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return batch->state() == BatchSession::State::Complete; },
                                kPatience));
    EXPECT_EQ(batch->counts().failed, 0u);
  }
  // The next day: all is as it was, what an engine would do, too, and nothing changed since.
  Studio studio;
  Library& library = studio->library();
  studio.settleAfter([&] { library.begin(data); });
  EXPECT_EQ(library.project().clips[3].outcome->motion_bytes, bytes);
  EXPECT_EQ(studio->session().document().options().ranges.size(), 1u);
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return studio->views().viewport->pinned().size() == 1; }, kPatience));
  studio.settleAfter([&] { library.setPreset({0, 1}, built_in_presets()[0]); });
  QSignalSpy compared(&library, &Library::compared);
  studio->resize(1560, 900);
  library.compareWith(out);
  ASSERT_TRUE(compared.count() > 0 || compared.wait(kPatience));
  const LibraryModel& rows = studio->work().clips;
  EXPECT_NE(textOf(rows.entry(0), LibraryColumn::Since), QString());
  EXPECT_EQ(textOf(rows.entry(3), LibraryColumn::Since), QString());
  EXPECT_EQ(studio->libraryPanel().tree()->clipsBelow({}).front(), 0);
  runDueEvents();
  const QTreeView& list = *studio->libraryPanel().view();
  EXPECT_LE(list.header()->length(), list.viewport()->width()) << "all columns show";
  EXPECT_GE(list.columnWidth(0), 200) << "and so do the clips";
  studio.picture(QStringLiteral("artist-3-since"));
}

}  // namespace
}  // namespace mocapress
