/* SPDX-License-Identifier: MIT
 * A crowd of a cooked bank: crowd BANK.mcpk CHARACTERS. Each plays a clip of its own, from its own
 * instant on; those further away leave out the finest bands. Prints where each character's root is
 * after every second. All that an engine does is in map_bank() and pose_all(). */
#define _POSIX_C_SOURCE 200809L
#include <mocapress_runtime.h>
#include <stdio.h>
#include <stdlib.h>

#include "system.h"

typedef struct character {
  const mcpr_cooked* clip; /* in the bank's memory */
  uint32_t number;         /* number of the clip */
  double start;            /* s into the clip */
  float distance;          /* m from the camera */
  mcpr_transform* pose;    /* one per joint */
} character;

static mcpr_result report; /* from the last call */

static void check(mcpr_status status) {
  if (status == MCPR_OK) return;
  fprintf(stderr, "crowd: %s: %s (byte %zu)\n", mcpr_status_message(status), report.message,
          report.offset);
  exit(1);
}

static void* or_exit(void* memory, const char* what) {
  if (memory != NULL) return memory;
  perror(what);
  exit(1);
}

/* Maps the bank from disk and uses it in place: a clip takes memory only when it is first sampled.
 * check = 1 verifies every byte, because the bank is somebody else's file. Skip that for your own
 * banks. */
static const mcpk_bank* map_bank(const char* path) {
  size_t size = 0;
  const void* memory = map_file(path, &size);
  if (memory == NULL) {
    fprintf(stderr, "crowd: %s cannot be mapped, or is empty\n", path);
    exit(1);
  }
  const mcpk_bank* bank = NULL;
  check(mcpk_open(memory, size, 1, &bank, &report));
  return bank;
}

static void* aligned(size_t size) {
  return or_exit(take_memory(size, MCPR_ALIGNMENT), "memory");
}

/* This function allocates the array and the scratch memory; an engine keeps them from frame to
 * frame. After sorting, several threads may each pose a slice of the array, with scratch memory of
 * their own. */
static void pose_all(const character* crowd, uint32_t count, double seconds) {
  mcpr_character* all = or_exit(calloc(count, sizeof *all), "crowd");
  for (uint32_t c = 0; c < count; ++c) {
    mcpr_cooked_info info;
    mcpr_cooked_describe(crowd[c].clip, &info);
    const double length = (info.frames - 1) / info.sample_rate;
    double at = crowd[c].start + seconds;
    while (length > 0 && at > length) at -= length; /* starts over */
    const float distance = crowd[c].distance;
    all[c] = (mcpr_character){.clip = crowd[c].clip,
                              .time = at,
                              .out = crowd[c].pose->rotation,
                              .bands_left_out = distance < 15   ? 0
                                                : distance < 40 ? 1
                                                                : 2};
  }
  const mcpr_crowd_request request = {.unit = MCPR_SECONDS};
  const size_t sort_size = mcpr_sort_crowd_scratch_bytes(count);
  const size_t pose_size = mcpr_crowd_scratch_bytes();
  void* sort_scratch = aligned(sort_size);
  void* pose_scratch = aligned(pose_size);
  check(mcpr_sort_crowd(&request, all, count, sort_scratch, sort_size, &report));
  check(mcpr_sample_crowd(&request, all, count, pose_scratch, pose_size, &report));
  give_back(pose_scratch);
  give_back(sort_scratch);
  free(all);
}

int main(int argc, char** argv) {
  const long count = argc == 3 ? strtol(argv[2], NULL, 10) : 0;
  if (count < 1 || count > 10000000)
    return fprintf(stderr, "Usage: crowd BANK.mcpk CHARACTERS\n"), 2;
  const mcpk_bank* bank = map_bank(argv[1]);
  mcpk_info info;
  mcpk_describe(bank, &info);
  if (info.clips == 0) return fprintf(stderr, "crowd: no clips\n"), 1;
  character* crowd = or_exit(calloc((size_t)count, sizeof *crowd), "crowd");
  for (long c = 0; c < count; ++c) {
    crowd[c].number = (uint32_t)c % info.clips;
    crowd[c].start = 0.37 * (double)c;
    crowd[c].distance = (float)(c % 60);
    check(mcpk_cooked(bank, crowd[c].number, &crowd[c].clip, &report));
    mcpr_cooked_info clip;
    mcpr_cooked_describe(crowd[c].clip, &clip);
    crowd[c].pose = or_exit(calloc(clip.joints, sizeof *crowd[c].pose), "crowd");
  }
  for (int second = 0; second < 3; ++second) {
    pose_all(crowd, (uint32_t)count, second);
    for (long c = 0; c < count; ++c) {
      char name[MCPK_NAME_BYTES];
      mcpk_name(bank, crowd[c].number, name);
      const float* at = crowd[c].pose[0].translation;
      printf("%d s: %ld plays %s at %.1f %.1f %.1f cm\n", second, c, name, (double)at[0],
             (double)at[1], (double)at[2]);
    }
  }
  return 0;
}
