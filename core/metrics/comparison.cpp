// SPDX-License-Identifier: MIT
#include "core/metrics/comparison.h"

#include <string>

#include "core/base/error.h"
#include "core/motion/body_tracks.h"

namespace mocapress {
namespace {

std::string shape_text(const Clip& clip) {
  return std::to_string(clip.frames()) + " frames of " + std::to_string(clip.channels.cols()) +
         " channels";
}

}  // namespace

void require_same_shape(const Clip& original, const Clip& decoded) {
  if (decoded.channels.rows() != original.channels.rows() ||
      decoded.channels.cols() != original.channels.cols())
    throw Error("is not a compressed form of the original: it has " + shape_text(decoded) +
                ", the original " + shape_text(original));
}

Comparison compare(const Motion& original, const Eigen::MatrixXd& original_body,
                   const Clip& decoded, const std::vector<ContactSpan>& contacts,
                   const SightLimits& limits) {
  require_same_shape(original.clip, decoded);
  const Eigen::MatrixXd body = body_tracks(original.skeleton, decoded);
  const double rate = original.clip.sample_rate_hz;
  return {measure(original.skeleton, original_body, body),
          measure_footskate(contacts, original_body, body, rate),
          measure_visibility(original.skeleton, original_body, body, rate, contacts, limits)};
}

}  // namespace mocapress
