// SPDX-License-Identifier: MIT
#include "core/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <cerrno>
#include <chrono>
#include <thread>

namespace mocapress {

std::optional<FileLock> FileLock::wait_for(const std::filesystem::path& path,
                                           const std::function<bool()>& may_wait) {
  constexpr std::chrono::milliseconds kBetween{20};
  const std::filesystem::path place = end_of_links(path);
  for (;;) {
    FileDescriptor file(::open(place.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (!file) return FileLock(std::move(file));
    const bool is_locked = ::flock(file.number(), LOCK_EX | LOCK_NB) == 0;
    const bool is_others = !is_locked && (errno == EWOULDBLOCK || errno == EINTR);
    // Who had it may have replaced it.
    if (!is_others && is_at(file.number(), place)) return FileLock(std::move(file));
    if (is_others && !may_wait()) return std::nullopt;
    if (is_others) std::this_thread::sleep_for(kBetween);
  }
}

}  // namespace mocapress
