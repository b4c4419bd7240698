// SPDX-License-Identifier: MIT
#include "core/report/scene_svg.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/report/markup.h"

namespace mocapress {
namespace {

constexpr double kBeside =
    62 * std::numbers::pi / 180;  // angle of the camera from the figure's front
constexpr double kElevation = 11 * std::numbers::pi / 180;  // angle of the camera above the horizon
constexpr double kDistanceInHeights = 2.6;  // distance of the camera in heights of the visible part
constexpr double kGridStepCm = 50;
constexpr int kGridLines = 4;      // on each side of the centre
constexpr std::size_t kFades = 4;  // steps in which the floor fades outwards
constexpr int kShades = 4;         // from near to far limbs
// Direction of the light: movement of a point's shadow for each cm of the point's height.
const Eigen::Vector3d kShadowSlope{0.28, 0, -0.18};

/// The outline around two discs: their outer arcs and common tangents.
std::string capsule_path(double x1, double y1, double r1, double x2, double y2, double r2) {
  const double d = std::hypot(x2 - x1, y2 - y1);
  if (r2 > r1) return capsule_path(x2, y2, r2, x1, y1, r1);
  const double along = std::atan2(y2 - y1, x2 - x1);
  const double aside = d <= r1 - r2 ? 0 : std::acos((r1 - r2) / d);
  const auto on = [](double x, double y, double r, double angle) {
    return px(x + r * std::cos(angle)) + " " + px(y + r * std::sin(angle));
  };
  const auto arc = [](double r, int large) {
    return "A" + px(r) + " " + px(r) + " 0 " + std::to_string(large) + " 0 ";
  };
  if (aside == 0)  // one disc covers the other
    return "M" + on(x1, y1, r1, 0) + arc(r1, 0) + on(x1, y1, r1, std::numbers::pi) + arc(r1, 0) +
           on(x1, y1, r1, 0) + "Z";
  return "M" + on(x1, y1, r1, along + aside) + "L" + on(x2, y2, r2, along + aside) + arc(r2, 0) +
         on(x2, y2, r2, along - aside) + "L" + on(x1, y1, r1, along - aside) + arc(r1, 1) +
         on(x1, y1, r1, along + aside) + "Z";
}

}  // namespace

SceneSvg::SceneSvg(const Picture& picture, const SceneView& view)
    : picture_(picture), view_(view), distance_(kDistanceInHeights * view.height_cm) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d aside = up.cross(view.facing);
  const Eigen::Vector3d level = std::cos(kBeside) * view.facing + std::sin(kBeside) * aside;
  toward_ = std::cos(kElevation) * level + std::sin(kElevation) * up;
  right_ = up.cross(toward_).normalized();
  up_ = toward_.cross(right_);
}

SceneSvg::OnSheet SceneSvg::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d from_centre = point - view_.centre;
  const double depth = std::max(distance_ - from_centre.dot(toward_), 0.2 * distance_);
  const double scale = view_.height / view_.height_cm * distance_ / depth;
  return {view_.width / 2 + scale * from_centre.dot(right_),
          view_.height / 2 - scale * from_centre.dot(up_), scale};
}

void SceneSvg::add_floor() {
  // Snaps the floor to a fixed grid in world space, so that its lines show how far the figure has
  // moved.
  const double x = kGridStepCm * std::round(view_.centre.x() / kGridStepCm);
  const double z = kGridStepCm * std::round(view_.centre.z() / kGridStepCm);
  const double reach = kGridLines * kGridStepCm;
  std::array<std::string, kFades> paths;
  const auto add_line = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    constexpr int kPieces = 4 * kGridLines;
    for (int i = 0; i < kPieces; ++i) {
      const Eigen::Vector3d begin = from + (to - from) * i / kPieces;
      const Eigen::Vector3d end = from + (to - from) * (i + 1) / kPieces;
      const Eigen::Vector3d middle = (begin + end) / 2;
      const double away = std::hypot(middle.x() - view_.centre.x(), middle.z() - view_.centre.z());
      const auto fade = static_cast<std::size_t>(away / reach * kFades);
      const OnSheet a = project(begin);
      const OnSheet b = project(end);
      if (fade < kFades)
        paths[fade] += "M" + px(a.x) + " " + px(a.y) + "L" + px(b.x) + " " + px(b.y);
    }
  };
  for (int i = -kGridLines; i <= kGridLines; ++i) {
    const double offset = i * kGridStepCm;
    add_line({x + offset, picture_.ground_cm, z - reach},
             {x + offset, picture_.ground_cm, z + reach});
    add_line({x - reach, picture_.ground_cm, z + offset},
             {x + reach, picture_.ground_cm, z + offset});
  }
  for (std::size_t fade = 0; fade < kFades; ++fade)
    content_ += element(
        "path", attribute("class", "floor f" + std::to_string(fade)) + attribute("d", paths[fade]),
        "");
}

