// SPDX-License-Identifier: MIT
#include "core/study/report_pictures.h"

#include <cmath>

#include "core/baselines/compression_method.h"
#include "core/report/markup.h"
#include "core/report/scene_svg.h"

namespace mocapress {
namespace {

std::string title_of(const PicturedMethod& method) {
  return std::string(method_title(method.method));
}

std::string captioned(const std::string& svg, const std::string& caption,
                      const std::string& css = "") {
  return element("figure", css.empty() ? "" : attribute("class", css),
                 svg + element("figcaption", "", caption));
}

/// The landmark that is furthest off.
std::size_t worst_landmark(const PosePoints& original, const PosePoints& decoded) {
  std::size_t worst = 0;
  double most = -1;
  for (std::size_t p = 0; p < original.size(); ++p)
    if (const double cm = (original[p] - decoded[p]).norm(); cm > most) most = cm, worst = p;
  return worst;
}

/// Midway between the floor and the top of the figure, over the middle of its bones.
Eigen::Vector3d centre_of(const Picture& picture, const PosePoints& points) {
  Eigen::Vector3d low = points.front();
  Eigen::Vector3d high = points.front();
  for (const DrawnBone& bone : picture.bones)
    for (const int landmark : {bone.from, bone.to}) {
      low = low.cwiseMin(points[static_cast<std::size_t>(landmark)]);
      high = high.cwiseMax(points[static_cast<std::size_t>(landmark)]);
    }
  low.y() = std::min(low.y(), picture.ground_cm);
  return (low + high) / 2;
}

/// Figure heights differ: what is seen is the tallest of the picture and some air.
double seen_height_cm(const Picture& picture) {
  double height = 0;
  const auto consider = [&](const PicturedFrame& frame) {
    const Eigen::Vector3d centre = centre_of(picture, frame.original);
    for (const DrawnBone& bone : picture.bones)
      height =
          std::max(height, 2 * (frame.original[static_cast<std::size_t>(bone.to)] - centre).norm());
  };
  consider(picture.worst);
  for (const PicturedFrame& frame : picture.sequence) consider(frame);
  return 1.12 * height;
}

std::string seconds_text(const Picture& picture, int frame) {
  return "frame " + std::to_string(frame) + ", " + fixed(frame / picture.sample_rate_hz, 2) + " s";
}

std::string worst_scene(const Picture& picture, std::size_t m, const SceneView& view) {
  const PosePoints& original = picture.worst.original;
  const PosePoints& decoded = picture.worst.decoded[m];
  const std::size_t worst = worst_landmark(original, decoded);
  SceneSvg scene(picture, view);
  scene.add_floor();
  scene.add_shadow(decoded);
  scene.add_figure(original, "ghost");
  scene.add_figure(decoded, "figure");
  scene.add_gap(original[worst], decoded[worst],
                format_significant((original[worst] - decoded[worst]).norm()) + " cm");
  const PicturedMethod& method = picture.methods[m];
  return captioned(scene.finish(title_of(method) + " over the original at its worst frame"),
                   element("b", "", escaped(title_of(method))) + " at " + ratio_text(method.ratio) +
                       ": &#949;<sub>x</sub> " + format_significant(method.eps_cm) +
                       " cm over the clip, at most " + format_significant(method.max_error_cm) +
                       " cm. Here the " + escaped(picture.landmark_names[worst]) +
                       " is furthest off.");
}

std::string strip(const Picture& picture, std::size_t m, double height_cm) {
  std::string cells;
  for (const PicturedFrame& frame : picture.sequence) {
    SceneSvg scene(picture, {.centre = centre_of(picture, frame.original),
                             .facing = picture.facing,
                             .height_cm = height_cm,
                             .width = 180,
                             .height = 270});
    scene.add_floor();
    scene.add_shadow(frame.decoded[m]);
    scene.add_figure(frame.original, "ghost");
    scene.add_figure(frame.decoded[m], "figure");
    cells += scene.finish(seconds_text(picture, frame.frame));
  }
  return captioned(element("div", attribute("class", "cells"), cells),
                   element("b", "", escaped(title_of(picture.methods[m]))) + ", " +
                       seconds_text(picture, picture.sequence.front().frame) + " to " +
                       seconds_text(picture, picture.sequence.back().frame),
                   "strip");
}

std::string foot_scene(const Picture& picture, std::size_t m) {
  const PicturedFoot& foot = *picture.foot;
  const auto landmark = static_cast<std::size_t>(foot.landmark);
  SceneView view{.centre = foot.pose.original[landmark],
                 .facing = picture.facing,
                 .height_cm = 40,
                 .width = 520,
                 .height = 330};
  view.centre.y() = picture.ground_cm + 11;
  SceneSvg scene(picture, view);
  scene.add_floor();
  scene.add_shadow(foot.pose.decoded[m]);
  scene.add_figure(foot.pose.original, "ghost");
  scene.add_figure(foot.pose.decoded[m], "figure");
  scene.add_trail(foot.original_trail, "trail was");
  scene.add_trail(foot.trails[m], "trail is");
  return captioned(scene.finish(title_of(picture.methods[m]) + ": the foot that slides most"),
                   element("b", "", escaped(title_of(picture.methods[m]))) + ": the " +
                       escaped(picture.landmark_names[landmark]) + " slides " +
                       fixed(foot.slid_cm[m], 1) + " cm while planted.");
}

std::string sights(const Picture& picture, std::size_t m) {
  const std::string title = title_of(picture.methods[m]);
  return captioned(draw(picture.methods[m].sights, picture.frames / picture.sample_rate_hz,
                        title + ": what the eye sees over time"),
                   element("b", "", escaped(title)));
}

}  // namespace

std::string picture_section(const Picture& picture) {
  const double height_cm = seen_height_cm(picture);
  const SceneView view{.centre = centre_of(picture, picture.worst.original),
                       .facing = picture.facing,
                       .height_cm = height_cm};
  std::string pair;
  std::string strips;
  std::string feet;
  std::string seen;
  for (std::size_t m = 0; m < picture.methods.size(); ++m) {
    pair += worst_scene(picture, m, view);
    strips += strip(picture, m, height_cm);
    seen += sights(picture, m);
    if (picture.foot) feet += foot_scene(picture, m);
  }
  const std::string clip = std::filesystem::path(picture.clip).stem().string();
  std::string content =
      element("h2", "", escaped(clip) + " at " + format_shortest(picture.ratio) + ":1") +
      element("p", attribute("class", "muted"),
              "Compressed in red over the original in grey, all at the same ratio. " +
                  std::string("First the frame where ") +
                  escaped(title_of(picture.methods.front())) +
                  " is furthest off: " + seconds_text(picture, picture.worst.frame) +
                  ". Lines on the floor are half a metre apart.") +
      element("div", attribute("class", "pair"), pair) + strips +
      element("h3", "", "What the eye sees") +
      element("p", attribute("class", "muted"), kSightLegend) +
      element("div", attribute("class", "pair"), seen);
  if (picture.foot)
    content += element("h3", "", "The foot that slides most") +
               element("p", attribute("class", "muted"),
                       "The path of the foot over the floor during one contact: grey as captured, "
                       "dark as compressed.") +
               element("div", attribute("class", "pair"), feet);
  return element("section", "", content);
}

}  // namespace mocapress
