// SPDX-License-Identifier: MIT
#include "tests/support/loop_of.h"

#include <algorithm>
#include <limits>

#include "core/motion/landmarks.h"

namespace mocapress::test {
namespace {

/// Landmarks' positions relative to the first one's place on the floor, and their velocities:
/// frames x values.
Eigen::MatrixXd poses(const Motion& motion) {
  Eigen::MatrixXd places = landmark_tracks(motion.skeleton, motion.clip);
  const Eigen::VectorXd x = places.col(0);
  const Eigen::VectorXd z = places.col(2);
  for (Eigen::Index p = 0; p < places.cols() / 3; ++p) {
    places.col(3 * p) -= x;
    places.col(3 * p + 2) -= z;
  }
  const Eigen::Index frames = places.rows();
  const double in_a_tenth = motion.clip.sample_rate_hz / 10;
  Eigen::MatrixXd both(frames - 1, 2 * places.cols());
  both.leftCols(places.cols()) = places.topRows(frames - 1);
  both.rightCols(places.cols()) =
      in_a_tenth * (places.bottomRows(frames - 1) - places.topRows(frames - 1));
  return both;
}

bool is_on_floor(const Skeleton& skeleton, int channel) {
  const ChannelKind kind = skeleton.channel_kind(channel);
  return skeleton.joint(skeleton.channel_joint(channel)).parent < 0 &&
         (kind == ChannelKind::TranslationX || kind == ChannelKind::TranslationZ);
}

}  // namespace

Motion loop_of(const Motion& motion, double least_seconds) {
  constexpr int kMostStarts = 200;
  const auto least = static_cast<Eigen::Index>(least_seconds * motion.clip.sample_rate_hz);
  Motion loop{motion.skeleton, {motion.clip.sample_rate_hz, {}}};
  loop.clip.channels.resize(0, motion.skeleton.channel_count());
  if (motion.clip.frames() < least + 2) return loop;
  const Eigen::MatrixXd found = poses(motion);
  const Eigen::Index step = found.rows() / kMostStarts + 1;
  double nearest = std::numeric_limits<double>::infinity();
  Eigen::Index first = 0;
  Eigen::Index last = 0;
  for (Eigen::Index i = 0; i < found.rows(); i += step)
    for (Eigen::Index j = i + least; j < found.rows(); j += step) {
      const double apart = (found.row(i) - found.row(j)).squaredNorm();
      if (apart >= nearest) continue;
      nearest = apart;
      first = i;
      last = j;
    }
  loop.clip.channels = motion.clip.channels.middleRows(first, last - first + 1);
  const Eigen::Index frames = loop.clip.channels.rows();
  for (int c = 0; c < motion.skeleton.channel_count(); ++c) {
    if (is_on_floor(motion.skeleton, c)) continue;
    auto channel = loop.clip.channels.col(c);
    const double left = channel(frames - 1) - channel(0);
    channel -= Eigen::VectorXd::LinSpaced(frames, 0, left);
  }
  return loop;
}

}  // namespace mocapress::test
