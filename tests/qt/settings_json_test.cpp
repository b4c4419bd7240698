// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/settings_json.h"

#include <gtest/gtest.h>

#include "app/jobs/settings_key.h"
#include "core/base/error.h"
#include "tests/qt/elaborate_settings.h"

namespace mocapress {
namespace {

using test::elaborate;

TEST(SettingsJson, BringsEverySettingBack) {
  for (const ClipSettings& settings : {ClipSettings(), elaborate()}) {
    const ClipSettings back = settingsFrom(toJson(settings));
    EXPECT_EQ(settingsKey(back.encode), settingsKey(settings.encode));
    EXPECT_EQ(back.contacts, settings.contacts);
    EXPECT_EQ(back.preset, settings.preset);
  }
}

TEST(SettingsJson, RefusesNamesItDoesNotKnow) {
  QJsonObject json = toJson(ClipSettings());
  json[QStringLiteral("method")] = QStringLiteral("magic");
  EXPECT_THROW(settingsFrom(json), Error);
}

}  // namespace
}  // namespace mocapress
