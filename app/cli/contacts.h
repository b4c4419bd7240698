// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/report.h"
#include "core/feet/contact_spans.h"

namespace mocapress::cli {

/// Where feet stand: found on the original by thresholds, or read from a file that was edited.
struct ContactInput {
  std::vector<double> height;  // cm: begin, end; empty: the usual ones
  std::vector<double> speed;   // cm/s
  std::optional<std::string> file;

  void add_options(CLI::App& command);

  /// Of the original. Throws InputError for a file that is not valid, and
  /// CLI::ValidationError for thresholds that are not.
  std::vector<ContactSpan> spans(const Motion& motion) const;
};

/// The spans as a file has them: an array of objects with joint, first_frame and last_frame, frames
/// from 0 and both included.
Json contacts_json(const Skeleton& skeleton, const std::vector<ContactSpan>& contacts);

}  // namespace mocapress::cli
