// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/studio/document/settings_json.h"

namespace mocapress::test {

/// Every setting of a clip is another than at first.
inline ClipSettings elaborate() {
  ClipSettings settings;
  settings.encode = {.method = Method::ClosedLoop,
                     .coding = Coding::Rle16,
                     .basis = Basis::Linear,
                     .weighting = Weighting::JointOrigins,
                     .target = {Target::Kind::MaxError, 1.25},
                     .seed = 0xffff'ffff'ffff'fff1,
                     .effort = Effort::Best,
                     .importance = {.joints = {1, 0.5, 4}, .contacts = 20}};
  settings.preset = QStringLiteral("Mine");
  settings.encode.correction =
      CorrectionOptions{.joints = {4, 7}, .ratio = 12.5, .at = CorrectAt::Contacts};
  settings.encode.contacts = std::vector<ContactSpan>{{4, 10, 20}, {7, 0, 3}};
  settings.contacts.begin_speed = 12;
  return settings;
}

}  // namespace mocapress::test
