// SPDX-License-Identifier: MIT
// The runtime for C++20: spans, and pointers that free what they point to. Nothing throws.
// mocapress_runtime.h explains the types and calls; its other functions take the same pointers.
#ifndef MOCAPRESS_RUNTIME_HPP
#define MOCAPRESS_RUNTIME_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <string_view>

#include "mocapress_runtime.h"

namespace mcpr {

/// A value. If a call failed: an empty value, and the result of that call.
template <typename T>
struct Expected {
  T value{};
  mcpr_result result{};

  /// True if the call succeeded.
  explicit operator bool() const { return result.status == MCPR_OK; }
  T& operator*() { return value; }
  T* operator->() { return &value; }
  const T& operator*() const { return value; }
  const T* operator->() const { return &value; }
};

/// The limits of the format.
inline mcpr_limits default_limits() {
  mcpr_limits limits;
  mcpr_default_limits(&limits);
  return limits;
}

/// The dimensions of a clip, a cooked clip or a bank; all zero for null.
inline mcpr_clip_info describe(const mcpr_clip* clip) {
  mcpr_clip_info info;
  mcpr_clip_describe(clip, &info);
  return info;
}
inline mcpr_cooked_info describe(const mcpr_cooked* cooked) {
  mcpr_cooked_info info;
  mcpr_cooked_describe(cooked, &info);
  return info;
}
inline mcpk_info describe(const mcpk_bank* bank) {
  mcpk_info info;
  mcpk_describe(bank, &info);
  return info;
}

/// Frees memory from allocate().
struct Release {
  void operator()(const void* memory) const {
    ::operator delete (const_cast<void*>(memory), std::align_val_t{MCPR_ALIGNMENT});
  }
};

/// Owns a clip, a cooked clip or memory for the runtime. Its destructor frees what it owns.
template <typename T>
using Owned = std::unique_ptr<T, Release>;

/// Allocates memory with the alignment that the runtime needs. Null if there is no memory left: the
/// runtime's functions accept null and report it.
inline Owned<void> allocate(std::size_t bytes) {
  return Owned<void>(::operator new (bytes, std::align_val_t{MCPR_ALIGNMENT}, std::nothrow));
}

/// The allocator that load() and load_cooked() use. Release frees its clips.
inline constexpr mcpr_allocator kAllocator = {
    [](void*, std::size_t bytes, std::size_t) { return allocate(bytes).release(); },
    [](void*, void* memory) { Release()(memory); }, nullptr};

/// Decodes a file, which is not needed afterwards. Files beyond `limits` are refused; if `limits`
/// is null, the format's own limits apply. Fails as mcpr_load does.
inline Expected<Owned<const mcpr_clip>> load(std::span<const std::byte> file,
                                             const mcpr_limits* limits = nullptr) {
  const mcpr_clip* clip = nullptr;
  mcpr_result result;
  mcpr_load(file.data(), file.size(), limits, &kAllocator, &clip, &result);
  return {Owned<const mcpr_clip>(result.status == MCPR_OK ? clip : nullptr), result};
}

/// Decodes and cooks a file for a Player. Fails as mcpr_load_cooked does.
inline Expected<Owned<const mcpr_cooked>> load_cooked(std::span<const std::byte> file,
                                                      const mcpr_cook_options& options = {},
                                                      const mcpr_limits* limits = nullptr) {
  const mcpr_cooked* clip = nullptr;
  mcpr_result result;
  mcpr_load_cooked(file.data(), file.size(), limits, &options, &kAllocator, &clip, &result);
  return {Owned<const mcpr_cooked>(result.status == MCPR_OK ? clip : nullptr), result};
}

/// Decodes a clip of a packed bank, or only its first tiers if `limits` say so. Fails as mcpk_load
/// does.
inline Expected<Owned<const mcpr_clip>> load(const mcpk_bank* bank, std::uint32_t number,
                                             const mcpr_limits* limits = nullptr) {
  const mcpr_clip* clip = nullptr;
  mcpr_result result;
  mcpk_load(bank, number, limits, &kAllocator, &clip, &result);
  return {Owned<const mcpr_clip>(result.status == MCPR_OK ? clip : nullptr), result};
}

/// Decodes and cooks a clip of a packed bank for a Player. Fails as mcpk_load_cooked does.
inline Expected<Owned<const mcpr_cooked>> load_cooked(const mcpk_bank* bank, std::uint32_t number,
                                                      const mcpr_cook_options& options = {},
                                                      const mcpr_limits* limits = nullptr) {
  const mcpr_cooked* clip = nullptr;
  mcpr_result result;
  mcpk_load_cooked(bank, number, limits, &options, &kAllocator, &clip, &result);
  return {Owned<const mcpr_cooked>(result.status == MCPR_OK ? clip : nullptr), result};
}

/// The number of tiers that are complete in a file's first bytes. Set mcpr_limits.tiers to this
/// number to read them. 0: no tier is complete, or the file has no tiers.
inline std::uint32_t tiers_within(std::span<const std::byte> file) {
  std::uint32_t count = 0;
  for (mcpr_tier tier; mcpr_tier_of(file.data(), file.size(), count, &tier, nullptr) == MCPR_OK &&
                       tier.bytes <= file.size();)
    ++count;
  return count;
}

/// Plays a cooked clip for one character. The clip must outlive the player. Each character needs a
/// player of its own, and a player serves one thread at a time.
class Player {
 public:
  /// Makes a player with a cursor. Fails as mcpr_make_cursor does.
  static Expected<Player> of(const mcpr_cooked* clip) {
    Expected<Player> player;
    const std::size_t bytes = mcpr_cursor_bytes(clip);
    player->clip_ = clip;
    player->memory_ = allocate(bytes);
    mcpr_make_cursor(clip, player->memory_.get(), bytes, &player->cursor_, &player.result);
    return player;
  }

