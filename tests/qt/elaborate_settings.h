// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/studio/document/named_settings.h"
#include "tests/support/test_motion.h"

namespace mocapress::test {

/// Settings for a clip of smooth_motion() in which every value differs from its default, as far as
/// they can be combined.
inline ClipSettings elaborate() {
  ClipSettings settings;
  settings.encode = {.method = Method::Standard,
                     .coding = Coding::Rle16,
                     .basis = Basis::Linear,
                     .weighting = Weighting::JointOrigins,
                     .target = {Target::Kind::MaxError, 1.25},
                     .seed = 0xffff'ffff'ffff'fff1,
                     .effort = Effort::Best,
                     .importance = {.joints = {1, 0.5, 4, 1, 7, 1, 0, 1}, .contacts = 20},
                     .ends = Ends::Exact,
                     .loop = Loop::Follows};
  settings.preset = QStringLiteral("Mine");
  settings.encode.correction = EncodeCorrection{.joints = {4, 7},
                                                .ratio = 12.5,
                                                .solver = IkSolver::CyclicDescent,
                                                .at = CorrectAt::Contacts};
  settings.encode.contacts = std::vector<ContactSpan>{{4, 10, 20}, {7, 0, 3}};
  settings.encode.ranges = {{5, 9, 2.5}, {12, 12, 100}};
  settings.contacts.begin_speed = 12;
  settings.track_error = 0.0125;
  return settings;
}

inline NamedSettings elaborateByName() {
  return namedSettings(elaborate(), small_skeleton());
}

}  // namespace mocapress::test
