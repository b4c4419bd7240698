// SPDX-License-Identifier: MIT
// The report's pictures are based on: "Adapting Wavelet Compression to Human Motion Capture Clips",
// Figures 1, 3 and 4.
#include "core/study/report.h"

#include <algorithm>

#include "core/base/frame_text.h"
#include "core/base/utf8_path.h"
#include "core/codec/methods/compression_method.h"
#include "core/metrics/sight_limits.h"
#include "core/mocapress/settings.h"
#include "core/report/chart_svg.h"
#include "core/report/markup.h"
#include "core/report/page_script.h"
#include "core/report/report_phrases.h"
#include "core/report/report_stamp.h"
#include "core/report/report_style.h"
#include "core/report/review_page.h"
#include "core/report/scene_svg.h"
#include "core/study/plan.h"
#include "core/study/report_tables.h"

namespace mocapress {

using namespace html;

namespace {

std::string section(std::string_view title, std::string_view content) {
  if (content.empty()) return "";
  return element("section", "", element("h2", "", title) + std::string(content));
}

/// The index of a series' colour and marker. Most methods have the same one in every study; other
/// series take the remaining ones, in their order.
int style_of(const Results& results, const Series& series) {
  constexpr std::string_view kOwn[] = {"annealed",     "standard", "per-channel", "haar",
                                       "linear",       "pca",      "subsample",   "quaternion",
                                       "liu-mcmillan", "arikan",   "closed-loop", "key-frames"};
  const auto own = std::ranges::find(kOwn, series.method);
  if (own != std::end(kOwn) && !series.ik_ratio) return static_cast<int>(own - std::begin(kOwn));
  std::vector<bool> taken(kChartStyles, false);
  for (const Series& other : results.series())
    if (const auto at = std::ranges::find(kOwn, other.method);
        at != std::end(kOwn) && !other.ik_ratio)
      taken[at - std::begin(kOwn)] = true;
  for (const Series& other : results.series()) {
    if (std::ranges::find(kOwn, other.method) != std::end(kOwn) && !other.ik_ratio) continue;
    const auto free = std::ranges::find(taken, false);
    const auto style = static_cast<int>(free - taken.begin()) % kChartStyles;
    if (&other == &series) return style;
    if (free != taken.end()) *free = true;
  }
  return 0;
}

std::string legend(const ReportLanguage& say, const Results& results) {
  std::string items;
  for (const Series& series : results.series())
    items +=
        element("li", "", legend_mark(style_of(results, series)) + escaped(title_of(say, series)));
  return element("ul", attribute("class", "legend"), items);
}

Chart mean_chart(const ReportLanguage& say, const Results& results) {
  Chart chart{.label = say("Error against compression ratio, averaged over the clips"),
              .width = 1060,
              .height = 520,
              .direct_labels = true};
  for (const Series& series : results.series()) {
    ChartSeries line{.title = title_of(say, series), .style = style_of(results, series)};
    line.line = results.mean_curve(series);
    chart.series.push_back(std::move(line));
  }
  return chart;
}

/// Adds the paper's points to a chart, as hollow markers.
void add_published(const ReportLanguage& say, Chart& chart, const Results& results,
                   const PublishedClip& clip) {
  const auto add = [&](const char* method, auto size_of) {
    const Series* series = results.find_series(method);
    if (!series) return;
    ChartSeries points{.title = say("The paper: %1", {title_of(say, *series)}),
                       .style = style_of(results, *series),
                       .paper = true};
    for (const PublishedSizes& row : clip.sizes)
      points.markers.push_back({size_of(row).ratio, row.eps_cm});
    chart.series.push_back(std::move(points));
  };
  add("pca", [](auto& row) { return row.pca; });
  add("standard", [](auto& row) { return row.standard; });
  add("annealed", [](auto& row) { return row.annealed; });
}

std::string clip_chart(const ReportLanguage& say, const Results& results, const StudiedClip& clip) {
  Chart chart{.label = say("%1: error against compression ratio", {clip.title}),
              .width = 350,
              .height = 270};
  for (const Series& series : results.series()) {
    ChartSeries one{.title = title_of(say, series), .style = style_of(results, series)};
    one.line = one.markers = results.curve(clip, series);
    chart.series.push_back(std::move(one));
  }
  if (clip.published) add_published(say, chart, results, *clip.published);
  const std::string title =
      clip.published ? clip.title + ", " + std::string(clip.published->title) : clip.title;
  return element(
      "figure", attribute("class", "clip"),
      element("h3", "",
              escaped(title) + " " +
                  element("small", "", say("%1 frames", {std::to_string(clip.frames)}))) +
          draw(chart, say));
}

std::string mean_of(const ReportLanguage& say, const MeanRatio& mean) {
  return mean.clips == 1 ? say("one clip")
                         : say("geometric mean of %1 clips", {std::to_string(mean.clips)});
}

std::string tiles(const ReportLanguage& say, const Results& results) {
  if (!results.leading_series()) return "";
  const double eps_cm = headline_eps_cm(results);
  const Series& first = *results.leading_series();
  const auto ratio = results.mean_ratio_at(first, eps_cm);
  std::string all;
  if (ratio)
    all += tile(
        ratio_text(ratio->ratio),
        say("%1 at %2 = %3 cm, %4",
            {escaped(title_of(say, first)), kEpsX, format_shortest(eps_cm), mean_of(say, *ratio)}) +
            (results.weighting() == Weighting::JointOrigins && eps_cm == kPublishedInvisibleEpsCm
                 ? say(" (the paper: about %1:1)", {format_shortest(kPublishedMeanRatio)})
                 : ""));
  for (const char* other_method : {"annealed", "standard"}) {
    const Series* other = results.find_series(other_method);
    if (!other || other->method == first.method || !ratio) continue;
    const auto other_ratio = results.mean_ratio_at(*other, eps_cm);
    if (other_ratio && other_ratio->clips == ratio->clips)
      all += tile(fixed(ratio->ratio / other_ratio->ratio, 2) + "&#215;",
                  say("smaller than %1 at equal error", {escaped(title_of(say, *other))}));
  }
  std::vector<double> ms;
  for (const StudyRow& row : results.rows())
    if (row.measured && row.settings.method == first.method && row.measured->ms_per_frame() > 0)
      ms.push_back(row.measured->ms_per_frame());
  if (const auto mean = geometric_mean(ms))
    all += tile(format_significant(*mean) + " ms",
                say("to compress a frame by %1, including the search for the target",
                    {escaped(title_of(say, first))}));
  return element("div", attribute("class", "tiles"), all);
}

/// The method with the smallest files at an error, among those that reach it for all clips.
const Series* smallest_at(const Results& results, double eps_cm) {
  const Series* smallest = nullptr;
  double largest_ratio = 0;
  for (const Series& series : results.series()) {
    const auto ratio = results.mean_ratio_at(series, eps_cm);
    if (!ratio || ratio->clips < static_cast<int>(results.clips().size()) ||
        ratio->ratio <= largest_ratio)
      continue;
    largest_ratio = ratio->ratio;
    smallest = &series;
  }
  return smallest;
}

/// Recommends a method and presets, by the measurements.
std::string recommendation(const ReportLanguage& say, const Results& results) {
  const double eps_cm = headline_eps_cm(results);
  const Series* best = smallest_at(results, eps_cm);
  if (!best) return "";
  const Series& shipped = *results.leading_series();
  std::string text =
      say("Use %1: it has the smallest files at %2 = %3 cm over all clips.",
          {element("b", "", escaped(title_of(say, *best))), kEpsX, format_shortest(eps_cm)});
  std::string lines;
  for (const Settings& preset : built_in_presets()) {
    if (preset.method != shipped.method || preset.target.kind != Target::Kind::Error ||
        preset.weighting != results.weighting())
      continue;
    const auto ratio = results.mean_ratio_at(shipped, preset.target.value);
    lines += line(head(escaped(preset.name), attribute("scope", "row")) +
                  cell(format_shortest(preset.target.value)) +
                  cell(ratio ? ratio_text(ratio->ratio) : std::string(kNothing)) +
                  cell(ratio ? std::to_string(ratio->clips) : std::string(kNothing)));
  }
  if (lines.empty()) return section(say("Recommended method"), muted(text));
  text += ' ' + say("The presets use %1. The table shows the ratio at the error of each preset. "
                    "Presets also bound the errors of heads, hands and roots, which costs some "
                    "more bytes.",
                    {escaped(title_of(say, shipped))});
  return section(say("Recommended method"),
                 muted(text) + table(line(head(say("Preset")) + head(kEpsX + std::string(", cm")) +
                                          head(say("mean ratio")) + head(say("clips"))),
                                     lines));
}

std::string subtitle(const ReportLanguage& say, const Results& results) {
  return say("Clips: %1, methods: %2, compressions: %3. Error weighting: %4.",
             {std::to_string(results.clips().size()), std::to_string(results.series().size()),
              std::to_string(results.rows().size()), say(std::string(name(results.weighting())))});
}

std::string coding_text(const ReportLanguage& say, const Results& results) {
  for (const StudyRow& row : results.rows())
    if (const auto coding = coding_of(row.settings))
      return say("wavelets by %1", {say(std::string(name(*coding)))});
  return say("no wavelets");
}

std::string measuring_notes(const ReportLanguage& say, const Results& results) {
  const StudyRow& row = results.rows().front();
  std::string notes;
  const auto add = [&](std::string_view term, const std::string& text) {
    notes += element("dt", "", term) + element("dd", "", text);
  };
  add(say("Ratio"),
      say("Bytes of the channels as 32-bit floats, divided by the bytes of the coded motion. The "
          "skeleton counts on neither side, as in the paper. 1 KB = 1024 bytes."));
  add(kEpsX,
      say("The paper's positional distortion (section 3.1), weighted by %1: the weighted root mean "
          "square distance between points of the body and the same points of the original. The "
          "paper's own figures use the weighting %2.",
          {say(std::string(name(results.weighting()))),
           say(std::string(name(Weighting::JointOrigins)))}));
  if (const auto judged = std::ranges::find_if(
          results.rows(), [](const StudyRow& one) { return one.measured.has_value(); });
      judged != results.rows().end()) {
    const SightLimits& limits = judged->measured->seen.limits;
    add(say("Visibility"), say("Judged from %1 m, by %2.", {format_shortest(limits.distance_m),
                                                            escaped(say(limits_text(limits)))}));
  }
  add(say("Mean"),
      say("Geometric mean over the clips of the ratio at equal %1, at errors within the measured "
          "range of every clip. Ratios between measured points are interpolated, linearly in the "
          "logarithms of ratio and error, and marked %2.",
          {kEpsX, "&#8776;"}));
  add(say("Coding"),
      say("%1, seed %2", {coding_text(say, results), std::to_string(row.settings.seed)}));
  int jobs = 0;
  for (const StudyRow& one : results.rows()) jobs = std::max(jobs, one.jobs);
  add(say("Time"),
      say("Wall time of a compression, including the search for the target; compressions at the "
          "same time: up to %1. Work that the compressions of a clip share counts in the first of "
          "them. The paper used a 2 GHz Athlon 64.",
          {std::to_string(jobs)}));
  for (const Series& series : results.series())
    if (const CompressionMethod* compression_method = find_compression_method(series.method))
      add(escaped(title_of(say, series)), escaped(say(std::string(compression_method->note))));
  add(say("The paper"), say("Figures marked as the paper's are from Tables 1 and 2 of %1.",
                            {"Adapting Wavelet Compression to Human Motion Capture Clips"}));
  return element("dl", "", notes);
}

std::string curves_section(const ReportLanguage& say, const Results& results) {
  std::string drawn = draw(mean_chart(say, results), say);
  std::string missing;
  for (const Series& series : results.series())
    if (results.mean_curve(series).empty())
      missing += (missing.empty() ? "" : ", ") + escaped(title_of(say, series));
  if (!missing.empty())
    drawn += muted(
        say("These methods have no mean, since no error is within the range of all clips: %1.",
            {missing}));
  return section(say("Error against compression ratio"),
                 muted(say("Files are smaller to the right, errors smaller to the bottom. "
                           "Curves are geometric means of the ratio at equal error. The dotted "
                           "line is 0.5 cm: the paper saw no artifacts below it.")) +
                     drawn + mean_size_table(say, results));
}

std::string clips_section(const ReportLanguage& say, const Results& results) {
  std::string charts;
  bool published = false;
  for (const StudiedClip& clip : results.clips()) {
    charts += clip_chart(say, results, clip);
    published = published || clip.published;
  }
  return section(say("Every clip"),
                 (published ? muted(say("Hollow marks are the paper's Table 1.")) : "") +
                     legend(say, results) +
                     element("div", attribute("class", "multiples"), charts) +
                     clip_table(say, results));
}

std::string title_of(const ReportLanguage& say, const PicturedMethod& method) {
  return say(std::string(method_title(method.method)));
}

std::string captioned(const std::string& svg, const std::string& caption,
                      const std::string& css = "") {
  return element("figure", css.empty() ? "" : attribute("class", css),
                 svg + element("figcaption", "", caption));
}

/// The index of the landmark with the largest error.
std::size_t worst_landmark(const PosePoints& original, const PosePoints& decoded) {
  std::size_t worst = 0;
  double most = -1;
  for (std::size_t p = 0; p < original.size(); ++p)
    if (const double cm = (original[p] - decoded[p]).norm(); cm > most) most = cm, worst = p;
  return worst;
}

/// The centre of a figure's bounding box, which is extended down to the floor.
Eigen::Vector3d centre_of(const Picture& picture, const PosePoints& points) {
  Eigen::Vector3d low = points.front();
  Eigen::Vector3d high = points.front();
  for (const DrawnBone& bone : picture.bones)
    for (const int landmark : {bone.from, bone.to}) {
      low = low.cwiseMin(points[landmark]);
      high = high.cwiseMax(points[landmark]);
    }
  low.y() = std::min(low.y(), picture.ground_cm);
  return (low + high) / 2;
}

/// The height to show, for which the largest figure of the picture has some air around it.
double seen_height_cm(const Picture& picture) {
  double height = 0;
  const auto consider = [&](const PicturedFrame& frame) {
    const Eigen::Vector3d centre = centre_of(picture, frame.original);
    for (const DrawnBone& bone : picture.bones)
      height = std::max(height, 2 * (frame.original[bone.to] - centre).norm());
  };
  consider(picture.worst);
  for (const PicturedFrame& frame : picture.sequence) consider(frame);
  return 1.12 * height;
}

std::string seconds_text(const ReportLanguage& say, const Picture& picture, int frame) {
  return say("frame %1, %2 s", {frame_text(frame), fixed(frame / picture.sample_rate_hz, 2)});
}

/// A button that opens a method's clip in the viewer. Empty if the page has no viewer for it.
std::string review_of(const ReportLanguage& say, const Picture& picture,
                      const PicturedMethod& method) {
  if (method.review.empty()) return "";
  return element("script", "", method.review) +
         review_button(review_name(picture, method.method),
                       {title_of(say, method), ratio_text(method.ratio),
                        say("largest error %1 cm", {format_significant(method.max_error_cm)})});
}

bool are_reviewed(const std::vector<Picture>& pictures) {
  return std::ranges::any_of(pictures, [](const Picture& picture) {
    return std::ranges::any_of(picture.methods,
                               [](const PicturedMethod& method) { return !method.review.empty(); });
  });
}

std::string worst_scene(const ReportLanguage& say, const Picture& picture, std::size_t m,
                        const SceneView& view) {
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
  const std::string title = title_of(say, method);
  return captioned(scene.finish(say("%1 over its original at its worst frame", {title})),
                   say("%1 at %2: %3 %4 cm over the clip, largest error %5 cm; at this frame: %6.",
                       {element("b", "", escaped(title)), ratio_text(method.ratio), kEpsX,
                        format_significant(method.eps_cm), format_significant(method.max_error_cm),
                        escaped(picture.landmark_names[worst])}) +
                       " " + review_of(say, picture, method));
}

std::string strip(const ReportLanguage& say, const Picture& picture, std::size_t m,
                  double height_cm) {
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
    cells += scene.finish(seconds_text(say, picture, frame.frame));
  }
  return captioned(
      element("div", attribute("class", "cells"), cells),
      say("%1, %2 to %3", {element("b", "", escaped(title_of(say, picture.methods[m]))),
                           seconds_text(say, picture, picture.sequence.front().frame),
                           seconds_text(say, picture, picture.sequence.back().frame)}),
      "strip");
}

std::string foot_scene(const ReportLanguage& say, const Picture& picture, std::size_t m) {
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
  const std::string title = title_of(say, picture.methods[m]);
  return captioned(scene.finish(say("%1: foot that slides most", {title})),
                   say("%1: %2 slides %3 cm while planted.",
                       {element("b", "", escaped(title)), escaped(picture.landmark_names[landmark]),
                        fixed(foot.slid_cm[m], 1)}));
}

std::string sights(const ReportLanguage& say, const Picture& picture, std::size_t m) {
  const std::string title = title_of(say, picture.methods[m]);
  return captioned(draw(picture.methods[m].sights, picture.frames / picture.sample_rate_hz,
                        say("%1: visible errors over time", {title}), say),
                   element("b", "", escaped(title)));
}

/// A section with the worst frame of each method side by side, a sequence of frames, and the foot
/// that slid most.
std::string picture_section(const ReportLanguage& say, const Picture& picture) {
  const double height_cm = seen_height_cm(picture);
  const SceneView view{.centre = centre_of(picture, picture.worst.original),
                       .facing = picture.facing,
                       .height_cm = height_cm};
  std::string pair;
  std::string strips;
  std::string feet;
  std::string seen;
  for (std::size_t m = 0; m < picture.methods.size(); ++m) {
    pair += worst_scene(say, picture, m, view);
    strips += strip(say, picture, m, height_cm);
    seen += sights(say, picture, m);
    if (picture.foot) feet += foot_scene(say, picture, m);
  }
  const std::string clip = utf8(utf8_path(picture.clip).stem());
  std::string content =
      element("h2", "", say("%1 at %2:1", {escaped(clip), format_shortest(picture.ratio)})) +
      muted(say("Compressed motion in red over the original in grey, all at the same ratio. "
                "The first pictures show the frame with the largest error of %1: %2. Lines on "
                "the floor are half a metre apart.",
                {escaped(title_of(say, picture.methods.front())),
                 seconds_text(say, picture, picture.worst.frame)})) +
      element("div", attribute("class", "pair"), pair) + strips +
      element("h3", "", say("Visible errors over time")) + muted(say(kSightLegend)) +
      element("div", attribute("class", "pair"), seen);
  if (picture.foot)
    content += element("h3", "", say("The foot that slides most")) +
               muted(say("Path of the foot over the floor during one contact: original in grey, "
                         "compressed dark.")) +
               element("div", attribute("class", "pair"), feet);
  return element("section", "", content);
}

}  // namespace

