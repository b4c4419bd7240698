// SPDX-License-Identifier: MIT
#include "core/base/file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <locale>
#include <ostream>
#include <streambuf>
#include <system_error>

#include "core/base/error.h"
#include "core/base/staged_file.h"

namespace mocapress {
namespace {

template <typename Buffer>
Buffer read_whole(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw InputError(path.string(), 0, 0, "is a folder, not a file");
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  if (!stream) throw InputError(path.string(), 0, 0, std::strerror(errno));
  const std::streamsize size = stream.tellg();
  if (size < 0) throw InputError(path.string(), 0, 0, "cannot be read");
  Buffer buffer(static_cast<std::size_t>(size), {});
  stream.seekg(0);
  stream.read(reinterpret_cast<char*>(buffer.data()), size);
  if (stream.gcount() != size) throw InputError(path.string(), 0, 0, "cannot be read to its end");
  return buffer;
}

/// Hands a stream's text on to a staged file, a piece at a time.
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
  stream.exceptions(std::ios::badbit);  // what the file throws gets through
  stream.imbue(std::locale::classic());
  write(stream);
  stream.flush();
  file.commit();
}

}  // namespace mocapress
