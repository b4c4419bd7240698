// SPDX-License-Identifier: MIT
// Based on: O. Arikan, "Compression of Motion Capture Databases", 2006. Our reading:
// - curves of one segment begin where those before ended, so that nothing has to be smoothed;
// - k-means, not spectral clustering, and a length of segment and a number of clusters chosen for
//   the tolerance;
// - roots and translations are curves of their own, and feet have no signals of their own;
// - 16-bit steps and DEFLATE in place of Huffman codes.
// The bytes: METHODS.md.

#pragma once

#include <span>

#include "core/codec/methods/comparison_method.h"
#include "core/motion/clip.h"
#include "core/motion/landmarks.h"

namespace mocapress {

/// Clustered PCA of short Bezier curves of virtual markers, with the clip alone as database. A
/// detail is a tolerance.
const ComparisonMethod& arikan_method();

/// Several motions whose segments share clusters and components.
struct ArikanDatabase {
  std::vector<std::byte> codebook;            // shared by all motions
  std::vector<std::vector<std::byte>> clips;  // one for each motion

  std::size_t bytes() const;
};

/// Compresses motions whose skeletons have the same joints and channels; lengths may differ. Throws
/// Error for other skeletons.
ArikanDatabase compress_database(std::span<const Motion> motions, Weighting weighting,
                                 double tolerance_cm);

/// Throws FormatError.
Clip decode_from_database(const Skeleton& skeleton, double sample_rate_hz, int frames,
                          std::span<const std::byte> codebook, std::span<const std::byte> clip);

}  // namespace mocapress
