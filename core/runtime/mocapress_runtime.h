/* SPDX-License-Identifier: MIT
 *
 * The runtime decoder of Mocapress: plays .mcpr files of the coding "adaptive" in an engine.
 *
 * A file is opened once into a compact resident form, about twice as large as the file's coded
 * motion. From that form the decoder gives any channels, any range of frames, any instant between
 * frames and any level of detail, without decoding the rest.
 *
 * Contents, each part below a line of dashes: opening a file, or its first tiers while it is on its
 * way; looking at a clip; decoding frames; poses at any instant (cooked clips, conventions,
 * cursors); a crowd; root motion; skeletons; blending; tracks, for morphs and events; banks of many
 * clips. A game that ships one cooked bank may begin with mcpk_open, mcpk_find, mcpk_cooked and
 * mcpr_sample.
 *
 * Memory and threads: the decoder allocates, throws and locks nothing and has no globals. The
 * caller provides all memory, see MCPR_ALIGNMENT, but for 16 KiB of stack at most in any
 * call. A built clip is read-only. Any number of threads may decode from it, each with its own
 * scratch memory.
 *
 * Errors: every function that can fail returns an mcpr_status. It writes where and why to `report`,
 * its last argument, unless that is null. If a call fails, the contents of its other outputs are
 * unspecified. A null argument, an unknown enum value or an index out of range gives MCPR_ARGUMENT.
 * Memory to work in or to build in gives MCPR_NO_MEMORY if it is null, MCPR_MISALIGNED if it is not
 * aligned, and MCPR_MEMORY if it is too small. Comments on functions list further errors only. No
 * function takes or returns a struct by value.
 *
 * Units: lengths are in centimetres, angles in radians, rates in frames per second. Time is counted
 * in frames from the first, unless a request says seconds: frame = seconds * sample_rate.
 *
 * Space: right-handed, y up, the ground is the x-z plane. The clip says where a character stands
 * and which way it faces. A positive angle turns counter-clockwise as seen from the tip of the
 * axis: about y, from z to x. Sampled poses may have another convention: see mcpr_convention.
 *
 * Rotations: unit quaternions w x y z that rotate column vectors, v' = q v q*. q and -q are the
 * same rotation, and the decoder may return either. A joint's transform maps its local space to its
 * parent's. World transforms are products parent * child, starting at the root.
 */
#ifndef MOCAPRESS_RUNTIME_H
#define MOCAPRESS_RUNTIME_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of the decoder. Until 1.0 the C interface may change with the minor version. */
#define MCPR_VERSION_MAJOR 0
#define MCPR_VERSION_MINOR 1
#define MCPR_VERSION_PATCH 0
#define MCPR_VERSION (MCPR_VERSION_MAJOR * 10000 + MCPR_VERSION_MINOR * 100 + MCPR_VERSION_PATCH)

/* Alignment, in bytes, of banks and of all memory to build in or to work in. Files, and output
 * arrays such as poses, need only the alignment of their type. */
#define MCPR_ALIGNMENT 32

/* Goes before every function. Define it when the decoder is part of a shared library, for example
 * as __declspec(dllexport) where it is compiled and __declspec(dllimport) where it is used. */
#ifndef MCPR_API
#define MCPR_API
#endif

typedef enum mcpr_status {
  MCPR_OK = 0,
  MCPR_NOT_A_CLIP = 1,      /* not a Mocapress file, cooked clip or bank */
  MCPR_UNKNOWN_VERSION = 2, /* a version that this decoder does not know */
  MCPR_DAMAGED = 3,         /* cut short, or a checksum differs */
  MCPR_INVALID = 4,         /* the contents violate FORMAT.md */
  MCPR_UNSUPPORTED = 5,     /* valid, but not coded as "adaptive": the mocapress library reads it */
  MCPR_LIMIT = 6,           /* larger than the given limits, or than a cooked clip can be */
  MCPR_MEMORY = 7,          /* the memory given is too small */
  MCPR_ARGUMENT = 8,        /* an invalid argument, or a request for what the clip does not have */
  MCPR_NO_MEMORY = 9,       /* the memory given is null, or an allocator had none */
  MCPR_MISALIGNED = 10      /* the memory given is not aligned to MCPR_ALIGNMENT */
} mcpr_status;

/* The report of a call, with the place and the cause of a failure. */
typedef struct mcpr_result {
  mcpr_status status;
  size_t offset;       /* the first byte in the file that is wrong; 0 if no byte is at fault */
  const char* message; /* a constant string in English; never null */
} mcpr_result;

/* A short English name for a status, such as "damaged file". Never null. */
MCPR_API const char* mcpr_status_message(mcpr_status status);

/* Limits for files. A file that exceeds one of the first five is refused before anything is
 * decoded. One that exceeds resident_bytes is refused after mcpr_read has decoded it. */
typedef struct mcpr_limits {
  uint32_t frames;
  uint32_t joints;
  uint32_t channels;    /* those of all joints together */
  uint64_t values;      /* frames * (channels + 3 * effectors + curve tracks). A frame shared
                           by two segments of a long clip counts twice */
  size_t scratch_bytes; /* limit for mcpr_info.read_bytes */
  size_t resident_bytes;
  uint32_t solver_iterations; /* cap on the IK solver's iterations per limb and frame; the format's
                                 solvers take up to 60 or 12. Fewer iterations are faster and less
                                 exact */
  uint32_t tiers;             /* number of tiers to read of a file that has tiers; the file may end
                                 after them, see mcpr_tier_of. 0: all */
} mcpr_limits;

/* Sets *out to the limits of the format. Every valid file is within them: 2^22 frames, 4096 joints,
 * 24576 channels, 2^26 values, 608 MiB of scratch memory, 272 MiB for the resident form, 60
 * iterations, all tiers. Set lower limits where files come from strangers; higher limits have no
 * effect. */
MCPR_API void mcpr_default_limits(mcpr_limits* out);

/* ---------------------------------------------------------------- opening */

/* The contents of a file, as its headers state them. The first five members mean the same as in
 * mcpr_clip_info. */
typedef struct mcpr_info {
  double sample_rate;
  uint32_t frames;
  uint32_t joints;
  uint32_t channels;
  uint32_t effectors;
  size_t motion_bytes; /* bytes of the file that code the motion: coefficients, segment table,
                          correction, clip ends, turned axes */
  size_t read_bytes;   /* scratch memory that mcpr_read needs. For a segmented clip: one decoded
                          segment plus motion_bytes */
  float error;         /* root-mean-square error in cm against the original, as the encoder
                          measured it, with the tiers that the limits ask for; 0: not known */
  float max_error;     /* largest error of any point at any frame, in cm; 0: not known */
  uint32_t tiers;      /* number of tiers in the whole file; 1: it can be read only as a whole */
} mcpr_info;

