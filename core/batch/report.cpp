// SPDX-License-Identifier: MIT
#include "core/batch/report.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/base/error.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

void write_streamed(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  fs::path part = path;
  part += ".part";
  {
    std::ofstream stream(part, std::ios::binary | std::ios::trunc);
    if (stream) write(stream);
    stream.close();
    if (!stream) throw WriteError(path.string() + ": cannot be written: " + std::strerror(errno));
  }
  std::error_code error;
  fs::rename(part, path, error);
  if (error) throw WriteError(path.string() + ": cannot be written: " + error.message());
}

}  // namespace

void write_batch_report(const fs::path& folder, const std::string& suffix, const BatchRows& rows,
                        std::size_t waiting) {
  const auto named = [&](const char* extension) {
    return folder / ("report" + suffix + extension);
  };
  write_streamed(named(".csv"), [&](std::ostream& out) {
    out << csv_head();
    rows([&](const BatchRow& row) { out << to_csv_line(row); });
  });
  write_streamed(named(".json"), [&](std::ostream& out) {
    const char* before = "[\n";
    rows([&](const BatchRow& row) {
      out << before << to_report_line(row);
      before = ",\n";
    });
    out << (*before == '[' ? "[]\n" : "\n]\n");
  });
  write_streamed(named(".html"), [&](std::ostream& out) { write_batch_html(out, rows, waiting); });
}

}  // namespace mocapress
