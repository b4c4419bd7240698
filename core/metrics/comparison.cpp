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

Comparison compare(const Motion& original, const Eigen::MatrixXd& original_body,
                   const Clip& decoded, const std::vector<ContactSpan>& contacts) {
  if (decoded.channels.rows() != original.clip.channels.rows() ||
      decoded.channels.cols() != original.clip.channels.cols())
    throw Error("is not a compressed form of the original: it has " + shape_text(decoded) +
                ", the original " + shape_text(original.clip));
  const Eigen::MatrixXd body = body_tracks(original.skeleton, decoded);
  const double rate = original.clip.sample_rate_hz;
  return {measure(original.skeleton, original_body, body),
          measure_footskate(contacts, original_body, body, rate),
          measure_visibility(original.skeleton, original_body, body, rate, contacts)};
}

}  // namespace mocapress
