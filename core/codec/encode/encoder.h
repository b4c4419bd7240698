// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", sections 4 and 5.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/codec/encode/mend/correction_encoder.h"
#include "core/codec/encode/options/encode_settings.h"
#include "core/metrics/comparison.h"

namespace mocapress {

class ClipAnalysis;

/// The result of an IK correction.
struct CorrectionResult {
  double ratio = 0;  // r_IK, asked for or found
  std::optional<double>
      slide_without_cm;   // footskate without a correction, where the encoder chose the ratio
  std::size_t bytes = 0;  // part of the motion's bytes
  CorrectionReport report;
  Clip uncorrected;         // in the coded channels; empty with figures_only
  double fastest_knee = 0;  // radians/s, with the correction
  double fastest_knee_of_original = 0;
};

/// A finished encode, decoded again and measured. With `figures_only` the decoded clip, its tracks
/// and the distances stay empty, and percentiles come from DistanceCounts; a closed loop in
/// segments then takes memory that hardly grows with the clip: only contacts, visibility (ten
/// entries a second), coded bytes and, under a hard maximum, one weight a frame. With
/// `size_will_do` a draft has no bytes: compressed.likely_bytes estimates them to a few per cent
/// and code_motion() makes them. All figures are those of the clip in `decoded`, which the coded
/// bytes reproduce up to the rounding of 32-bit floats.
struct Encoding : Comparison {
  CompressedClip compressed;
  std::vector<std::byte> file;  // the .mcpr, where a MethodEncoder made it
  Clip decoded;
  Eigen::MatrixXd tracks;  // landmark_tracks() of `decoded`
  std::optional<CorrectionResult> correction;
  std::optional<double> coefficient_ratio;  // the paper's r, of wavelets
  std::optional<int> iterations;            // of the last annealing
  double seconds = 0;
  bool complete = true;  // false: the observer ended it early
};

/// Compresses one motion any number of times with any settings. Data that does not depend on the
/// settings (transform, coefficient order, original poses) is computed once, when first needed.
/// Const and safe to use from several threads at a time.
class Encoder {
 public:
  explicit Encoder(Motion motion);
  ~Encoder();

  const Motion& motion() const;

  /// landmark_tracks() and body_tracks() of the original.
  const Eigen::MatrixXd& original_tracks() const;
  const Eigen::MatrixXd& original_body() const;

  /// The contacts of the feet, found on the original.
  const std::vector<ContactSpan>& contacts() const;

  /// Throws TargetMissed when no number of coefficients meets the target or no weights keep the
  /// promises, and Error when a correction is asked for that the skeleton does not allow.
  Encoding encode(const EncodeSettings& settings,
                  const Observer<EncodeProgress>& observer = {}) const;

 private:
  /// Encodes to the target, without checking the promises.
  Encoding encode_once(const EncodeSettings& settings,
                       const Observer<EncodeProgress>& observer) const;

  std::unique_ptr<const ClipAnalysis> analysis_;
};

}  // namespace mocapress
