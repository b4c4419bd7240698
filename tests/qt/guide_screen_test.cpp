// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of the guide. resources/guide/make_pictures makes those of all languages.
#include <gtest/gtest.h>

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QImage>
#include <QTest>

#include "app/studio/document/clip_files.h"
#include "tests/qt/patience.h"
#include "tests/qt/studio_at_work.h"
#include "widgets/plots/heat_map.h"
#include "widgets/plots/rate_plot.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

using namespace test;

constexpr int kPanelHeight = 260;              // as if drawn higher: the plots are read
constexpr std::size_t kCurvePoints = 12;       // on all curves together: they have shapes
constexpr int kCurvePatience = 5 * kPatience;  // many encodings, while nothing else is to be done

TEST_F(StudioTour, DoesWhatTheGuideTells) {
  Studio studio;
  const ViewActions& view = studio->actions().view;
  const auto aim = [&](double ratio) {
    EncodeSettings options = studio->session().document().options();
    options.target = {Target::Kind::Ratio, ratio};
    studio.settleAfter([&] { studio->session().setOptions(options); });
  };
  const auto raise = [&](const char* id) {
    auto* const dock = studio->findChild<QDockWidget*>(QString::fromLatin1(id));
    dock->raise();
    studio->resizeDocks({dock}, {kPanelHeight}, Qt::Vertical);
  };
  studio.open(sampleClip());
  aim(200);
  studio->actions().next_worst->trigger();
  view.mode[2]->trigger();
  raise("error-over-time");
  const QImage compared = studio.picture(QStringLiteral("guide-compare"));
  EXPECT_GT(coloursIn(compared, studio.areaOf(studio->views().viewport)), 500u);

  view.mode[0]->trigger();
  view.by_error->trigger();
  raise("heat-map");
  const QImage inspected = studio.picture(QStringLiteral("guide-inspect"));
  EXPECT_GT(coloursIn(inspected, studio.areaOf(studio->inspection().heat_map)), 60u);

  view.by_error->trigger();
  raise("rate-distortion");
  const auto* const plot = studio->findChild<RatePlot*>();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        std::size_t points = 0;
        for (const RateCurve& curve : plot->curves()) points += curve.points.size();
        return points >= kCurvePoints;
      },
      kCurvePatience));
  const QImage curve = studio.picture(QStringLiteral("guide-curve"));
  EXPECT_GT(differing(inspected, curve), 2000);

  raise("pinned");
  for (const double ratio : {100, 400}) {
    aim(ratio);
    studio->actions().pin->trigger();
  }
  aim(200);
  view.mode[1]->trigger();
  const QImage pinned = studio.picture(QStringLiteral("guide-pinned"));
  for (const PinnedFigure& one : studio->views().viewport->pinned())
    EXPECT_GT(pixelsNear(pinned, studio.areaOf(studio->views().viewport), one.colour), 30);
}

}  // namespace
}  // namespace mocapress
