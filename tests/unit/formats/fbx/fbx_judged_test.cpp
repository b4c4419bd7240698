// SPDX-License-Identifier: MIT
// Compares files of Maya, 3ds Max, MotionBuilder and Blender, corner by corner, with the meshes
// that these programs exported beside them. Prints the tables of JUDGED.md.
//
// The frame number of an .obj counts from time 0. Maya's game sausage is an exception: its clips
// are cut from one time line and count from the start of their take.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <regex>
#include <sstream>

#include "core/base/file.h"
#include "core/formats/fbx/fbx_reader.h"
#include "core/formats/fbx/fbx_scene.h"
#include "tests/support/corpus.h"

namespace mocapress::fbx_judged_test {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

struct Picture {
  std::vector<Vector3d> corners;  // three a triangle
  double height = 0;              // its largest extent
  // Maya moves the skinned mesh once more with its node.
  bool moves_with_node = false;
};

Picture read_obj(const fs::path& path) {
  Picture picture;
  Eigen::AlignedBox3d box;
  std::vector<Vector3d> points;
  std::istringstream in(read_text(path));
  for (std::string line; std::getline(in, line);) {
    picture.moves_with_node |= line.find("transform_skin") != line.npos;
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      Vector3d point;
      words >> point.x() >> point.y() >> point.z();
      points.push_back(point);
      box.extend(point);
    } else if (word == "f") {
      std::vector<std::size_t> polygon;
      while (words >> word) polygon.push_back(std::stoul(word) - 1);
      for (std::size_t k = 2; k < polygon.size(); ++k)
        for (const std::size_t corner : {polygon[0], polygon[k - 1], polygon[k]})
          picture.corners.push_back(points[corner]);
    }
  }
  picture.height = box.sizes().maxCoeff();
  return picture;
}

Eigen::Affine3d affine(const NodePlacement& placement) {
  Eigen::Affine3d transform(placement.world_from_node);
  transform.translation() = placement.origin;
  return transform;
}

/// Corners of the meshes of a take in the file's unit; frame -1: at rest.
std::vector<Vector3d> corners_of(const NodeTake& take, int frame, bool moves_with_node) {
  std::vector<Eigen::Affine3d> file_from;
  std::vector<NodePlacement> placements;
  const NodePlacement file = file_placement(1, UpAxis::Y);
  Eigen::Affine3d moved = Eigen::Affine3d::Identity();
  for (const AnimatedNode& node : take.nodes) {
    placements.push_back(
        below(node.parent < 0 ? file : placements[static_cast<std::size_t>(node.parent)],
              frame < 0 || node.frames.empty() ? node.rest
                                               : node.frames[static_cast<std::size_t>(frame)]));
    file_from.push_back(affine(placements.back()));
    if (moves_with_node && node.name == "pCube1")
      moved = file_from.back() * take.meshes.front().file_from_mesh->inverse();
  }
  std::vector<Vector3d> corners;
  for (const NodeMesh& mesh : take.meshes)
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t v : triangle) {
        const auto on = [&](std::size_t bone) {
          const NodeMesh::Bone& of = mesh.bones[bone];
          return Vector3d(file_from[static_cast<std::size_t>(of.node)] * of.node_from_mesh *
                          mesh.positions[v]);
        };
        Vector3d place = Vector3d::Zero();
        double sum = 0;
        if (!mesh.weights.empty())
          for (const auto& [bone, weight] : mesh.weights[v]) {
            place += weight * on(bone);
            sum += weight;
          }
        corners.push_back(moved * (sum > 0 ? Vector3d(place / sum) : on(0)));
      }
  return corners;
}

/// The take whose name ends so, whatever the case of its letters.
std::optional<std::string> take_named(FbxFile& file, const std::string& end) {
  if (end.empty()) return std::nullopt;
  const FbxAnimation animation(file.records, file.objects, file.ticks_per_second());
  for (const FbxTakeInfo& take : animation.takes()) {
    std::string name = take.name;
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (name.ends_with(end)) return take.name;
  }
  return std::nullopt;
}

