// SPDX-License-Identifier: MIT
#include "core/report/report_phrases.h"

#include "core/base/number_text.h"

namespace mocapress {

std::string sight_phrase(const ReportLanguage& say, Sight sight) {
  return say(sight == Sight::NotVisible ? "not visible" : std::string(name(sight)));
}

std::string sight_phrase(const ReportLanguage& say, Sight sight, double distance_m) {
  return say("%1 from %2 m", {sight_phrase(say, sight), significant_text(distance_m, 3)});
}

}  // namespace mocapress
