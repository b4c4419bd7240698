// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/named_settings.h"

#include <gtest/gtest.h>

#include "app/jobs/result_cache.h"
#include "core/base/error.h"
#include "core/mocapress/settings_json.h"
#include "core/report/json_value.h"
#include "tests/qt/elaborate_settings.h"

namespace mocapress {
namespace {

using test::elaborate;
using test::elaborateByName;

TEST(NamedSettings, BringEverySettingBack) {
  const Motion motion = test::smooth_motion(60);
  for (const ClipSettings& settings : {ClipSettings(), elaborate()}) {
    const Json json = toJson(namedSettings(settings, motion.skeleton));
    const ClipSettings back = settingsFor(namedSettingsFrom(Json::parse(json.dump())), motion);
    EXPECT_EQ(settingsKey(back.encode), settingsKey(settings.encode)) << json;
    EXPECT_EQ(back.contacts, settings.contacts);
    EXPECT_EQ(back.preset, settings.preset);
  }
}

TEST(NamedSettings, AreWrittenAsAPresetIs) {
  Json json = toJson(elaborateByName());
  json.erase("contact_settings");
  EXPECT_EQ(preset_from(Json::parse(json.dump())), elaborateByName().preset);
}

TEST(NamedSettings, RefuseWhatTheyDoNotKnow) {
  for (const char* key : {"method", "seed", "contact_settings", "unheard-of"}) {
    Json json = toJson(NamedSettings());
    json[key] = "magic";
    EXPECT_THROW(namedSettingsFrom(json), Error) << key;
  }
  EXPECT_THROW(namedSettingsFrom(3), Error);
}

}  // namespace
}  // namespace mocapress