std::string SceneSvg::capsule(const DrawnBone& bone, const PosePoints& points) const {
  const OnSheet from = project(points[bone.from]);
  const OnSheet to = project(points[bone.to]);
  return capsule_path(from.x, from.y, bone.from_radius * from.scale, to.x, to.y,
                      bone.to_radius * to.scale);
}

void SceneSvg::add_shadow(const PosePoints& points) {
  PosePoints fallen = points;
  for (Eigen::Vector3d& point : fallen) {
    point += (point.y() - picture_.ground_cm) * kShadowSlope;
    point.y() = picture_.ground_cm;
  }
  std::string d;
  for (const DrawnBone& bone : picture_.bones) {
    const OnSheet from = project(fallen[bone.from]);
    const OnSheet to = project(fallen[bone.to]);
    // Flattened, as a disc on the floor appears to the camera.
    d += capsule_path(from.x, from.y, 0.45 * bone.from_radius * from.scale, to.x, to.y,
                      0.45 * bone.to_radius * to.scale);
  }
  content_ += element("path", attribute("class", "shadow") + attribute("d", d), "");
}

void SceneSvg::add_figure(const PosePoints& points, std::string_view css) {
  std::vector<double> nearness;
  for (const DrawnBone& bone : picture_.bones)
    nearness.push_back((points[bone.from] + points[bone.to]).dot(toward_));
  std::vector<std::size_t> order(nearness.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order,
                           [&](std::size_t a, std::size_t b) { return nearness[a] < nearness[b]; });
  std::string bones;
  for (const std::size_t b : order) {
    const double range = nearness[order.back()] - nearness[order.front()];
    const double near = range > 0 ? (nearness[b] - nearness[order.front()]) / range : 1;
    const int shade = std::min(static_cast<int>(near * kShades), kShades - 1);
    bones += element("path",
                     attribute("class", "b" + std::to_string(shade)) +
                         attribute("d", capsule(picture_.bones[b], points)),
                     "");
  }
  content_ += element("g", attribute("class", css), bones);
}

void SceneSvg::add_trail(const std::vector<Eigen::Vector3d>& points, std::string_view css) {
  if (points.empty()) return;
  std::string d;
  for (const Eigen::Vector3d& point : points) {
    const OnSheet at = project({point.x(), picture_.ground_cm, point.z()});
    d += (d.empty() ? "M" : "L") + px(at.x) + " " + px(at.y);
  }
  const OnSheet end = project({points.back().x(), picture_.ground_cm, points.back().z()});
  content_ += element(
      "g", attribute("class", css),
      element("path", attribute("d", d), "") +
          element("circle",
                  attribute("cx", px(end.x)) + attribute("cy", px(end.y)) + attribute("r", "4"),
                  ""));
}

void SceneSvg::add_gap(const Eigen::Vector3d& wanted, const Eigen::Vector3d& found,
                       const std::string& text) {
  const OnSheet from = project(wanted);
  const OnSheet to = project(found);
  const double x = (from.x + to.x) / 2;
  const double y = (from.y + to.y) / 2;
  const double r = std::hypot(from.x - to.x, from.y - to.y) / 2 + 13;
  const bool leftwards = x > view_.width / 2;
  const double side = leftwards ? 1 : -1;  // away from the figure
  const bool fits = side > 0 ? x + r + 8 < view_.width * 0.8 : x - r - 8 > view_.width * 0.2;
  const double text_x = fits ? x + side * (r + 8) : x - side * (r + 8);
  const bool to_the_right = text_x > x;
  content_ += element(
      "g", attribute("class", "gap"),
      element("path",
              attribute("d", "M" + px(from.x) + " " + px(from.y) + "L" + px(to.x) + " " + px(to.y)),
              "") +
          element("circle", attribute("cx", px(x)) + attribute("cy", px(y)) + attribute("r", px(r)),
                  "") +
          element("text",
                  attribute("x", px(text_x)) + attribute("y", px(y + 4)) +
                      attribute("text-anchor", to_the_right ? "start" : "end"),
                  escaped(text)));
}

std::string SceneSvg::finish(std::string_view label) const {
  return element("svg",
                 attribute("class", "scene") +
                     attribute("viewBox", "0 0 " + px(view_.width) + " " + px(view_.height)) +
                     attribute("role", "img") + attribute("aria-label", label),
                 content_);
}

}  // namespace mocapress
