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

/// Makes the script by which a review page shows a compressed clip, see review_script(). Pages play
/// only what the runtime plays, so the original is coded, too, to 0.01 cm. If the runtime does not
/// play `file`, `decoded` is its motion and is coded likewise; otherwise `decoded` is null.
std::string review_clip(std::string_view name, const Encoder& original,
                        std::span<const std::byte> file, const Clip* decoded,
                        const Observer<EncodeProgress>& observer = {});

/// Short texts about a compressed clip for its page.
std::vector<std::string> review_facts(std::string_view method, double ratio,
                                      const Distortion& distortion, Weighting weighting,
                                      const Visibility& visibility, const ReportLanguage& say = {});

}  // namespace mocapress
