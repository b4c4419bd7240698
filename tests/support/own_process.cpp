// SPDX-License-Identifier: MIT
#include "tests/support/own_process.h"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <exception>

#include "core/base/staged_file.h"

namespace mocapress::test {
namespace {

constexpr unsigned kNobody = 65534;

bool write_setting(const char* file, const std::string& text) {
  const FileDescriptor open(::open(file, O_WRONLY | O_CLOEXEC));
  return open && write_all(open.number(), text);
}

/// Becomes root of its own namespace, in which it may mount.
bool enter_own_mounts() {
  const uid_t user = ::geteuid();
  const gid_t group = ::getegid();
  if (::unshare(user == 0 ? CLONE_NEWNS : CLONE_NEWNS | CLONE_NEWUSER) != 0) return false;
  if (user != 0 && !(write_setting("/proc/self/setgroups", "deny") &&
                     write_setting("/proc/self/uid_map", "0 " + std::to_string(user) + " 1") &&
                     write_setting("/proc/self/gid_map", "0 " + std::to_string(group) + " 1")))
    return false;
  return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

}  // namespace

std::string in_own_process(const std::function<std::string()>& work) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return "no pipe";
  const pid_t child = ::fork();
  if (child == 0) {
    std::string answer;
    try {
      answer = work();
    } catch (const std::exception& error) {
      answer = std::string("threw: ") + error.what();
    }
    write_all(ends[1], answer);
    ::_exit(0);  // skips the test process's own exit handlers
  }
  ::close(ends[1]);
  const FileDescriptor pipe(ends[0]);
  if (child < 0) return "no process";
  std::string answer;
  char piece[256];
  for (ssize_t got = 0; (got = ::read(pipe.number(), piece, sizeof piece)) != 0;) {
    if (got > 0) answer.append(piece, static_cast<std::size_t>(got));
    if (got < 0 && errno != EINTR) break;
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFSIGNALED(status) ? "killed by " + std::to_string(WTERMSIG(status)) : answer;
}

bool mount_small_disk(const std::filesystem::path& folder, std::size_t bytes) {
  return enter_own_mounts() && ::mount("tmpfs", folder.c_str(), "tmpfs", 0,
                                       ("size=" + std::to_string(bytes)).c_str()) == 0;
}

bool limit_file_size(std::size_t bytes) {
  const rlimit limit{bytes, bytes};
  return ::signal(SIGXFSZ, SIG_IGN) != SIG_ERR && ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
}

bool become_ordinary_user() {
  if (::geteuid() != 0) return true;
  return ::setresgid(kNobody, kNobody, kNobody) == 0 && ::setresuid(kNobody, kNobody, kNobody) == 0;
}

}  // namespace mocapress::test
