// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/report/picture.h"
#include "core/report/report_language.h"
#include "core/report/review_viewer.h"
#include "core/study/results.h"

namespace mocapress {

/// Makes a study's report: one HTML page that needs no other file, with curves, tables beside the
/// paper's, and poses. If this build has the viewer, the pictured clips turn and play. Equal rows
/// and pictures make an equal page.
std::string report_html(const Results& results, const std::vector<Picture>& pictures,
                        const ReportLanguage& say = {},
                        std::span<const std::byte> viewer = review_viewer());

}  // namespace mocapress
