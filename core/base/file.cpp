// SPDX-License-Identifier: MIT
#include "core/base/file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <locale>
#include <ostream>
#include <streambuf>
#include <string_view>

#include "core/base/error.h"
#include "core/base/memory_limit.h"
#include "core/base/open_file.h"
#include "core/base/staged_file.h"
#include "core/base/utf8_path.h"

namespace mocapress {
namespace {

/// True for the small text that Git LFS leaves in place of a large file that was not fetched.
bool is_lfs_pointer(std::string_view text) {
  return text.starts_with("version https://git-lfs.github.com/spec/");
}

template <typename Buffer>
Buffer read_whole(const std::filesystem::path& path) {
  const FileDescriptor file = open_to_read(path);
  const std::optional<FileStatus> status = status_of(file.number());
  if (!status) throw InputError(utf8(path), 0, 0, std::strerror(errno));
  require_memory(utf8(path), status->size);
  Buffer buffer = naming_what_takes_memory(utf8(path), [&] { return Buffer(status->size, {}); });
  const auto got =
      read_all(file.number(), 0, reinterpret_cast<char*>(buffer.data()), buffer.size());
  if (!got) throw InputError(utf8(path), 0, 0, std::strerror(errno));
  if (*got < buffer.size()) throw InputError(utf8(path), 0, 0, "cannot be read to its end");
  if (is_lfs_pointer({reinterpret_cast<const char*>(buffer.data()), buffer.size()}))
    throw InputError(utf8(path), 0, 0,
                     "is a pointer of Git LFS, not the file itself: 'git lfs pull' fetches that");
  return buffer;
}

/// Passes a stream's text to a staged file, piece by piece.
class StagedBuffer : public std::streambuf {
 public:
  explicit StagedBuffer(StagedFile& file) : file_(file) { begin(); }

 protected:
  int_type overflow(int_type next) override {
    sync();
    if (!traits_type::eq_int_type(next, traits_type::eof())) sputc(static_cast<char>(next));
    return traits_type::not_eof(next);
  }
  int sync() override {
    file_.write({pbase(), static_cast<std::size_t>(pptr() - pbase())});
    begin();
    return 0;
  }

 private:
  void begin() { setp(piece_.data(), piece_.data() + piece_.size()); }

  StagedFile& file_;
  std::array<char, 1 << 14> piece_;
};

}  // namespace

FileDescriptor open_to_read(const std::filesystem::path& path) {
  FileDescriptor file = open_existing(path);
  const auto status = file ? status_of(file.number()) : std::nullopt;
  if (!status) throw InputError(utf8(path), 0, 0, std::strerror(errno));
  if (status->kind == PathKind::Folder)
    throw InputError(utf8(path), 0, 0, "is a folder, not a file");
  if (status->kind != PathKind::File)
    throw InputError(utf8(path), 0, 0, "is a pipe or a device, not a file");
  return file;
}

std::vector<std::byte> read_bytes(const std::filesystem::path& path) {
  return read_whole<std::vector<std::byte>>(path);
}

std::string read_text(const std::filesystem::path& path) {
  return read_whole<std::string>(path);
}

void write_bytes(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  StagedFile file(path);
  file.write(bytes);
  file.commit();
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  write_bytes(path, std::as_bytes(std::span(text)));
}

void write_stream(const std::filesystem::path& path,
                  const std::function<void(std::ostream&)>& write) {
  StagedFile file(path);
  StagedBuffer buffer(file);
  std::ostream stream(&buffer);
  stream.exceptions(std::ios::badbit);  // lets exceptions of `file` through
  stream.imbue(std::locale::classic());
  write(stream);
  stream.flush();
  file.commit();
}

}  // namespace mocapress
