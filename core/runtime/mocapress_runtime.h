/* SPDX-License-Identifier: MIT
 *
 * The runtime decoder of Mocapress: plays .mcpr files of the coding "adaptive" in an engine.
 *
 * A file is opened once into a compact resident form, about twice as large as the file's coded
 * motion. From that form the decoder gives any channels, any stretch of frames, any instant between
 * frames and any level of detail, each by itself. It allocates, throws and locks nothing and keeps
 * no globals: all memory is the caller's. A clip is read-only once it was built. Any number of
 * threads may decode from it, each with scratch memory of its own.
 *
 * Units: lengths are centimetres, angles radians, rates frames a second. Instants are counted in
 * frames from the first: seconds * sample_rate.
 *
 * Space: right-handed, y up, the ground is x and z. The clip says where a character stands and
 * faces. A positive angle turns as a right-handed screw along its axis: about y from z to x. An
 * engine with z up takes x y z as x -z y, and does the same with a quaternion's vector part. A
 * left-handed engine also negates one axis, and the two other components of a quaternion's vector
 * part.
 *
 * Rotations: unit quaternions w x y z that turn columns, v' = q v q*; q and -q are the same
 * rotation, and either may come. A joint's transform maps its own frame to its
 * parent's; a pose in the world is parent * child, from the roots on.
 *
 * Memory handed in must be aligned to MCPR_ALIGNMENT. Every function that can fail says where and
 * why; what it writes is then unspecified.
 */
#ifndef MOCAPRESS_RUNTIME_H
#define MOCAPRESS_RUNTIME_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of the decoder. Until 1.0 the C interface may change with the minor one. */
#define MCPR_VERSION_MAJOR 0
#define MCPR_VERSION_MINOR 1
#define MCPR_VERSION_PATCH 0
#define MCPR_VERSION (MCPR_VERSION_MAJOR * 10000 + MCPR_VERSION_MINOR * 100 + MCPR_VERSION_PATCH)

#define MCPR_ALIGNMENT 32

typedef enum mcpr_status {
  MCPR_OK = 0,
  MCPR_NOT_A_CLIP = 1,      /* the bytes are no .mcpr file */
  MCPR_UNKNOWN_VERSION = 2, /* a version that this decoder does not know */
  MCPR_DAMAGED = 3,         /* cut short, or a checksum differs */
  MCPR_INVALID = 4,         /* not what FORMAT.md allows */
  MCPR_UNSUPPORTED = 5,     /* allowed, but not adaptive: the library mocapress reads it */
  MCPR_LIMIT = 6,           /* larger than the limits given */
  MCPR_MEMORY = 7,          /* too little memory given, or not aligned */
  MCPR_ARGUMENT = 8         /* a request for what the clip does not have */
} mcpr_status;

typedef struct mcpr_result {
  mcpr_status status;
  size_t offset;       /* of the first offending byte in the file; 0 if no byte is at fault */
  const char* message; /* a constant, in English; never null */
} mcpr_result;

/* "damaged file" ...: a name for a status. Never null. */
const char* mcpr_status_message(mcpr_status status);

/* Limits for files. A file beyond them is refused before any work is done for it. Only mcpr_read
 * finds out how large the resident form is: beyond that limit a file is refused after it. */
typedef struct mcpr_limits {
  uint32_t frames;
  uint32_t joints;
  uint32_t channels;    /* of all joints together */
  uint64_t values;      /* frames * (channels + 3 * effectors + tracks that are curves); frames that
                           two segments of a long clip share count twice */
  size_t scratch_bytes; /* of mcpr_info.read_bytes */
  size_t resident_bytes;      /* of the resident form */
  uint32_t solver_iterations; /* of an IK solver, for a limb at a frame; the format's solvers take
                                 60 or 12 */
} mcpr_limits;

/* The limits of the format, within which every valid file opens: frames 2^22, joints 4096, channels
 * 24576, values 2^26, scratch memory 608 MiB, resident form 272 MiB, 60 iterations. That is hours
 * of motion: give less where files come from strangers and memory is scarce. Higher limits do not
 * let in files beyond the format. */
mcpr_limits mcpr_default_limits(void);

/* ---------------------------------------------------------------- opening */

