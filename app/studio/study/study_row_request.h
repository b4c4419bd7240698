// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/jobs/open_clip.h"
#include "core/study/row.h"

namespace mocapress {

/// What opens the clip of a row of a study as it is compressed there.
OpenRequest requestOf(const StudyRow& row);

}  // namespace mocapress
