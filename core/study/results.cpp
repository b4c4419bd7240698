// SPDX-License-Identifier: MIT
#include "core/study/results.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/base/utf8_path.h"
#include "core/codec/methods/compression_method.h"
#include "core/study/plan.h"

namespace mocapress {
namespace {

std::string stem_of(const std::string& path) {
  return utf8(utf8_path(path).stem());
}

std::string title_of(const StudyRow& row) {
  std::string title(method_title(row.settings.method));
  if (!row.ik_ratio()) return title;
  return title + " + IK " + significant_text(*row.ik_ratio(), 6) + ":1";
}

StudiedClip studied(const StudyRow& row) {
  const Measurement& m = *row.measured;
  StudiedClip clip{.path = row.clip,
                   .review = row.review,
                   .title = stem_of(row.clip),
                   .frames = m.frames,
                   .channels = m.channels,
                   .sample_rate_hz = m.sample_rate_hz,
                   .raw_bytes = m.raw_bytes};
  const PublishedClip* published = find_published(clip.title);
  if (published && published->frames == m.frames) clip.published = published;
  return clip;
}

/// Replaces each title that several clips share by the clip's path.
void make_titles_unique(std::vector<StudiedClip>& clips) {
  for (StudiedClip& clip : clips) {
    const std::string stem = stem_of(clip.path);
    const auto same = [&](const StudiedClip& other) { return stem_of(other.path) == stem; };
    if (std::ranges::count_if(clips, same) > 1) clip.title = clip.path;
  }
}

}  // namespace

Results::Results(std::vector<StudyRow> rows) : rows_(std::move(rows)) {
  for (const StudyRow& row : rows_) {
    weighting_ = row.settings.weighting;
    if (std::ranges::none_of(series_, [&](auto& s) { return s.has(row); }))
      series_.push_back({row.settings.method, row.ik_ratio(), title_of(row)});
    if (row.measured && std::ranges::none_of(clips_, [&](auto& c) { return c.path == row.clip; }))
      clips_.push_back(studied(row));
  }
  make_titles_unique(clips_);
}

const Series* Results::find_series(std::string_view method) const {
  for (const Series& series : series_)
    if (series.method == method && !series.ik_ratio) return &series;
  return nullptr;
}

const Series* Results::leading_series() const {
  for (const Method method : {Method::ClosedLoop, Method::Annealed})
    if (const Series* series = find_series(name(method))) return series;
  return series_.empty() ? nullptr : &series_.front();
}

const StudyRow* Results::row(const StudiedClip& clip, const Series& series,
                             const Target& target) const {
  for (const StudyRow& row : rows_)
    if (row.measured && row.clip == clip.path && series.has(row) && row.settings.target == target)
      return &row;
  return nullptr;
}

Curve Results::curve(const StudiedClip& clip, const Series& series) const {
  std::vector<CurvePoint> points;
  for (const StudyRow& row : rows_)
    if (row.measured && row.clip == clip.path && series.has(row))
      points.push_back({row.measured->ratio, row.measured->eps_cm(row.settings.weighting)});
  return best_of(std::move(points));
}

std::optional<SizeAtError> Results::size_at(const StudiedClip& clip, const Series& series,
                                            double eps_cm) const {
  const StudyRow* exact = row(clip, series, {Target::Kind::Error, eps_cm});
  if (exact && exact->reached()) return SizeAtError{exact->measured->ratio, true};
  const auto ratio = ratio_at(curve(clip, series), eps_cm);
  if (!ratio) return std::nullopt;
  return SizeAtError{*ratio, false};
}

std::optional<MeanRatio> Results::mean_ratio_at(const Series& series, double eps_cm) const {
  std::vector<double> ratios;
  for (const StudiedClip& clip : clips_)
    if (const auto size = size_at(clip, series, eps_cm)) ratios.push_back(size->ratio);
  const auto mean = geometric_mean(ratios);
  if (!mean) return std::nullopt;
  return MeanRatio{*mean, static_cast<int>(ratios.size())};
}

Curve Results::mean_curve(const Series& series) const {
  std::vector<Curve> curves;
  for (const StudiedClip& clip : clips_) curves.push_back(curve(clip, series));
  return mean_at_equal_error(curves);
}

}  // namespace mocapress