/* Reads the headers of a file into *info, and verifies all checksums in the part of the file that
 * the limits ask for. If `limits` is null, the default limits apply. Fails with any status from
 * MCPR_NOT_A_CLIP to MCPR_LIMIT. */
MCPR_API mcpr_status mcpr_inspect(const void* file, size_t size, const mcpr_limits* limits,
                                  mcpr_info* info, mcpr_result* report);

/* A tier: the first bytes of a file, which are enough for a coarser motion. The last tier is the
 * whole file. */
typedef struct mcpr_tier {
  size_t bytes;            /* number of bytes from the start of the file that are enough for this
                              tier */
  uint32_t bands_left_out; /* number of the finest bands that the motion then lacks, see
                              mcpr_clip_info.bands */
  float error;     /* root-mean-square error in cm against the original, measured by the encoder; 0:
                      not known. For the last tier it is in mcpr_info, not here. Informative */
  float max_error; /* largest error of any point at any frame, in cm. Like `error` */
} mcpr_tier;

/* mcpr_tier_of needs at most this many bytes from the start of a file. */
#define MCPR_TIERS_HEAD_BYTES 133

/* Describes a tier of a file whose first `size` bytes have been loaded. To play a file while the
 * rest is loading: load as many bytes as the first tier has, and read them with mcpr_limits.tiers =
 * 1; then load up to the size of the next tier, and read the file again with tiers = 2. Fails with
 * MCPR_ARGUMENT if the file has no such tier, or no tiers at all. */
MCPR_API mcpr_status mcpr_tier_of(const void* file, size_t size, uint32_t tier, mcpr_tier* out,
                                  mcpr_result* report);

/* Decodes a file, or its first tiers, into `scratch`, which has at least mcpr_info.read_bytes. Sets
 * *resident_bytes to the memory that mcpr_build needs. The file is not needed afterwards. Takes
 * time in proportion to values + joints^2 + 2^15 * size at most. Fails as mcpr_inspect does. */
MCPR_API mcpr_status mcpr_read(const void* file, size_t size, const mcpr_limits* limits,
                               void* scratch, size_t scratch_size, size_t* resident_bytes,
                               mcpr_result* report);

/* A clip in its resident form: skeleton, motion and tracks in one block of bytes. */
typedef struct mcpr_clip mcpr_clip;

/* Builds the resident form in `resident`, which has the size that mcpr_read returned, and points
 * *clip to it. `scratch` is the memory that mcpr_read filled, at the same address; it is not needed
 * afterwards. The resident form contains no pointers: within one program and version it may be
 * moved and copied as bytes. For a segmented clip, building takes as long as mcpr_read. */
MCPR_API mcpr_status mcpr_build(void* scratch, size_t scratch_size, void* resident,
                                size_t resident_size, const mcpr_clip** clip, mcpr_result* report);

/* Memory for mcpr_load. `allocate` returns memory with the given alignment, a power of two, or null
 * if there is none; `release` takes it back. */
typedef struct mcpr_allocator {
  void* (*allocate)(void* context, size_t size, size_t alignment);
  void (*release)(void* context, void* memory);
  void* context;
} mcpr_allocator;

/* Does what mcpr_inspect, mcpr_read and mcpr_build do, in one call. The clip is one piece of memory
 * from the allocator; release it with the allocator. All other memory is released before the call
 * returns, also after a failure. */
MCPR_API mcpr_status mcpr_load(const void* file, size_t size, const mcpr_limits* limits,
                               const mcpr_allocator* allocator, const mcpr_clip** clip,
                               mcpr_result* report);

/* ---------------------------------------------------------------- looking at a clip */

typedef struct mcpr_clip_info {
  double sample_rate; /* frames per second */
  uint32_t frames;
  uint32_t joints;
  uint32_t channels;
  uint32_t effectors;    /* joints placed by the IK correction; 0: the clip has no correction */
  uint32_t bands;        /* levels of detail that can be left out, 0 to 26. The last segment of a
                            long clip may have fewer */
  size_t resident_bytes; /* size of the whole clip in memory */
  size_t skeleton_bytes; /* the part of resident_bytes that holds names, offsets and axes */
  uint32_t loop_frames;  /* frames in one cycle of a loop: frames - 1 if the last frame repeats the
                            first pose, else frames. 0: the clip is not a loop */
  uint32_t tracks;       /* scalar tracks: morph weights, properties, scales */
} mcpr_clip_info;

/* Sets *out to the dimensions of a clip; all zero if `clip` is null or not a clip. */
MCPR_API void mcpr_clip_describe(const mcpr_clip* clip, mcpr_clip_info* out);

/* A joint of the skeleton. Parents come before their children. A point moves from the joint's space
 * to its parent's by
 *   x_in_parent = offset + translation + rotation * x_in_joint
 * where MCPR_LOCAL gives the rotation and the sum offset + translation. */
typedef struct mcpr_joint {
  const char* name; /* UTF-8, zero-terminated, in the clip's memory */
  int32_t parent;   /* index of the parent; -1: a root */
  float offset[3];  /* cm, in the parent's space */
  uint32_t first_channel;
  uint32_t channels;    /* 0 to 6 */
  uint8_t kinds[6];     /* one per channel. 0 1 2: translation x y z, cm; 3 4 5: rotation x y z,
                           radians. Rotations are multiplied in this order, the first leftmost. The
                           encoder may have turned their axes (AXES in FORMAT.md), which is not told
                           here: take poses from MCPR_LOCAL */
  uint8_t has_end_site; /* 1: `end_site` is set */
  float end_site[3];    /* the tip of a joint without children. cm, in the joint's space */
} mcpr_joint;

MCPR_API mcpr_status mcpr_clip_joint(const mcpr_clip* clip, uint32_t joint, mcpr_joint* out,
                                     mcpr_result* report);

/* The index of the first joint with this name, compared byte for byte; -1 if there is none.
 * Searches all joints: call it once, not at every frame. */
MCPR_API int32_t mcpr_find_joint(const mcpr_clip* clip, const char* name);

/* ---------------------------------------------------------------- decoding */

/* The unit of the instants in a request. */
typedef enum mcpr_time { MCPR_FRAMES = 0, MCPR_SECONDS = 1 } mcpr_time;

/* The pose before the first frame and after the last. The caller may choose any wrap for any clip,
 * with one exception: MCPR_LOOP needs a clip that is a loop, and otherwise gives MCPR_ARGUMENT. In
 * a loop the character starts each cycle at the same place: the caller adds up the distance and the
 * turn of the cycles, see mcpr_sample_motion. */
