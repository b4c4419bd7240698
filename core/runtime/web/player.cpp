// SPDX-License-Identifier: MIT
// The functions of the runtime that mocapress.js calls. They take numbers and addresses only, so
// that a WebAssembly module can export them. MOCAPRESS_COOKED_ALONE leaves out the functions that
// decode .mcpr files and packed banks.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#include "core/runtime/mocapress_runtime.hpp"

namespace {

// mocapress.js reads these structs at their byte offsets.
struct Dimensions {
  double sample_rate;
  double frames;
  double joints;
  double loop_frames;
  double tracks;
};
struct JointRecord {
  const char* name;
  std::int32_t parent;
  float offset[3];
  std::int32_t has_end_site;
  float end_site[3];
};
struct TrackRecord {
  std::int32_t kind;
  const char* node;
  const char* name;
  std::int32_t steps;
};

/// Error message of the last call that failed. Each thread runs a module of its own, with its own
/// message.
char last_error[256];

void set_error(const char* message) {
  std::strncpy(last_error, message, sizeof last_error - 1);
}

mcpr_result report;  // from the last call

bool succeeded(mcpr_status status) {
  if (status == MCPR_OK) return true;
  set_error(report.message);
  return false;
}

constexpr const char* kNoMemory = "there is not enough memory for the clip";

/// Aligned memory for the runtime.
class Memory {
 public:
  Memory() = default;
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  ~Memory() { std::free(data_); }

  /// Allocates the memory; called once.
  bool reserve(std::size_t bytes) {
    size_ = (bytes / MCPR_ALIGNMENT + 1) * MCPR_ALIGNMENT;
    if (bytes <= SIZE_MAX / 2) data_ = std::aligned_alloc(MCPR_ALIGNMENT, size_);
    if (data_ == nullptr) set_error(kNoMemory);
    return data_ != nullptr;
  }
  void* data() const { return data_; }
  std::size_t size() const { return size_; }
  float* floats() const { return static_cast<float*>(data_); }

 private:
  void* data_ = nullptr;
  std::size_t size_ = 0;
};

constexpr mcpr_track_request kAllTracks = {};

/// A cooked clip: either one of a cooked bank, or one that this class has cooked.
class Clip {
 public:
  /// Decodes and cooks a clip by calling `inspect` and `read`. These know whether the clip is a
  /// file or lies in a packed bank.
  template <typename Inspect, typename Read>
  bool open(const Inspect& inspect, const Read& read) {
    Memory scratch;
    mcpr_info info;
    std::size_t bytes = 0;
    if (!succeeded(inspect(&info)) || !scratch.reserve(info.read_bytes) ||
        !succeeded(read(scratch.data(), info.read_bytes, &bytes)) || !resident_.reserve(bytes) ||
        !succeeded(
            mcpr_build(scratch.data(), info.read_bytes, resident_.data(), bytes, &clip_, &report)))
      return false;
    error_ = info.error;
    const mcpr_clip_info described = mcpr::describe(clip_);
    dimensions_.sample_rate = described.sample_rate;
    dimensions_.frames = described.frames;
    dimensions_.joints = described.joints;
    dimensions_.loop_frames = described.loop_frames;
    return cook() && prepare_tracks();
  }

  /// Opens a clip of a cooked bank, and samples it in the bank's memory.
  bool open_cooked(const mcpk_bank* bank, std::uint32_t number) {
    bank_ = bank;
    number_ = number;
    if (!succeeded(mcpk_cooked(bank, number, &cooked_, &report))) return false;
    const mcpr_cooked_info described = mcpr::describe(cooked_);
    dimensions_.sample_rate = described.sample_rate;
    dimensions_.frames = described.frames;
    dimensions_.joints = described.joints;
    dimensions_.loop_frames = described.loop_frames;
    return prepare_tracks();
  }

  const mcpr_cooked* cooked() const { return cooked_; }
  const Dimensions& dimensions() const { return dimensions_; }

  const JointRecord* joint(std::uint32_t number) {
    mcpr_joint joint;
    if (!succeeded(clip_ != nullptr ? mcpr_clip_joint(clip_, number, &joint, &report)
                                    : mcpk_joint(bank_, number_, number, &joint, &report)))
      return nullptr;
    joint_.name = joint.name;
    joint_.parent = joint.parent;
    std::memcpy(joint_.offset, joint.offset, sizeof joint.offset);
    joint_.has_end_site = joint.has_end_site;
    std::memcpy(joint_.end_site, joint.end_site, sizeof joint.end_site);
    return &joint_;
  }

