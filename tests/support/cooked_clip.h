// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/own_memory.h"

namespace mocapress::test {

/// A clip cooked into its own memory, as an engine would do it.
struct CookedClip {
  mcpr_result result{};  // result of the step that failed, or of the last one
  std::optional<AlignedBytes> bytes;
  const mcpr_cooked* clip = nullptr;  // null if it was refused

  explicit CookedClip(const mcpr_clip* from, const mcpr_cook_options& options = {}) {
    const AlignedBytes scratch(mcpr_cook_scratch_bytes(from, &options));
    std::size_t size = 0;
    mcpr_cook_size(from, &options, scratch.data(), scratch.size(), &size, &result);
    if (result.status != MCPR_OK) return;
    bytes.emplace(size);
    mcpr_cook(from, &options, scratch.data(), scratch.size(), bytes->data(), size, &clip, &result);
  }

  /// Empty if it was refused.
  std::vector<float> sample(const mcpr_sample_request& request, double time) const {
    std::vector<float> out(mcpr_sample_values(clip, &request));
    if (out.empty() || mcpr_sample(clip, &request, time, out.data(), nullptr) != MCPR_OK) return {};
    return out;
  }
};

}  // namespace mocapress::test