typedef enum mcpr_wrap {
  MCPR_CLAMP = 0,      /* the first or the last frame */
  MCPR_LOOP = 1,       /* the clip repeats in cycles of loop_frames frames. If the first frame comes
                          one frame after the last, channels go linearly from one to the other,
                          angles the shorter way round, and roots repeat their last step */
  MCPR_PING_PONG = 2,  /* forwards, then backwards, and so on */
  MCPR_LOOP_JUMP = 3,  /* the clip repeats in cycles of frames - 1: instead of the last frame comes
                          the first one, without a blend */
  MCPR_LOOP_BLEND = 4, /* the clip repeats in cycles of `frames`: the first frame comes one frame
                          after the last. From one to the other as in MCPR_LOOP; if the clip is not
                          such a loop, roots go straight, too */
  MCPR_LOOP_HOLD = 5   /* the clip repeats in cycles of `frames`: the last frame is held until the
                          first one comes */
} mcpr_wrap;

/* The kind of values that decoding returns for each frame. */
typedef enum mcpr_output {
  MCPR_CHANNELS = 0, /* 1 float per channel, in cm or radians, in the order of the request */
  MCPR_LOCAL = 1,    /* 7 floats per joint: the quaternion w x y z from the joint's space to its
                        parent's, then the joint's origin x y z in its parent's space (for a root:
                        in world space), in cm */
  MCPR_POSITIONS = 2 /* 3 floats per joint: its origin x y z in world space, in cm */
} mcpr_output;

/* The instruction set to compute with. All instruction sets give the same bits. */
typedef enum mcpr_path {
  MCPR_PATH_BEST = 0, /* the fastest that exists */
  MCPR_PATH_PLAIN = 1,
  MCPR_PATH_SSE2 = 2,
  MCPR_PATH_AVX2 = 3,
  MCPR_PATH_NEON = 4,
  MCPR_PATH_WASM = 5
} mcpr_path;

/* 1 if this build and this machine have the path, else 0. */
MCPR_API int mcpr_path_exists(mcpr_path path);

/* A request for decoding. If all members are zero: every channel, in full detail, without IK
 * correction. */
typedef struct mcpr_request {
  mcpr_output output;
  int apply_ik;             /* 1: apply the clip's IK correction, if it has one */
  uint32_t bands_left_out;  /* number of finest bands to leave out. Each halves the rate at which
                               the remaining motion is sampled */
  const uint16_t* channels; /* channels to decode, in any order, without duplicates; null: all.
                               Allowed for MCPR_CHANNELS only */
  uint32_t channel_count;   /* length of `channels`; 0 if that is null */
  mcpr_path path;
  uint32_t solver_iterations; /* cap on the IK solver's iterations, such as for characters far away;
                                 0, or beyond the clip's own (mcpr_limits): the clip's own */
  mcpr_time unit;             /* this and the next are for mcpr_decode_moment */
  mcpr_wrap wrap;
} mcpr_request;

/* The number of floats that one decoded frame takes; 0 if the request is not possible. */
MCPR_API size_t mcpr_frame_values(const mcpr_clip* clip, const mcpr_request* request);

/* The bytes of scratch memory that decoding needs, for any number of frames; 0 if the request is
 * not possible. Every thread needs its own. */
MCPR_API size_t mcpr_scratch_bytes(const mcpr_clip* clip, const mcpr_request* request);

/* Decodes frames `first` to `first + count - 1` into `out`, frame after frame: count rows of
 * mcpr_frame_values() floats. If the request lists channels, only those are computed, unless the IK
 * correction turns one of them. */
MCPR_API mcpr_status mcpr_decode_frames(const mcpr_clip* clip, const mcpr_request* request,
                                        uint32_t first, uint32_t count, float* out, void* scratch,
                                        size_t scratch_size, mcpr_result* report);

/* Decodes the pose at one finite instant into mcpr_frame_values() floats. A whole number of frames
 * gives exactly that frame. Between two frames, the channels and the offsets of effectors are
 * interpolated linearly, and the IK correction is solved for that instant. */
MCPR_API mcpr_status mcpr_decode_moment(const mcpr_clip* clip, const mcpr_request* request,
                                        double time, float* out, void* scratch, size_t scratch_size,
                                        mcpr_result* report);

/* ---------------------------------------------------------------- poses at any instant */

/* A cooked clip: a form of a clip that is laid out for sampling poses at any instant. It is several
 * times as fast as mcpr_decode_moment, and takes about three times the bytes of the coded motion.
 * It is one little-endian block without pointers, aligned to MCPR_ALIGNMENT: it may be copied,
 * written to disk, and used in place when mapped from there. It has the joints of the clip that it
 * was cooked from, in the same order, but not their names and parents. It has the same scalar
 * tracks. */
typedef struct mcpr_cooked mcpr_cooked;

#define MCPR_MOST_DETAIL_BANDS 5

/* Options of cooking. A null pointer means that all are zero. */
typedef struct mcpr_cook_options {
  int apply_ik;   /* 1: apply the clip's IK correction, if it has one, once and for all */
  float ik_error; /* how far, in cm, cooking the correction may move a joint at any frame, beside
                     rounding. 0: not at all, which takes far more memory, see SAMPLING.md */
  int skeleton;   /* 1: keep the joints' names, parents and offsets, about 50 bytes a joint, for
                     mcpr_cooked_joint. Clips in a cooked bank need not: the bank keeps them */
  uint32_t detail_bands; /* 1 to MCPR_MOST_DETAIL_BANDS: how many of the finest bands stay details;
                            coarser ones become samples. With fewer a pose is faster and the clip
                            larger, see SAMPLING.md. 0: 4 or 5, whichever suits memory */
} mcpr_cook_options;

/* The bytes of scratch memory that cooking needs; 0 without a clip. They grow with frames *
 * channels of the longest segment; with apply_ik, of the whole clip. */
MCPR_API size_t mcpr_cook_scratch_bytes(const mcpr_clip* clip, const mcpr_cook_options* options);

/* Sets *bytes to the size of the cooked form. Takes as long as mcpr_cook. Fails with MCPR_LIMIT if
 * the clip has too many channels to be cooked or would take more than 4 GiB. */
MCPR_API mcpr_status mcpr_cook_size(const mcpr_clip* clip, const mcpr_cook_options* options,
                                    void* scratch, size_t scratch_size, size_t* bytes,
                                    mcpr_result* report);

/* Cooks a clip into `memory`, which has the size that mcpr_cook_size returned, and points *cooked
 * to it. The clip is not needed afterwards. Fails as mcpr_cook_size does. */
MCPR_API mcpr_status mcpr_cook(const mcpr_clip* clip, const mcpr_cook_options* options,
                               void* scratch, size_t scratch_size, void* memory, size_t size,
                               const mcpr_cooked** cooked, mcpr_result* report);

/* Does what mcpr_load and mcpr_cook do, in one call. The cooked clip is one piece of memory from
 * the allocator; release it with the allocator. */
MCPR_API mcpr_status mcpr_load_cooked(const void* file, size_t size, const mcpr_limits* limits,
                                      const mcpr_cook_options* options,
                                      const mcpr_allocator* allocator, const mcpr_cooked** cooked,
                                      mcpr_result* report);

