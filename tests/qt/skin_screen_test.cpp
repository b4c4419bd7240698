// SPDX-License-Identifier: GPL-3.0-or-later
// Characters in the 3D view. Needs an X display with OpenGL (Xvfb is enough).
#include <gtest/gtest.h>

#include <QBuffer>
#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include "core/formats/motion_file.h"
#include "core/motion/landmarks.h"
#include "tests/qt/patience.h"
#include "tests/qt/pixel_colour.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

/// A foot that moves along x, with a head above it.
Skeleton post() {
  Skeleton skeleton;
  Joint foot;
  foot.name = "foot";
  foot.offset = {0, 10, 0};
  foot.channels = {ChannelKind::TranslationX};
  skeleton.add(foot);
  Joint head;
  head.name = "head";
  head.parent = 0;
  head.offset = {0, 100, 0};
  skeleton.add(head);
  return skeleton;
}

/// A blue box of 30 x 100 x 20 cm around it: the foot carries its lower half, the head its upper
/// half.
std::shared_ptr<const Skin> box() {
  Skin skin;
  skin.bones = {{0, Eigen::Affine3d(Eigen::Translation3d(0, -10, 0))},
                {1, Eigen::Affine3d(Eigen::Translation3d(0, -110, 0))}};
  const auto add_face = [&](const Eigen::Vector3f& normal, const Eigen::Vector3f& side) {
    const Eigen::Vector3f up = normal.cross(side);
    const Eigen::Vector3f half(15, 50, 10);
    const auto first = static_cast<std::uint32_t>(skin.vertices.size());
    for (const auto& [s, u] :
         {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
      const Eigen::Vector3f unit =
          normal + static_cast<float>(s) * side + static_cast<float>(u) * up;
      const auto bone = static_cast<std::uint8_t>(unit.y() > 0);
      skin.vertices.push_back({Eigen::Vector3f(0, 60, 0) + half.cwiseProduct(unit),
                               normal,
                               {0.2F, 0.3F, 0.9F},
                               {{bone}, {1}}});
    }
    skin.triangles.push_back({first, first + 1, first + 2});
    skin.triangles.push_back({first, first + 2, first + 3});
  };
  const Eigen::Vector3f x(1, 0, 0);
  const Eigen::Vector3f y(0, 1, 0);
  const Eigen::Vector3f z(0, 0, 1);
  for (const float sign : {-1.0F, 1.0F}) {
    add_face(sign * x, y);
    add_face(sign * y, z);
    add_face(sign * z, x);
  }
  return std::make_shared<const Skin>(std::move(skin));
}

/// The box with a picture whose upper half is red and whose lower half is blue.
std::shared_ptr<const Skin> pictured_box() {
  QImage image(16, 16, QImage::Format_RGB32);
  image.fill(Qt::blue);
  for (int y = 0; y < image.height() / 2; ++y)
    for (int x = 0; x < image.width(); ++x) image.setPixel(x, y, qRgb(255, 0, 0));
  QByteArray png;
  QBuffer file(&png);
  file.open(QIODevice::WriteOnly);
  image.save(&file, "PNG");

  Skin skin = *box();
  skin.pictures = {std::make_shared<SkinPicture>(SkinPicture{"red above blue", png.toStdString()})};
  for (Skin::Vertex& vertex : skin.vertices) {
    vertex.colour = {1, 1, 1};
    vertex.in_picture = {0.5F, vertex.in_bind.y() > 60 ? 0.05F : 0.95F};
    vertex.picture = 0;
  }
  return std::make_shared<const Skin>(std::move(skin));
}

bool isBlue(QRgb pixel) {
  return qBlue(pixel) > qRed(pixel) + 60 && qBlue(pixel) > qGreen(pixel) + 60;
}

bool isReddish(QRgb pixel) {
  return qRed(pixel) > qGreen(pixel) + 60 && qRed(pixel) > qBlue(pixel) + 60;
}

class SkinScreen : public testing::Test {
 protected:
  void SetUp() override {
    viewport_.resize(640, 480);
    viewport_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&viewport_));
    viewport_.setSkeleton(post());
    viewport_.setSkin(box());
    set(&Viewport::setOriginal, original_at_);
    set(&Viewport::setCompressed, compressed_at_);
    viewport_.resetCamera();
    QSignalSpy drawn(&viewport_, &Viewport::drawn);
    ASSERT_TRUE(drawn.wait(kPatience));
  }

  /// A clip of one frame with the foot at x.
  template <typename Setter>
  void set(Setter setter, double x) {
    const auto motion =
        std::make_shared<const Motion>(Motion{post(), {120, Eigen::MatrixXd::Constant(1, 1, x)}});
    (viewport_.*setter)(
        std::make_shared<const Eigen::MatrixXd>(landmark_tracks(motion->skeleton, motion->clip)),
        [motion](int frame, Pose& pose) {
          compute_pose(motion->skeleton, motion->clip.channels.row(frame), pose);
        });
  }

  QImage picture() {
    QSignalSpy captured(&viewport_, &Viewport::captured);
    viewport_.capture();
    EXPECT_TRUE(captured.wait(kPatience));
    return captured.isEmpty() ? QImage() : captured.first().first().value<QImage>();
  }

  /// The colour on the front of the box, 10 cm beside the bone.
  QRgb front(const QImage& picture, double foot_x, float y) const {
    const QVector3D place(static_cast<float>(foot_x) + 10, y, 10);
    return picture.pixel(viewport_.camera().project(place)->toPoint());
  }

  void choose(const std::function<void(ViewOptions&)>& change) {
    ViewOptions options = viewport_.options();
    change(options);
    viewport_.setOptions(options);
  }

  const double original_at_ = 15;
  const double compressed_at_ = -35;
  Viewport viewport_;
};

