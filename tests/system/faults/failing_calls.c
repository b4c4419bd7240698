// SPDX-License-Identifier: MIT
// A library to preload (ld.so(8), LD_PRELOAD): one call of a program to the system fails. Calls are
// counted that name a file below a folder, or are made of one that is open, so that neither shared
// libraries nor the terminal count. Allocations count from the first such call on, and only those
// of a kilobyte and more: the directory iterators of libstdc++ end the program where the few bytes
// of a path cannot be had.
//
// FAULT_UNDER   the folder
// FAULT_KIND    open, read, write, sync, name, stat, map, lock, list, make or memory
// FAULT_AT      which call of the kind fails, from 1 on; 0: none, they are counted
// FAULT_HOW     number of the error; "short": a part is done; "interrupted": EINTR
// FAULT_LASTING "1": all calls of the kind fail from there on
// FAULT_COUNT   a file that gets the number of calls of the kind
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

enum { kFiles = 1 << 16, kMostPath = 4096, kLeastAllocation = 1024 };

static char under[kMostPath];
static char kind[16];
static long at;
static int error_number;  // 0: only a part is done
static bool lasting;
static bool cwd_is_below;
static bool is_set_up;
static atomic_bool has_begun;  // the program has named a file below the folder
static atomic_long calls;
static atomic_bool is_below[kFiles];  // by file descriptor

__attribute__((constructor)) static void set_up(void) {
  const char* folder = getenv("FAULT_UNDER");
  const char* of = getenv("FAULT_KIND");
  const char* how = getenv("FAULT_HOW");
  char cwd[kMostPath] = "";
  if (!folder || !of) return;
  snprintf(under, sizeof under, "%s", folder);
  snprintf(kind, sizeof kind, "%s", of);
  at = atol(getenv("FAULT_AT") ? getenv("FAULT_AT") : "0");
  lasting = getenv("FAULT_LASTING") != NULL;
  if (how && strcmp(how, "interrupted") == 0)
    error_number = EINTR;
  else if (how && strcmp(how, "short") != 0)
    error_number = atoi(how);
  cwd_is_below = getcwd(cwd, sizeof cwd) && strncmp(cwd, under, strlen(under)) == 0;
  is_set_up = true;
}

__attribute__((destructor)) static void write_count(void) {
  const char* path = getenv("FAULT_COUNT");
  char text[32];
  if (!is_set_up || !path) return;
  const long file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int length = snprintf(text, sizeof text, "%ld", (long)calls);
  syscall(SYS_write, file, text, length);
  syscall(SYS_close, file);
}

static bool is_counted_file(int file) {
  return is_set_up && file >= 0 && file < kFiles && is_below[file];
}

static bool is_counted_at(int folder, const char* path) {
  if (!is_set_up || !path) return false;
  bool counts = false;
  if (strncmp(path, "/proc/self/fd/", 14) == 0)
    counts = is_counted_file(atoi(path + 14));
  else if (path[0] == '/')
    counts = strncmp(path, under, strlen(under)) == 0;
  else
    counts = folder == AT_FDCWD ? cwd_is_below : is_counted_file(folder);
  if (counts) has_begun = true;
  return counts;
}

// True if this call is the one to fail.
static bool is_hit(bool counts, const char* of) {
  if (!counts || strcmp(kind, of) != 0) return false;
  const long call = ++calls;
  return at > 0 && (call == at || (lasting && call > at));
}

// Sets errno if it returns true.
static bool fails(bool counts, const char* of) {
  if (!is_hit(counts, of)) return false;
  errno = error_number;
  return true;
}