  const TrackRecord* track(std::uint32_t number) {
    mcpr_track track;
    if (!succeeded(mcpr_track_describe(tracks_, number, &track, &report))) return nullptr;
    track_ = {track.kind, track.node, track.name, track.steps};
    return &track_;
  }

  const float* sample_tracks(double frame, mcpr_wrap wrap) {
    mcpr_track_request request = kAllTracks;
    request.wrap = wrap;
    return succeeded(mcpr_track_moment(tracks_, &request, frame, track_values_.floats(),
                                       track_scratch_.data(), track_scratch_.size(), &report))
               ? track_values_.floats()
               : nullptr;
  }

#ifndef MOCAPRESS_COOKED_ALONE
  bool is_decoded() const {
    return clip_ != nullptr;
  }

  /// Decodes frames in the layout of MCPR_LOCAL.
  bool decode(std::uint32_t first, std::uint32_t count, float* out) const {
    mcpr_request request = {};
    request.output = MCPR_LOCAL;
    request.apply_ik = 1;
    Memory scratch;
    return scratch.reserve(mcpr_scratch_bytes(clip_, &request)) &&
           succeeded(mcpr_decode_frames(clip_, &request, first, count, out, scratch.data(),
                                        scratch.size(), &report));
  }
#endif

 private:
  bool cook() {
    mcpr_cook_options options = {};
    options.apply_ik = 1;
    options.ik_error = error_;  // with an error of 0, the cooked clip would take up to ten times
                                // the memory
    const std::size_t scratch_bytes = mcpr_cook_scratch_bytes(clip_, &options);
    Memory scratch;
    std::size_t bytes = 0;
    return scratch.reserve(scratch_bytes) &&
           succeeded(
               mcpr_cook_size(clip_, &options, scratch.data(), scratch_bytes, &bytes, &report)) &&
           block_.reserve(bytes) &&
           succeeded(mcpr_cook(clip_, &options, scratch.data(), scratch_bytes, block_.data(), bytes,
                               &cooked_, &report));
  }

  bool prepare_tracks() {
    tracks_ = mcpr_cooked_tracks(cooked_);
    dimensions_.tracks = mcpr_track_count(tracks_);
    return track_values_.reserve(sizeof(float) * mcpr_track_count(tracks_)) &&
           track_scratch_.reserve(mcpr_track_scratch_bytes(tracks_, &kAllTracks));
  }

  const mcpr_clip* clip_ = nullptr;  // null: the clip belongs to a cooked bank
  const mcpk_bank* bank_ = nullptr;
  std::uint32_t number_ = 0;
  const mcpr_cooked* cooked_ = nullptr;
  const mcpr_tracks* tracks_ = nullptr;
  Dimensions dimensions_ = {};
  float error_ = 0;  // root-mean-square error that the file states, in cm; 0: not known
  JointRecord joint_ = {};
  TrackRecord track_ = {};
  Memory resident_;
  Memory block_;
  Memory track_values_;
  Memory track_scratch_;
};

/// One character that plays a clip.
class Player {
 public:
  bool play(const mcpr_cooked* cooked, std::size_t joints) {
    const std::size_t bytes = mcpr_cursor_bytes(cooked);
    return pose_.reserve(sizeof(mcpr_transform) * joints) && memory_.reserve(bytes) &&
           succeeded(mcpr_make_cursor(cooked, memory_.data(), bytes, &cursor_, &report));
  }

  /// Returns one mcpr_transform for each joint.
  const float* sample(double seconds, mcpr_wrap wrap, std::uint32_t bands_left_out) {
    mcpr_sample_request request = {};
    request.unit = MCPR_SECONDS;
    request.wrap = wrap;
    request.bands_left_out = bands_left_out;
    return succeeded(mcpr_sample_next(cursor_, &request, seconds, pose_.floats(), &report))
               ? pose_.floats()
               : nullptr;
  }

 private:
  mcpr_cursor* cursor_ = nullptr;
  Memory memory_;
  Memory pose_;
};

template <typename T>
void destroy(T* object) {
  object->~T();
  std::free(object);
}

/// Returns a new object if `open` succeeds on it, else null.
template <typename T, typename Open>
T* made(const Open& open) {
  void* const memory = std::malloc(sizeof(T));
  if (memory == nullptr) {
    set_error(kNoMemory);
    return nullptr;
  }
  T* const object = new (memory) T;
  if (open(*object)) return object;
  destroy(object);
  return nullptr;
}

}  // namespace

