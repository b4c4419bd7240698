// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/codec/encode/encoder.h"
#include "core/report/report_language.h"

namespace mocapress {

/// The script by which a review page shows a compressed clip, see review_script(). Pages play what
/// engines play, so the original is coded to 0.01 cm. `decoded` is the motion of a `file` that the
/// runtime does not play, and is coded likewise; null: the runtime plays the file.
std::string review_clip(std::string_view name, const Encoder& original,
                        std::span<const std::byte> file, const Clip* decoded,
                        const Observer<EncodeProgress>& observer = {});

/// Short texts about a clip on its page.
std::vector<std::string> review_facts(std::string_view method, double ratio,
                                      const Distortion& distortion, Weighting weighting,
                                      const Visibility& visibility, const ReportLanguage& say = {});

}  // namespace mocapress
