// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/motion_input.h"

#include <cstdio>

namespace mocapress::cli {

void MotionInput::add_options(CLI::App& command) {
  command.add_option("--skeleton", skeleton, "The .asf of an .amc that has none beside it")
      ->type_name("S.asf");
  command.add_option("--rate", options.sample_rate_hz, "Sample rate in Hz, whatever the file says")
      ->type_name("HZ")
      ->check(CLI::PositiveNumber);
  command.add_option("--cm-per-unit", options.cm_per_unit, "Length unit of a BVH file in cm")
      ->type_name("CM")
      ->check(CLI::PositiveNumber);
}

Motion MotionInput::read(const std::string& path) const {
  MotionFile file = read_motion(path, skeleton, options);
  print_warnings(file.warnings);
  return std::move(file.motion);
}

void print_warnings(const Warnings& warnings) {
  for (const Warning& warning : warnings)
    std::fprintf(stderr, "warning: %s\n", warning.text().c_str());
}

}  // namespace mocapress::cli
