// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "widgets/models/study_settings.h"

namespace mocapress {

/// What was asked of the last study, clips left out, from the user's settings.
StudySettings rememberedStudySettings();
void remember(const StudySettings& settings);

/// Where rows are kept unless the user chooses a folder: one for each build of the program, for
/// another may compress otherwise.
QString studyCache();

}  // namespace mocapress