#define NEXT(name)               \
  static __typeof__(&name) next; \
  if (!next) next = (__typeof__(&name))dlsym(RTLD_NEXT, #name)

static int opened(int file, bool counts) {
  if (file >= 0 && file < kFiles) is_below[file] = counts;
  return file;
}

#define MODE_OF(flags, mode)             \
  mode_t mode = 0;                       \
  if ((flags) & (O_CREAT | O_TMPFILE)) { \
    va_list rest;                        \
    va_start(rest, flags);               \
    mode = va_arg(rest, mode_t);         \
    va_end(rest);                        \
  }

#define OPENS(name)                                                              \
  int name(const char* path, int flags, ...) {                                   \
    MODE_OF(flags, mode)                                                         \
    NEXT(name);                                                                  \
    const bool counts = is_counted_at(AT_FDCWD, path);                           \
    return fails(counts, "open") ? -1 : opened(next(path, flags, mode), counts); \
  }
OPENS(open)
OPENS(open64)

#define OPENS_AT(name)                                                                   \
  int name(int folder, const char* path, int flags, ...) {                               \
    MODE_OF(flags, mode)                                                                 \
    NEXT(name);                                                                          \
    const bool counts = is_counted_at(folder, path);                                     \
    return fails(counts, "open") ? -1 : opened(next(folder, path, flags, mode), counts); \
  }
OPENS_AT(openat)
OPENS_AT(openat64)

#define OPENS_STREAM(name)                             \
  FILE* name(const char* path, const char* mode) {     \
    NEXT(name);                                        \
    const bool counts = is_counted_at(AT_FDCWD, path); \
    if (fails(counts, "open")) return NULL;            \
    FILE* const stream = next(path, mode);             \
    if (stream) opened(fileno(stream), counts);        \
    return stream;                                     \
  }
OPENS_STREAM(fopen)
OPENS_STREAM(fopen64)

int close(int file) {
  NEXT(close);
  opened(file, false);
  return next(file);
}

// Half of the bytes, but at least one: none would mean the end of a file.
static size_t part_of(size_t bytes) {
  return bytes < 2 ? bytes : bytes / 2;
}

// Defines a call that fails or does only a part.
#define MOVES(name, of, PARAMETERS, ARGUMENTS) \
  ssize_t name PARAMETERS {                    \
    NEXT(name);                                \
    if (is_hit(is_counted_file(file), of)) {   \
      if (error_number != 0) {                 \
        errno = error_number;                  \
        return -1;                             \
      }                                        \
      bytes = part_of(bytes);                  \
    }                                          \
    return next ARGUMENTS;                     \
  }
MOVES(read, "read", (int file, void* to, size_t bytes), (file, to, bytes))
MOVES(pread, "read", (int file, void* to, size_t bytes, off_t offset), (file, to, bytes, offset))
MOVES(pread64, "read", (int file, void* to, size_t bytes, off64_t offset),
      (file, to, bytes, offset))
MOVES(write, "write", (int file, const void* from, size_t bytes), (file, from, bytes))
MOVES(pwrite, "write", (int file, const void* from, size_t bytes, off_t offset),
      (file, from, bytes, offset))
MOVES(pwrite64, "write", (int file, const void* from, size_t bytes, off64_t offset),
      (file, from, bytes, offset))

// Does only the first of several pieces.
#define MOVES_PIECES(name, of)                                                \
  ssize_t name(int file, const struct iovec* pieces, int count) {             \
    NEXT(name);                                                               \
    if (!is_hit(is_counted_file(file), of)) return next(file, pieces, count); \
    errno = error_number;                                                     \
    return error_number != 0 ? -1 : next(file, pieces, 1);                    \
  }
MOVES_PIECES(readv, "read")
MOVES_PIECES(writev, "write")

#define SYNCHRONISES(name)                                         \
  int name(int file) {                                             \
    NEXT(name);                                                    \
    return fails(is_counted_file(file), "sync") ? -1 : next(file); \
  }
SYNCHRONISES(fsync)
SYNCHRONISES(fdatasync)
SYNCHRONISES(syncfs)

int rename(const char* from, const char* to) {
  NEXT(rename);
  return fails(is_counted_at(AT_FDCWD, to), "name") ? -1 : next(from, to);
}
int renameat(int folder, const char* from, int target, const char* to) {
  NEXT(renameat);
  return fails(is_counted_at(target, to), "name") ? -1 : next(folder, from, target, to);
}
int renameat2(int folder, const char* from, int target, const char* to, unsigned flags) {
  NEXT(renameat2);
  return fails(is_counted_at(target, to), "name") ? -1 : next(folder, from, target, to, flags);
}
int linkat(int folder, const char* from, int target, const char* to, int flags) {
  NEXT(linkat);
  return fails(is_counted_at(target, to), "name") ? -1 : next(folder, from, target, to, flags);
}

#define LOOKS(name, STATUS)                                                        \
  int name(const char* path, STATUS* status) {                                     \
    NEXT(name);                                                                    \
    return fails(is_counted_at(AT_FDCWD, path), "stat") ? -1 : next(path, status); \
  }
LOOKS(stat, struct stat)
LOOKS(lstat, struct stat)
LOOKS(stat64, struct stat64)
LOOKS(lstat64, struct stat64)

#define LOOKS_AT_FILE(name, STATUS)                                        \
  int name(int file, STATUS* status) {                                     \
    NEXT(name);                                                            \
    return fails(is_counted_file(file), "stat") ? -1 : next(file, status); \
  }
LOOKS_AT_FILE(fstat, struct stat)
LOOKS_AT_FILE(fstat64, struct stat64)

int fstatat(int folder, const char* path, struct stat* status, int flags) {
  NEXT(fstatat);
  return fails(is_counted_at(folder, path), "stat") ? -1 : next(folder, path, status, flags);
}
int access(const char* path, int mode) {
  NEXT(access);
  return fails(is_counted_at(AT_FDCWD, path), "stat") ? -1 : next(path, mode);
}
int faccessat(int folder, const char* path, int mode, int flags) {
  NEXT(faccessat);
  return fails(is_counted_at(folder, path), "stat") ? -1 : next(folder, path, mode, flags);
}
ssize_t readlink(const char* path, char* to, size_t bytes) {
  NEXT(readlink);
  return fails(is_counted_at(AT_FDCWD, path), "stat") ? -1 : next(path, to, bytes);
}
char* realpath(const char* path, char* resolved) {
  NEXT(realpath);
  return fails(is_counted_at(AT_FDCWD, path), "stat") ? NULL : next(path, resolved);
}

#define MAPS(name, OFFSET)                                                                      \
  void* name(void* address, size_t bytes, int protection, int flags, int file, OFFSET offset) { \
    NEXT(name);                                                                                 \
    if (fails(is_counted_file(file), "map")) return MAP_FAILED;                                 \
    return next(address, bytes, protection, flags, file, offset);                               \
  }
MAPS(mmap, off_t)
MAPS(mmap64, off64_t)

int flock(int file, int operation) {
  NEXT(flock);
  return fails(is_counted_file(file), "lock") ? -1 : next(file, operation);
}

#define LISTS(name, ENTRY)                                                      \
  ENTRY* name(DIR* folder) {                                                    \
    NEXT(name);                                                                 \
    return fails(is_counted_file(dirfd(folder)), "list") ? NULL : next(folder); \
  }
LISTS(readdir, struct dirent)
LISTS(readdir64, struct dirent64)

int mkdir(const char* path, mode_t mode) {
  NEXT(mkdir);
  return fails(is_counted_at(AT_FDCWD, path), "make") ? -1 : next(path, mode);
}

// The C library's own function, since dlsym() allocates.
extern void* __libc_malloc(size_t bytes);
extern void* __libc_calloc(size_t count, size_t bytes);
extern void* __libc_realloc(void* old, size_t bytes);
extern void* __libc_memalign(size_t alignment, size_t bytes);

// True while a thread is being started. oneTBB ends the program if that fails, so such failures are
// not tried.
static _Thread_local bool starts_thread;

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                   void* with) {
  NEXT(pthread_create);
  starts_thread = true;
  const int result = next(thread, attributes, work, with);
  starts_thread = false;
  return result;
}

static bool no_memory(size_t bytes) {
  return fails(has_begun && !starts_thread && bytes >= kLeastAllocation, "memory");
}
void* malloc(size_t bytes) {
  return no_memory(bytes) ? NULL : __libc_malloc(bytes);
}
void* calloc(size_t count, size_t bytes) {
  return no_memory(count * bytes) ? NULL : __libc_calloc(count, bytes);
}
void* realloc(void* old, size_t bytes) {
  return no_memory(bytes) ? NULL : __libc_realloc(old, bytes);
}
void* aligned_alloc(size_t alignment, size_t bytes) {
  return no_memory(bytes) ? NULL : __libc_memalign(alignment, bytes);
}
int posix_memalign(void** to, size_t alignment, size_t bytes) {
  if (no_memory(bytes)) return ENOMEM;
  *to = __libc_memalign(alignment, bytes);
  return *to ? 0 : ENOMEM;
}
