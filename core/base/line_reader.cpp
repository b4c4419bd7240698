// SPDX-License-Identifier: MIT
#include "core/base/line_reader.h"

#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/utf8_path.h"

namespace mocapress {

LineReader::LineReader(const std::filesystem::path& path)
    : path_(utf8(path)), file_(open_to_read(path)) {}

bool LineReader::next(std::string& line) {
  constexpr std::size_t kPiece = 1 << 16;
  offset_ = piece_end_ - (piece_.size() - next_in_piece_);
  line.clear();
  for (;;) {
    const std::size_t end = piece_.find('\n', next_in_piece_);
    line.append(piece_, next_in_piece_, end == piece_.npos ? end : end - next_in_piece_);
    if (end != piece_.npos) {
      next_in_piece_ = end + 1;
      return true;
    }
    piece_ = read_up_to(piece_end_, kPiece);
    next_in_piece_ = 0;
    piece_end_ += piece_.size();
    if (piece_.empty()) return !line.empty();
  }
}

std::string LineReader::read(std::uint64_t offset, std::size_t length) const {
  std::string text = read_up_to(offset, length);
  if (text.size() != length) throw InputError(path_, 0, 0, "became shorter while it was read");
  return text;
}

std::string LineReader::read_up_to(std::uint64_t offset, std::size_t length) const {
  std::string text(length, '\0');
  if (!read_all(file_.number(), offset, text))
    throw InputError(path_, 0, 0, std::string("cannot be read: ") + std::strerror(errno));
  return text;
}

}  // namespace mocapress
