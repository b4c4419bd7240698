// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", sections 4 and 5.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/progress.h"
#include "core/codec/encode/mend/correction_encoder.h"
#include "core/codec/encode/options/encode_options.h"
#include "core/feet/footskate.h"
#include "core/metrics/distortion.h"
#include "core/metrics/visibility.h"

namespace mocapress {

class ClipAnalysis;

/// What an IK correction did to a clip.
struct CorrectionResult {
  double ratio = 0;                        // r_IK, asked for or found
  std::optional<double> slide_without_cm;  // where it was found: footskate without a correction
  std::size_t bytes = 0;                   // of the motion's
  CorrectionReport report;
  Clip uncorrected;         // in the channels as coded; empty where only figures were asked for
  double fastest_knee = 0;  // radians/s, with the correction
  double fastest_knee_of_original = 0;
};

/// A finished encode, decoded again and measured. With `figures_only` the decoded clip, its tracks
/// and the distances stay empty, and percentiles are those of DistanceCounts. With `size_will_do`
/// the bytes of a draft are not there: compressed.likely_bytes says how many they will be, to some
/// hundredths, and code_motion() makes them. Then all figures are of the very clip that `decoded`
/// is, which is what these bytes will say but for the rounding of 32-bit floats. A closed loop in
/// segments then takes memory that hardly grows with the clip. What grows: the contacts, what is
/// seen in each tenth of a second, the coded bytes and, under a hard maximum, a weight for each
/// frame.
struct Encoding {
  CompressedClip compressed;
  Clip decoded;
  Eigen::MatrixXd tracks;  // landmark_tracks() of it
  Distortion distortion;
  Footskate footskate;
  Visibility visibility;
  std::optional<CorrectionResult> correction;
  double coefficient_ratio = 0;  // the paper's r
  int iterations = 0;            // of the last annealing, or sweeps of the closed loop
  double seconds = 0;
  bool complete = true;  // false: the observer ended it early
};

/// Compresses one motion, any number of times and with any options. What does not depend on the
/// options (transform, order of coefficients, original poses) is computed once, when first needed.
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
  Encoding encode(const EncodeOptions& options,
                  const Observer<EncodeProgress>& observer = {}) const;

 private:
  /// To the target alone.
  Encoding encode_once(const EncodeOptions& options,
                       const Observer<EncodeProgress>& observer) const;

  std::unique_ptr<const ClipAnalysis> analysis_;
};

}  // namespace mocapress