/* Opens a block that mcpr_cook made earlier; *cooked points into `memory`. check = 0 reads the head
 * only, and trusts the rest. check = 1 verifies every byte, so that blocks from anywhere are safe
 * to sample. Fails with MCPR_NOT_A_CLIP, MCPR_UNKNOWN_VERSION, MCPR_DAMAGED or MCPR_INVALID. */
MCPR_API mcpr_status mcpr_open_cooked(const void* memory, size_t size, int check,
                                      const mcpr_cooked** cooked, mcpr_result* report);

typedef struct mcpr_cooked_info {
  double sample_rate; /* frames per second */
  uint32_t frames;
  uint32_t joints;
  uint32_t loop_frames;  /* frames in one cycle of a loop, as in mcpr_clip_info; 0: not a loop */
  size_t bytes;          /* size of the whole block */
  size_t skeleton_bytes; /* the part of `bytes` that does not grow with the motion: constant
                            transforms, and tables of which channel moves which joint */
} mcpr_cooked_info;

/* Sets *out to the dimensions of a cooked clip; all zero if `cooked` is null. */
MCPR_API void mcpr_cooked_describe(const mcpr_cooked* cooked, mcpr_cooked_info* out);

/* A joint's local transform. */
typedef struct mcpr_transform {
  float rotation[4];    /* quaternion w x y z, from the joint's space to its parent's */
  float translation[4]; /* the joint's origin x y z in its parent's space (for a root: in world
                           space), in cm; then 0 */
} mcpr_transform;

/* The layout of a sampled pose. */
typedef enum mcpr_layout {
  MCPR_TRANSFORMS = 0, /* one mcpr_transform per joint: 8 floats */
  MCPR_ARRAYS = 1,     /* seven arrays, each with one float per joint: rotation w, x, y, z, then
                          translation x, y, z */
  MCPR_MATRICES = 2, /* 12 floats per joint: a 3 x 4 matrix [rotation | translation], row by row */
  MCPR_FOURS = 3,    /* four joints at a time, as ozz-animation's SoaTransform: 40 floats, one per
                        joint of translation x, y, z, of the rotation's four numbers in the order of
                        the convention, and of scale x, y, z, which is 1. Places after the last
                        joint have no translation and no rotation */
  MCPR_HALVES = 4,   /* mcpr_transform in half floats (IEEE 754 binary16, rounded to nearest): 8
                        uint16_t per joint. Lengths of 512 to 1024 are rounded to multiples of 0.5:
                        ask for metres */
  MCPR_WRITER = 5    /* the output is an mcpr_writer, which receives joint after joint */
} mcpr_layout;

/* Receives a pose joint by joint, for an engine that keeps poses in a form of its own. `write` gets
 * a joint's place in the output, counted up from 0, and its transform, which is valid only during
 * the call. `write` must not throw. */
typedef struct mcpr_writer {
  void (*write)(void* context, uint32_t joint, const mcpr_transform* transform);
  void* context;
} mcpr_writer;

/* The axes, the unit of length and the order of quaternions that an engine wants. If all members
 * are zero: the clip's own convention, which the top of this file describes. */
typedef struct mcpr_convention {
  int8_t axes[3]; /* for each of the engine's axes x y z, the axis of the clip that it is: 1 x, 2 y,
                     3 z; negative: the opposite direction. All zero: 1 2 3 */
  uint8_t w_last; /* 1: quaternions x y z w; 0: w x y z */
  float length;   /* factor on lengths in centimetres: 0.01 gives metres; 0: 1 */
} mcpr_convention;

/* The conventions of some engines. */
typedef enum mcpr_engine {
  MCPR_MOCAPRESS = 0, /* the clip's own */
  MCPR_GLTF = 1,      /* metres, right-handed, y up, x y z w */
  MCPR_GODOT = 2,     /* the same as MCPR_GLTF */
  MCPR_UNITY = 3,     /* metres, left-handed, y up, x y z w: the clip's x is negated */
  MCPR_UNREAL = 4,    /* centimetres, left-handed, z up, x y z w: y and z are exchanged */
  MCPR_BLENDER = 5    /* metres, right-handed, z up, w x y z: x -z y */
} mcpr_engine;

MCPR_API mcpr_status mcpr_convention_of(mcpr_engine engine, mcpr_convention* out,
                                        mcpr_result* report);

/* A subset of a cooked clip's joints, prepared in advance. Sampling a selection is as fast as
 * sampling all joints. A list of joints in the request is slower, because it is looked up in each
 * call. */
typedef struct mcpr_selection mcpr_selection;

/* The most bands of finest details that can be left out, for poses seen from far away. Without 1,
 * 2, 3 or 4 of them, movement faster than about 2, 4, 8 or 16 frames is lost. SAMPLING.md tells the
 * error and the time saved. */
#define MCPR_MOST_BANDS_LEFT_OUT 4

/* A request for sampling. If all members are zero: the transforms of all joints, time in frames,
 * clamped. */
typedef struct mcpr_sample_request {
  mcpr_layout layout;
  mcpr_time unit;
  mcpr_wrap wrap;
  mcpr_path path;
  const uint16_t* joints; /* joints to sample, in any order, without duplicates; null: all */
  uint32_t joint_count;   /* length of `joints`; 0 if that is null */
  const mcpr_selection* selection;   /* a selection of this clip; null: `joints` applies */
  uint32_t bands_left_out;           /* number of finest bands to leave out, 0 to
                                        MCPR_MOST_BANDS_LEFT_OUT */
  const mcpr_convention* convention; /* the engine's; null: the clip's own */
  const int16_t* parents;  /* gives transforms in the character's space instead of the parents': for
                              each joint of the output the place of its parent in the output, which
                              is smaller; -1 keeps a joint as it is. Null: all are kept. A cooked
                              clip has no parents: mcpr_clip_joint and mcpk_joint tell them */
  const uint16_t* stepped; /* joints that jump from frame to frame, such as props that change hands:
                              between two frames they have the transform of the earlier. The clip's
                              numbers; others than those of the output are ignored. All together
                              take the time of another pose at most */
  uint32_t stepped_count;  /* length of `stepped` */
  void* scratch;           /* memory to work in, if mcpr_sample_scratch_bytes() is not 0; not shared
                              by threads at the same time */
  size_t scratch_size;
} mcpr_sample_request;

/* The bytes that a selection of `joint_count` joints takes, about 1.5 KB for 30 joints; 0 without a
 * clip, or if the clip has fewer joints. */
MCPR_API size_t mcpr_selection_bytes(const mcpr_cooked* cooked, uint32_t joint_count);

/* Makes a selection in `memory`, which has mcpr_selection_bytes(), and points *selection to it.
 * Poses list the joints in the order of `joints`, which has no duplicates and is not needed
 * afterwards. Neither the clip nor the selection may be moved after this call. A selection works
 * with its own clip only. */
MCPR_API mcpr_status mcpr_make_selection(const mcpr_cooked* cooked, const uint16_t* joints,
                                         uint32_t joint_count, void* memory, size_t size,
                                         const mcpr_selection** selection, mcpr_result* report);

