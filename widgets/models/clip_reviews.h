// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QString>

#include "core/report/review.h"

namespace mocapress {

/// What a library says about its clips, by their paths.
using ClipReviews = QHash<QString, ClipReview>;

}  // namespace mocapress
