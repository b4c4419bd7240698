// SPDX-License-Identifier: MIT
#include "core/study/rows_file.h"

#include <algorithm>
#include <string>
#include <utility>

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

RowsFile::RowsFile(const std::filesystem::path& path) : lines_(path) {
  const std::string text = lines_.read(0, lines_.size());
  if (text.size() != lines_.size()) throw InputError(path.string(), 0, 0, "cannot be read");
  WholeRows whole(text);
  rows_ = std::move(whole.rows);
  if (whole.lines != text) lines_.replace([&](StagedFile& file) { file.write(whole.lines); });
}

void RowsFile::append(const StudyRow& row) {
  lines_.append(to_json_line(row));
}

}  // namespace mocapress
