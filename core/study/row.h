// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/codec/encode/target.h"
#include "core/codec/format/compressed_clip.h"
#include "core/report/measurement.h"
#include "core/report/review.h"

namespace mocapress {

/// One compression of a study: what was asked, and what came of it or why nothing did.
struct StudyRow {
  std::string clip;         // the path as given
  ClipReview review = {};   // where a library has one
  std::string fingerprint;  // of the motion that was read; empty: it could not be
  std::string method;       // name of a method
  Target target;
  Weighting weighting = Weighting::BoneEnds;
  std::optional<Coding> coding = Coding::Deflate;  // of wavelets
  std::uint64_t seed = 1;
  std::optional<double> ik_ratio;  // unset: without IK correction
  int jobs = 1;                    // compressions at a time, which seconds depend on
  std::optional<Measurement> measured;
  std::string error;  // why there is no measurement

  /// Whether the target was met: a ratio within 2 %, a bound not exceeded.
  bool reached() const;

  /// What makes it the same compression in another run: all that was asked and the motion itself,
  /// wherever its file is.
  std::string key() const;
};

}  // namespace mocapress