/* What a file holds, by its headers alone. */
typedef struct mcpr_info {
  double sample_rate; /* frames a second */
  uint32_t frames;
  uint32_t joints;
  uint32_t channels;
  uint32_t effectors;  /* of the IK correction; 0: none */
  size_t motion_bytes; /* of the file: coded motion, segments, correction, ends, turned axes */
  size_t read_bytes;   /* scratch memory that mcpr_read needs; for a long clip in segments: one
                          decoded segment and motion_bytes */
} mcpr_info;

mcpr_result mcpr_inspect(const void* file, size_t size, const mcpr_limits* limits, mcpr_info* info);

/* Decodes a whole file into `scratch` (info.read_bytes), from which mcpr_build makes a clip of
 * *resident_bytes. The file is not needed afterwards. The work is at most in proportion to
 * values + joints^2 + 2^15 * size, whatever the bytes. */
mcpr_result mcpr_read(const void* file, size_t size, const mcpr_limits* limits, void* scratch,
                      size_t scratch_size, size_t* resident_bytes);

typedef struct mcpr_clip mcpr_clip;

/* Makes the resident form. It has no pointers: it may be moved and copied as bytes, within one
 * program and version. `scratch` is what mcpr_read left, in its place. mcpr_build works in it; it
 * is not needed afterwards. For a clip in segments it takes as long as mcpr_read. */
mcpr_result mcpr_build(void* scratch, size_t scratch_size, void* resident, size_t resident_size,
                       const mcpr_clip** clip);

/* ---------------------------------------------------------------- looking at a clip */

typedef struct mcpr_clip_info {
  double sample_rate; /* frames a second */
  uint32_t frames;
  uint32_t joints;
  uint32_t channels;
  uint32_t effectors;
  uint32_t bands;        /* levels of detail that can be left out, 0 .. 26; the last segment of a
                            long clip may have fewer */
  size_t resident_bytes; /* all of the clip */
  size_t skeleton_bytes; /* of them the skeleton's: names, offsets, axes */
  uint32_t loop_frames;  /* of one turn of a loop: one less than frames where the last frame shows
                            the first pose again; 0: the clip is no loop */
  uint32_t tracks;       /* morph weights, properties, scales: see below */
} mcpr_clip_info;

/* All zero if `clip` is no clip. */
mcpr_clip_info mcpr_clip_describe(const mcpr_clip* clip);

/* A joint, parents before children. Its frame maps to its parent's by
 *   x_in_parent = offset + translation + rotation * x_in_joint
 * where offset + translation and rotation are what MCPR_LOCAL decodes to. */
typedef struct mcpr_joint {
  const char* name; /* UTF-8, ends with a zero; in the clip's memory */
  int32_t parent;   /* -1: a root */
  float offset[3];  /* cm, in the parent's frame */
  uint32_t first_channel;
  uint32_t channels; /* 0 .. 6 */
  uint8_t kinds[6];  /* 0 1 2: translation x y z, cm; 3 4 5: rotation x y z, radians; of angles the
                        first leftmost, about axes that suit the clip and are not told here (AXES
                        in FORMAT.md): MCPR_LOCAL is what poses a joint */
  uint8_t has_end_site;
  float end_site[3]; /* cm, in the joint's frame */
} mcpr_joint;

mcpr_result mcpr_clip_joint(const mcpr_clip* clip, uint32_t joint, mcpr_joint* out);

/* The first joint of that name, compared byte for byte. -1: there is none, or clip or name is null.
 * It searches all joints: call it once, not at every frame. */
int32_t mcpr_find_joint(const mcpr_clip* clip, const char* name);

/* ---------------------------------------------------------------- decoding */

typedef enum mcpr_output {
  MCPR_CHANNELS = 0, /* 1 float a channel: cm or radians, in the order of the request */
  MCPR_LOCAL = 1,    /* 7 floats a joint: quaternion w x y z of parent_from_joint, then the
                        joint's origin in its parent's frame, x y z (a root's: in the world), cm */
  MCPR_POSITIONS = 2 /* 3 floats a joint: its origin in the world, x y z, cm */
} mcpr_output;

/* By what instructions rows are computed. All give the same bits. */
typedef enum mcpr_path {
  MCPR_PATH_BEST = 0,
  MCPR_PATH_PLAIN = 1,
  MCPR_PATH_SSE2 = 2,
  MCPR_PATH_AVX2 = 3
} mcpr_path;

/* 1 if this machine and build have the path. */
int mcpr_path_exists(mcpr_path path);

