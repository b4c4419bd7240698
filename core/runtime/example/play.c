/* SPDX-License-Identifier: MIT
 * Plays a .mcpr file in a terminal: play CLIP.mcpr. Elsewhere than in a terminal it prints one
 * frame of each second. All that an engine does is in open_clip() and main(). */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <mocapress_runtime.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "system.h"

enum { COLUMNS = 64, ROWS = 30 };
static const float kCmPerRow = 7;

static mcpr_result report; /* from the last call */

static void check(mcpr_status status) {
  if (status == MCPR_OK) return;
  fprintf(stderr, "play: %s: %s (byte %zu)\n", mcpr_status_message(status), report.message,
          report.offset);
  exit(1);
}

static void* memory_of(size_t size) {
  void* memory = take_memory(size > 0 ? size : MCPR_ALIGNMENT, MCPR_ALIGNMENT);
  if (memory == NULL) exit(1);
  return memory;
}

static const mcpr_clip* open_clip(const char* path) {
  FILE* stream = fopen(path, "rb");
  if (stream == NULL || fseek(stream, 0, SEEK_END) != 0) {
    perror(path);
    exit(1);
  }
  const size_t size = (size_t)ftell(stream);
  rewind(stream);
  void* file = memory_of(size);
  if (fread(file, 1, size, stream) != size) exit(1);
  fclose(stream);
  mcpr_info info;
  size_t resident_bytes = 0;
  const mcpr_clip* clip = NULL;
  check(mcpr_inspect(file, size, NULL, &info, &report));
  void* scratch = memory_of(info.read_bytes);
  check(mcpr_read(file, size, NULL, scratch, info.read_bytes, &resident_bytes, &report));
  void* resident = memory_of(resident_bytes);
  check(mcpr_build(scratch, info.read_bytes, resident, resident_bytes, &clip, &report));
  give_back(scratch);
  give_back(file);
  return clip;
}

static void draw_bone(char screen[ROWS][COLUMNS + 1], const float* from, const float* to,
                      float middle) {
  for (int i = 0; i <= 16; ++i) {
    const float x = from[0] + (to[0] - from[0]) * (float)i / 16 - middle;
    const float y = from[1] + (to[1] - from[1]) * (float)i / 16;
    const int column = COLUMNS / 2 + (int)lrintf(2 * x / kCmPerRow); /* as wide as high */
    const int row = ROWS - 2 - (int)lrintf(y / kCmPerRow);
    if (column >= 0 && column < COLUMNS && row >= 0 && row < ROWS) screen[row][column] = '#';
  }
}

int main(int argc, char** argv) {
  if (argc != 2) return fprintf(stderr, "Usage: play CLIP.mcpr\n"), 2;
  const mcpr_clip* clip = open_clip(argv[1]);
  mcpr_clip_info info;
  mcpr_clip_describe(clip, &info);
  const mcpr_request request = {.output = MCPR_POSITIONS, .apply_ik = 1};
  const size_t scratch_bytes = mcpr_scratch_bytes(clip, &request);
  void* scratch = memory_of(scratch_bytes);
  float* positions = malloc(mcpr_frame_values(clip, &request) * sizeof(float));
  const int terminal = prints_to_a_terminal();
  const double frames_a_second = terminal ? 25 : 1;
  const double step = info.sample_rate / frames_a_second; /* may fall between frames */
  for (double frame = 0; frame <= (double)info.frames - 1; frame += step) {
    check(mcpr_decode_moment(clip, &request, frame, positions, scratch, scratch_bytes, &report));
    char screen[ROWS][COLUMNS + 1];
    memset(screen, ' ', sizeof screen);
    for (uint32_t j = 1; j < info.joints; ++j) {
      mcpr_joint joint;
      check(mcpr_clip_joint(clip, j, &joint, &report));
      if (joint.parent >= 0)
        draw_bone(screen, positions + 3 * joint.parent, positions + 3 * j, positions[0]);
    }
    if (terminal) printf("\033[H\033[2J");
    for (int row = 0; row < ROWS; ++row) printf("%.*s\n", COLUMNS, screen[row]);
    printf("%ld ms\n", lrint(1000 * frame / info.sample_rate));
    fflush(stdout);
    if (terminal) wait_for(1000 / 25);
  }
  return 0;
}
