/* SPDX-License-Identifier: MIT
 * A crowd of a cooked bank: crowd BANK.mcpk CHARACTERS. Each plays a clip of its own, from its own
 * instant on; those further away leave out the finest bands. Prints where each character's root is
 * after every second. All that an engine does is in map_bank() and pose(). */
#define _POSIX_C_SOURCE 200809L
#include <fcntl.h>
#include <mocapress_runtime.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct character {
  const mcpr_cooked* clip; /* where it lies in the bank */
  uint32_t number;         /* of the clip */
  double start;            /* s into the clip */
  float distance;          /* m from the camera */
  mcpr_transform* pose;    /* of each joint */
} character;

static void check(mcpr_result result) {
  if (result.status == MCPR_OK) return;
  fprintf(stderr, "crowd: %s: %s (byte %zu)\n", mcpr_status_message(result.status), result.message,
          result.offset);
  exit(1);
}

static void* or_exit(void* memory, const char* what) {
  if (memory != NULL && memory != MAP_FAILED) return memory;
  perror(what);
  exit(1);
}

/* Mapped from disk and used as it is: a clip takes memory when it is first sampled. The bank is
 * somebody else's file, so that every byte is checked; one's own need not be. */
static const mcpk_bank* map_bank(const char* path) {
  struct stat file;
  const int descriptor = open(path, O_RDONLY);
  if (descriptor < 0 || fstat(descriptor, &file) != 0 || file.st_size == 0) or_exit(NULL, path);
  const size_t size = (size_t)file.st_size;
  const mcpk_bank* bank = NULL;
  check(mcpk_open(or_exit(mmap(NULL, size, PROT_READ, MAP_PRIVATE, descriptor, 0), path), size, 1,
                  &bank));
  close(descriptor); /* the mapping stays */
  return bank;
}

/* May be called by any number of threads at once, each for characters of its own. */
static void pose(const character* one, double seconds) {
  const mcpr_cooked_info info = mcpr_cooked_describe(one->clip);
  const double length = (info.frames - 1) / info.sample_rate;
  double at = one->start + seconds;
  while (length > 0 && at > length) at -= length; /* it begins anew */
  const mcpr_sample_request request = {.unit = MCPR_SECONDS,
                                       .bands_left_out = one->distance < 15   ? 0
                                                         : one->distance < 40 ? 1
                                                                              : 2};
  check(mcpr_sample(one->clip, &request, at, one->pose->rotation));
}

int main(int argc, char** argv) {
  const long count = argc == 3 ? strtol(argv[2], NULL, 10) : 0;
  if (count < 1) return fprintf(stderr, "Usage: crowd BANK.mcpk CHARACTERS\n"), 2;
  const mcpk_bank* bank = map_bank(argv[1]);
  const mcpk_info info = mcpk_describe(bank);
  if (info.clips == 0) return fprintf(stderr, "crowd: no clips\n"), 1;
  character* crowd = or_exit(calloc((size_t)count, sizeof *crowd), "crowd");
  for (long c = 0; c < count; ++c) {
    crowd[c].number = (uint32_t)c % info.clips;
    crowd[c].start = 0.37 * (double)c;
    crowd[c].distance = (float)(c % 60);
    check(mcpk_cooked(bank, crowd[c].number, &crowd[c].clip));
    const size_t joints = mcpr_cooked_describe(crowd[c].clip).joints;
    crowd[c].pose = or_exit(calloc(joints, sizeof *crowd[c].pose), "crowd");
  }
  for (int second = 0; second < 3; ++second)
    for (long c = 0; c < count; ++c) {
      char name[MCPK_NAME_BYTES];
      mcpk_name(bank, crowd[c].number, name);
      pose(&crowd[c], second);
      const float* at = crowd[c].pose[0].translation;
      printf("%d s: %ld plays %s at %.1f %.1f %.1f cm\n", second, c, name, (double)at[0],
             (double)at[1], (double)at[2]);
    }
  return 0;
}