/* What to decode. All zero: every channel, in full detail, without IK correction. */
typedef struct mcpr_request {
  mcpr_output output;
  int apply_ik;             /* 1: with the clip's IK correction, if it has one */
  uint32_t bands_left_out;  /* how many of the finest; each halves the sample rate of the rest */
  const uint16_t* channels; /* MCPR_CHANNELS only: which, in any order, none twice; null: all */
  uint32_t channel_count;   /* of `channels`; 0 where that is null */
  mcpr_path path;
  uint32_t solver_iterations; /* at most, for a limb at a frame; 0: as many as the format's solvers
                                 take */
} mcpr_request;

/* Floats in a frame of output; 0 for a request that the clip cannot fulfil. */
size_t mcpr_frame_values(const mcpr_clip* clip, const mcpr_request* request);

/* Scratch memory of mcpr_decode_frames and mcpr_decode_moment, whatever the frames. */
size_t mcpr_scratch_bytes(const mcpr_clip* clip, const mcpr_request* request);

/* Decodes frames first .. first + count - 1, row after row, each of mcpr_frame_values() floats. For
 * a subset of channels only those are computed, unless the correction turns one of them. */
mcpr_result mcpr_decode_frames(const mcpr_clip* clip, const mcpr_request* request, uint32_t first,
                               uint32_t count, float* out, void* scratch, size_t scratch_size);

/* Decodes one instant, in frames from the first, 0 .. frames - 1. At a frame it is exact; between
 * two, the channels and what the correction adds are linear in time. */
mcpr_result mcpr_decode_moment(const mcpr_clip* clip, const mcpr_request* request, double frame,
                               float* out, void* scratch, size_t scratch_size);

/* The same for a loop, at any instant: whole turns are taken off it first. If the first frame
 * follows upon the last, channels go from the last frame to the first, angles by the shorter way.
 * Roots go on as they came: the caller adds up, turn by turn, where a character stands and faces.
 */
mcpr_result mcpr_decode_looped(const mcpr_clip* clip, const mcpr_request* request, double frame,
                               float* out, void* scratch, size_t scratch_size);

/* ---------------------------------------------------------------- poses at any instant */

/* A cooked clip: laid out for poses at any instant, several times as fast as mcpr_decode_moment,
 * and about three times the coded motion's bytes. One block of bytes without pointers,
 * little-endian, aligned to MCPR_ALIGNMENT: it may be copied, written to disk and used as it is
 * mapped from there. It has the tracks of its clip, but neither names nor parents of joints: joints
 * are those of the clip that it was cooked from, in their order. */
typedef struct mcpr_cooked mcpr_cooked;

typedef struct mcpr_cook_options {
  int apply_ik; /* 1: with the clip's IK correction, if it has one, cooked in */
} mcpr_cook_options;

/* Scratch memory of cooking, in proportion to frames * channels of the longest segment; with
 * apply_ik of the whole clip. 0: there is no clip. */
size_t mcpr_cook_scratch_bytes(const mcpr_clip* clip, const mcpr_cook_options* options);

/* The size of the cooked form. Works as much as mcpr_cook. */
mcpr_result mcpr_cook_size(const mcpr_clip* clip, const mcpr_cook_options* options, void* scratch,
                           size_t scratch_size, size_t* bytes);

/* Makes it. The clip is no longer needed after this. */
mcpr_result mcpr_cook(const mcpr_clip* clip, const mcpr_cook_options* options, void* scratch,
                      size_t scratch_size, void* memory, size_t size, const mcpr_cooked** cooked);

/* A block that was cooked before. Unchecked, only its head is looked at, and the rest must be what
 * mcpr_cook made. `check`: every byte is, and whatever is no cooked clip refused: for files from
 * anywhere. */
mcpr_result mcpr_open_cooked(const void* memory, size_t size, int check,
                             const mcpr_cooked** cooked);

typedef struct mcpr_cooked_info {
  double sample_rate; /* frames a second */
  uint32_t frames;
  uint32_t joints;
  uint32_t loop_frames;  /* as of mcpr_clip_info */
  size_t bytes;          /* all of it */
  size_t skeleton_bytes; /* of them what is the skeleton's: what never changes, and which channel
                            turns what */
} mcpr_cooked_info;

/* All zero where there is no clip. */
mcpr_cooked_info mcpr_cooked_describe(const mcpr_cooked* cooked);

