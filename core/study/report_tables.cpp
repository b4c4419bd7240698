// SPDX-License-Identifier: MIT
#include "core/study/report_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/base/utf8_path.h"
#include "core/codec/methods/compression_method.h"
#include "core/report/markup.h"
#include "core/study/plan.h"
#include "core/study/published_figures.h"

namespace mocapress {

using namespace html;

namespace {

std::string eps_text(double eps_cm) {
  return format_shortest(eps_cm) + " cm";
}

/// The series for which has_any() is true, in order.
template <typename HasAny>
std::vector<const Series*> series_with(const Results& results, const HasAny& has_any) {
  std::vector<const Series*> chosen;
  for (const Series& series : results.series())
    if (has_any(series)) chosen.push_back(&series);
  return chosen;
}

using Errors = std::set<double, std::greater<>>;  // cm, largest first

constexpr double kUsualErrors[] = {1, 0.5, 0.26, 0.1};

/// The errors at which a study compressed a clip; the usual errors if there are none.
Errors asked_errors(const Results& results, const StudiedClip& clip) {
  Errors errors;
  for (const StudyRow& row : results.rows())
    if (row.clip == clip.path && row.settings.target.kind == Target::Kind::Error)
      errors.insert(row.settings.target.value);
  if (errors.empty()) errors.insert(std::begin(kUsualErrors), std::end(kUsualErrors));
  return errors;
}

/// The errors at which every clip was compressed, and the usual errors.
Errors common_errors(const Results& results) {
  Errors errors(std::begin(kUsualErrors), std::end(kUsualErrors));
  if (results.clips().empty()) return errors;
  for (const double eps_cm : asked_errors(results, results.clips().front()))
    if (std::ranges::all_of(results.clips(), [&](const StudiedClip& clip) {
          return asked_errors(results, clip).contains(eps_cm);
        }))
      errors.insert(eps_cm);
  return errors;
}

/// The clips of the paper; if there are none, the first `most` clips.
std::vector<const StudiedClip*> shown_clips(const Results& results, std::size_t most) {
  std::vector<const StudiedClip*> shown;
  for (const StudiedClip& clip : results.clips())
    if (clip.published) shown.push_back(&clip);
  if (!shown.empty()) return shown;
  for (const StudiedClip& clip : results.clips())
    if (shown.size() < most) shown.push_back(&clip);
  return shown;
}

std::string clip_head(const StudiedClip& clip) {
  std::string text = clip.title;
  if (clip.published) text = std::string(clip.published->title) + " (" + clip.title + ")";
  return text;
}

const PublishedSize* published_size(const PublishedSizes* row, std::string_view method) {
  if (!row) return nullptr;
  if (method == "pca") return &row->pca;
  if (method == "standard") return &row->standard;
  if (method == "annealed") return &row->annealed;
  return nullptr;
}

std::string size_text(double kb, double ratio) {
  return format_significant(kb) + " (" + ratio_text(ratio) + ")";
}

/// A size, marked "≈" if it is read from the curve instead of measured.
std::string size_cell(const Results& results, const StudiedClip& clip, const Series& series,
                      double eps_cm) {
  const auto size = results.size_at(clip, series, eps_cm);
  if (!size) return cell(kNothing);
  const double kb = static_cast<double>(clip.raw_bytes) / 1024 / size->ratio;
  return cell((size->measured ? "" : "&#8776; ") + size_text(kb, size->ratio));
}

std::string size_lines(const Results& results, const StudiedClip& clip,
                       const std::vector<const Series*>& series, bool with_paper) {
  struct Level {
    double eps_cm;
    const PublishedSizes* published;
  };
  std::vector<Level> levels;
  if (clip.published)
    for (const PublishedSizes& row : clip.published->sizes) levels.push_back({row.eps_cm, &row});
  else
    for (const double eps_cm : asked_errors(results, clip)) levels.push_back({eps_cm, nullptr});
  std::string body;
  for (const Level& level : levels) {
    std::string cells = row_head(&level == &levels.front() ? clip_head(clip) : "");
    cells += cell(format_shortest(level.eps_cm));
    for (const Series* one : series) {
      cells += size_cell(results, clip, *one, level.eps_cm);
      const PublishedSize* paper = published_size(level.published, one->method);
      if (with_paper && !one->ik_ratio)
        cells +=
            cell(paper ? format_shortest(paper->kb) + " (" + format_shortest(paper->ratio) + ":1)"
                       : kNothing,
                 "paper");
    }
    body += line(cells);
  }
  return body;
}

std::vector<double> timed_ratios(const Results& results) {
  std::set<double, std::greater<>> ratios;
  for (const StudyRow& row : results.rows())
    if (row.settings.method == "annealed" && row.settings.target.kind == Target::Kind::Ratio)
      ratios.insert(row.settings.target.value);
  std::vector<double> tabled;
  for (const PublishedTiming& timing : kPublishedClips.front().timings)
    if (ratios.contains(timing.ratio)) tabled.push_back(timing.ratio);
  return tabled.empty() ? std::vector<double>(ratios.begin(), ratios.end()) : tabled;
}

std::string time_cells(const StudyRow* row, const StudiedClip& clip, double ratio) {
  std::string cells = row ? cell(format_significant(row->measured->ms_per_frame())) +
                                cell(std::to_string(row->measured->iterations.value_or(0)))
                          : cell(kNothing) + cell(kNothing);
  if (!clip.published) return cells;
  for (const PublishedTiming& timing : clip.published->timings)
    if (timing.ratio == ratio)
      return cells + cell(format_shortest(timing.ms_per_frame), "paper") +
             cell(std::to_string(timing.iterations), "paper");
  return cells + cell(kNothing, "paper") + cell(kNothing, "paper");
}

/// The target of a kind that is nearest to `value`, among measured rows for which suits() is true.
template <typename Suits>
std::optional<Target> nearest_target(const Results& results, Target::Kind kind, double value,
                                     const Suits& suits) {
  std::optional<Target> nearest;
  const auto off = [&](const Target& target) { return std::abs(std::log(target.value / value)); };
  for (const StudyRow& row : results.rows())
    if (row.measured && suits(row) && row.settings.target.kind == kind &&
        (!nearest || off(row.settings.target) < off(*nearest)))
      nearest = row.settings.target;
  return nearest;
}

/// A cell with the length of all sliding, its mean and largest length for a contact, and the
/// largest drift.
std::string slide_cell(const ReportLanguage& say, const Measurement& measured) {
  std::string text = fixed(*measured.footskate_cm, 1) + " cm";
  if (measured.slide)
    text += element("small", "",
                    " (" + fixed(measured.slide->mean_cm, 2) + ", " +
                        fixed(measured.slide->worst_cm, 2) + "; " +
                        say("drift %1", {fixed(measured.slide->drift_worst_cm, 2)}) + ")");
  return cell(text);
}

std::string footskate_at(const ReportLanguage& say, const Results& results, const Target& target) {
  const auto measured = [&](const StudiedClip& clip, const Series& series) {
    const StudyRow* row = results.row(clip, series, target);
    return row && row->measured->footskate_cm ? &*row->measured : nullptr;
  };
  const auto series = series_with(results, [&](const Series& one) {
    return std::ranges::any_of(
        results.clips(), [&](const StudiedClip& clip) { return measured(clip, one) != nullptr; });
  });
  std::string heads = text_head(say("Clip")) + head(say("contacts"));
  for (const Series* one : series) heads += head(escaped(title_of(say, *one)));
  std::string body;
  std::map<const Series*, double> sums;
  int all_contacts = 0;
  for (const StudiedClip& clip : results.clips()) {
    const StudyRow* any = nullptr;
    for (const Series* one : series)
      if (!any) any = results.row(clip, *one, target);
    if (!any || !any->measured->footskate_cm || any->measured->contacts == 0) continue;
    all_contacts += any->measured->contacts;
    std::string cells = row_head(clip.title) + cell(std::to_string(any->measured->contacts));
    for (const Series* one : series) {
      const Measurement* slid = measured(clip, *one);
      cells += slid ? slide_cell(say, *slid) : cell(kNothing);
      sums[one] += slid ? *slid->footskate_cm : std::nan("");
    }
    body += line(cells);
  }
  if (all_contacts == 0) return "";
  std::string cells = row_head(say("mean of a contact")) + cell(std::to_string(all_contacts));
  for (const Series* one : series)
    cells += cell(std::isnan(sums[one]) ? kNothing : fixed(sums[one] / all_contacts, 2) + " cm");
  body += line(cells, attribute("class", "sum"));
  const bool paper_ratio = target.kind == Target::Kind::CoefficientRatio;
  return element("h3", "",
                 say(paper_ratio ? "At the paper's coefficient ratio r = %1"
                                 : "At the compression ratio %1:1",
                     {format_shortest(target.value)})) +
         table(line(heads), body);
}

}  // namespace

std::string title_of(const ReportLanguage& say, const Series& series) {
  const std::string method(method_title(series.method));
  return say(method) + series.title.substr(method.size());
}

double headline_eps_cm(const Results& results) {
  double best = kPublishedInvisibleEpsCm;
  const Series* leading = results.leading_series();
  std::pair<int, int> most = {-1, -1};
  for (const double eps_cm : {0.5, 0.26, 1.0, 0.1, 2.0, 0.2, 0.05, 5.0, 10.0}) {
    // The leading series counts first: an error at which it has no size is not chosen if there is
    // another.
    std::pair<int, int> sizes = {0, 0};
    for (const Series& series : results.series())
      for (const StudiedClip& clip : results.clips())
        if (results.size_at(clip, series, eps_cm)) {
          ++sizes.second;
          if (leading && series.method == leading->method) ++sizes.first;
        }
    if (sizes > most) most = sizes, best = eps_cm;
  }
  return best;
}

std::string mean_size_table(const ReportLanguage& say, const Results& results) {
  std::string heads = head(kEpsX);
  for (const Series& series : results.series()) heads += head(escaped(title_of(say, series)));
  std::string body;
  const int clips = static_cast<int>(results.clips().size());
  for (const double eps_cm : common_errors(results)) {
    // A mean ratio takes part in the comparison only if it is over all clips. Otherwise it would
    // compare clips instead of methods.
    std::vector<std::optional<MeanRatio>> means;
    double best = 0;
    bool all = true;
    for (const Series& series : results.series()) {
      means.push_back(results.mean_ratio_at(series, eps_cm));
      const bool whole = means.back() && means.back()->clips == clips;
      if (whole) best = std::max(best, means.back()->ratio);
      all = all && whole;
    }
    if (best == 0) continue;
    std::string cells = head(eps_text(eps_cm), attribute("scope", "row"));
    for (const auto& mean : means)
      if (mean && mean->clips == clips)
        cells += cell(ratio_text(mean->ratio), all && mean->ratio == best ? "best" : "");
      else
        cells += cell(element("small", "",
                              say("%1 of %2 clips", {std::to_string(mean ? mean->clips : 0),
                                                     std::to_string(clips)})));
    body += line(cells);
  }
  return body.empty() ? "" : table(line(heads), body);
}

std::string size_table(const ReportLanguage& say, const Results& results) {
  auto series = series_with(results, [](const Series& s) {
    return s.method == "pca" || s.method == "standard" || s.method == "annealed";
  });
  if (series.empty()) series = series_with(results, [](const Series&) { return true; });
  const auto clips = shown_clips(results, 3);
  if (clips.empty() || series.empty()) return "";
  const bool with_paper = clips.front()->published != nullptr;
  std::string groups = head("", attribute("rowspan", "2")) +
                       head(kEpsX + std::string(", cm"), attribute("rowspan", "2"));
  std::string heads;
  for (const Series* one : series) {
    const bool beside = with_paper && !one->ik_ratio;
    groups += group(escaped(title_of(say, *one)), beside ? 2 : 1);
    heads += head(say("KB (ratio)"));
    if (beside) heads += head(say("paper"), attribute("class", "paper"));
  }
  std::string body;
  for (const StudiedClip* clip : clips) body += size_lines(results, *clip, series, with_paper);
  return table(line(groups) + line(heads), body);
}

std::string time_table(const ReportLanguage& say, const Results& results) {
  const Series* annealed = results.find_series("annealed");
  const auto ratios = timed_ratios(results);
  const auto clips = shown_clips(results, 2);
  if (!annealed || ratios.empty() || clips.empty()) return "";
  std::string groups = head(say("Ratio"), attribute("rowspan", "2"));
  std::string heads;
  for (const StudiedClip* clip : clips) {
    groups +=
        group(escaped(clip_head(*clip)) + ", " + say("%1 frames", {std::to_string(clip->frames)}),
              clip->published ? 4 : 2);
    heads += head(say("ms a frame")) + head(say("iterations"));
    if (clip->published)
      heads += head(say("paper: ms"), attribute("class", "paper")) +
               head(say("iterations"), attribute("class", "paper"));
  }
  std::string body;
  for (const double ratio : ratios) {
    std::string cells = head(format_shortest(ratio) + ":1", attribute("scope", "row"));
    for (const StudiedClip* clip : clips)
      cells +=
          time_cells(results.row(*clip, *annealed, {Target::Kind::Ratio, ratio}), *clip, ratio);
    body += line(cells);
  }
  return table(line(groups) + line(heads), body);
}

std::string footskate_table(const ReportLanguage& say, const Results& results) {
  std::string tables;
  for (const Target::Kind kind : {Target::Kind::CoefficientRatio, Target::Kind::Ratio})
    if (const auto target = nearest_target(
            results, kind, kPublishedVideoRatio,
            [](const StudyRow& row) { return row.measured->footskate_cm.has_value(); }))
      tables += footskate_at(say, results, *target);
  return tables.empty()
             ? ""
             : muted(say("Horizontal path of the feet during contacts, beyond the original's; in "
                         "brackets the mean contact and the worst contact. Contacts are detected "
                         "in the original; clips without contacts are not listed.")) +
                   tables;
}

std::string clip_table(const ReportLanguage& say, const Results& results) {
  const double eps_cm = headline_eps_cm(results);
  std::string heads = text_head(say("Clip")) + head(say("frames")) + head(say("seconds"));
  for (const Series& series : results.series()) heads += head(escaped(title_of(say, series)));
  const bool reviewed = std::ranges::any_of(
      results.clips(), [](const StudiedClip& clip) { return clip.review != ClipReview(); });
  if (reviewed) heads += text_head(say("verdict")) + text_head(say("note"));
  std::string body;
  for (const StudiedClip& clip : results.clips()) {
    std::string cells = row_head(clip_head(clip)) + cell(std::to_string(clip.frames)) +
                        cell(fixed(clip.frames / clip.sample_rate_hz, 1));
    for (const Series& series : results.series()) {
      const auto size = results.size_at(clip, series, eps_cm);
      cells += cell(size ? (size->measured ? "" : "&#8776; ") + ratio_text(size->ratio)
                         : std::string(kNothing));
    }
    if (reviewed)
      cells += cell(say(std::string(name(clip.review.verdict))), "name") +
               cell(escaped(clip.review.note), "wrap");
    body += line(cells);
  }
  return body.empty()
             ? ""
             : muted(say("Compression ratio at %1.", {kEpsX + (" = " + eps_text(eps_cm))})) +
                   table(line(heads), body);
}

namespace {

std::optional<Target> angle_target(const Results& results) {
  const auto all = [](const StudyRow&) { return true; };
  const auto ratio = nearest_target(results, Target::Kind::Ratio, kPublishedVideoRatio, all);
  return ratio ? ratio
               : nearest_target(results, Target::Kind::Error, headline_eps_cm(results), all);
}

std::string angle_target_text(const Target& target) {
  return target.kind == Target::Kind::Ratio
             ? format_shortest(target.value) + ":1"
             : kEpsX + (" = " + format_shortest(target.value)) + " cm";
}

std::string degrees_text(const std::optional<double>& value) {
  return value ? format_significant(*value) + "&#176;" : kNothing;
}

std::string turn_text(const std::optional<PartTurn>& turn) {
  return turn ? degrees_text(turn->rms_degrees) : kNothing;
}

std::string angle_cell(const BodyFigures& body) {
  std::string text = degrees_text(body.angle_rms_degrees);
  if (body.head || body.hand)
    text += element("small", "", " (" + turn_text(body.head) + ", " + turn_text(body.hand) + ")");
  return cell(text);
}

}  // namespace

std::string angle_table(const ReportLanguage& say, const Results& results) {
  const auto target = angle_target(results);
  if (!target) return "";
  std::string heads = text_head(say("Clip"));
  for (const Series& series : results.series()) heads += head(escaped(title_of(say, series)));
  std::string body;
  for (const StudiedClip& clip : results.clips()) {
    std::string cells = row_head(clip.title);
    for (const Series& series : results.series()) {
      const StudyRow* row = results.row(clip, series, *target);
      cells += row ? angle_cell(row->measured->body) : cell(kNothing);
    }
    body += line(cells);
  }
  return muted(say("Angle between a joint's world-space rotation and the original's, root mean "
                   "square over frames and joints; in brackets that of the head and of the worse "
                   "hand, if they are recognised by their names. Measured at %1.",
                   {angle_target_text(*target)})) +
         table(line(heads), body);
}

namespace {

constexpr double kShownRatio = 50;  // compression ratio of r = 30, r_IK = 16 in the paper's video

/// The rows of a clip at the same size, without and with IK.
struct Pair {
  const StudyRow* without;
  const StudyRow* with;
};

const Series* held_series(const Results& results) {
  for (const Series& series : results.series())
    if (series.ik_ratio) return &series;
  return nullptr;
}

Pair pair_of(const Results& results, const StudiedClip& clip, const Series& held,
             const Target& target) {
  const Series* plain = results.find_series(held.method);
  return {plain ? results.row(clip, *plain, target) : nullptr, results.row(clip, held, target)};
}

std::string percent(double share) {
  const std::string text = fixed(100 * share, 0);
  return (share > 0 && text[0] != '-' ? "+" : "") + text + " %";
}

std::string line_of(const StudiedClip& clip, const Pair& pair, Weighting weighting) {
  const Measurement& without = *pair.without->measured;
  const Measurement& with = *pair.with->measured;
  const double before = without.footskate_cm.value_or(0);
  const double after = with.footskate_cm.value_or(0);
  return line(row_head(clip.title) + cell(fixed(with.ratio, 1) + ":1") +
              cell(fixed(without.eps_cm(weighting), 3)) + cell(fixed(with.eps_cm(weighting), 3)) +
              cell(percent(with.eps_cm(weighting) / without.eps_cm(weighting) - 1)) +
              cell(fixed(before, 1)) + cell(fixed(after, 1)) +
              cell(before > 0 ? percent(after / before - 1) : kNothing) +
              cell(with.knee_speed_ratio ? fixed(*with.knee_speed_ratio, 2) + " x" : kNothing));
}

}  // namespace

std::string held_feet_table(const ReportLanguage& say, const Results& results) {
  const Series* held = held_series(results);
  const auto target =
      nearest_target(results, Target::Kind::Ratio, kShownRatio,
                     [](const StudyRow& row) { return row.ik_ratio().has_value(); });
  if (!held || !target) return "";
  const std::string groups = head("") + head("") +
                             group(say("%1 (cm) without, with IK", {kEpsX}), 3) +
                             group(say("footskate (cm) without, with IK"), 3) + head("");
  const std::string heads = text_head(say("Clip")) + head(say("ratio")) + head(say("without")) +
                            head(say("with")) + head("") + head(say("without")) +
                            head(say("with")) + head("") + head(say("knee"));
  std::string body;
  for (const StudiedClip& clip : results.clips()) {
    const Pair pair = pair_of(results, clip, *held, *target);
    if (pair.without && pair.with && pair.with->measured->contacts > 0)
      body += line_of(clip, pair, results.weighting());
  }
  if (body.empty()) return "";
  return muted(say("Clips with and without IK have the same compression ratio, so bytes of the "
                   "correction are missing elsewhere. Knee: its highest speed, divided by that "
                   "of the original.")) +
         table(line(groups) + line(heads), body);
}

namespace {

/// All targets that a method missed for a clip.
struct Failure {
  std::vector<std::string> steps;    // targets that it missed, with the nearest result
  std::vector<std::string> targets;  // targets for which it failed
  std::string why;                   // reason of the first failure
};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::string failure_table(const ReportLanguage& say, const Results& results) {
  std::map<std::pair<std::string, std::string>, Failure> failures;  // by clip and method
  for (const StudyRow& row : results.rows()) {
    if (row.reached()) continue;
    const bool unread = row.fingerprint.empty();
    Failure& failure = failures[{row.clip, unread ? say("every method") : row.settings.method}];
    if (row.measured) {
      const std::string nearest = say(
          "%1 gave %2", {say(target_text(row.settings.target)), ratio_text(row.measured->ratio)});
      failure.steps.push_back(nearest);
      continue;
    }
    if (!unread) failure.targets.push_back(say(target_text(row.settings.target)));
    if (failure.why.empty()) failure.why = row.error;
  }
  std::string body;
  for (const auto& [of, failure] : failures)
    body += line(row_head(utf8(utf8_path(of.first).filename())) + cell(escaped(of.second), "name") +
                 cell(joined(failure.targets), "wrap") + cell(escaped(say(failure.why)), "wrap") +
                 cell(joined(failure.steps), "wrap"));
  if (body.empty()) return "";
  return element("details", "",
                 element("summary", "",
                         say("%1 combinations of clip and method missed a target",
                             {std::to_string(failures.size())})) +
                     table(line(text_head(say("Clip")) + text_head(say("method")) +
                                text_head(say("missed target")) + text_head(say("first reason")) +
                                text_head(say("nearest result"))),
                           body));
}

}  // namespace mocapress
