// SPDX-License-Identifier: MIT
#include "core/study/take_picture.h"

#include <algorithm>

#include "core/base/utf8_path.h"
#include "core/feet/footskate.h"
#include "core/metrics/rate.h"
#include "core/mocapress/encode_settings.h"
#include "core/report/loaded_clip.h"
#include "core/report/review_clip.h"
#include "core/report/review_page.h"

namespace mocapress {
namespace {

constexpr int kSequenceFrames = 6;

PosePoints points_at(const Eigen::MatrixXd& tracks, int frame) {
  PosePoints points;
  for (Eigen::Index p = 0; p + 2 < tracks.cols(); p += 3)
    points.push_back(tracks.block<1, 3>(frame, p).transpose());
  return points;
}

/// Tracks (positions of landmarks) of the original and of every method.
struct AllTracks {
  const Eigen::MatrixXd& original;
  std::vector<Eigen::MatrixXd> decoded;

  PicturedFrame at(int frame) const {
    PicturedFrame pictured{.frame = frame, .original = points_at(original, frame)};
    for (const auto& tracks : decoded) pictured.decoded.push_back(points_at(tracks, frame));
    return pictured;
  }
};

/// The height of the floor: the lowest height at which a landmark rests.
double floor_cm(const Eigen::MatrixXd& tracks) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int landmark = 0; 3 * landmark < tracks.cols(); ++landmark)
    lowest = std::min(lowest, ground_height(tracks, landmark));
  return lowest;
}

std::vector<Eigen::Vector3d> trail(const Eigen::MatrixXd& tracks, const ContactSpan& span) {
  std::vector<Eigen::Vector3d> points;
  for (int t = span.first_frame; t <= span.last_frame; ++t)
    points.push_back(tracks.block<1, 3>(t, 3 * span.landmark).transpose());
  return points;
}

std::optional<PicturedFoot> worst_foot(const std::vector<ContactSpan>& contacts,
                                       const AllTracks& tracks, double sample_rate_hz) {
  const auto slides = [&](const std::vector<ContactSpan>& spans, const Eigen::MatrixXd& decoded) {
    return measure_footskate(spans, tracks.original, decoded, sample_rate_hz);
  };
  const Footskate first = slides(contacts, tracks.decoded.front());
  if (first.total_cm <= 0) return std::nullopt;
  const ContactSpan span = first.findings.front().span;
  PicturedFoot foot{.landmark = span.landmark,
                    .pose = tracks.at((span.first_frame + span.last_frame) / 2),
                    .original_trail = trail(tracks.original, span)};
  for (const auto& decoded : tracks.decoded) {
    foot.trails.push_back(trail(decoded, span));
    foot.slid_cm.push_back(slides({span}, decoded).total_cm);
  }
  return foot;
}

/// The frame with the largest error, as the sum of squares over all landmarks.
int worst_frame(const Distortion& distortion) {
  Eigen::Index frame = 0;
  distortion.distances.rowwise().squaredNorm().maxCoeff(&frame);
  return static_cast<int>(frame);
}

}  // namespace

std::optional<Picture> take_picture(const StudyPlan& plan, const std::filesystem::path& path,
                                    const std::vector<std::string>& methods, double ratio,
                                    const Observer<EncodeProgress>& observer) {
  const LoadedClip clip(read_motion_of_many(path, plan.skeleton, plan.reading));
  const Skeleton& skeleton = clip.motion().skeleton;
  const int frames = clip.motion().clip.frames();
  Picture picture{.clip = utf8(path),
                  .ratio = ratio,
                  .sample_rate_hz = clip.motion().clip.sample_rate_hz,
                  .frames = frames,
                  .bones = figure_shape(skeleton)};
  for (const Landmark& landmark : landmarks(skeleton))
    picture.landmark_names.push_back(landmark.name);
  AllTracks tracks{clip.encoder().wavelets().original_tracks(), {}};
  int worst = 0;
  for (const std::string& name : methods) {
    const CompressionMethod* method = find_compression_method(name);
    if (!method) throw Error("unknown method \"" + name + "\"");
    Settings settings = plan.settings;
    settings.method = name;
    settings.target = {Target::Kind::Ratio, ratio};
    const Encoding made =
        clip.encoder().compress(*method, encode_settings(settings, skeleton), observer);
    if (!made.complete) return std::nullopt;
    if (tracks.decoded.empty()) worst = worst_frame(made.distortion);
    picture.methods.push_back(
        {name, compression_ratio(clip.motion().clip, made.compressed.motion_bytes()),
         made.distortion.eps(plan.settings.weighting),
         made.distortion.worst(plan.settings.weighting).cm,
         sight_chart(made.visibility.table, skeleton)});
    if (has_review_viewer())
      picture.methods.back().review = review_clip(
          review_name(picture, name), clip.encoder().wavelets(), made.file, &made.decoded);
    tracks.decoded.push_back(landmark_tracks(skeleton, made.decoded));
  }
  picture.ground_cm = floor_cm(tracks.original);
  picture.worst = tracks.at(worst);
  picture.facing = facing(skeleton, picture.worst.original);
  for (int i = 0; i < kSequenceFrames; ++i)
    picture.sequence.push_back(tracks.at((2 * i + 1) * frames / (2 * kSequenceFrames)));
  if (!clip.contacts().empty() && !tracks.decoded.empty())
    picture.foot = worst_foot(clip.contacts(), tracks, picture.sample_rate_hz);
  return picture;
}

}  // namespace mocapress
