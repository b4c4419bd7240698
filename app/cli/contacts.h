// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/report.h"
#include "core/feet/contact_spans.h"

namespace mocapress::cli {

/// Contacts of the feet: found on the original by thresholds, or read from an edited file.
struct ContactInput {
  std::vector<double> height;  // thresholds in cm: begin, end; empty: the default
  std::vector<double> speed;   // thresholds in cm/s: begin, end; empty: the default
  std::optional<std::string> file;

  void add_options(CLI::App& command);

  bool is_given() const { return file || !height.empty() || !speed.empty(); }

  /// Finds or reads the contacts of the original. Throws InputError for an invalid file, and
  /// CLI::ValidationError for invalid thresholds.
  std::vector<ContactSpan> spans(const Motion& motion) const;
};

/// Contacts as JSON: an array of objects with joint, first_frame and last_frame. Frames count from
/// 0, and both are included.
Json contacts_json(const Skeleton& skeleton, const std::vector<ContactSpan>& contacts);

}  // namespace mocapress::cli