typedef struct mcpr_transform {
  float rotation[4];    /* w x y z of parent_from_joint */
  float translation[4]; /* the joint's origin in its parent's frame, x y z (a root's: in the world),
                           cm; then 0 */
} mcpr_transform;

typedef enum mcpr_layout {
  MCPR_TRANSFORMS = 0, /* an mcpr_transform a joint */
  MCPR_ARRAYS = 1,     /* w of all joints, then x, y, z of the rotation, then x, y, z of the
                          translation: 7 floats a joint */
  MCPR_MATRICES = 2    /* 12 floats a joint: three rows of rotation and translation */
} mcpr_layout;

typedef enum mcpr_time { MCPR_FRAMES = 0, MCPR_SECONDS = 1 } mcpr_time;

/* Before the first frame and after the last. */
typedef enum mcpr_wrap {
  MCPR_CLAMP = 0, /* these stand still */
  MCPR_LOOP = 1   /* as mcpr_decode_looped, of a clip that is a loop */
} mcpr_wrap;

/* Some joints of a cooked clip, checked and looked up beforehand: sampling them takes no more
 * time than all, where a list that is given with each request does. */
typedef struct mcpr_selection mcpr_selection;

/* The finest bands of details may be left out of poses that are seen from far away: what moves
 * within 2 frames, then 4, 8 and 16. SAMPLING.md has what that costs and brings. */
#define MCPR_MOST_BANDS_LEFT_OUT 4

/* What to sample. All zero: the transforms of all joints, by frames, clamped. */
typedef struct mcpr_sample_request {
  mcpr_layout layout;
  mcpr_time unit;
  mcpr_wrap wrap;
  mcpr_path path;
  const uint16_t* joints;          /* which, in any order, none twice; null: all */
  uint32_t joint_count;            /* of `joints`; 0 where that is null */
  const mcpr_selection* selection; /* in place of `joints`; null: what these say */
  uint32_t bands_left_out;         /* 0: none; up to MCPR_MOST_BANDS_LEFT_OUT, the finest first */
} mcpr_sample_request;

/* Memory of a selection of so many joints: about 1.5 KB for 30 joints. 0: there is no clip, or
 * it has not so many. */
size_t mcpr_selection_bytes(const mcpr_cooked* cooked, uint32_t joint_count);

/* Makes one of joints in any order, none twice, which is the order in which they come out. The list
 * is no longer needed after this; the clip must stay where it is, and so must the selection. It is
 * for this clip alone. Any number of threads may use it. */
mcpr_result mcpr_make_selection(const mcpr_cooked* cooked, const uint16_t* joints,
                                uint32_t joint_count, void* memory, size_t size,
                                const mcpr_selection** selection);

/* Floats of a sample; 0 for a request that the clip cannot fulfil. */
size_t mcpr_sample_values(const mcpr_cooked* cooked, const mcpr_sample_request* request);

/* Local transforms of one instant. Needs no scratch memory but some stack (112 KiB at most).
 * Between two frames channels are linear in time, as in mcpr_decode_moment, and so is what the
 * correction made of them. Within 2^-16 of one it is that frame. All paths give the same bits. */
mcpr_result mcpr_sample(const mcpr_cooked* cooked, const mcpr_sample_request* request, double time,
                        float* out);

/* A cursor remembers some frames of a clip around the last instant: play through it, forwards or
 * backwards, takes less time. It is for one who plays; the clip may have any number. Any instant
 * may be asked for at any time, and what comes out depends on the instant alone. From mcpr_sample
 * it differs by rounding: each is within 5e-4 radians and 2e-3 cm of mcpr_decode_moment. */
typedef struct mcpr_cursor mcpr_cursor;

/* Memory of a cursor: 4096 bytes at most. 0: there is no clip. */
size_t mcpr_cursor_bytes(const mcpr_cooked* cooked);

/* Makes one. The clip must stay where it is. */
mcpr_result mcpr_make_cursor(const mcpr_cooked* cooked, void* memory, size_t size,
                             mcpr_cursor** cursor);

/* mcpr_sample of the cursor's clip. */
mcpr_result mcpr_sample_next(mcpr_cursor* cursor, const mcpr_sample_request* request, double time,
                             float* out);

/* ---------------------------------------------------------------- a crowd */

