// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sight_arguments.h"

#include "core/base/file.h"
#include "core/base/utf8_path.h"
#include "core/metrics/sight_limits_json.h"

namespace mocapress::cli {

void SightArguments::add_options(CLI::App& command, const std::string& otherwise) {
  command
      .add_option("--limits", limits_file,
                  "Limits above which errors are noticed, as a blind test in the studio writes "
                  "them (.json) [built in]")
      ->type_name("FILE");
  command
      .add_option("--distance", distance_m,
                  "Viewing distance for visibility in metres, 0.5 to 100 [that of --limits, " +
                      otherwise + "]")
      ->type_name("M")
      ->check(CLI::Range(kLeastDistance, kMostDistance));
}

SightLimits SightArguments::read(const SightLimits& otherwise) const {
  SightLimits limits =
      limits_file.empty()
          ? otherwise
          : limits_from_text(limits_file, read_text(utf8_path(limits_file)), otherwise.distance_m);
  if (distance_m) limits.distance_m = *distance_m;
  return limits;
}

}  // namespace mocapress::cli
