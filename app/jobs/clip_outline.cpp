// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/clip_outline.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/jobs/open_clip.h"
#include "core/codec/methods/compared_file.h"
#include "core/formats/motion_file.h"
#include "core/motion/body.h"
#include "core/motion/landmarks.h"
#include "core/motion/rig.h"
#include "core/motion/skin.h"

namespace mocapress {
namespace {

/// The horizontal direction in which the points reach furthest.
Eigen::Vector3d widest(const Eigen::MatrixX3d& points) {
  const Eigen::MatrixX3d centred = points.rowwise() - points.colwise().mean();
  const double xx = centred.col(0).squaredNorm();
  const double zz = centred.col(2).squaredNorm();
  const double xz = centred.col(0).dot(centred.col(2));
  const double angle = std::atan2(2 * xz, xx - zz) / 2;
  return {std::cos(angle), 0, std::sin(angle)};
}

constexpr int kSkinSide = 96;  // pixels

/// Projects points to the square: x to the right, y down, z towards the viewer.
struct View {
  Eigen::Vector3d right;
  Eigen::Vector3d middle;  // centre of the square, in x and y
  double size;

  Eigen::Vector3d of(const Eigen::Vector3d& point) const {
    return {(point.dot(right) - middle.x()) / size + 0.5, (-point.y() - middle.y()) / size + 0.5,
            point.dot(right.cross(Eigen::Vector3d::UnitY()))};
  }
};

View viewOf(const Eigen::MatrixX3d& points) {
  View view{widest(points), Eigen::Vector3d::Zero(), 1};
  const Eigen::VectorXd across = points * view.right;
  const Eigen::VectorXd down = -points.col(1);
  view.middle = {(across.maxCoeff() + across.minCoeff()) / 2,
                 (down.maxCoeff() + down.minCoeff()) / 2, 0};
  view.size =
      std::max({across.maxCoeff() - across.minCoeff(), down.maxCoeff() - down.minCoeff(), 1e-6});
  return view;
}

/// Draws the mesh lit from the viewer, the far triangles first.
QImage pictureOf(const Skin& skin, const Pose& pose) {
  const std::vector<Eigen::Vector3d> places = skinned_positions(skin, pose);
  Eigen::MatrixX3d points(std::ssize(places), 3);
  for (Eigen::Index p = 0; p < points.rows(); ++p)
    points.row(p) = places[static_cast<std::size_t>(p)];
  const View view = viewOf(points);
  std::vector<Eigen::Vector3d> seen;
  for (const Eigen::Vector3d& place : places) seen.push_back(view.of(place));
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
    const auto& [a, b, c] = skin.triangles[t];
    order.emplace_back(seen[a].z() + seen[b].z() + seen[c].z(), t);
  }
  std::sort(order.begin(), order.end());
  QImage picture(kSkinSide, kSkinSide, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& [depth, t] : order) {
    const auto& [a, b, c] = skin.triangles[t];
    const auto at = [&](std::uint32_t corner) {
      return QPointF(kSkinSide * seen[corner].x(), kSkinSide * seen[corner].y());
    };
    const Eigen::Vector3d normal = (places[b] - places[a]).cross(places[c] - places[a]);
    const Eigen::Vector3d to_eye = view.right.cross(Eigen::Vector3d::UnitY());
    const double facing = normal.norm() > 0 ? std::abs(normal.normalized().dot(to_eye)) : 1;
    const Eigen::Vector3f lit = skin.vertices[a].colour * static_cast<float>(0.35 + 0.65 * facing);
    const QColor colour = QColor::fromRgbF(lit.x(), lit.y(), lit.z());
    painter.setPen(QPen(colour, 0.5));  // closes gaps between neighbouring triangles
    painter.setBrush(colour);
    const QPointF corners[] = {at(a), at(b), at(c)};
    painter.drawConvexPolygon(corners, 3);
  }
  return picture;
}

}  // namespace

ClipOutline outlineOf(const Motion& motion, const Skin* skin) {
  ClipOutline outline;
  outline.frames = motion.clip.frames();
  outline.sample_rate_hz = motion.clip.sample_rate_hz;
  outline.rig = rig_of(motion.skeleton);
  if (outline.frames == 0) return outline;
  outline.loop = find_loop(motion);
  Clip shown;
  shown.channels = motion.clip.channels.row(outline.frames / 2);
  const Eigen::MatrixXd track = landmark_tracks(motion.skeleton, shown);
  Eigen::MatrixX3d points(track.cols() / 3, 3);
  for (Eigen::Index p = 0; p < points.rows(); ++p) points.row(p) = track.block<1, 3>(0, 3 * p);

  const int root = body_root(motion.skeleton);
  const View view = viewOf(points.bottomRows(points.rows() - root));
  const auto at = [&](int landmark) {
    const Eigen::Vector3d place = view.of(points.row(landmark));
    return QPointF(place.x(), place.y());
  };
  int end_site = motion.skeleton.joint_count();
  for (const Segment& segment : motion.skeleton.segments()) {
    const int end = segment.child >= 0 ? segment.child : end_site++;
    if (segment.joint >= root) outline.bones << QLineF(at(segment.joint), at(end));
  }
  if (skin) {
    Pose pose;
    compute_pose(motion.skeleton, shown.channels.row(0), pose);
    outline.skin = pictureOf(*skin, pose);
  }
  return outline;
}

ClipOutline readOutline(const QString& path, const QString& skeleton, const ReadOptions& reading) {
  if (isCompressedFile(path)) {
    const OpenedMcpr opened = open_mcpr(path.toStdU16String());
    return outlineOf({opened.compressed.skeleton, opened.decoded}, nullptr);
  }
  std::optional<std::filesystem::path> beside;
  if (!skeleton.isEmpty()) beside = skeleton.toStdU16String();
  const MotionFile file = read_motion(path.toStdU16String(), beside, reading);
  ClipOutline outline = outlineOf(file.motion, file.skin.get());
  for (const Warning& warning : file.warnings)
    outline.notes << QString::fromStdString(warning.text());
  outline.takes = file.takes;
  return outline;
}

std::optional<std::string> takeAmong(const Takes& takes) {
  return takes.keys.size() > 1 ? std::optional(takes.keys.at(takes.read)) : std::nullopt;
}

}  // namespace mocapress
