// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/slot_control.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QToolButton>

namespace mocapress {
namespace {

TEST(SlotControl, AsksToSwitchOnlyForTheOther) {
  SlotControl control;
  control.setSlots(0, {QStringLiteral("25 : 1"), QString()});
  QSignalSpy asked(&control, &SlotControl::switchRequested);
  control.slot(0)->click();
  EXPECT_EQ(asked.count(), 0);
  EXPECT_TRUE(control.slot(0)->isChecked());
  control.slot(1)->click();
  EXPECT_EQ(asked.count(), 1);
  EXPECT_TRUE(control.slot(0)->isChecked());  // keeps its state until setSlots()
  control.setSlots(1, {});
  EXPECT_TRUE(control.slot(1)->isChecked());
  EXPECT_FALSE(control.slot(0)->isChecked());
}

}  // namespace
}  // namespace mocapress
