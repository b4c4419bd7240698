// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/shared_name.h"

#include <gtest/gtest.h>

#include <QFontMetrics>
#include <QGuiApplication>
#include <QSet>

namespace mocapress {
namespace {

TEST(SharedName, IsWhatAllBeginAndEndWithButForNumbers) {
  const SharedName shared = sharedName({"set-2_walk_active_001.bvh", "set-2_walk_old_102.bvh"});
  EXPECT_EQ(shared.start, 11);
  EXPECT_EQ(shared.end, 4);
  EXPECT_EQ(sharedName({"walk01.bvh", "walk02.bvh"}).start, 4);
  EXPECT_EQ(sharedName({"alone.bvh"}).start, 0);
  const SharedName nested = sharedName({"aa.bvh", "aaa.bvh"});
  EXPECT_LE(nested.start + nested.end, 6);
}

TEST(SharedName, ShortNamesKeepWhatTellsThemApart) {
  const QStringList names = {"dataset-2_walk_active_001.bvh", "dataset-2_walk_active_002.bvh",
                             "dataset-2_run_masculinity_001.bvh", "dataset-2_jump_001.bvh"};
  const SharedName shared = sharedName(names);
  const QFontMetrics metrics{QGuiApplication::font()};
  const int width = metrics.horizontalAdvance(QStringLiteral("…masculinity_001"));
  QSet<QString> seen;
  for (const QString& name : names) {
    const QString text = shortened(name, shared, metrics, width);
    EXPECT_LE(metrics.horizontalAdvance(text), width);
    EXPECT_FALSE(text.contains(QStringLiteral("dataset"))) << qPrintable(text);
    seen.insert(text);
  }
  EXPECT_EQ(seen.size(), 4);
  EXPECT_EQ(shortened(names[0], shared, metrics, 10 * width), names[0]);
}

}  // namespace
}  // namespace mocapress