class FbxJudged : public testing::Test {
 protected:
  void SetUp() override {
    const auto corpus = test::corpus();
    if (!corpus || !fs::exists(*corpus / "fbx_judged"))
      GTEST_SKIP() << "the corpus of judged files is not here";
    for (const auto& entry : fs::directory_iterator(*corpus / "fbx_judged"))
      (entry.path().extension() == ".fbx" ? files_ : pictures_).push_back(entry.path());
    std::sort(files_.begin(), files_.end());
  }

  std::vector<fs::path> files_;
  std::vector<fs::path> pictures_;
};

TEST_F(FbxJudged, SkinsAsTheProgramDidThatWroteTheFile) {
  int judged = 0;
  for (const fs::path& path : files_) {
    const std::string name = path.stem().string();
    std::smatch parts;
    if (!std::regex_match(name, parts, std::regex("(.*)_([0-9]{4})_(ascii|binary)(_.*)?")))
      continue;
    // Shapes have a test of their own; of geometry caches the files are not there.
    if (name.starts_with("maya_blend_inbetween") || name.starts_with("maya_axes_anim")) continue;
    const std::string base = parts[1].str() + parts[4].str();
    const std::string bytes = read_text(path);
    int frames = 0;
    double worst = 0;  // as a share of the height
    double worst_cm = 0;
    for (const fs::path& picture_path : pictures_) {
      const std::string of = picture_path.stem().string();
      std::smatch which;
      const bool is_rest = of == base;
      if (!is_rest &&
          !std::regex_match(of, which, std::regex(base + "(?:_(base|wiggle|spin))?_([0-9]+)")))
        continue;
      FbxFile file(path.string(), bytes);
      const Picture picture = read_obj(picture_path);
      const FbxTake read =
          is_rest ? read_fbx_rest(file) : read_fbx_take(file, {.take = take_named(file, which[1])});
      int frame = -1;
      if (!is_rest) {
        const bool is_cut = base.starts_with("maya_game_sausage") && !base.ends_with("wiggle");
        const double since = is_cut ? 0 : read.first_s * read.take.sample_rate_hz;
        frame = std::clamp(static_cast<int>(std::lround(std::stoi(which[2]) - since)), 0,
                           read.take.frames - 1);
      }
      const std::vector<Vector3d> corners = corners_of(read.take, frame, picture.moves_with_node);
      ASSERT_EQ(corners.size(), picture.corners.size()) << of;
      for (std::size_t c = 0; c < corners.size(); ++c) {
        const double off = (corners[c] - picture.corners[c]).norm();
        worst = std::max(worst, off / picture.height);
        worst_cm = std::max(worst_cm, off * read.take.cm_per_unit);
      }
      ++frames;
    }
    if (frames == 0) continue;
    ++judged;
    std::cout << "| " << name << " | " << frames << " | " << worst_cm << " | " << worst << " |\n";
    EXPECT_LT(worst, 1e-3) << name;
  }
  EXPECT_GE(judged, 24);
}

/// Weights of the shapes of a channel at `percent`: from each to the next as a straight line,
/// which goes on beyond the last. The mesh itself is the shape of 0.
std::vector<double> shares_of(const std::vector<double>& full_weights, double percent) {
  std::vector<std::pair<double, int>> stops = {{0, -1}};
  for (const double weight : full_weights)
    stops.emplace_back(weight, static_cast<int>(stops.size()) - 1);
  std::sort(stops.begin(), stops.end());
  std::size_t next = 1;
  while (next + 1 < stops.size() && stops[next].first < percent) ++next;
  const double share =
      (percent - stops[next - 1].first) / (stops[next].first - stops[next - 1].first);
  std::vector<double> shares(full_weights.size());
  const auto add = [&](int shape, double of) {
    if (shape >= 0) shares[static_cast<std::size_t>(shape)] += of;
  };
  add(stops[next - 1].second, 1 - share);
  add(stops[next].second, share);
  return shares;
}

