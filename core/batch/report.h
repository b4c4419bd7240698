// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "core/batch/row.h"
#include "core/report/report_language.h"
#include "core/report/review_viewer.h"

namespace mocapress {

/// Passes every row to a visitor, one at a time and in the order of the batch. May be called
/// repeatedly.
using BatchRows = std::function<void(const std::function<void(const BatchRow&)>&)>;

/// Writes report.csv, report.json and report.html, with `suffix` before their extensions. Keeps one
/// row in memory at a time. Equal rows and an equal report_time() give equal bytes. `waiting` is
/// the number of clips without a row. The page is in `language`; the tables for programs are in
/// English. Throws WriteError.
void write_batch_report(const std::filesystem::path& folder, const std::string& suffix,
                        const BatchRows& rows, std::size_t waiting,
                        const ReportLanguage& language = {});

/// Writes the page alone, which needs no other file: totals, failures, drawings of the worst
/// frames, and every clip. If this build has the viewer, it shows the clips that have a file for it
/// (OutputFormat::Review).
void write_batch_html(std::ostream& out, const BatchRows& rows, std::size_t waiting,
                      const ReportStamp& stamp, const ReportLanguage& say = {},
                      std::span<const std::byte> viewer = review_viewer());

}  // namespace mocapress
