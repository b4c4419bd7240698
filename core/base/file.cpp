// SPDX-License-Identifier: MIT
#include "core/base/file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/base/error.h"

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

/// Removes the half-written file unless it was renamed into place.
class TemporaryBeside {
 public:
  explicit TemporaryBeside(const std::filesystem::path& target) : path_(target) {
    path_ += ".part";
  }
  TemporaryBeside(const TemporaryBeside&) = delete;
  TemporaryBeside& operator=(const TemporaryBeside&) = delete;
  ~TemporaryBeside() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

std::vector<std::byte> read_bytes(const std::filesystem::path& path) {
  return read_whole<std::vector<std::byte>>(path);
}

std::string read_text(const std::filesystem::path& path) {
  return read_whole<std::string>(path);
}

void write_bytes(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  const TemporaryBeside temporary(path);
  {
    std::ofstream stream(temporary.path(), std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) throw WriteError(path.string() + ": cannot be written: " + std::strerror(errno));
  }
  std::error_code error;
  std::filesystem::rename(temporary.path(), path, error);
  if (error) throw WriteError(path.string() + ": cannot be written: " + error.message());
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  write_bytes(path, std::as_bytes(std::span(text)));
}

}  // namespace mocapress
