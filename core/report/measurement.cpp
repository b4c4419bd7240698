// SPDX-License-Identifier: MIT
#include "core/report/measurement.h"

namespace mocapress {

Spread Measurement::spread(Weighting weighting) const {
  if (is_on_bones(weighting))
    return {weighting == Weighting::BoneEnds ? eps_bone_ends_cm : eps_joint_origins_cm,
            p95_error_cm,
            p99_error_cm,
            {.cm = max_error_cm}};
  if (weighting == Weighting::Skin) return body.skin.value_or(Spread());
  return weighting == Weighting::Shell ? body.shell : body.surface;
}

double Measurement::quantity(Target::Kind kind, Weighting weighting) const {
  switch (kind) {
    case Target::Kind::Ratio:
      return ratio;
    case Target::Kind::CoefficientRatio:
      return coefficient_ratio.value_or(0);
    case Target::Kind::Size:
      return static_cast<double>(motion_bytes);
    case Target::Kind::Error:
      return eps_cm(weighting);
    case Target::Kind::MaxError:
      return max_cm(weighting);
    case Target::Kind::Visibility:
      return seen.times_noticed;
  }
  return 0;
}

}  // namespace mocapress
