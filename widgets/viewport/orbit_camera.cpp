// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mocapress {
namespace {

constexpr float kRadiansPerPixel = 0.007f;
constexpr float kDistancePerNotch = 0.85f;
constexpr float kSteepest = 89;  // degrees
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

void OrbitCamera::lookDown() {
  azimuth_ = 0;
  elevation_ = radians(kSteepest);
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
  distance_ = std::clamp(distance_, 0.1f * radius_, 100 * radius_);
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

}  // namespace mocapress