/* The number of floats, 4 bytes each, that one pose takes; 0 if the request is not possible. */
MCPR_API size_t mcpr_sample_values(const mcpr_cooked* cooked, const mcpr_sample_request* request);

/* The bytes of scratch memory that sampling needs; 0 for a clip of up to 1,100 columns. Columns are
 * the clip's moving channels and a few more: 1,100 suffice for about 350 joints that turn about
 * three axes. A list of joints needs memory, too, and so do stepped joints and the last three
 * layouts. No request needs more than 192 KiB. */
MCPR_API size_t mcpr_sample_scratch_bytes(const mcpr_cooked* cooked,
                                          const mcpr_sample_request* request);

/* Samples the local transforms at one finite instant into mcpr_sample_values() floats. Between two
 * frames, channels are interpolated linearly, as in mcpr_decode_moment; so are angles that a cooked
 * IK correction changed. An instant within 2^-16 frames of a frame gives that frame. Results are
 * within 5e-4 radians and 2e-3 cm of mcpr_decode_moment (with an IK correction: at frames), and all
 * paths give the same bits. */
MCPR_API mcpr_status mcpr_sample(const mcpr_cooked* cooked, const mcpr_sample_request* request,
                                 double time, void* out, mcpr_result* report);

/* Asks the processor to bring the first `bytes` of a cooked clip into its caches
 * (mcpr_cooked_info.bytes: the whole clip), without waiting. Call it for a clip that was not
 * sampled for a while, before another clip is sampled: it then takes half to two thirds of the
 * time, see SAMPLING.md. mcpr_sample_crowd does this itself. Changes nothing; null is ignored. */
MCPR_API void mcpr_prefetch_hint(const mcpr_cooked* cooked, size_t bytes);

/* A cursor caches some frames of a clip around the last instant, which makes playing forwards or
 * backwards faster. Each player needs its own. Instants may be asked for in any order, and the
 * result depends on the instant alone. Results differ from those of mcpr_sample by rounding, within
 * the same bounds. */
typedef struct mcpr_cursor mcpr_cursor;

/* The bytes that a cursor takes, at most 8192; 0 without a clip. */
MCPR_API size_t mcpr_cursor_bytes(const mcpr_cooked* cooked);

/* Makes a cursor in `memory`, which has mcpr_cursor_bytes(), and points *cursor to it. The clip may
 * not be moved after this call. */
MCPR_API mcpr_status mcpr_make_cursor(const mcpr_cooked* cooked, void* memory, size_t size,
                                      mcpr_cursor** cursor, mcpr_result* report);

/* Samples as mcpr_sample does, but uses and updates the frames that the cursor caches. */
MCPR_API mcpr_status mcpr_sample_next(mcpr_cursor* cursor, const mcpr_sample_request* request,
                                      double time, void* out, mcpr_result* report);

/* ---------------------------------------------------------------- a crowd */

/* One of many characters that are posed together. */
typedef struct mcpr_character {
  const mcpr_cooked* clip;
  const mcpr_selection* selection; /* a selection of the clip's joints; null: all */
  double time;                     /* the instant, in the unit of the request */
  void* out; /* room for the pose: mcpr_sample_values() floats; or an mcpr_writer */
  mcpr_wrap wrap;
  uint32_t bands_left_out; /* this and those below: as in mcpr_sample_request */
  const int16_t* parents;
  const uint16_t* stepped;
  uint32_t stepped_count;
} mcpr_character;

/* The settings that all characters share. If all members are zero: transforms, time in frames. */
typedef struct mcpr_crowd_request {
  mcpr_layout layout;
  mcpr_time unit;
  mcpr_path path;
  const mcpr_convention* convention;
  int exact; /* 1: every pose has the bits of mcpr_sample. 0, faster: where many characters play one
                clip, some frames are made once for several, as a cursor does. Then a pose has the
                bits of mcpr_sample or of mcpr_sample_next, depending on the other characters. Both
                are within 5e-4 radians and 2e-3 cm of mcpr_decode_moment on every path */
} mcpr_crowd_request;

/* The bytes of scratch memory that mcpr_sort_crowd needs: about 96 per character. */
MCPR_API size_t mcpr_sort_crowd_scratch_bytes(uint32_t count);

/* Sorts the characters in place, into the order in which mcpr_sample_crowd is fastest: by clip,
 * bands left out, and frame. The order stays nearly right while time advances, so characters need
 * not be sorted at every frame. Fails as mcpr_sample_crowd does. */
MCPR_API mcpr_status mcpr_sort_crowd(const mcpr_crowd_request* request, mcpr_character* characters,
                                     uint32_t count, void* scratch, size_t scratch_size,
                                     mcpr_result* report);

/* The bytes of scratch memory that mcpr_sample_crowd needs: about 320 KB for any number of
 * characters. */
MCPR_API size_t mcpr_crowd_scratch_bytes(void);

/* Samples the pose of each character, as mcpr_sample does. Any order is allowed. Several threads
 * may each take a slice of the array, with their own scratch memory. If a character cannot be
 * posed, nothing is written, and the offset of the report is the index of the first such character.
 */
MCPR_API mcpr_status mcpr_sample_crowd(const mcpr_crowd_request* request,
                                       const mcpr_character* characters, uint32_t count,
                                       void* scratch, size_t scratch_size, mcpr_result* report);

/* ---------------------------------------------------------------- root motion */

/* Computes the motion of one joint, usually the root, between two instants in the unit of the
 * request: *out = inverse(transform at `from`) * (transform at `to`). In a loop the motion of whole
 * cycles is accumulated. `to` may be before `from`. Ignores the layout, joints, selection and
 * parents of the request, but not its convention. Needs the scratch memory of a request with a list
 * of joints. */
MCPR_API mcpr_status mcpr_sample_motion(const mcpr_cooked* cooked,
                                        const mcpr_sample_request* request, uint32_t joint,
                                        double from, double to, mcpr_transform* out,
                                        mcpr_result* report);

/* As mcpr_sample_motion, but only for the part of the motion that mcpr_split_root takes out of a
 * pose: the movement on the ground and the turn about the axis that points up. */
MCPR_API mcpr_status mcpr_sample_ground_motion(const mcpr_cooked* cooked,
                                               const mcpr_sample_request* request, uint32_t joint,
                                               double from, double to, mcpr_transform* out,
                                               mcpr_result* report);

/* ---------------------------------------------------------------- skeletons */

/* Describes a joint of a cooked clip, if it was cooked with mcpr_cook_options.skeleton.
 * `first_channel`, `channels` and `kinds` are 0. */
MCPR_API mcpr_status mcpr_cooked_joint(const mcpr_cooked* cooked, uint32_t joint, mcpr_joint* out,
                                       mcpr_result* report);

