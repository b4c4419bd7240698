// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/report/picture.h"
#include "core/study/results.h"

namespace mocapress {

/// A finished study as one HTML page that needs nothing else: curves, tables beside the paper's,
/// poses. The same rows and pictures make the same page.
std::string report_html(const Results& results, const std::vector<Picture>& pictures);

}  // namespace mocapress
