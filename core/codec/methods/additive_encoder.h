// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/codec/methods/compression_method.h"
#include "core/metrics/sight_limits.h"

namespace mocapress {

/// Compresses the difference of a motion from a base (core/motion/difference.h). An engine adds the
/// difference to the base or to other poses. Errors are those of base plus difference in world
/// space. Each search adds the difference to the base's first frame only; for a target error it is
/// repeated with smaller targets until the whole base plus difference meets the target.
class AdditiveEncoder {
 public:
  /// Throws Error if the base has other joints, or neither one frame nor as many as the motion.
  AdditiveEncoder(Motion motion, Motion base);

  /// Compresses with the adaptive coding to a ratio, a size or an error. `contacts` are those of
  /// the motion's feet. The result's figures compare base plus difference with the motion. Throws
  /// what MethodEncoder::compress() throws.
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
  Eigen::MatrixXd body_;  // body_tracks() of sum_
  MethodEncoder on_base_pose_;
};

}  // namespace mocapress