/* Return a hash that identifies a skeleton: 64 bits made from names, parents, offsets and end sites
 * of all joints. A clip, its cooked form and its copy in a bank have the same hash, on every
 * machine. 0: no clip, or a cooked clip that has no skeleton. Takes time in proportion to the
 * joints: keep the result. */
MCPR_API uint64_t mcpr_skeleton_hash(const mcpr_clip* clip);
MCPR_API uint64_t mcpr_cooked_skeleton_hash(const mcpr_cooked* cooked);

/* An engine's skeleton. */
typedef struct mcpr_skeleton {
  uint32_t joints;          /* at most 32767 */
  const char* const* names; /* zero-terminated, one per joint */
  const int16_t* parents;   /* -1: a root; may be null, but then mcpr_map_gaps.moved is 0 */
} mcpr_skeleton;

/* The differences between the joints of a clip and of an engine's skeleton. */
typedef struct mcpr_map_gaps {
  uint32_t missing; /* joints of the skeleton that the clip does not have: they get the bind pose */
  uint32_t unused;  /* joints of the clip that the skeleton does not have: they are left out */
  uint32_t moved;   /* joints of both that have another parent in the clip. Their transforms are in
                       the space of that parent: retarget the clip, or the joints will be in wrong
                       places */
} mcpr_map_gaps;

/* Finds the joints of an engine's skeleton in a clip by their names, compared byte for byte. Sets
 * map[j] to the number of the clip's first joint that has the name of joint j, or to -1 if there is
 * none. Takes joints * joints comparisons: do it once for each skeleton, not for each clip. The
 * second function needs a clip cooked with mcpr_cook_options.skeleton. */
MCPR_API mcpr_status mcpr_map_joints(const mcpr_clip* clip, const mcpr_skeleton* skeleton,
                                     int16_t* map, mcpr_map_gaps* gaps, mcpr_result* report);
MCPR_API mcpr_status mcpr_map_cooked_joints(const mcpr_cooked* cooked,
                                            const mcpr_skeleton* skeleton, int16_t* map,
                                            mcpr_map_gaps* gaps, mcpr_result* report);

/* Transfers a clip's pose of `clip_joints` joints to an engine's skeleton of `joints` joints. Joint
 * j takes the transform of the clip's joint map[j], or that of the bind pose if map[j] is -1.
 * `bind` has one transform per joint of the skeleton, in the pose's convention. `out` overlaps
 * neither pose. */
MCPR_API mcpr_status mcpr_remap_pose(const int16_t* map, uint32_t joints,
                                     const mcpr_transform* bind, const mcpr_transform* pose,
                                     uint32_t clip_joints, mcpr_transform* out,
                                     mcpr_result* report);

/* ---------------------------------------------------------------- blending */

/* Poses are blended as arrays of mcpr_transform, one per joint, in the parents' spaces: as
 * mcpr_sample gives them with MCPR_TRANSFORMS and without `parents`. All poses of a call have the
 * same joints in the same order. Rotations are unit quaternions; q and -q count as the same.
 * README.md shows how the functions work together. They use arithmetic alone and give the same bits
 * on every machine. */
typedef struct mcpr_pose_form {
  uint32_t joints;                   /* transforms in each pose */
  const mcpr_convention* convention; /* that of the poses; null: the clip's own */
} mcpr_pose_form;

/* A pose that goes into a blend, with its weight. */
typedef struct mcpr_weighted_pose {
  const mcpr_transform* pose;
  float weight;
  const float* joint_weights; /* a mask: one number per joint, multiplied to `weight`; null: 1 */
} mcpr_weighted_pose;

/* Blends poses: *out = the sum of weight * pose, divided by the sum of the weights, joint by joint.
 * So weights need not add up to 1. Rotations are added as quaternions, and the sum is normalised;
 * each rotation takes the sign that is nearer to the sum of those before it. Weights are 0 to 10^6;
 * weights below 10^-6 count as 0. If only one pose counts for a joint, the joint takes its
 * transform bit by bit; if none counts, that of the first pose. `out` may be one of the poses. */
MCPR_API mcpr_status mcpr_blend(const mcpr_pose_form* form, const mcpr_weighted_pose* poses,
                                uint32_t count, mcpr_transform* out, mcpr_result* report);

/* Lays a pose over another: each joint of `pose` moves towards `layer` by its weight, 0 to 1;
 * rotations go the shorter way round. Weight 0 leaves a joint as it is, weight 1 copies that of the
 * layer. */
MCPR_API mcpr_status mcpr_blend_layer(const mcpr_pose_form* form, const mcpr_weighted_pose* layer,
                                      mcpr_transform* pose, mcpr_result* report);

/* Sets *out to the difference between a pose and a base pose: rotation * inverse(base rotation),
 * and the difference of the translations. `out` may be `pose` or `base`. */
MCPR_API mcpr_status mcpr_pose_difference(const mcpr_pose_form* form, const mcpr_transform* pose,
                                          const mcpr_transform* base, mcpr_transform* out,
                                          mcpr_result* report);

/* Adds a difference from mcpr_pose_difference to a pose: rotation = difference * rotation,
 * translation = translation + difference. With a weight, 0 to 1, only a part is added: the rotation
 * is interpolated from no turn to the whole difference, the shorter way round. */
MCPR_API mcpr_status mcpr_blend_additive(const mcpr_pose_form* form,
                                         const mcpr_weighted_pose* difference, mcpr_transform* pose,
                                         mcpr_result* report);

/* Takes the movement on the ground out of a root's transform: root before = *ground * root after.
 * *ground has the place on the ground and the turn about the axis that points up; the root keeps
 * its height and its tilt. If a root lies so that it faces nowhere, *ground does not turn. */
MCPR_API mcpr_status mcpr_split_root(const mcpr_convention* convention, mcpr_transform* root,
                                     mcpr_transform* ground, mcpr_result* report);

/* The rule for mirroring a joint. */
typedef struct mcpr_mirror_joint {
  uint16_t partner; /* the joint whose mirror image it takes */
  float before[4];  /* constant rotations before and after that image, w x y z */
  float after[4];
} mcpr_mirror_joint;

/* Prepares mirroring of a skeleton. `bind` is a pose in which the skeleton is symmetric, such as a
 * T-pose; its rotations may be of any kind. `parents` gives each joint's parent, which comes before
 * it; -1: a root. `partners` gives each joint's counterpart on the other side; for joints in the
 * middle, themselves. `axis` is the axis from side to side, 0 1 2 for x y z, in the poses' own
 * convention. Writes one mcpr_mirror_joint per joint. Fails with MCPR_ARGUMENT if the partner of a
 * joint's partner is not the joint itself, or if partners do not hang from partners. */
MCPR_API mcpr_status mcpr_make_mirror(const mcpr_pose_form* form, const mcpr_transform* bind,
                                      const int16_t* parents, const uint16_t* partners, int axis,
                                      mcpr_mirror_joint* mirror, mcpr_result* report);

