// SPDX-License-Identifier: MIT
#include "core/batch/report.h"

#include <ostream>

#include "core/base/file.h"

namespace mocapress {

namespace fs = std::filesystem;

void write_batch_report(const fs::path& folder, const std::string& suffix, const BatchRows& rows,
                        std::size_t waiting) {
  const auto named = [&](const char* extension) {
    return folder / ("report" + suffix + extension);
  };
  write_stream(named(".csv"), [&](std::ostream& out) {
    out << csv_head();
    rows([&](const BatchRow& row) { out << to_csv_line(row); });
  });
  write_stream(named(".json"), [&](std::ostream& out) {
    const char* before = "[\n";
    rows([&](const BatchRow& row) {
      out << before << to_report_line(row);
      before = ",\n";
    });
    out << (*before == '[' ? "[]\n" : "\n]\n");
  });
  write_stream(named(".html"), [&](std::ostream& out) { write_batch_html(out, rows, waiting); });
}

}  // namespace mocapress
