// SPDX-License-Identifier: MIT
#include "core/report/measurement.h"

namespace mocapress {

double Measurement::eps_cm(Weighting weighting) const {
  switch (weighting) {
    case Weighting::BoneEnds:
      return eps_bone_ends_cm;
    case Weighting::JointOrigins:
      return eps_joint_origins_cm;
    case Weighting::Surface:
      return body.surface.rms;
    case Weighting::Shell:
      return body.shell.rms;
    case Weighting::Skin:
      return body.skin ? body.skin->rms : 0;
  }
  return 0;
}

double Measurement::max_cm(Weighting weighting) const {
  switch (weighting) {
    case Weighting::BoneEnds:
    case Weighting::JointOrigins:
      return max_error_cm;
    case Weighting::Surface:
      return body.surface.max.cm;
    case Weighting::Shell:
      return body.shell.max.cm;
    case Weighting::Skin:
      return body.skin ? body.skin->max.cm : 0;
  }
  return 0;
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
