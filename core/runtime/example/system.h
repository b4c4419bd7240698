/* SPDX-License-Identifier: MIT
 * The calls of the examples that Windows and POSIX name differently. */
#ifndef MOCAPRESS_EXAMPLE_SYSTEM_H
#define MOCAPRESS_EXAMPLE_SYSTEM_H

#include <stddef.h>

#ifdef _WIN32

#include <io.h>
#include <malloc.h>
#include <windows.h>

static inline void* take_memory(size_t size, size_t alignment) {
  return _aligned_malloc(size, alignment);
}
static inline void give_back(void* memory) {
  _aligned_free(memory);
}

/* Null if the file cannot be mapped or is empty. */
static inline const void* map_file(const char* path, size_t* size) {
  const HANDLE file =
      CreateFileA(path, GENERIC_READ, FILE_SHARE_READ, NULL, OPEN_EXISTING, 0, NULL);
  if (file == INVALID_HANDLE_VALUE) return NULL;
  LARGE_INTEGER bytes = {0};
  const HANDLE mapping = GetFileSizeEx(file, &bytes)
                             ? CreateFileMappingA(file, NULL, PAGE_READONLY, 0, 0, NULL)
                             : NULL;
  CloseHandle(file); /* the mapping stays */
  if (mapping == NULL) return NULL;
  *size = (size_t)bytes.QuadPart;
  const void* memory = MapViewOfFile(mapping, FILE_MAP_READ, 0, 0, 0);
  CloseHandle(mapping);
  return memory;
}

static inline int prints_to_a_terminal(void) {
  return _isatty(1);
}
static inline void wait_for(unsigned milliseconds) {
  Sleep(milliseconds);
}

#else

#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static inline void* take_memory(size_t size, size_t alignment) {
  return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
static inline void give_back(void* memory) {
  free(memory);
}

/* Null if the file cannot be mapped or is empty. */
static inline const void* map_file(const char* path, size_t* size) {
  struct stat status;
  const int file = open(path, O_RDONLY);
  if (file < 0) return NULL;
  void* memory = MAP_FAILED;
  if (fstat(file, &status) == 0 && status.st_size > 0) {
    *size = (size_t)status.st_size;
    memory = mmap(NULL, *size, PROT_READ, MAP_PRIVATE, file, 0);
  }
  close(file); /* the mapping stays */
  return memory == MAP_FAILED ? NULL : memory;
}

static inline int prints_to_a_terminal(void) {
  return isatty(STDOUT_FILENO);
}
static inline void wait_for(unsigned milliseconds) {
  const struct timespec pause = {milliseconds / 1000, (long)(milliseconds % 1000) * 1000000};
  nanosleep(&pause, NULL);
}

#endif

#endif
