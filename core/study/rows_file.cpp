// SPDX-License-Identifier: MIT
#include "core/study/rows_file.h"

#include <cerrno>
#include <cstring>
#include <string>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/study/row_json.h"

namespace mocapress {

namespace {

/// The lines that are whole rows.
struct WholeRows {
  explicit WholeRows(const std::string& text) {
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string line = text.substr(begin, end - begin);
      if (auto row = parse_row(line)) {
        rows.push_back(std::move(*row));
        lines += line + '\n';
      }
      begin = end + 1;
    }
  }

  std::vector<StudyRow> rows;
  std::string lines;
};

}  // namespace

std::vector<StudyRow> read_rows(const std::filesystem::path& path) {
  return WholeRows(read_text(path)).rows;
}

RowsFile::RowsFile(std::filesystem::path path) : path_(std::move(path)) {
  const std::string text = std::filesystem::exists(path_) ? read_text(path_) : std::string();
  WholeRows whole(text);
  rows_ = std::move(whole.rows);
  if (whole.lines != text) write_text(path_, whole.lines);
  stream_.open(path_, std::ios::binary | std::ios::app);
  if (!stream_) throw WriteError(path_.string() + ": cannot be written: " + std::strerror(errno));
}

void RowsFile::append(const StudyRow& row) {
  stream_ << to_json_line(row) << '\n' << std::flush;
  if (!stream_) throw WriteError(path_.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace mocapress
