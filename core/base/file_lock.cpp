// SPDX-License-Identifier: MIT
#include "core/base/file_lock.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <thread>

#include "core/base/open_file.h"
#include "core/base/utf8_path.h"

namespace mocapress {

std::optional<FileLock> FileLock::wait_for(const std::filesystem::path& path,
                                           const std::function<bool()>& may_wait) {
  return wait_for(path, may_wait, &lock_now);
}

std::optional<FileLock> FileLock::wait_for(const std::filesystem::path& path,
                                           const std::function<bool()>& may_wait, Lock lock) {
  constexpr std::chrono::milliseconds kBetween{20};
  const std::filesystem::path place = end_of_links(path);
  for (;;) {
    FileDescriptor file = open_existing(place);
    if (!file && is_absence(errno)) return FileLock(std::move(file));
    if (!file) throw InputError(utf8(path), 0, 0, std::strerror(errno));
    if (lock(file.number()) == 0) {
      // Otherwise the process that held the lock has replaced the file: lock the new one.
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
