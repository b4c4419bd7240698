// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/clip_outcome.h"

namespace mocapress {
namespace {

/// What a compression came to, of the kind its target is of.
double quantityOf(const DecodedClip& decoded, const EncodeOptions& options) {
  switch (options.target.kind) {
    case Target::Kind::Ratio:
      return decoded.ratio;
    case Target::Kind::Size:
      return static_cast<double>(decoded.compressed.motion_bytes());
    case Target::Kind::Error:
      return decoded.distortion->eps(options.weighting);
    case Target::Kind::MaxError:
      return decoded.distortion->worst(options.weighting).cm;
    case Target::Kind::Visibility:
      return decoded.visibility->worst().times_noticed();
    case Target::Kind::CoefficientRatio:
      break;
  }
  return options.target.value;
}

}  // namespace

Outcome outcomeOf(const DecodedClip& decoded, const EncodeOptions& options) {
  return {decoded.ratio, decoded.distortion->eps(options.weighting), decoded.distortion->max.cm,
          decoded.compressed.motion_bytes(), reached(options.target, quantityOf(decoded, options))};
}

}  // namespace mocapress