/// Weights of blend shapes as we read them, held against the points of the program. No character of
/// ours has shapes, so the test bends the mesh.
TEST_F(FbxJudged, WeighsShapesAndTheirInBetweensAsMayaDid) {
  const std::string base = "maya_blend_inbetween";
  for (const fs::path& path : files_) {
    const std::string name = path.stem().string();
    if (!name.starts_with(base)) continue;
    const std::string bytes = read_text(path);
    FbxFile file(path.string(), bytes);
    const FbxTake read = read_fbx_take(file, {});
    ASSERT_EQ(read.take.tracks.size(), 2u);
    double worst = 0;
    int frames = 0;
    for (const fs::path& picture_path : pictures_) {
      std::smatch which;
      const std::string of = picture_path.stem().string();
      if (!std::regex_match(of, which, std::regex(base + "_([0-9]+)"))) continue;
      const Picture picture = read_obj(picture_path);
      const auto frame = static_cast<std::size_t>(std::clamp(
          static_cast<int>(
              std::lround(std::stoi(which[1]) - read.first_s * read.take.sample_rate_hz)),
          0, read.take.frames - 1));
      std::vector<double> points;
      std::vector<std::int64_t> ends;
      for (std::size_t o = 0; o < file.objects.all().size(); ++o) {
        const FbxObject& object = file.objects[o];
        if (object.kind == "Mesh" && object.type == "Geometry") {
          points = file.records.numbers(*object.record, "Vertices");
          ends = file.records.integers(*object.record, "PolygonVertexIndex");
        }
      }
      for (std::size_t o = 0; o < file.objects.all().size(); ++o) {
        if (file.objects[o].kind != "BlendShapeChannel") continue;
        const auto track = std::find_if(
            read.take.tracks.begin(), read.take.tracks.end(),
            [&](const ScalarTrack& each) { return each.name == file.objects[o].name; });
        ASSERT_NE(track, read.take.tracks.end());
        std::vector<double> shares =
            shares_of(file.records.numbers(*file.objects[o].record, "FullWeights"),
                      100 * static_cast<double>(track->values[frame]));
        std::size_t shape = 0;
        for (const FbxLink& link : file.objects.children(o)) {
          const FbxObject& geometry = file.objects[link.object];
          if (geometry.kind != "Shape") continue;
          const auto moved = file.records.integers(*geometry.record, "Indexes");
          const auto offsets = file.records.numbers(*geometry.record, "Vertices");
          for (std::size_t i = 0; i < moved.size(); ++i)
            for (std::size_t a = 0; a < 3; ++a)
              points[3 * static_cast<std::size_t>(moved[i]) + a] +=
                  shares[shape] * offsets[3 * i + a];
          ++shape;
        }
        ASSERT_EQ(shape, shares.size());
      }
      std::vector<Vector3d> corners;
      std::vector<std::size_t> polygon;
      for (const std::int64_t end : ends) {
        polygon.push_back(static_cast<std::size_t>(end < 0 ? -(end + 1) : end));
        if (end >= 0) continue;
        for (std::size_t k = 2; k < polygon.size(); ++k)
          for (const std::size_t corner : {polygon[0], polygon[k - 1], polygon[k]})
            corners.emplace_back(&points[3 * corner]);
        polygon.clear();
      }
      ASSERT_EQ(corners.size(), picture.corners.size());
      for (std::size_t c = 0; c < corners.size(); ++c)
        worst = std::max(worst, (corners[c] - picture.corners[c]).norm() / picture.height);
      ++frames;
    }
    std::cout << "| " << name << " | " << frames << " | | " << worst << " |\n";
    EXPECT_EQ(frames, 8);
    EXPECT_LT(worst, 1e-3) << name;
  }
}

TEST_F(FbxJudged, OpensTheOthersOrRefusesThemInOneSentence) {
  for (const fs::path& path : files_) {
    std::string verdict = "read";
    try {
      read_fbx(path.filename().string(), read_text(path));
    } catch (const InputError& error) {
      verdict = error.what();
    }
    std::cout << "| " << path.stem().string() << " | " << verdict << " |\n";
    EXPECT_EQ(verdict.find('\n'), verdict.npos);
    EXPECT_LE(verdict.size(), 200u);
  }
}

}  // namespace
}  // namespace mocapress::fbx_judged_test
