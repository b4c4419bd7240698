// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", sections 4 and 5.
#pragma once

#include <cstdint>
#include <memory>

#include "core/base/progress.h"
#include "core/codec/compressed_clip.h"
#include "core/codec/target.h"
#include "core/metrics/distortion.h"

namespace mocapress {

class ClipAnalysis;

struct EncodeOptions {
  Method method = Method::Annealed;
  Coding coding = Coding::Deflate;
  Basis basis = Basis::Cubic;
  Weighting weighting = Weighting::BoneEnds;
  Target target;
  std::uint64_t seed = 1;  // of the annealing; the same seed gives the same bytes
};

/// The state of a running encode. A target other than the coefficient ratio takes several passes.
struct EncodeProgress {
  int pass = 0;        // from 0
  int iteration = 0;   // of this pass's annealing
  int step = 0;        // coefficients moved at a time: halves until it is 0
  int first_step = 0;  // the step the pass began with
  double eps_cm = 0;   // by the quadratic model, in the chosen weighting
};

/// A finished encode, decoded again and measured.
struct Encoding {
  CompressedClip compressed;
  Clip decoded;
  Distortion distortion;
  double coefficient_ratio = 0;  // the paper's r
  int iterations = 0;            // of the last annealing
  double seconds = 0;
  bool complete = true;  // false: the observer ended it early
};

/// Compresses one motion, as often and with whatever options one likes: what does not depend on
/// them (transform, order of coefficients, original poses) is computed once, on construction. Const
/// and safe to use from several threads at a time.
class Encoder {
 public:
  explicit Encoder(Motion motion);
  ~Encoder();

  const Motion& motion() const;

  /// landmark_tracks() of the original.
  const Eigen::MatrixXd& original_tracks() const;

  /// Throws TargetMissed when no number of coefficients meets the target.
  Encoding encode(const EncodeOptions& options,
                  const Observer<EncodeProgress>& observer = {}) const;

 private:
  std::unique_ptr<const ClipAnalysis> analysis_;
};

}  // namespace mocapress
