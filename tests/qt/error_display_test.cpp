// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/error_display.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QSettings>

namespace mocapress {
namespace {

TEST(ErrorDisplay, TheScaleFitsWhatIsShownUntilAnotherIsChosen) {
  QSettings().remove(QStringLiteral("view"));
  auto decoded = std::make_shared<DecodedClip>();
  decoded->distortion.emplace();
  decoded->distortion->p99 = 0.3;
  decoded->distortion->p99_degrees = 7;
  const ErrorDisplay first;
  EXPECT_DOUBLE_EQ(first.scales(ErrorQuantity::Distance)->scaleFor(decoded).top, 0.5);
  EXPECT_DOUBLE_EQ(first.scales(ErrorQuantity::Angle)->scaleFor(decoded).top, 10);
  first.scales(ErrorQuantity::Distance)->actions().at(2)->trigger();
  EXPECT_DOUBLE_EQ(first.scales(ErrorQuantity::Distance)->scaleFor(decoded).top, 1);
  const ErrorDisplay next;
  EXPECT_DOUBLE_EQ(next.scales(ErrorQuantity::Distance)->scaleFor(decoded).top, 1);
  QSettings().remove(QStringLiteral("view"));
}

}  // namespace
}  // namespace mocapress