/* Mirrors a pose at the plane through the origin that is perpendicular to `axis`. mcpr_make_mirror
 * has prepared `mirror` for the same axis. `out` and `pose` do not overlap. */
MCPR_API mcpr_status mcpr_mirror_pose(const mcpr_pose_form* form, const mcpr_mirror_joint* mirror,
                                      int axis, const mcpr_transform* pose, mcpr_transform* out,
                                      mcpr_result* report);

/* ---------------------------------------------------------------- tracks */

/* The meaning of a scalar track: a number without a unit that changes over time. */
typedef enum mcpr_track_kind {
  MCPR_TRACK_PROPERTY = 0,     /* a custom property, an IK curve or an event curve */
  MCPR_TRACK_MORPH_WEIGHT = 1, /* weight of a morph target: 0: none, 1: full */
  MCPR_TRACK_SCALE_X = 2,      /* scale of a joint relative to its parent. MCPR_LOCAL already
                                  places the joints below accordingly: apply it to the skin only */
  MCPR_TRACK_SCALE_Y = 3,
  MCPR_TRACK_SCALE_Z = 4
} mcpr_track_kind;

/* A scalar track. Strings are UTF-8, zero-terminated, in the clip's memory. */
typedef struct mcpr_track {
  const char* node; /* the joint or mesh node that the track belongs to; empty: the clip */
  const char* name; /* the property or the morph target; empty for a scale */
  mcpr_track_kind kind;
  int steps; /* 1: holds the value of the earlier frame between two frames; 0: interpolates */
} mcpr_track;

/* The scalar tracks of a clip, in the clip's memory. */
typedef struct mcpr_tracks mcpr_tracks;

/* The tracks of a built or of a cooked clip; both have exactly the same values. Null if the clip
 * has no tracks; the functions below accept null. */
MCPR_API const mcpr_tracks* mcpr_clip_tracks(const mcpr_clip* clip);
MCPR_API const mcpr_tracks* mcpr_cooked_tracks(const mcpr_cooked* cooked);

/* The number of tracks; 0 for null. */
MCPR_API uint32_t mcpr_track_count(const mcpr_tracks* tracks);

MCPR_API mcpr_status mcpr_track_describe(const mcpr_tracks* tracks, uint32_t track, mcpr_track* out,
                                         mcpr_result* report);

/* The index of the first track with this kind, node and name, compared byte for byte; -1 if there
 * is none. If node or name is null, any node or name matches. Searches all tracks. */
MCPR_API int32_t mcpr_find_track(const mcpr_tracks* tracks, mcpr_track_kind kind, const char* node,
                                 const char* name);

/* A request for tracks. If all members are zero: every track, instants in frames, clamped. */
typedef struct mcpr_track_request {
  const uint16_t* tracks; /* tracks to decode, in any order, without duplicates; null: all */
  uint32_t track_count;   /* length of `tracks`; 0 if that is null */
  double sample_rate;     /* for instants in seconds: frames per second, those of the clip. 0:
                             instants are in frames. Below 0: not possible */
  mcpr_wrap wrap;         /* for instants */
} mcpr_track_request;

/* The number of floats that one frame takes, one per track; 0 if the request is not possible. */
MCPR_API size_t mcpr_track_values(const mcpr_tracks* tracks, const mcpr_track_request* request);

/* The bytes of scratch memory that the next two functions need. If that is 0, `scratch` may be
 * null. */
MCPR_API size_t mcpr_track_scratch_bytes(const mcpr_tracks* tracks,
                                         const mcpr_track_request* request);

/* Decodes frames `first` to `first + count - 1` into `out`, frame after frame: count rows of
 * mcpr_track_values() floats. */
MCPR_API mcpr_status mcpr_track_frames(const mcpr_tracks* tracks, const mcpr_track_request* request,
                                       uint32_t first, uint32_t count, float* out, void* scratch,
                                       size_t scratch_size, mcpr_result* report);

/* Decodes the tracks at one finite instant into mcpr_track_values() floats. A track that does not
 * step is interpolated linearly between frames, and from the last frame to the first as the wrap
 * says. */
MCPR_API mcpr_status mcpr_track_moment(const mcpr_tracks* tracks, const mcpr_track_request* request,
                                       double time, float* out, void* scratch, size_t scratch_size,
                                       mcpr_result* report);

/* A change in the value of a track that steps, such as a switch. */
typedef struct mcpr_change {
  double time;    /* the frame of the change, in the unit of the request; beyond the clip's frames,
                     it is in another cycle */
  uint32_t track; /* the track's place in the request, or its number if all tracks were asked for */
  float value;    /* the value after the change, on the way from `from` to `to` */
} mcpr_change;

/* Lists the changes of the tracks that step, on the way from one instant to another, for events: at
 * the frames in (from, to], or, if `to` is earlier, at those in (to, from], latest first. So if
 * each call starts where the previous one ended, every change is listed once. Sets *count to the
 * number of changes, and writes at most `capacity` of them; `changes` may be null if `capacity` is
 * 0. Takes time in proportion to the number of frames in between. Fails with MCPR_ARGUMENT if these
 * are more than 2^22, or if an instant is beyond frame 2^52. On the way back of MCPR_PING_PONG, the
 * value of mcpr_track_moment changes just behind the frame of a change, not at the frame. */
MCPR_API mcpr_status mcpr_track_changes(const mcpr_tracks* tracks,
                                        const mcpr_track_request* request, double from, double to,
                                        mcpr_change* changes, uint32_t capacity, uint32_t* count,
                                        mcpr_result* report);

/* ---------------------------------------------------------------- banks */

/* Many clips in one file, .mcpk, which stores only once what clips share (skeletons, tags, parts of
 * names). A packed bank holds compressed clips, which mcpk_read decodes as mcpr_read decodes a
 * file. A cooked bank holds cooked clips, which mcpk_cooked gives in place. An mcpk_bank is the
 * bytes of the file, aligned to MCPR_ALIGNMENT, in memory or mapped from disk; they must stay there
 * while the bank is in use. If somebody cuts a mapped file short meanwhile, a signal (SIGBUS) ends
 * the program, as with any mapped file: replace banks instead of writing into them, or read them
 * into memory. Clips are numbered in the byte order of their names. Any number of threads may use a
 * bank. A function that needs the other form of bank gives MCPR_ARGUMENT, a damaged index
 * MCPR_DAMAGED. */
typedef struct mcpk_bank mcpk_bank;

/* Longest name of a clip, in bytes, with its terminating zero. */
#define MCPK_NAME_BYTES 256

/* Opens a bank; *bank points to `memory`. check = 0 reads the head only, in the same time for any
 * number of clips, and trusts the rest. check = 1 verifies every byte, so that banks from anywhere
 * are safe to use. check = 2 verifies everything but the clips, which may be loaded later: see
 * mcpk_place. Fails as mcpr_open_cooked does. */
