// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace mocapress {

/// The most bytes of a viewer that a build accepts. With it, a report of 3,000 clips stays below 3
/// MB.
inline constexpr std::size_t kLargestViewer = 300'000;

/// The bytes of build/web/viewer.js.gz; empty if the build had none.
std::span<const std::byte> review_viewer();

}  // namespace mocapress
