// SPDX-License-Identifier: MIT
// The part of the C interface that opens a file in one call, with an allocator of the caller's.
#include "core/runtime/format/result.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {
namespace {

/// A piece of the allocator's memory, released at the end unless it is kept.
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

bool is_allocator(const mcpr_allocator* allocator) {
  return allocator != nullptr && allocator->allocate != nullptr && allocator->release != nullptr;
}

}  // namespace
}  // namespace mocapress::runtime

mcpr_status mcpr_load(const void* file, size_t size, const mcpr_limits* limits,
                      const mcpr_allocator* allocator, const mcpr_clip** clip,
                      mcpr_result* report) {
  using namespace mocapress::runtime;
  if (!is_allocator(allocator) || clip == nullptr)
    return tell(report,
                failure(MCPR_ARGUMENT, 0, "no allocator, or no place was given for the clip"));
  mcpr_info info;
  mcpr_result result;
  mcpr_inspect(file, size, limits, &info, &result);
  if (failed(result)) return tell(report, result);
  const Allocated scratch(*allocator, info.read_bytes);
  std::size_t bytes = 0;
  mcpr_read(file, size, limits, scratch.data(), scratch.size(), &bytes, &result);
  if (failed(result)) return tell(report, result);
  Allocated resident(*allocator, bytes);
  mcpr_build(scratch.data(), scratch.size(), resident.data(), bytes, clip, &result);
  if (!failed(result)) resident.keep();
  return tell(report, result);
}

mcpr_status mcpr_load_cooked(const void* file, size_t size, const mcpr_limits* limits,
                             const mcpr_cook_options* options, const mcpr_allocator* allocator,
                             const mcpr_cooked** cooked, mcpr_result* report) {
  using namespace mocapress::runtime;
  if (cooked == nullptr)
    return tell(report, failure(MCPR_ARGUMENT, 0, "no place was given for the clip"));
  const mcpr_clip* clip = nullptr;
  mcpr_result result;
  mcpr_load(file, size, limits, allocator, &clip, &result);
  if (failed(result)) return tell(report, result);
  const Allocated scratch(*allocator, mcpr_cook_scratch_bytes(clip, options));
  std::size_t bytes = 0;
  mcpr_cook_size(clip, options, scratch.data(), scratch.size(), &bytes, &result);
  if (!failed(result)) {
    Allocated memory(*allocator, bytes);
    mcpr_cook(clip, options, scratch.data(), scratch.size(), memory.data(), bytes, cooked, &result);
    if (!failed(result)) memory.keep();
  }
  allocator->release(allocator->context, const_cast<mcpr_clip*>(clip));
  return tell(report, result);
}