#define MOCAPRESS_EXPORT extern "C" __attribute__((visibility("default"), used))

// These functions return null on failure; web_error() then tells the reason.

MOCAPRESS_EXPORT const char* web_error() {
  return last_error;
}

MOCAPRESS_EXPORT void* web_allocate(std::size_t bytes) {
  if (bytes > SIZE_MAX / 2) return nullptr;
  return std::aligned_alloc(MCPR_ALIGNMENT, (bytes / MCPR_ALIGNMENT + 1) * MCPR_ALIGNMENT);
}

MOCAPRESS_EXPORT void web_free(void* memory) {
  std::free(memory);
}

/// Opens a bank, whose bytes must stay in place while the bank or a clip of it is in use.
MOCAPRESS_EXPORT const mcpk_bank* web_open_bank(const void* memory, std::size_t size) {
  const mcpk_bank* bank = nullptr;
  return succeeded(mcpk_open(memory, size, 1, &bank, &report)) ? bank : nullptr;
}

/// Opens the head of a bank whose other bytes have not been loaded yet.
MOCAPRESS_EXPORT const mcpk_bank* web_open_head(const void* memory) {
  const mcpk_bank* bank = nullptr;
  return succeeded(mcpk_open(memory, SIZE_MAX, 0, &bank, &report)) ? bank : nullptr;
}

/// Opens a bank whose clips have not been loaded yet. The memory has room for the whole bank.
MOCAPRESS_EXPORT const mcpk_bank* web_open_shared(const void* memory, std::size_t size) {
  const mcpk_bank* bank = nullptr;
  return succeeded(mcpk_open(memory, size, 2, &bank, &report)) ? bank : nullptr;
}

/// Returns two numbers: the offset and the size of the bytes that a tier adds to a clip. In tier 0,
/// the number after the last clip stands for the data that follows all clips.
MOCAPRESS_EXPORT const double* web_place(const mcpk_bank* bank, std::uint32_t number,
                                         std::uint32_t tier) {
  static double place[2];
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
  if (!succeeded(mcpk_tier_place(bank, number, tier, &offset, &bytes, &report))) return nullptr;
  place[0] = static_cast<double>(offset);
  place[1] = static_cast<double>(bytes);
  return place;
}

/// Verifies a clip that was loaded later. Returns 0 on failure.
MOCAPRESS_EXPORT int web_check(const mcpk_bank* bank, std::uint32_t number) {
  return succeeded(mcpk_check(bank, number, &report)) ? 1 : 0;
}

MOCAPRESS_EXPORT double web_bank_bytes(const mcpk_bank* bank) {
  return static_cast<double>(mcpr::describe(bank).bytes);
}

/// Returns the number of tiers that the bank still has.
MOCAPRESS_EXPORT std::uint32_t web_bank_tiers(const mcpk_bank* bank) {
  std::uint32_t present = 0;
  mcpk_tiers(bank, &present);
  return present;
}

MOCAPRESS_EXPORT std::uint32_t web_bank_clips(const mcpk_bank* bank) {
  return mcpr::describe(bank).clips;
}

MOCAPRESS_EXPORT int web_bank_is_cooked(const mcpk_bank* bank) {
  return mcpr::describe(bank).is_cooked;
}

MOCAPRESS_EXPORT const char* web_bank_name(const mcpk_bank* bank, std::uint32_t number) {
  static char name[MCPK_NAME_BYTES];
  return mcpk_name(bank, number, name) > 0 ? name : nullptr;
}

/// Returns a tag of a clip; null after the last one.
MOCAPRESS_EXPORT const char* web_bank_tag(const mcpk_bank* bank, std::uint32_t clip,
                                          std::uint32_t number) {
  return mcpk_tag(bank, clip, number);
}

MOCAPRESS_EXPORT Clip* web_open_cooked(const mcpk_bank* bank, std::uint32_t number) {
  return made<Clip>([&](Clip& clip) { return clip.open_cooked(bank, number); });
}

#ifndef MOCAPRESS_COOKED_ALONE

