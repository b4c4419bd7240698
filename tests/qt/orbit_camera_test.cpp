// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/orbit_camera.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace mocapress {
namespace {

constexpr float kTolerance = 1e-3f;  // pixels or cm

OrbitCamera cameraAt(const QVector3D& centre, float radius) {
  OrbitCamera camera;
  camera.setViewSize({800, 600});
  camera.lookAt(centre, radius);
  return camera;
}

double pixelsBetween(const std::optional<QPointF>& a, const QPointF& b) {
  return a ? std::hypot(a->x() - b.x(), a->y() - b.y()) : 1e9;
}

TEST(OrbitCamera, SeesItsTargetInTheMiddle) {
  const OrbitCamera camera = cameraAt({10, 90, -30}, 100);
  EXPECT_LT(pixelsBetween(camera.project({10, 90, -30}), {400, 300}), kTolerance);
}

TEST(OrbitCamera, SeesTheWholeSphereInAnyShapeOfWindow) {
  for (const QSizeF size : {QSizeF(800, 600), QSizeF(300, 900), QSizeF(1600, 200)}) {
    OrbitCamera camera;
    camera.setViewSize(size);
    camera.lookAt({0, 90, 0}, 100);
    for (const QVector3D direction :
         {QVector3D(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
      const auto seen = camera.project(QVector3D(0, 90, 0) + 100 * direction);
      ASSERT_TRUE(seen);
      EXPECT_TRUE(QRectF(QPointF(0, 0), size).contains(*seen));
    }
  }
}

/// A figure with its arms spread, `height` cm high.
std::vector<QVector3D> figure(float height) {
  std::vector<QVector3D> points;
  for (const QVector3D point : {QVector3D(0.1f, 0, 0.05f),
                                {-0.1f, 0, -0.1f},
                                {0, 0.55f, 0},
                                {0.5f, 0.8f, 0},
                                {-0.5f, 0.8f, 0.1f},
                                {0, 1, 0.02f}})
    points.push_back(height * (point + QVector3D(3, 0, -2)));
  return points;
}

TEST(OrbitCamera, FramesAFigureOfAnySizeInAnyShapeOfWindowWithoutWaste) {
  for (const float height : {0.01f, 1.0f, 100.0f, 170.0f, 1e4f, 1e6f})
    for (const QSizeF size : {QSizeF(800, 600), QSizeF(300, 900), QSizeF(1600, 200)}) {
      OrbitCamera camera;
      camera.setViewSize(size);
      camera.frame(figure(height), 0.1f * height);
      QRectF seen;
      for (const QVector3D& point : figure(height)) {
        const auto at = camera.project(point);
        ASSERT_TRUE(at);
        EXPECT_TRUE(QRectF(QPointF(), size).contains(*at)) << height;
        const QRectF here(*at, QSizeF(1, 1));
        seen = seen.isNull() ? here : seen.united(here);
      }
      EXPECT_GT(std::max(seen.width() / size.width(), seen.height() / size.height()), 0.75)
          << height;
      EXPECT_NEAR(seen.center().x(), size.width() / 2, 0.06 * size.width());
      EXPECT_NEAR(seen.center().y(), size.height() / 2, 0.06 * size.height());
      EXPECT_LT(camera.nearPlane(), camera.distance() - height);
      EXPECT_GT(camera.farPlane(), camera.distance() + height);
    }
}

TEST(OrbitCamera, FramesASinglePoint) {
  OrbitCamera camera;
  camera.setViewSize({800, 600});
  camera.frame(std::vector<QVector3D>{{5, 6, 7}}, 10);
  EXPECT_LT(pixelsBetween(camera.project({5, 6, 7}), {400, 300}), kTolerance);
  EXPECT_GT(camera.distance(), 10);
}

TEST(OrbitCamera, ZoomEndsWhereTheFigureIsStillSeen) {
  for (const float height : {1.0f, 170.0f, 1e4f}) {
    OrbitCamera camera;
    camera.setViewSize({900, 700});
    camera.frame(figure(height), 0.1f * height);
    for (int notch = 0; notch < 300; ++notch) camera.zoom(-1);
    const double pixels =
        std::abs(camera.project(figure(height)[5])->y() - camera.project(figure(height)[0])->y());
    EXPECT_GT(pixels, 15) << height;
    for (int notch = 0; notch < 300; ++notch) camera.zoom(1);
    EXPECT_GT(camera.distance(), 0.02f * height);
    EXPECT_LT(camera.distance(), 0.2f * height);
  }
}

TEST(OrbitCamera, DrawsUpUpwards) {
  const OrbitCamera camera = cameraAt({0, 0, 0}, 100);
  EXPECT_LT(camera.project({0, 50, 0})->y(), camera.project({0, 0, 0})->y());
}

TEST(OrbitCamera, OrbitsAtAConstantDistanceAndStopsShortOfThePoles) {
  OrbitCamera camera = cameraAt({5, 6, 7}, 100);
  const float distance = camera.distance();
  for (int step = 0; step < 100; ++step) {
    camera.orbit({13, 40});
    EXPECT_NEAR((camera.eye() - camera.target()).length(), distance, kTolerance);
  }
  EXPECT_GT(camera.eye().y(), camera.target().y() + 0.99f * distance);
  EXPECT_LT(pixelsBetween(camera.project({5, 6, 7}), {400, 300}), kTolerance);
}

TEST(OrbitCamera, TurnsTheSceneWithTheHand) {
  OrbitCamera camera = cameraAt({0, 0, 0}, 100);
  const QVector3D towards_eye = camera.eye() / 10;
  camera.orbit({20, 10});
  EXPECT_GT(camera.project(towards_eye)->x(), 400);
  EXPECT_GT(camera.project(towards_eye)->y(), 300);
}

TEST(OrbitCamera, PansWhatLiesAtTheTargetWithTheHand) {
  OrbitCamera camera = cameraAt({0, 90, 0}, 100);
  camera.pan({37, -21});
  EXPECT_LT(pixelsBetween(camera.project({0, 90, 0}), {437, 279}), 0.05);
}

TEST(OrbitCamera, ZoomsThereAndBackWithinBounds) {
  OrbitCamera camera = cameraAt({0, 90, 0}, 100);
  const float distance = camera.distance();
  camera.zoom(3);
  EXPECT_LT(camera.distance(), distance);
  camera.zoom(-3);
  EXPECT_NEAR(camera.distance(), distance, kTolerance);
  camera.zoom(1000);
  EXPECT_GT(camera.distance(), 0);
  camera.zoom(-5000);
  EXPECT_LT(camera.distance(), 1e5f);
}

TEST(OrbitCamera, ClipsNeitherDwarfsNorGiants) {
  for (const float radius : {0.01f, 1.0f, 100.0f, 1e5f}) {
    const OrbitCamera camera = cameraAt({0, radius, 0}, radius);
    EXPECT_LT(camera.nearPlane(), camera.distance() - radius);
    EXPECT_GT(camera.farPlane(), camera.distance() + radius);
  }
}

TEST(OrbitCamera, ProjectsNothingFromBehindTheEye) {
  const OrbitCamera camera = cameraAt({0, 0, 0}, 100);
  EXPECT_FALSE(camera.project(2 * camera.eye()));
}

TEST(OrbitCamera, LooksDownAndBackToWhereItLookedFrom) {
  OrbitCamera camera;
  camera.lookAt({1, 2, 3}, 100);
  camera.orbit({30, -20});
  const QVector3D before = camera.eye();
  camera.lookAlong(ViewAxis::Top);
  EXPECT_GT(camera.eye().y() - camera.target().y(), 0.99F * camera.distance());
  camera.lookAlong(ViewAxis::Top);
  EXPECT_LT((camera.eye() - before).length(), 1e-3F * camera.distance());
  camera.lookAlong(ViewAxis::Top);
  camera.orbit({5, 5});
  camera.lookAlong(ViewAxis::Top);
  EXPECT_GT(camera.eye().y() - camera.target().y(), 0.99F * camera.distance());
}

TEST(OrbitCamera, LooksFromTheFrontAndTheSide) {
  OrbitCamera camera;
  camera.lookAt({1, 2, 3}, 100);
  camera.lookAlong(ViewAxis::Front);
  const QVector3D from_front = (camera.eye() - camera.target()) / camera.distance();
  EXPECT_LT((from_front - QVector3D(0, 0, 1)).length(), 1e-3F);
  camera.lookAlong(ViewAxis::Side);
  const QVector3D from_side = (camera.eye() - camera.target()) / camera.distance();
  EXPECT_LT((from_side - QVector3D(1, 0, 0)).length(), 1e-3F);
  camera.setFront(std::numbers::pi_v<float>);  // the figure faces -z
  camera.lookAlong(ViewAxis::Front);
  EXPECT_LT(camera.eye().z() - camera.target().z(), -0.99F * camera.distance());
}

TEST(OrbitCamera, ComesBackToAPlaceThatWasKept) {
  OrbitCamera camera;
  camera.lookAt({1, 2, 3}, 100);
  camera.orbit({30, -20});
  camera.zoom(2);
  const OrbitCamera::Place kept = camera.place();
  const QVector3D eye = camera.eye();
  camera.pan({40, 10});
  camera.orbit({-100, 50});
  camera.setPlace(kept);
  EXPECT_LT((camera.eye() - eye).length(), 1e-3F);
}

TEST(OrbitCamera, LooksCloseWithoutTurning) {
  OrbitCamera camera;
  camera.setViewSize({800, 600});
  camera.lookAt({0, 90, 0}, 100);
  const QVector3D direction = (camera.eye() - camera.target()).normalized();
  camera.lookClose({20, 40, 0}, 20);
  EXPECT_EQ(camera.target(), QVector3D(20, 40, 0));
  EXPECT_LT(((camera.eye() - camera.target()).normalized() - direction).length(), 1e-4F);
  const QPointF edge = *camera.project({20, 60, 0});
  EXPECT_GT(edge.y(), 0);
  EXPECT_LT(edge.y(), 120);  // a fifth of the view from its top
}

}  // namespace
}  // namespace mocapress