std::string report_html(const Results& results, const std::vector<Picture>& pictures,
                        const ReportLanguage& say, std::span<const std::byte> viewer) {
  const ReportStamp stamp = report_stamp();
  std::string body =
      element("header", "",
              element("h1", "", say("Compression study")) + muted(subtitle(say, results)) +
                  muted(escaped(stamp.program + ", " + stamp.time)));
  if (!results.clips().empty()) {
    body += tiles(say, results) + recommendation(say, results) + curves_section(say, results);
    if (are_reviewed(pictures))
      body += element("script", "", say_script(say, {review_texts()})) + review_section(viewer);
    for (const Picture& picture : pictures) body += picture_section(say, picture);
    body += section(say("Size at equal error"), size_table(say, results));
    body += section(say("Time of the annealing"), time_table(say, results));
    body += section(say("Feet held by inverse kinematics"), held_feet_table(say, results));
    body += section(say("Sliding feet"), footskate_table(say, results));
    body += section(say("Rotation errors"), angle_table(say, results));
    body += clips_section(say, results);
  }
  body += section(say("Missed targets"), failure_table(say, results));
  if (!results.clips().empty())
    body += section(say("How clips were measured"), measuring_notes(say, results));
  return page_begin(say.code, say("Compression study"), kReportStyle) + body +
         "</main></body></html>\n";
}

}  // namespace mocapress
