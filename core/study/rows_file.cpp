// SPDX-License-Identifier: MIT
#include "core/study/rows_file.h"

#include <cerrno>
#include <cstring>
#include <string>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/study/row_json.h"

namespace mocapress {

RowsFile::RowsFile(std::filesystem::path path) : path_(std::move(path)) {
  const std::string text = std::filesystem::exists(path_) ? read_text(path_) : std::string();
  std::string whole;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    if (auto row = parse_row(line)) {
      rows_.push_back(std::move(*row));
      whole += line + '\n';
    }
    begin = end + 1;
  }
  if (whole != text) write_text(path_, whole);
  stream_.open(path_, std::ios::binary | std::ios::app);
  if (!stream_) throw WriteError(path_.string() + ": cannot be written: " + std::strerror(errno));
}

void RowsFile::append(const StudyRow& row) {
  stream_ << to_json_line(row) << '\n' << std::flush;
  if (!stream_) throw WriteError(path_.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace mocapress
