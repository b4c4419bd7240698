// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/clip_outline.h"

#include <algorithm>
#include <cmath>

#include "app/jobs/open_clip.h"
#include "core/baselines/compared_file.h"
#include "core/formats/motion_file.h"
#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

/// The direction on the ground in which the points reach furthest.
Eigen::Vector3d widest(const Eigen::MatrixX3d& points) {
  const Eigen::MatrixX3d centred = points.rowwise() - points.colwise().mean();
  const double xx = centred.col(0).squaredNorm();
  const double zz = centred.col(2).squaredNorm();
  const double xz = centred.col(0).dot(centred.col(2));
  const double angle = std::atan2(2 * xz, xx - zz) / 2;
  return {std::cos(angle), 0, std::sin(angle)};
}

}  // namespace

ClipOutline outlineOf(const Motion& motion) {
  ClipOutline outline{motion.clip.frames(), motion.clip.sample_rate_hz, {}};
  if (outline.frames == 0) return outline;
  Clip pose;
  pose.channels = motion.clip.channels.row(outline.frames / 2);
  const Eigen::MatrixXd track = landmark_tracks(motion.skeleton, pose);
  Eigen::MatrixX3d points(track.cols() / 3, 3);
  for (Eigen::Index p = 0; p < points.rows(); ++p) points.row(p) = track.block<1, 3>(0, 3 * p);

  const Eigen::VectorXd across = points * widest(points);
  const Eigen::VectorXd down = -points.col(1);
  const double size =
      std::max({across.maxCoeff() - across.minCoeff(), down.maxCoeff() - down.minCoeff(), 1e-6});
  const auto at = [&](int landmark) {
    const double x = across[landmark] - (across.maxCoeff() + across.minCoeff()) / 2;
    const double y = down[landmark] - (down.maxCoeff() + down.minCoeff()) / 2;
    return QPointF(0.5 + x / size, 0.5 + y / size);
  };
  int end_site = motion.skeleton.joint_count();
  for (const Segment& segment : motion.skeleton.segments())
    outline.bones << QLineF(at(segment.joint), at(segment.child >= 0 ? segment.child : end_site++));
  return outline;
}

ClipOutline readOutline(const QString& path, const QString& skeleton, const ReadOptions& reading) {
  if (isCompressedFile(path)) {
    const OpenedMcpr opened = open_mcpr(path.toStdU16String());
    return outlineOf({opened.compressed.skeleton, opened.decoded});
  }
  std::optional<std::filesystem::path> beside;
  if (!skeleton.isEmpty()) beside = skeleton.toStdU16String();
  return outlineOf(read_motion(path.toStdU16String(), beside, reading).motion);
}

}  // namespace mocapress
