// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/picture_space.h"

#include <gtest/gtest.h>

namespace mocapress::picture_space_test {
namespace {

const QSizeF kWindow(800, 400);

OrbitCamera cameraFor(const QSizeF& pane) {
  OrbitCamera camera;
  camera.setViewSize(pane);
  camera.lookAt({0, 90, 0}, 100);
  return camera;
}

/// One joint at a place, for one frame.
Eigen::MatrixXd jointAt(const QVector3D& place) {
  Eigen::MatrixXd tracks(1, 3);
  tracks << place.x(), place.y(), place.z();
  return tracks;
}

TEST(PictureSpace, FindsAJointAtThePixelOfItsPlaceInEachPane) {
  const QVector3D place(20, 80, 5);
  const Eigen::MatrixXd tracks = jointAt(place);
  const QVector3D offset(-30, 0, 10);
  const Arrangement sides = arrange({.mode = ViewMode::SideBySide}, true, false);
  const PictureSpace picture(sides, kWindow, cameraFor({400, 400}), offset);
  for (const Pane& pane : {sides.original.pane, sides.compressed.pane}) {
    const auto pixel = picture.pixelOf(place, pane);
    ASSERT_TRUE(pixel);
    const auto joint = picture.pointedAt({{tracks, 0, pane}}, 1, *pixel, 1);
    ASSERT_TRUE(joint);
    EXPECT_EQ(joint->joint, 0);
    EXPECT_EQ(joint->place, place);
  }
  EXPECT_NE(picture.pixelOf(place, sides.original.pane),
            picture.pixelOf(place, sides.compressed.pane));
  EXPECT_FALSE(picture.pointedAt({{tracks, 0, sides.original.pane}}, 1, {1, 1}, 12));
}

TEST(PictureSpace, APlaceBesideItsPaneIsNotInThePicture) {
  const Arrangement sides = arrange({.mode = ViewMode::SideBySide}, true, false);
  const PictureSpace picture(sides, kWindow, cameraFor({400, 400}), {});
  EXPECT_TRUE(picture.pixelOf({0, 90, 0}, sides.original.pane));
  EXPECT_FALSE(picture.pixelOf({400, 90, -400}, sides.original.pane));
}

TEST(PictureSpace, AQuarterSeesTheWorldByItsOwnCamera) {
  const Arrangement quarters = arrange({.quartered = true}, true, false);
  const PictureSpace picture(quarters, kWindow, cameraFor({400, 200}), {});
  ASSERT_EQ(picture.cameras().size(), 4u);
  EXPECT_EQ(picture.quarterAt({10, 10}), 0);
  EXPECT_EQ(picture.quarterAt({790, 10}), 1);
  EXPECT_EQ(picture.quarterAt({10, 390}), 2);
  EXPECT_EQ(picture.quarterAt({790, 390}), 3);
  const QVector3D place(20, 80, 5);
  const Eigen::MatrixXd tracks = jointAt(place);
  const QPointF in_front = *picture.cameras()[1].project(place) + QPointF(400, 0);
  EXPECT_TRUE(picture.pointedAt({{tracks, 0, Pane()}}, 1, in_front, 1));
}

}  // namespace
}  // namespace mocapress::picture_space_test