/* One of many that are posed at once. */
typedef struct mcpr_character {
  const mcpr_cooked* clip;
  const mcpr_selection* selection; /* of the clip's joints; null: all */
  double time;                     /* in the unit of the request */
  float* out;                      /* mcpr_sample_values() of them */
  mcpr_wrap wrap;
  uint32_t bands_left_out; /* as of mcpr_sample_request */
} mcpr_character;

/* What all of them ask for. All zero: transforms, by frames. */
typedef struct mcpr_crowd_request {
  mcpr_layout layout;
  mcpr_time unit;
  mcpr_path path;
  int exact; /* 1: the bits of mcpr_sample, whoever else is posed. 0: where many play a clip, some
                frames are made once for several, as a cursor keeps them: each pose has the bits of
                mcpr_sample or those of mcpr_sample_next, by which others are beside it. Both are
                within 5e-4 radians and 2e-3 cm of mcpr_decode_moment, and all paths agree */
} mcpr_crowd_request;

/* Scratch memory of mcpr_sort_crowd: about 72 bytes a character. */
size_t mcpr_sort_crowd_scratch_bytes(uint32_t count);

/* Puts the array into the order in which mcpr_sample_crowd is fastest: by clip, bands left out and
 * frame. Characters that were in it a moment before are nearly so yet: it need not be called at
 * every frame. Fails as mcpr_sample_crowd does. */
mcpr_result mcpr_sort_crowd(const mcpr_crowd_request* request, mcpr_character* characters,
                            uint32_t count, void* scratch, size_t scratch_size);

/* Scratch memory of mcpr_sample_crowd, however many they are: about 140 KB. */
size_t mcpr_crowd_scratch_bytes(void);

/* mcpr_sample of each, in any order, fastest in that of mcpr_sort_crowd. Threads take a slice of
 * the array each, with scratch memory of their own. If one of them cannot be posed, nothing is
 * written, and the result's offset is the first such one's number in the array. */
mcpr_result mcpr_sample_crowd(const mcpr_crowd_request* request, const mcpr_character* characters,
                              uint32_t count, void* scratch, size_t scratch_size);

/* ---------------------------------------------------------------- root motion */

/* How a joint, usually the root, moves from one instant to another: the transform at `from`,
 * inverted, times that at `to`. In a loop, turn after turn is added to it; `to` may be before
 * `from`. Layout and list of the request do not matter. */
mcpr_result mcpr_sample_motion(const mcpr_cooked* cooked, const mcpr_sample_request* request,
                               uint32_t joint, double from, double to, mcpr_transform* out);

/* ---------------------------------------------------------------- tracks */

/* What moves besides joints: one number without a unit, over time. */
typedef enum mcpr_track_kind {
  MCPR_TRACK_PROPERTY = 0,     /* custom properties, IK and event curves */
  MCPR_TRACK_MORPH_WEIGHT = 1, /* 0: not at all, 1: all of the shape */
  MCPR_TRACK_SCALE_X = 2,      /* of a joint against its parent. What MCPR_LOCAL decodes to has the
                                  places that it gives to the joints below: it is for the skin */
  MCPR_TRACK_SCALE_Y = 3,
  MCPR_TRACK_SCALE_Z = 4
} mcpr_track_kind;

typedef struct mcpr_track {
  const char* node; /* what has it: a joint, or the node of a mesh; empty: the clip */
  const char* name; /* of the property or the morph target; empty: a scale. Both are UTF-8, end with
                       a zero, and are in the clip's memory */
  mcpr_track_kind kind;
  int steps; /* 1: between two frames it has the value of the first; 0: it is linear */
} mcpr_track;

/* The tracks of a clip that was built, or of a cooked one, which has the same, to the bit. They are
 * in the clip's memory. Null: it has none, or there is no clip; whoever asks further is told so. */
typedef struct mcpr_tracks mcpr_tracks;

const mcpr_tracks* mcpr_clip_tracks(const mcpr_clip* clip);
const mcpr_tracks* mcpr_cooked_tracks(const mcpr_cooked* cooked);

uint32_t mcpr_track_count(const mcpr_tracks* tracks);

mcpr_result mcpr_track_describe(const mcpr_tracks* tracks, uint32_t track, mcpr_track* out);

/* The first track of that kind, node and name, compared byte for byte; a null node or name is any.
 * -1: there is none. It searches all tracks: call it once, not at every frame. */
int32_t mcpr_find_track(const mcpr_tracks* tracks, mcpr_track_kind kind, const char* node,
                        const char* name);

