// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 5.1.
#pragma once

#include <vector>

#include "core/codec/encode/mend/difference_fit.h"
#include "core/codec/encode/options/encode_settings.h"
#include "core/codec/format/compressed_clip.h"
#include "core/feet/contact_spans.h"
#include "core/select/point_term.h"

namespace mocapress {

/// Encodes the differences between a reconstruction's effectors and the original's.
class CorrectionEncoder {
 public:
  /// `original_tracks` are landmark_tracks(). During `contacts` the effectors are kept nearer to
  /// their original places; with CorrectAt::Contacts they are corrected nowhere else. Throws Error
  /// if there is nothing to correct or a joint cannot be moved.
  CorrectionEncoder(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                    const EncodeCorrection& settings, const std::vector<ContactSpan>& contacts,
                    double sample_rate_hz);

  /// For each limb, the weights of its errors in the motion, given that this correction mends them
  /// afterwards.
  std::vector<PointResponse> responses(const Clip& original,
                                       const Eigen::MatrixXd& original_tracks) const;

  CodedCorrection correction() const { return {solver_, effectors_}; }

  /// Fits the differences with 1 / ratio of their coefficients.
  DifferenceFit select(const Clip& reconstructed, double ratio, Basis basis,
                       const CodedStep& coded_step) const;

 private:
  void limit_to_contacts(const std::vector<Effector>& effectors, PointResponse& response) const;

  const Skeleton& skeleton_;
  IkSolver solver_;
  CorrectAt at_;
  std::vector<Effector> effectors_;
  Eigen::MatrixXd original_;  // frames x 3 * effectors, cm
  Eigen::MatrixXd contacts_;  // frames x effectors: 1 in contact, falling smoothly to 0 beside it
};

}  // namespace mocapress
