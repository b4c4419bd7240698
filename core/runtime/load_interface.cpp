// SPDX-License-Identifier: MIT
// The part of the C interface that opens a file, or a clip of a packed bank, in one call. Memory
// comes from an allocator that the caller gives.
#include "core/runtime/format/result.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {
namespace {

/// Memory from the caller's allocator. The destructor releases it, unless keep() was called.
class Allocated {
 public:
  Allocated(const mcpr_allocator& allocator, std::size_t size)
      : allocator_(allocator),
        size_(size),
        memory_(allocator.allocate(allocator.context, size, MCPR_ALIGNMENT)) {}
  Allocated(const Allocated&) = delete;
  Allocated& operator=(const Allocated&) = delete;
  ~Allocated() {
    if (memory_ != nullptr) allocator_.release(allocator_.context, memory_);
  }

  void* data() const { return memory_; }
  std::size_t size() const { return size_; }
  void keep() { memory_ = nullptr; }

 private:
  const mcpr_allocator& allocator_;
  std::size_t size_;
  void* memory_;
};

/// Loads a clip by calling `inspect` and `read`. These know whether the clip is a file or lies in a
/// packed bank.
template <typename Inspect, typename Read>
mcpr_result load_by(const Inspect& inspect, const Read& read, const mcpr_allocator* allocator,
                    const mcpr_clip** clip) {
  if (allocator == nullptr || allocator->allocate == nullptr || allocator->release == nullptr ||
      clip == nullptr)
    return failure(MCPR_ARGUMENT, 0, "no allocator, or no place was given for the clip");
  mcpr_info info;
  mcpr_result result;
  inspect(&info, &result);
  if (failed(result)) return result;
  const Allocated scratch(*allocator, info.read_bytes);
  std::size_t bytes = 0;
  read(scratch.data(), scratch.size(), &bytes, &result);
  if (failed(result)) return result;
  Allocated resident(*allocator, bytes);
  mcpr_build(scratch.data(), scratch.size(), resident.data(), bytes, clip, &result);
  if (!failed(result)) resident.keep();
  return result;
}

/// Loads a clip by calling `load`, cooks it, and releases the uncooked clip.
template <typename Load>
mcpr_result load_cooked_by(const Load& load, const mcpr_cook_options* options,
                           const mcpr_allocator* allocator, const mcpr_cooked** cooked) {
  if (cooked == nullptr) return failure(MCPR_ARGUMENT, 0, "no place was given for the clip");
  const mcpr_clip* clip = nullptr;
  mcpr_result result;
  load(&clip, &result);
  if (failed(result)) return result;
  const Allocated scratch(*allocator, mcpr_cook_scratch_bytes(clip, options));
  std::size_t bytes = 0;
  mcpr_cook_size(clip, options, scratch.data(), scratch.size(), &bytes, &result);
  if (!failed(result)) {
    Allocated memory(*allocator, bytes);
    mcpr_cook(clip, options, scratch.data(), scratch.size(), memory.data(), bytes, cooked, &result);
    if (!failed(result)) memory.keep();
  }
  allocator->release(allocator->context, const_cast<mcpr_clip*>(clip));
  return result;
}

}  // namespace
}  // namespace mocapress::runtime

mcpr_status mcpr_load(const void* file, size_t size, const mcpr_limits* limits,
                      const mcpr_allocator* allocator, const mcpr_clip** clip,
                      mcpr_result* report) {
  using namespace mocapress::runtime;
  const auto inspect = [&](mcpr_info* info, mcpr_result* result) {
    mcpr_inspect(file, size, limits, info, result);
  };
  const auto read = [&](void* scratch, size_t bytes, size_t* resident, mcpr_result* result) {
    mcpr_read(file, size, limits, scratch, bytes, resident, result);
  };
  return tell(report, load_by(inspect, read, allocator, clip));
}

mcpr_status mcpr_load_cooked(const void* file, size_t size, const mcpr_limits* limits,
                             const mcpr_cook_options* options, const mcpr_allocator* allocator,
                             const mcpr_cooked** cooked, mcpr_result* report) {
  using namespace mocapress::runtime;
  const auto load = [&](const mcpr_clip** clip, mcpr_result* result) {
    mcpr_load(file, size, limits, allocator, clip, result);
  };
  return tell(report, load_cooked_by(load, options, allocator, cooked));
}

mcpr_status mcpk_load(const mcpk_bank* bank, uint32_t number, const mcpr_limits* limits,
                      const mcpr_allocator* allocator, const mcpr_clip** clip,
                      mcpr_result* report) {
  using namespace mocapress::runtime;
  const auto inspect = [&](mcpr_info* info, mcpr_result* result) {
    mcpk_inspect(bank, number, limits, info, result);
  };
  const auto read = [&](void* scratch, size_t bytes, size_t* resident, mcpr_result* result) {
    mcpk_read(bank, number, limits, scratch, bytes, resident, result);
  };
  return tell(report, load_by(inspect, read, allocator, clip));
}

mcpr_status mcpk_load_cooked(const mcpk_bank* bank, uint32_t number, const mcpr_limits* limits,
                             const mcpr_cook_options* options, const mcpr_allocator* allocator,
                             const mcpr_cooked** cooked, mcpr_result* report) {
  using namespace mocapress::runtime;
  const auto load = [&](const mcpr_clip** clip, mcpr_result* result) {
    mcpk_load(bank, number, limits, allocator, clip, result);
  };
  return tell(report, load_cooked_by(load, options, allocator, cooked));
}
