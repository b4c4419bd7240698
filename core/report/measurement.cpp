// SPDX-License-Identifier: MIT
#include "core/report/measurement.h"

namespace mocapress {

namespace {

/// The spread of a weighting that is not on bones; zeros for the skin of a body without a mesh.
Spread spread_of(const BodyFigures& body, Weighting weighting) {
  if (weighting == Weighting::Skin) return body.skin.value_or(Spread());
  return weighting == Weighting::Shell ? body.shell : body.surface;
}

}  // namespace

double Measurement::eps_cm(Weighting weighting) const {
  if (weighting == Weighting::BoneEnds) return eps_bone_ends_cm;
  if (weighting == Weighting::JointOrigins) return eps_joint_origins_cm;
  return spread_of(body, weighting).rms;
}

double Measurement::max_cm(Weighting weighting) const {
  return is_on_bones(weighting) ? max_error_cm : spread_of(body, weighting).max.cm;
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
      return seen ? seen->times_noticed : 0;
  }
  return 0;
}

}  // namespace mocapress