  /// Samples a pose into mcpr_sample_values() floats. Allocates the scratch memory that very large
  /// clips need.
  mcpr_result sample(mcpr_sample_request request, double time, std::span<float> out) {
    if (request.layout == MCPR_WRITER || out.size() < mcpr_sample_values(clip_, &request))
      return {MCPR_MEMORY, 0, "the pose has no room for all values"};
    return sample_into(out.data(), request, time);
  }

  /// Samples a pose into transforms. The layout of the request is MCPR_TRANSFORMS.
  mcpr_result sample(const mcpr_sample_request& request, double time,
                     std::span<mcpr_transform> pose) {
    if (pose.empty()) return sample(request, time, std::span<float>());
    constexpr std::size_t kValues = sizeof(mcpr_transform) / sizeof(float);
    return sample(request, time, std::span(pose.data()->rotation, kValues * pose.size()));
  }

  /// Samples a pose, and passes the transforms to the writer, one after the other.
  mcpr_result sample(mcpr_sample_request request, double time, mcpr_writer& writer) {
    request.layout = MCPR_WRITER;
    return sample_into(&writer, request, time);
  }

  /// Samples the local transform of each joint at an instant. Fails if `pose` has fewer transforms
  /// than the clip has joints.
  mcpr_result sample(double seconds, std::span<mcpr_transform> pose, mcpr_wrap wrap = MCPR_CLAMP) {
    mcpr_sample_request request = {};
    request.unit = MCPR_SECONDS;
    request.wrap = wrap;
    return sample(request, seconds, pose);
  }

 private:
  mcpr_result sample_into(void* out, mcpr_sample_request& request, double time) {
    const std::size_t bytes = mcpr_sample_scratch_bytes(clip_, &request);
    if (bytes > scratch_bytes_) {
      scratch_ = allocate(bytes);
      scratch_bytes_ = scratch_ ? bytes : 0;
    }
    request.scratch = scratch_.get();
    request.scratch_size = scratch_bytes_;
    mcpr_result result;
    mcpr_sample_next(cursor_, &request, time, out, &result);
    return result;
  }

  const mcpr_cooked* clip_ = nullptr;
  mcpr_cursor* cursor_ = nullptr;
  Owned<void> memory_;   // memory of the cursor
  Owned<void> scratch_;  // enlarged when a request needs more
  std::size_t scratch_bytes_ = 0;
};

/// Opens a bank in place: `memory` must be aligned, and stay there while the bank is in use.
/// `check` = 1 verifies every byte. Fails as mcpk_open does.
inline Expected<const mcpk_bank*> open_bank(std::span<const std::byte> memory, int check = 1) {
  Expected<const mcpk_bank*> bank;
  mcpk_open(memory.data(), memory.size(), check, &bank.value, &bank.result);
  return bank;
}

/// The name of a clip in a bank; empty if there is none.
struct Name {
  char text[MCPK_NAME_BYTES] = {};

  Name(const mcpk_bank* bank, std::uint32_t clip) { mcpk_name(bank, clip, text); }
  operator std::string_view() const { return text; }
};

/// Finds a clip of a cooked bank by its name, ready for a Player. Fails if there is none.
inline Expected<const mcpr_cooked*> cooked_of(const mcpk_bank* bank, const char* name) {
  const std::int32_t number = mcpk_find(bank, name);
  if (number < 0) return {nullptr, {MCPR_ARGUMENT, 0, "the bank has no clip of this name"}};
  Expected<const mcpr_cooked*> clip;
  mcpk_cooked(bank, static_cast<std::uint32_t>(number), &clip.value, &clip.result);
  return clip;
}

}  // namespace mcpr

#endif
