// SPDX-License-Identifier: MIT
#include "core/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <thread>

namespace mocapress {

std::optional<FileLock> FileLock::wait_for(const std::filesystem::path& path,
                                           const std::function<bool()>& may_wait) {
  return wait_for(path, may_wait, &::flock);
}

std::optional<FileLock> FileLock::wait_for(const std::filesystem::path& path,
                                           const std::function<bool()>& may_wait, Lock lock) {
  constexpr std::chrono::milliseconds kBetween{20};
  const std::filesystem::path place = end_of_links(path);
  for (;;) {
    FileDescriptor file(::open(place.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (!file && (errno == ENOENT || errno == ENOTDIR)) return FileLock(std::move(file));
    if (!file) throw InputError(path.string(), 0, 0, std::strerror(errno));
    if (lock(file.number(), LOCK_EX | LOCK_NB) == 0) {
      // The last holder may have replaced the file.
      if (is_at(file.number(), place)) return FileLock(std::move(file));
    } else if (errno == EWOULDBLOCK || errno == EINTR) {
      if (!may_wait()) return std::nullopt;
      std::this_thread::sleep_for(kBetween);
    } else {
      return FileLock(std::move(file), cannot_be_locked(path, errno));
    }
  }
}

}  // namespace mocapress
