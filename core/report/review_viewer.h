// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace mocapress {

/// A build refuses a larger one: a report of 3,000 clips stays below 3 MB with it.
inline constexpr std::size_t kLargestViewer = 300'000;

/// build/web/viewer.js.gz, as the build found it; empty where there was none.
std::span<const std::byte> review_viewer();

}  // namespace mocapress