MCPR_API mcpr_status mcpk_open(const void* memory, size_t size, int check, const mcpk_bank** bank,
                               mcpr_result* report);

typedef struct mcpk_info {
  uint64_t bytes; /* size of the whole bank */
  uint32_t clips;
  uint32_t tags;      /* number of different tags */
  uint32_t texts;     /* number of key-value pairs */
  int is_cooked;      /* 1: cooked, 0: packed */
  size_t table_bytes; /* the part of `bytes` that cooked clips share; 0 in a packed bank */
  uint32_t skeletons; /* numbers of skeletons are below this: see mcpk_skeleton. A cooked bank has
                         as many skeletons; in a packed bank some of the numbers have no skeleton */
} mcpk_info;

/* Sets *out to the dimensions of a bank; all zero if `bank` is null. */
MCPR_API void mcpk_describe(const mcpk_bank* bank, mcpk_info* out);

/* The number of the clip with this name; -1 if there is none. Compares about log2(clips) names. */
MCPR_API int32_t mcpk_find(const mcpk_bank* bank, const char* name);

/* Copies the name of a clip, zero-terminated, to `name`, which has room for MCPK_NAME_BYTES.
 * Returns the length without the zero; 0 if there is no such clip. */
MCPR_API size_t mcpk_name(const mcpk_bank* bank, uint32_t clip, char* name);

/* Tag `number` of a clip, in the bank's memory; null if the clip has fewer. */
MCPR_API const char* mcpk_tag(const mcpk_bank* bank, uint32_t clip, uint32_t number);

/* Key and value of pair `number` of the bank, in its memory; null if it has fewer. */
MCPR_API const char* mcpk_key(const mcpk_bank* bank, uint32_t number);
MCPR_API const char* mcpk_value(const mcpk_bank* bank, uint32_t number);

/* The number of bytes at the start of a bank that mcpk_open reads with check = 0. */
#define MCPK_HEAD_BYTES 104

/* Tells where the bytes of a clip are, counted from the beginning of the bank. With `clip` =
 * mcpk_info.clips, tells where the shared data is, which follows all clips. So single clips of a
 * bank can be loaded, for example from a server: load the head, and open it with check = 0 and the
 * size of the whole bank; load the shared data to its place, and open the bank with check = 2; then
 * load clips to their places, and call mcpk_check before using one. Memory between these places is
 * not read. */
MCPR_API mcpr_status mcpk_place(const mcpk_bank* bank, uint32_t clip, uint64_t* offset,
                                uint64_t* bytes, mcpr_result* report);

/* The largest number of tiers of any clip in the bank; 1 if the bank has no tiers, as cooked banks
 * do; 0 if `bank` is null. Unless `present` is null, sets *present to the number of tiers that the
 * bank still has: it may have been cut short after any tier. Reads the data that follows the clips,
 * which has to be loaded. */
MCPR_API uint32_t mcpk_tiers(const mcpk_bank* bank, uint32_t* present);

/* Tells where the piece is that a tier adds to a clip, 0 < tier < mcpk_tiers(), counted from the
 * beginning of the bank, even if the piece is not loaded. *bytes is 0 if the clip has no such tier.
 * With `clip` = mcpk_info.clips, tells where the pieces of all clips are in this tier. Tier 0 of a
 * clip is where mcpk_place says. Load the pieces to their places in any order, but read a clip with
 * mcpr_limits.tiers = k only when its tiers 0 to k - 1 are there. */
MCPR_API mcpr_status mcpk_tier_place(const mcpk_bank* bank, uint32_t clip, uint32_t tier,
                                     uint64_t* offset, uint64_t* bytes, mcpr_result* report);

/* Verifies a clip that was loaded after its bank was opened, so that the clip is safe to use. A
 * packed clip has no checksum of its own: if damage leaves its structure valid, another motion is
 * decoded. */
MCPR_API mcpr_status mcpk_check(const mcpk_bank* bank, uint32_t clip, mcpr_result* report);

/* Do what mcpr_inspect and mcpr_read do, for a clip of a packed bank. mcpr_build then makes the
 * clip. */
MCPR_API mcpr_status mcpk_inspect(const mcpk_bank* bank, uint32_t clip, const mcpr_limits* limits,
                                  mcpr_info* info, mcpr_result* report);
MCPR_API mcpr_status mcpk_read(const mcpk_bank* bank, uint32_t clip, const mcpr_limits* limits,
                               void* scratch, size_t scratch_size, size_t* resident_bytes,
                               mcpr_result* report);

/* Do what mcpr_load and mcpr_load_cooked do, for a clip of a packed bank or its first tiers. */
MCPR_API mcpr_status mcpk_load(const mcpk_bank* bank, uint32_t clip, const mcpr_limits* limits,
                               const mcpr_allocator* allocator, const mcpr_clip** loaded,
                               mcpr_result* report);
MCPR_API mcpr_status mcpk_load_cooked(const mcpk_bank* bank, uint32_t clip,
                                      const mcpr_limits* limits, const mcpr_cook_options* options,
                                      const mcpr_allocator* allocator, const mcpr_cooked** cooked,
                                      mcpr_result* report);

/* Points *cooked to a clip of a cooked bank, in the bank's memory. */
MCPR_API mcpr_status mcpk_cooked(const mcpk_bank* bank, uint32_t clip, const mcpr_cooked** cooked,
                                 mcpr_result* report);

/* The number of a clip's skeleton, below mcpk_info.skeletons; -1 if there is no such clip, or if,
 * in a packed bank from elsewhere, the clip shares its skeleton with no other clip. Clips with the
 * same number have the same skeleton: the same names, parents and offsets. In a cooked bank, clips
 * with different numbers have different skeletons. In a packed bank these may be the same but for
 * their channels: once the clips are built, mcpr_skeleton_hash tells. */
MCPR_API int32_t mcpk_skeleton(const mcpk_bank* bank, uint32_t clip);

/* Describes a joint as mcpr_cooked_joint does, for a clip of a cooked bank; the name is in the
 * bank's memory. */
MCPR_API mcpr_status mcpk_joint(const mcpk_bank* bank, uint32_t clip, uint32_t joint,
                                mcpr_joint* out, mcpr_result* report);

/* Finds a joint as mcpr_find_joint does, for a clip of a cooked bank. */
MCPR_API int32_t mcpk_find_joint(const mcpk_bank* bank, uint32_t clip, const char* name);

/* Do what mcpr_skeleton_hash and mcpr_map_joints do, for a clip of a cooked bank. */
MCPR_API uint64_t mcpk_skeleton_hash(const mcpk_bank* bank, uint32_t clip);
MCPR_API mcpr_status mcpk_map_joints(const mcpk_bank* bank, uint32_t clip,
                                     const mcpr_skeleton* skeleton, int16_t* map,
                                     mcpr_map_gaps* gaps, mcpr_result* report);

#ifdef __cplusplus
}
#endif

#endif
