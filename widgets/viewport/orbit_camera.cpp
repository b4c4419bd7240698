// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/orbit_camera.h"

#include <QLineF>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/viewport/figure_shape.h"

namespace mocapress {

namespace {

constexpr float kRadiansPerPixel = 0.007f;
constexpr float kDistancePerNotch = 0.85f;
constexpr float kSteepest = 89;   // degrees
constexpr float kFilled = 0.86f;  // share of the view that framed points fill
constexpr float kNearest = 0.1f;  // distance to the target, per radius
constexpr float kFurthest = 60;   // distance, per radius: a person is then about 40 pixels high
constexpr QVector3D kUp{0, 1, 0};

constexpr float radians(float degrees) {
  return degrees * std::numbers::pi_v<float> / 180;
}

const float kHalfHeight = std::tan(radians(OrbitCamera::kFieldOfView) / 2);  // at distance 1

}  // namespace

void OrbitCamera::setViewSize(const QSizeF& pixels) {
  size_ = pixels.expandedTo({1, 1});
}

float OrbitCamera::aspectRatio() const {
  return static_cast<float>(size_.width() / size_.height());
}

void OrbitCamera::lookAt(const QVector3D& centre, float radius) {
  const float half_angle = std::atan(kHalfHeight * std::min(1.0f, aspectRatio()));
  target_ = centre;
  radius_ = radius;
  distance_ = radius / std::sin(half_angle);
  azimuth_ = radians(38);
  elevation_ = radians(12);
}

void OrbitCamera::frame(std::span<const QVector3D> points, float least_radius) {
  if (points.empty()) return;
  QVector3D low = points[0], high = points[0];
  for (const QVector3D& point : points)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  const QVector3D centre = (low + high) / 2;
  float radius = least_radius;
  for (const QVector3D& point : points) radius = std::max(radius, (point - centre).length());
  lookAt(centre, radius);
  if (radius <= least_radius) return;  // a single point has no size to fill the view
  // The distance depends on the view's centre, and the centre on the distance, so both are
  // iterated.
  constexpr int kRounds = 4;
  const QVector3D right = this->right();
  const QVector3D up = QVector3D::crossProduct(targetToEye(), right);
  const float tallest = kFilled * kHalfHeight;
  const float widest = tallest * aspectRatio();
  for (int round = 0; round < kRounds; ++round) {
    float left_most = 1e9f, right_most = -1e9f, lowest = 1e9f, highest = -1e9f;  // at distance 1
    for (const QVector3D& point : points) {
      const QVector3D away = point - target_;
      const float depth = distance_ - QVector3D::dotProduct(away, targetToEye());
      const float x = QVector3D::dotProduct(away, right) / depth;
      const float y = QVector3D::dotProduct(away, up) / depth;
      left_most = std::min(left_most, x);
      right_most = std::max(right_most, x);
      lowest = std::min(lowest, y);
      highest = std::max(highest, y);
    }
    target_ += distance_ * ((left_most + right_most) / 2 * right + (lowest + highest) / 2 * up);
    distance_ = radius_;  // the minimum, for points in one line of sight
    for (const QVector3D& point : points) {
      const QVector3D away = point - target_;
      distance_ = std::max({distance_,
                            QVector3D::dotProduct(away, targetToEye()) +
                                std::abs(QVector3D::dotProduct(away, right)) / widest,
                            QVector3D::dotProduct(away, targetToEye()) +
                                std::abs(QVector3D::dotProduct(away, up)) / tallest});
    }
  }
}

OrbitCamera OrbitCamera::along(ViewAxis axis) const {
  OrbitCamera camera = *this;
  camera.azimuth_ = axis == ViewAxis::Top    ? 0
                    : axis == ViewAxis::Side ? front_ + radians(90)
                                             : front_;
  camera.elevation_ = axis == ViewAxis::Top ? radians(kSteepest) : 0;
  return camera;
}

void OrbitCamera::lookAlong(ViewAxis axis) {
  const OrbitCamera along_axis = along(axis);
  const Angles wanted{along_axis.azimuth_, along_axis.elevation_};
  const Angles now{azimuth_, elevation_};
  const Angles next = now == wanted ? before_.value_or(wanted) : wanted;
  if (now != wanted) before_ = now;
  azimuth_ = next.azimuth;
  elevation_ = next.elevation;
}

void OrbitCamera::lookClose(const QVector3D& centre, float radius) {
  target_ = centre;
  distance_ = std::max(radius / (kFilled * kHalfHeight * std::min(1.0f, aspectRatio())),
                       kNearest * radius_);
}

void OrbitCamera::setPlace(const Place& place) {
  target_ = place.target;
  distance_ = std::clamp(place.distance, kNearest * radius_, kFurthest * radius_);
  azimuth_ = place.azimuth;
  elevation_ = std::clamp(place.elevation, radians(-kSteepest), radians(kSteepest));
}

void OrbitCamera::orbit(const QPointF& pixels) {
  azimuth_ -= kRadiansPerPixel * static_cast<float>(pixels.x());
  elevation_ += kRadiansPerPixel * static_cast<float>(pixels.y());
  elevation_ = std::clamp(elevation_, radians(-kSteepest), radians(kSteepest));
}

void OrbitCamera::pan(const QPointF& pixels) {
  const float cm_per_pixel = 2 * distance_ * kHalfHeight / static_cast<float>(size_.height());
  const QVector3D up = QVector3D::crossProduct(targetToEye(), right());
  target_ -= cm_per_pixel * static_cast<float>(pixels.x()) * right();
  target_ += cm_per_pixel * static_cast<float>(pixels.y()) * up;
}

void OrbitCamera::zoom(float notches) {
  distance_ *= std::pow(kDistancePerNotch, notches);
  distance_ = std::clamp(distance_, kNearest * radius_, kFurthest * radius_);
}

QVector3D OrbitCamera::beside(const QVector3D& in_world, const QPointF& pixel) const {
  const QVector3D away = in_world - eye();
  const float depth = -QVector3D::dotProduct(away, targetToEye());
  const float cm_per_pixel = 2 * depth * kHalfHeight / static_cast<float>(size_.height());
  const QVector3D up = QVector3D::crossProduct(targetToEye(), right());
  const QPointF from_middle = pixel - QPointF(size_.width(), size_.height()) / 2;
  return eye() - depth * targetToEye() +
         cm_per_pixel * static_cast<float>(from_middle.x()) * right() -
         cm_per_pixel * static_cast<float>(from_middle.y()) * up;
}

QMatrix4x4 OrbitCamera::clipFromWorld() const {
  QMatrix4x4 matrix;
  matrix.perspective(kFieldOfView, aspectRatio(), nearPlane(), farPlane());
  matrix.lookAt(eye(), target_, kUp);
  return matrix;
}

std::optional<QPointF> OrbitCamera::project(const QVector3D& in_world) const {
  const QVector4D clip = clipFromWorld() * QVector4D(in_world, 1);
  if (clip.w() <= 0) return std::nullopt;
  const QVector3D device = clip.toVector3DAffine();
  return QPointF((1 + device.x()) / 2 * size_.width(), (1 - device.y()) / 2 * size_.height());
}

QVector3D OrbitCamera::targetToEye() const {
  return {std::cos(elevation_) * std::sin(azimuth_), std::sin(elevation_),
          std::cos(elevation_) * std::cos(azimuth_)};
}

QVector3D OrbitCamera::right() const {
  return {std::cos(azimuth_), 0, -std::sin(azimuth_)};
}

std::optional<PickedJoint> pickJoint(const OrbitCamera& camera, const Eigen::MatrixXd& tracks,
                                     int frame, int joint_count, const QPointF& cursor,
                                     double reach) {
  std::optional<PickedJoint> nearest;
  for (int j = 0; j < joint_count; ++j) {
    const std::optional<QPointF> seen = camera.project(landmarkAt(tracks, frame, j));
    if (!seen) continue;
    const double distance = QLineF(*seen, cursor).length();
    if (distance <= reach && (!nearest || distance < nearest->distance))
      nearest = PickedJoint{j, distance};
  }
  return nearest;
}

}  // namespace mocapress
