// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/codec/encode/encoder.h"
#include "core/report/picture.h"
#include "core/study/plan.h"

namespace mocapress {

/// Compresses a clip of the plan to `ratio` by each of `methods` and selects the frames to draw.
/// Unset if the observer stopped it. Throws InputError; throws TargetMissed if a method does not
/// reach the ratio.
std::optional<Picture> take_picture(const StudyPlan& plan, const std::filesystem::path& clip,
                                    const std::vector<std::string>& methods, double ratio,
                                    const Observer<EncodeProgress>& observer = {});

}  // namespace mocapress
