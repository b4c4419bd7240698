// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/codec/methods/compression_method.h"
#include "core/metrics/sight_limits.h"

namespace mocapress {

/// Compresses a motion as what it adds to a base (core/motion/difference.h), which an engine adds
/// to that base or to other poses. The error is that of base plus difference in the world. The
/// search takes the base for a pose, its first frame; a target error is then met on the base as it
/// is.
class AdditiveEncoder {
 public:
  /// Throws Error if the base has other joints, or neither one frame nor as many as the motion.
  AdditiveEncoder(Motion motion, Motion base);

  /// Compresses with the adaptive coding to a ratio, a size or an error. `contacts` are those of
  /// the motion's feet. The result's figures compare base plus difference with the motion. Throws
  /// as MethodEncoder::compress() does.
  Encoding compress(const CompressionMethod& method, EncodeSettings settings,
                    const std::vector<ContactSpan>& contacts,
                    const Observer<EncodeProgress>& observer = {}) const;

  /// Decodes a file that compress() made as an engine does, adds the base, and compares the sum
  /// with the motion. Throws FormatError.
  Comparison measure(std::span<const std::byte> file, const std::vector<ContactSpan>& contacts,
                     const SightLimits& limits = {}) const;

 private:
  Motion base_;
  Motion difference_;
  Motion sum_;            // the motion, in the channels of the differences
  Eigen::MatrixXd body_;  // its body_tracks()
  MethodEncoder on_base_pose_;
};

}  // namespace mocapress
