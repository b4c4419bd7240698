// SPDX-License-Identifier: MIT
// Pictures that meshes of a glTF have their colours from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <string>

#include "core/base/file.h"
#include "core/formats/motion_file.h"
#include "tests/support/small_gltf.h"

namespace mocapress {
namespace {

using test::SmallGltf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;

const std::string kPng = std::string("\x89PNG\r\n\x1A\n") + "no more is read of it";

/// A triangle on the knee. `image`: its entry in "images".
SmallGltf painted_knee(const GltfJson& image) {
  SmallGltf gltf = test::bending_knee();
  const std::size_t places = gltf.add("VEC3", std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::size_t in_picture = gltf.add("VEC2", std::vector<float>{0, 0, 0.5F, 0, 0, 2});
  gltf.json["images"] = GltfJson::array({image});
  gltf.json["textures"] = {{{"source", 0}}};
  gltf.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  gltf.json["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", places}, {"TEXCOORD_0", in_picture}}}, {"material", 0}}}}}};
  gltf.json["nodes"][1]["mesh"] = 0;
  return gltf;
}

MotionFile read(const SmallGltf& gltf, const std::filesystem::path& file = "small.glb") {
  return parse_motion(file, gltf.glb());
}

void expect_painted(const MotionFile& file) {
  ASSERT_TRUE(file.skin);
  ASSERT_EQ(file.skin->pictures.size(), 1u);
  EXPECT_EQ(file.skin->pictures[0]->bytes, kPng);
  EXPECT_EQ(file.skin->vertices[1].picture, 0);
  EXPECT_EQ(file.skin->vertices[1].in_picture, Eigen::Vector2f(0.5F, 0));
  EXPECT_EQ(file.skin->vertices[2].in_picture, Eigen::Vector2f(0, 2));
  EXPECT_NEAR(file.skin->vertices[0].colour.minCoeff(), 1, 1e-6);
}

void expect_plain(const MotionFile& file, const char* why) {
  ASSERT_TRUE(file.skin);
  EXPECT_TRUE(file.skin->pictures.empty());
  EXPECT_EQ(file.skin->vertices[0].picture, -1);
  EXPECT_EQ(file.skin->vertices[0].colour, kPlainSkin);
  EXPECT_THAT(file.warnings, Contains(Field(&Warning::message, HasSubstr(why))));
}

TEST(SkinPicture, IsReadFromTheFileItself) {
  SmallGltf gltf = painted_knee({});
  const std::size_t view = gltf.add_view(std::vector<char>(kPng.begin(), kPng.end()));
  gltf.json["images"][0] = {{"bufferView", view}, {"mimeType", "image/png"}};
  expect_painted(read(gltf));
}

TEST(SkinPicture, IsReadFromItsFolderAlone) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) /
                                       ("mocapress-pictures-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder / "in");
  write_text(folder / "in/skin.png", kPng);
  write_text(folder / "out.png", kPng);
  const std::filesystem::path file = folder / "in/small.glb";
  expect_painted(read(painted_knee({{"uri", "skin.png"}}), file));
  expect_plain(read(painted_knee({{"uri", "../out.png"}}), file), "only files in its own folder");
  expect_plain(read(painted_knee({{"uri", "gone.png"}}), file), "which is not there");
  std::filesystem::remove_all(folder);
}

TEST(SkinPicture, IsPngOrJpeg) {
  expect_plain(read(painted_knee({{"uri", "data:image/gif;base64,R0lGODlh"}})),
               "it is neither PNG nor JPEG");
  expect_plain(read(painted_knee({{"name", "coat"}})), "the picture coat is not shown");
}

}  // namespace
}  // namespace mocapress
