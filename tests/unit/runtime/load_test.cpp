// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <new>

#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress::load_test {
namespace {

/// Counts what is allocated, and refuses after some allocations.
struct Heap {
  int live = 0;
  int left = 100;
  std::align_val_t aligned_to{1};  // all of it
  mcpr_allocator allocator = {[](void* context, std::size_t size, std::size_t alignment) -> void* {
                                auto* const heap = static_cast<Heap*>(context);
                                if (heap->left-- <= 0) return nullptr;
                                ++heap->live;
                                heap->aligned_to = std::align_val_t{alignment};
                                return ::operator new(size, heap->aligned_to, std::nothrow);
                              },
                              [](void* context, void* memory) {
                                auto* const heap = static_cast<Heap*>(context);
                                --heap->live;
                                ::operator delete(memory, heap->aligned_to);
                              },
                              this};
};

std::vector<std::byte> file() {
  return write_container(
      Encoder(test::smooth_motion(90))
          .encode({.method = Method::ClosedLoop, .weighting = Weighting::BoneEnds})
          .compressed);
}

TEST(Load, GivesTheClipOfTheThreeCalls) {
  const std::vector<std::byte> bytes = file();
  Heap heap;
  const mcpr_clip* clip = nullptr;
  ASSERT_EQ(mcpr_load(bytes.data(), bytes.size(), nullptr, &heap.allocator, &clip, nullptr),
            MCPR_OK);
  EXPECT_EQ(heap.live, 1);
  EXPECT_EQ(mcpr::describe(clip).frames, 90U);
  const test::OpenedClip opened(bytes);
  EXPECT_EQ(test::CookedClip(clip).sample({}, 12.5),
            test::CookedClip(opened.clip).sample({}, 12.5));
  heap.allocator.release(&heap, const_cast<mcpr_clip*>(clip));
}

TEST(Load, CooksInOneCall) {
  const std::vector<std::byte> bytes = file();
  Heap heap;
  const mcpr_cooked* cooked = nullptr;
  ASSERT_EQ(mcpr_load_cooked(bytes.data(), bytes.size(), nullptr, nullptr, &heap.allocator, &cooked,
                             nullptr),
            MCPR_OK);
  EXPECT_EQ(heap.live, 1);
  EXPECT_EQ(mcpr::describe(cooked).frames, 90U);
  heap.allocator.release(&heap, const_cast<mcpr_cooked*>(cooked));
}

TEST(Load, ReleasesEverythingWhenMemoryOrTheFileFails) {
  std::vector<std::byte> bytes = file();
  for (int left = 0; left < 4; ++left) {
    Heap heap;
    heap.left = left;
    const mcpr_cooked* cooked = nullptr;
    EXPECT_EQ(mcpr_load_cooked(bytes.data(), bytes.size(), nullptr, nullptr, &heap.allocator,
                               &cooked, nullptr),
              MCPR_NO_MEMORY)
        << left;
    EXPECT_EQ(heap.live, 0) << left;
  }
  Heap heap;
  const mcpr_clip* clip = nullptr;
  bytes.pop_back();
  EXPECT_NE(mcpr_load(bytes.data(), bytes.size(), nullptr, &heap.allocator, &clip, nullptr),
            MCPR_OK);
  EXPECT_EQ(mcpr_load(bytes.data(), bytes.size(), nullptr, nullptr, &clip, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(heap.live, 0);
}

}  // namespace
}  // namespace mocapress::load_test