/// Returns the number of tiers of a file, of which only the first bytes need to be loaded; 0 if it
/// has no tiers, -1 on failure.
MOCAPRESS_EXPORT int web_tiers(const void* file, std::size_t size) {
  mcpr_tier tier;
  int count = 0;
  while (mcpr_tier_of(file, size, static_cast<std::uint32_t>(count), &tier, &report) == MCPR_OK)
    ++count;
  return report.status == MCPR_ARGUMENT || succeeded(report.status) ? count : -1;
}

/// Returns three numbers about a tier: its bytes from the file's start, its root-mean-square error
/// and its largest error, both in cm.
MOCAPRESS_EXPORT const double* web_tier(const void* file, std::size_t size, std::uint32_t number) {
  static double numbers[3];
  mcpr_tier tier;
  if (!succeeded(mcpr_tier_of(file, size, number, &tier, &report))) return nullptr;
  numbers[0] = static_cast<double>(tier.bytes);
  numbers[1] = static_cast<double>(tier.error);
  numbers[2] = static_cast<double>(tier.max_error);
  return numbers;
}

/// Opens a file or, if tiers > 0, only its first tiers; the file may then end after these. The file
/// is not needed afterwards.
MOCAPRESS_EXPORT Clip* web_open(const void* file, std::size_t size, std::uint32_t tiers) {
  mcpr_limits limits = mcpr::default_limits();
  limits.tiers = tiers;
  return made<Clip>([&](Clip& clip) {
    return clip.open(
        [&](mcpr_info* info) { return mcpr_inspect(file, size, &limits, info, &report); },
        [&](void* scratch, std::size_t bytes, std::size_t* resident_bytes) {
          return mcpr_read(file, size, &limits, scratch, bytes, resident_bytes, &report);
        });
  });
}

/// Opens a clip of a packed bank or, if tiers > 0, only its first tiers.
MOCAPRESS_EXPORT Clip* web_open_packed(const mcpk_bank* bank, std::uint32_t number,
                                       std::uint32_t tiers) {
  mcpr_limits limits = mcpr::default_limits();
  limits.tiers = tiers;
  return made<Clip>([&](Clip& clip) {
    return clip.open(
        [&](mcpr_info* info) { return mcpk_inspect(bank, number, &limits, info, &report); },
        [&](void* scratch, std::size_t bytes, std::size_t* resident_bytes) {
          return mcpk_read(bank, number, &limits, scratch, bytes, resident_bytes, &report);
        });
  });
}

/// Returns 1 if frames of the clip can be decoded; 0 for a clip of a cooked bank, which can only be
/// sampled.
MOCAPRESS_EXPORT int web_is_decoded(const Clip* clip) {
  return clip->is_decoded() ? 1 : 0;
}

/// Writes seven floats for each joint and frame. Returns 0 on failure.
MOCAPRESS_EXPORT int web_decode(const Clip* clip, std::uint32_t first, std::uint32_t count,
                                float* out) {
  return clip->decode(first, count, out) ? 1 : 0;
}

#endif

/// Closes a clip. Its players must be closed before.
MOCAPRESS_EXPORT void web_close(Clip* clip) {
  destroy(clip);
}

MOCAPRESS_EXPORT const Dimensions* web_dimensions(const Clip* clip) {
  return &clip->dimensions();
}

MOCAPRESS_EXPORT const JointRecord* web_joint(Clip* clip, std::uint32_t number) {
  return clip->joint(number);
}

MOCAPRESS_EXPORT const TrackRecord* web_track(Clip* clip, std::uint32_t number) {
  return clip->track(number);
}

// `wrap` is the number of an mcpr_wrap.

/// Returns one float for each track.
MOCAPRESS_EXPORT const float* web_sample_tracks(Clip* clip, double frame, int wrap) {
  return clip->sample_tracks(frame, static_cast<mcpr_wrap>(wrap));
}

MOCAPRESS_EXPORT Player* web_play(const Clip* clip) {
  return made<Player>([&](Player& player) {
    return player.play(clip->cooked(), static_cast<std::size_t>(clip->dimensions().joints));
  });
}

MOCAPRESS_EXPORT void web_stop(Player* player) {
  destroy(player);
}

/// Returns eight floats for each joint.
MOCAPRESS_EXPORT const float* web_sample(Player* player, double seconds, int wrap,
                                         std::uint32_t bands_left_out) {
  return player->sample(seconds, static_cast<mcpr_wrap>(wrap), bands_left_out);
}
