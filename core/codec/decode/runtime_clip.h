// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

#include "core/motion/skeleton.h"
#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/own_memory.h"

namespace mocapress {

/// An adaptive .mcpr file, opened as an engine opens it: by the C interface of the runtime decoder,
/// within its default limits.
class RuntimeClip {
 public:
  /// Opens a file, or only its first `tiers` tiers (0: all). Throws FormatError with the runtime
  /// decoder's message about the file.
  explicit RuntimeClip(std::span<const std::byte> file, int tiers = 0);

  mcpr_clip_info info() const { return mcpr::describe(get()); }

  /// The handle for the C interface; lives as long as this object.
  const mcpr_clip* get() const { return clip_.get(); }

  /// Returns whether joints and channels equal the skeleton's, to the precision of the file's
  /// 32-bit floats. Turned axes of joints are not compared.
  bool has_joints_of(const Skeleton& skeleton) const;

  /// Decodes some frames with their IK correction: one row of all channels for each frame, in cm
  /// and radians.
  Eigen::MatrixXd frames(int first, int count) const;

 private:
  mcpr::Owned<const mcpr_clip> clip_;
  std::optional<AlignedBytes> scratch_;  // for frames()
};

}  // namespace mocapress