/* Which tracks, in any order, none twice; null: all. */
typedef struct mcpr_track_request {
  const uint16_t* tracks;
  uint32_t track_count; /* of `tracks`; 0 where that is null */
} mcpr_track_request;

/* Floats in a frame: one for each track; 0 for a request that they cannot fulfil. */
size_t mcpr_track_values(const mcpr_tracks* tracks, const mcpr_track_request* request);

/* Scratch memory of the next two. 0: none, null will do. */
size_t mcpr_track_scratch_bytes(const mcpr_tracks* tracks, const mcpr_track_request* request);

/* Decodes frames first .. first + count - 1, row after row, each of mcpr_track_values() floats. */
mcpr_result mcpr_track_frames(const mcpr_tracks* tracks, const mcpr_track_request* request,
                              uint32_t first, uint32_t count, float* out, void* scratch,
                              size_t scratch_size);

/* One instant, in frames from the first, 0 .. frames - 1. In a loop whose first frame follows upon
 * the last, instants up to frames are between these two. */
mcpr_result mcpr_track_moment(const mcpr_tracks* tracks, const mcpr_track_request* request,
                              double frame, float* out, void* scratch, size_t scratch_size);

/* ---------------------------------------------------------------- banks */

/* Many clips in one file, .mcpk: their skeletons, tags and names stand once. In a packed bank each
 * clip is read as its file would be, by mcpk_read; in a cooked one each is used as it lies there,
 * by mcpk_cooked. The bank is the bytes of its file, aligned to MCPR_ALIGNMENT, in memory or mapped
 * from disk; they stay there as long as it is used. Clips are numbered in the order of their names,
 * byte by byte. Any number of threads may use a bank. */
typedef struct mcpk_bank mcpk_bank;

#define MCPK_NAME_BYTES 256 /* of a clip's name, with the zero at its end */

/* Unchecked, only the head is looked at, however many clips there are, and the rest must be what
 * `mocapress bank` made. `check`: every byte is, and whatever is no bank refused: for files from
 * anywhere. */
mcpr_result mcpk_open(const void* memory, size_t size, int check, const mcpk_bank** bank);

typedef struct mcpk_info {
  uint64_t bytes; /* all of it */
  uint32_t clips;
  uint32_t tags;      /* different ones */
  uint32_t texts;     /* keys with a value */
  int is_cooked;      /* 0: packed */
  size_t table_bytes; /* of it what cooked clips have in common */
} mcpk_info;

/* All zero where there is no bank. */
mcpk_info mcpk_describe(const mcpk_bank* bank);

/* The clip of that name; -1: there is none. Compares about log2(clips) names. */
int32_t mcpk_find(const mcpk_bank* bank, const char* name);

/* Puts a clip's name where there is room for MCPK_NAME_BYTES. Its length; 0: there is no such clip.
 */
size_t mcpk_name(const mcpk_bank* bank, uint32_t clip, char* name);

/* A clip's tags, from number 0 on; null: it has no more. */
const char* mcpk_tag(const mcpk_bank* bank, uint32_t clip, uint32_t number);

/* The keys and values that the bank has, from number 0 on; null: there are no more. */
const char* mcpk_key(const mcpk_bank* bank, uint32_t number);
const char* mcpk_value(const mcpk_bank* bank, uint32_t number);

/* Of a packed bank: as mcpr_inspect and mcpr_read, whose place they take; mcpr_build follows. */
mcpr_result mcpk_inspect(const mcpk_bank* bank, uint32_t clip, const mcpr_limits* limits,
                         mcpr_info* info);
mcpr_result mcpk_read(const mcpk_bank* bank, uint32_t clip, const mcpr_limits* limits,
                      void* scratch, size_t scratch_size, size_t* resident_bytes);

/* Of a cooked bank: the clip where it lies, for mcpr_sample. */
mcpr_result mcpk_cooked(const mcpk_bank* bank, uint32_t clip, const mcpr_cooked** cooked);

/* Of a cooked bank: a joint of a clip's skeleton, parents before children; without channels. The
 * name is in the bank. */
mcpr_result mcpk_joint(const mcpk_bank* bank, uint32_t clip, uint32_t joint, mcpr_joint* out);

/* As mcpr_find_joint. */
int32_t mcpk_find_joint(const mcpk_bank* bank, uint32_t clip, const char* name);

#ifdef __cplusplus
}
#endif

#endif
