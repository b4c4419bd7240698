// SPDX-License-Identifier: MIT
// Pictures that colour the meshes of a glTF.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <numbers>
#include <string>
#include <utility>

#include "core/base/file.h"
#include "core/formats/gltf_reader.h"
#include "core/formats/motion_file.h"
#include "tests/support/small_gltf.h"

namespace mocapress::skin_picture_test {
namespace {

using test::SmallGltf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;

const std::string kPng = std::string("\x89PNG\r\n\x1A\n") + "no more is read of it";

/// A triangle on the knee with a picture. `image`: its entry in "images".
SmallGltf painted_knee(const Json& image) {
  SmallGltf gltf = test::bending_knee();
  const std::size_t places = gltf.add("VEC3", std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::size_t in_picture = gltf.add("VEC2", std::vector<float>{0, 0, 0.5F, 0, 0, 2});
  gltf.json["images"] = Json::array({image});
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

/// Texture coordinates of the second and the third vertex.
std::pair<Eigen::Vector2f, Eigen::Vector2f> places_moved_by(const Json& transform) {
  SmallGltf gltf = painted_knee({{"uri", "data:image/png;base64,iVBORw0KGgo="}});
  gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
      {"KHR_texture_transform", transform}};
  const MotionFile file = read(gltf);
  return {file.skin->vertices.at(1).in_picture, file.skin->vertices.at(2).in_picture};
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

TEST(SkinPicture, IsMovedTurnedAndScaledByATextureTransform) {
  // The vertices' own coordinates are (0.5, 0) and (0, 2).
  const auto [scaled, down] = places_moved_by({{"scale", {2, 0.25}}, {"offset", {0.125, 0.5}}});
  EXPECT_TRUE(scaled.isApprox(Eigen::Vector2f(1.125F, 0.5F)));
  EXPECT_TRUE(down.isApprox(Eigen::Vector2f(0.125F, 1)));
  // Counter-clockwise in the picture: a point to the right goes up.
  const auto [right, below] =
      places_moved_by({{"rotation", std::numbers::pi / 2}, {"scale", {2, 1}}, {"offset", {0, 1}}});
  EXPECT_LT(right.norm(), 1e-6F);
  EXPECT_TRUE(below.isApprox(Eigen::Vector2f(2, 1)));
}

/// The extension's own example: "only the lower left quadrant of the source image". Computed by
/// hand, with the second coordinate down: (u, v) -> (v / 2, 1 - u / 2).
TEST(SkinPicture, IsTurnedAsTheExampleOfTheSpecificationIs) {
  const auto [first, second] =
      places_moved_by({{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}});
  EXPECT_TRUE(first.isApprox(Eigen::Vector2f(0, 0.75F), 1e-5F));  // from (0.5, 0)
  EXPECT_TRUE(second.isApprox(Eigen::Vector2f(1, 1), 1e-5F));     // from (0, 2)
}

TEST(SkinPicture, IsLookedUpByTheCoordinatesThatATextureTransformNames) {
  SmallGltf gltf = painted_knee({{"uri", "data:image/png;base64,iVBORw0KGgo="}});
  const std::size_t second = gltf.add("VEC2", std::vector<float>{0, 0, 0.25F, 0, 0, 0.75F});
  gltf.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = second;
  gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
      {"KHR_texture_transform", {{"texCoord", 1}}}};
  EXPECT_EQ(read(gltf).skin->vertices.at(2).in_picture, Eigen::Vector2f(0, 0.75F));
}

/// Expects the motion to be read, and a sentence that says what is not.
void expect_left_out(const SmallGltf& gltf, const std::string& extension) {
  const MotionFile file = read(gltf);
  EXPECT_FALSE(file.skin);
  EXPECT_GT(file.motion.clip.frames(), 1);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_THAT(file.warnings[0].message, HasSubstr("its character is not read: "));
  EXPECT_THAT(file.warnings[0].message, HasSubstr(extension));
  try {
    read_gltf_character("small.glb", gltf.glb());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(extension));
  }
}

TEST(PackedMesh, LeavesOutBrokenDracoInOneSentence) {
  SmallGltf gltf = painted_knee({{"uri", "data:image/png;base64,iVBORw0KGgo="}});
  gltf.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  Json& primitive = gltf.json["meshes"][0]["primitives"][0];
  primitive["extensions"] = {
      {"KHR_draco_mesh_compression", {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}}}};
  const std::size_t position = primitive["attributes"]["POSITION"];
  gltf.json["accessors"][position].erase("bufferView");  // its values are in the packed bytes
  gltf.json["meshes"][0]["primitives"].push_back(primitive);
  expect_left_out(gltf, "KHR_draco_mesh_compression");
}

TEST(PackedMesh, IsReadUnpackedWhereItAlsoStandsSo) {
  SmallGltf gltf = painted_knee({{"uri", "data:image/png;base64,iVBORw0KGgo="}});
  gltf.json["meshes"][0]["primitives"][0]["extensions"] = {
      {"KHR_draco_mesh_compression", {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}}}};
  EXPECT_TRUE(read(gltf).skin);
}

TEST(PackedMesh, LeavesOutBrokenMeshoptInOneSentence) {
  for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    SmallGltf gltf = painted_knee({{"uri", "data:image/png;base64,iVBORw0KGgo="}});
    const std::size_t position = gltf.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
    const std::size_t view = gltf.json["accessors"][position]["bufferView"];
    gltf.json["bufferViews"][view]["extensions"] = {{extension, {{"buffer", 0}}}};
    expect_left_out(gltf, "EXT_meshopt_compression");
  }
}

}  // namespace
}  // namespace mocapress::skin_picture_test