TEST_F(SkinScreen, DrawsTheCompressedInItsColourAndTheOriginalAsAGreyGhost) {
  const QImage skins = picture();
  choose([](ViewOptions& options) { options.skin = false; });
  const QImage skeletons = picture();
  EXPECT_TRUE(isBlue(front(skins, compressed_at_, 80)));
  EXPECT_FALSE(isBlue(front(skeletons, compressed_at_, 80)));
  const QRgb ghost = front(skins, original_at_, 80);
  EXPECT_TRUE(isGrey(ghost));
  EXPECT_GT(difference(ghost, front(skeletons, original_at_, 80)), 12);
}

TEST_F(SkinScreen, FollowsItsJoints) {
  viewport_.setOriginal(nullptr);
  set(&Viewport::setCompressed, compressed_at_ + 50);
  const QImage moved = picture();
  EXPECT_TRUE(isBlue(front(moved, compressed_at_ + 50, 80)));
  EXPECT_FALSE(isBlue(front(moved, compressed_at_, 80)));
}

TEST_F(SkinScreen, IsColouredByTheErrorsOfItsJoints) {
  auto errors = std::make_shared<Eigen::MatrixXf>(1, 2);
  *errors << 0, 100;
  viewport_.setErrors(errors, {});
  choose([](ViewOptions& options) { options.by_error = true; });
  const QImage coloured = picture();
  EXPECT_GT(difference(front(coloured, compressed_at_, 15), front(coloured, compressed_at_, 105)),
            60);
  EXPECT_FALSE(isBlue(front(coloured, compressed_at_, 105)));
}

/// The box half as large, on the floor.
std::shared_ptr<const Skin> smaller_box() {
  Skin skin = *box();
  skin.lengths.scale = 0.5;
  skin.lengths.bones = {{0, -1, Eigen::Vector3d::Zero()}, {1, 0, Eigen::Vector3d::Zero()}};
  return std::make_shared<const Skin>(std::move(skin));
}

TEST_F(SkinScreen, WithBonesOfItsOwnIsColouredAsFarOffAsItIsSeen) {
  choose([](ViewOptions& options) { options.by_error = true; });
  const auto coloured = [&](float error, double x) {
    viewport_.setErrors(
        std::make_shared<const Eigen::MatrixXf>(Eigen::MatrixXf::Constant(1, 2, error)), {});
    return front(picture(), x, 40);
  };
  viewport_.setSkin(smaller_box());
  EXPECT_EQ(coloured(0, compressed_at_ / 2), coloured(100, compressed_at_ / 2))
      << "both are 25 cm off";
  viewport_.setSkin(box());
  EXPECT_NE(coloured(0, compressed_at_), coloured(100, compressed_at_));
}

