// SPDX-License-Identifier: MIT
#include "core/study/study_folder.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "core/base/file.h"
#include "core/base/make_folders.h"
#include "core/base/parallel.h"
#include "core/base/utf8_path.h"
#include "core/study/report.h"
#include "core/study/results.h"
#include "core/study/row.h"
#include "core/study/take_picture.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPictures = 2;
constexpr double kPicturedRatio = 50;  // a ratio at which errors can be seen

/// The two methods to draw: the paper's plain one and the one that ships, or else the first two.
std::vector<std::string> pictured_methods(const Results& results) {
  const Series* shipped = results.leading_series();
  if (results.find_series("standard") && shipped && shipped->method != "standard")
    return {"standard", shipped->method};
  std::vector<std::string> methods;
  for (const Series& series : results.series())
    if (methods.size() < 2 && !series.ik_ratio) methods.push_back(series.method);
  return methods;
}

/// A clip, and a ratio at which it was measured with all methods to draw.
struct Pictured {
  std::string path;
  bool published;
  double ratio;
  double eps_cm;  // error of the first method
};

std::optional<Pictured> pictured(const Results& results, const StudiedClip& clip,
                                 const std::vector<std::string>& methods) {
  std::optional<Pictured> best;
  for (const StudyRow& row : results.rows()) {
    if (row.clip != clip.path || row.settings.method != methods.front() ||
        row.settings.target.kind != Target::Kind::Ratio || !row.reached())
      continue;
    const bool by_all = std::ranges::all_of(methods, [&](const std::string& name) {
      const StudyRow* other = results.row(clip, *results.find_series(name), row.settings.target);
      return other && other->reached();
    });
    const auto distance = [](double ratio) { return std::abs(std::log(ratio / kPicturedRatio)); };
    if (by_all && (!best || distance(row.settings.target.value) < distance(best->ratio)))
      best = Pictured{clip.path, clip.published != nullptr, row.settings.target.value,
                      row.measured->eps_cm(row.settings.weighting)};
  }
  return best;
}

/// Selects clips to draw: the paper's first, then those with the largest errors.
std::vector<Pictured> pictured_clips(const Results& results,
                                     const std::vector<std::string>& methods) {
  std::vector<Pictured> clips;
  if (methods.empty()) return clips;
  for (const StudiedClip& clip : results.clips())
    if (const auto found = pictured(results, clip, methods)) clips.push_back(*found);
  std::ranges::stable_sort(clips, [](const Pictured& a, const Pictured& b) {
    if (a.published != b.published) return a.published;
    return !a.published && a.eps_cm > b.eps_cm;
  });
  clips.resize(std::min(clips.size(), kPictures));
  return clips;
}

/// Takes the pictures. Returns nothing if the observer stopped it.
std::optional<std::vector<Picture>> take_pictures(const StudyPlan& plan, const Results& results,
                                                  const Observer<EncodeProgress>& observer,
                                                  Warnings& warnings) {
  const std::vector<std::string> methods = pictured_methods(results);
  const std::vector<Pictured> clips = pictured_clips(results, methods);
  std::vector<std::optional<Picture>> taken(clips.size());
  std::vector<std::string> problems(clips.size());
  std::atomic<bool> stopped = false;
  parallel_for(std::size_t{0}, clips.size(), [&](std::size_t i) {
    tbb::this_task_arena::isolate([&] {
      try {
        taken[i] = take_picture(plan, utf8_path(clips[i].path), methods, clips[i].ratio, observer);
        if (!taken[i]) stopped = true;
      } catch (const InputError& error) {  // the report is complete without this picture
        problems[i] = error.what();
      }
    });
  });
  if (stopped) return std::nullopt;
  for (std::size_t i = 0; i < clips.size(); ++i)
    if (!problems[i].empty())
      warnings.push_back({clips[i].path, 0, "is not pictured in the report: " + problems[i]});
  std::vector<Picture> pictures;
  for (auto& picture : taken)
    if (picture) pictures.push_back(std::move(*picture));
  return pictures;
}

}  // namespace

StudyOutcome run_study_kept(const fs::path& folder, const StudyPlan& plan,
                            const Observer<StudyProgress>& observer) {
  make_folders(folder);
  RowsFile file(folder / kRowsSoFar);
  StudyOutcome outcome = run_study(
      plan, file.rows(), [&](const StudyRow& row) { file.append(row); }, observer);
  if (file.warning()) outcome.warnings.push_back(*file.warning());
  return outcome;
}

std::optional<std::string> study_report(const StudyPlan& plan, const Results& results,
                                        const Observer<EncodeProgress>& observer,
                                        Warnings* warnings, const ReportLanguage& language) {
  Warnings unheard;
  const auto pictures =
      take_pictures(plan, results, observer, warnings == nullptr ? unheard : *warnings);
  if (!pictures) return std::nullopt;
  return report_html(results, *pictures, language);
}

StudyOutcome run_study_in(const fs::path& folder, const StudyPlan& plan,
                          const Observer<StudyProgress>& observer) {
  StudyProgress last;
  StudyOutcome outcome = run_study_kept(folder, plan, [&](const StudyProgress& progress) {
    last = progress;
    return should_continue(observer, progress);
  });
  if (!outcome.complete) return outcome;

  last.finished = nullptr;
  std::mutex mutex;
  const auto report = study_report(
      plan, Results(outcome.rows),
      [&](const EncodeProgress&) {
        const std::lock_guard lock(mutex);
        return should_continue(observer, last);
      },
      &outcome.warnings);
  outcome.complete = report.has_value();
  if (!outcome.complete) return outcome;
  write_text(folder / kRowsCsv, rows_csv(outcome.rows));
  write_text(folder / kRowsJson, rows_json(outcome.rows));
  write_text(folder / kReport, *report);
  return outcome;
}

}  // namespace mocapress