TEST_F(SkinScreen, WithBonesOfItsOwnHasItsRingWhereItIsSeen) {
  viewport_.setOriginal(nullptr);
  viewport_.setSkin(smaller_box());
  const QImage plain = picture();
  viewport_.setSelectedJoint(1);
  const QImage selected = picture();
  const auto changed = [&](const QVector3D& place) {
    const QPoint at = viewport_.camera().project(place)->toPoint();
    int count = 0;
    for (int y = -40; y <= 40; ++y)
      for (int x = -40; x <= 40; ++x) {
        const QPoint point = at + QPoint(x, y);
        count += plain.valid(point) && plain.pixel(point) != selected.pixel(point);
      }
    return count;
  };
  EXPECT_GT(changed({static_cast<float>(compressed_at_) / 2, 55, 0}), 10);
  EXPECT_EQ(changed({static_cast<float>(compressed_at_), 110, 0}), 0);
}

TEST_F(SkinScreen, HasARingAroundTheSelectedJointAndKeepsItsColours) {
  const QImage plain = picture();
  viewport_.setSelectedJoint(1);
  const QImage selected = picture();
  const QPoint head =
      viewport_.camera().project({static_cast<float>(compressed_at_), 110, 0})->toPoint();
  EXPECT_EQ(plain.pixel(head), selected.pixel(head));
  int white = 0;
  for (int y = -30; y <= 30; ++y)
    for (int x = -30; x <= 30; ++x) {
      const QPoint place = head + QPoint(x, y);
      white += plain.pixel(place) != selected.pixel(place) && qGray(selected.pixel(place)) > 245;
    }
  EXPECT_GT(white, 10);
  EXPECT_EQ(front(plain, compressed_at_, 12), front(selected, compressed_at_, 12));
}

TEST_F(SkinScreen, IsDrawnInItsHalfSideBySide) {
  choose([](ViewOptions& options) { options.mode = ViewMode::SideBySide; });
  const QImage both = picture();
  int blue = 0;
  for (int y = 0; y < both.height(); ++y)
    for (int x = 0; x < both.width(); ++x)
      if (isBlue(both.pixel(x, y))) {
        ++blue;
        ASSERT_GE(x, both.width() / 2 - 1);
      }
  EXPECT_GT(blue, 1000);
}

TEST_F(SkinScreen, HasThePictureOfItsMeshTheRightWayUp) {
  viewport_.setOriginal(nullptr);
  viewport_.setSkin(pictured_box());
  const QImage pictured = picture();
  EXPECT_TRUE(isReddish(front(pictured, compressed_at_, 100)));
  EXPECT_TRUE(isBlue(front(pictured, compressed_at_, 20)));
}

TEST_F(SkinScreen, IsASkeletonWithoutASkin) {
  viewport_.setSkin(nullptr);
  const QImage skeletons = picture();
  EXPECT_FALSE(isBlue(front(skeletons, compressed_at_, 80)));
  EXPECT_TRUE(isReddish(skeletons.pixel(
      viewport_.camera().project({static_cast<float>(compressed_at_), 60, 0})->toPoint())));
}

/// Draws the sample character walking, for people who look at pictures in $MOCAPRESS_PICTURES.
TEST_F(SkinScreen, DrawsTheSampleCharacter) {
  const std::filesystem::path file =
      std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.fbx";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no sample character";
  const MotionFile read = read_motion(file);
  viewport_.setSkeleton(read.motion.skeleton);
  viewport_.setSkin(read.skin);
  const auto motion = std::make_shared<const Motion>(read.motion);
  const auto tracks =
      std::make_shared<const Eigen::MatrixXd>(landmark_tracks(motion->skeleton, motion->clip));
  const auto poses = [motion](int lag) {
    return [motion, lag](int frame, Pose& pose) {
      compute_pose(motion->skeleton, motion->clip.channels.row(frame + lag), pose);
    };
  };
  viewport_.setOriginal(tracks, poses(8));
  viewport_.setCompressed(tracks, poses(0));
  viewport_.setFrame(100);
  viewport_.resetCamera();
  const QImage skins = picture();
  choose([](ViewOptions& options) { options.skin = false; });
  const QImage skeletons = picture();
  int changed = 0;
  for (int y = 0; y < skins.height(); ++y)
    for (int x = 0; x < skins.width(); ++x)
      changed += difference(skins.pixel(x, y), skeletons.pixel(x, y)) > 60;
  EXPECT_GT(changed, 4000);
  if (const char* folder = std::getenv("MOCAPRESS_PICTURES"))
    skins.save(QString::fromUtf8(folder) + QStringLiteral("/skin-overlay.png"));
}

}  // namespace
}  // namespace mocapress
