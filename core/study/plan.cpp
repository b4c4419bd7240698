// SPDX-License-Identifier: MIT
#include "core/study/plan.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/compare/comparison_method.h"
#include "core/study/published_figures.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<Target::Kind, std::string_view>, 6> kKinds = {{
    {Target::Kind::Ratio, "ratio"},
    {Target::Kind::CoefficientRatio, "coefficient-ratio"},
    {Target::Kind::Size, "size"},
    {Target::Kind::Error, "error"},
    {Target::Kind::MaxError, "max-error"},
    {Target::Kind::Visibility, "not-visible"},
}};

constexpr std::string_view kHeldMethod = "annealed";  // of which feet are held

std::vector<Target> targets(Target::Kind kind, std::initializer_list<double> values) {
  std::vector<Target> all;
  for (const double value : values) all.push_back({kind, value});
  return all;
}

bool is_clip(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".bvh" || extension == ".amc";
}

std::vector<fs::path> clips_below(const fs::path& folder) {
  std::vector<fs::path> clips;
  try {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (is_clip(entry.path()) && entry.is_regular_file()) clips.push_back(entry.path());
  } catch (const fs::filesystem_error& error) {
    throw InputError(folder.string(), 0, 0, error.code().message());
  }
  if (clips.empty()) throw InputError(folder.string(), 0, 0, "holds no .bvh and no .amc");
  std::sort(clips.begin(), clips.end());
  return clips;
}

}  // namespace

std::string_view name(Target::Kind kind) {
  for (const auto& [value, word] : kKinds)
    if (value == kind) return word;
  return "";
}

std::optional<Target::Kind> target_kind(std::string_view name) {
  for (const auto& [value, word] : kKinds)
    if (word == name) return value;
  return std::nullopt;
}

std::vector<Target> usual_targets() {
  std::vector<Target> all = targets(Target::Kind::Ratio, {7, 10, 15, 20, 30, 40, 50});
  const auto errors = targets(Target::Kind::Error, {0.1, 0.26, 0.5, 1});
  all.insert(all.end(), errors.begin(), errors.end());
  return all;
}

std::vector<Target> paper_targets(const fs::path& clip) {
  std::vector<Target> all =
      targets(Target::Kind::Ratio, {3, 5, 7, 10, 15, 20, 30, 40, 50, 70, 100});
  all.push_back({Target::Kind::CoefficientRatio, kPublishedVideoRatio});
  all.push_back({Target::Kind::Error, kPublishedInvisibleEpsCm});
  if (const PublishedClip* published = find_published(clip.stem().string()))
    for (const PublishedSizes& row : published->sizes)
      all.push_back({Target::Kind::Error, row.eps_cm});
  return all;
}

std::vector<fs::path> find_clips(const std::vector<fs::path>& inputs) {
  std::vector<fs::path> clips;
  std::set<fs::path> found;
  const auto add = [&](const fs::path& clip) {
    if (found.insert(clip).second) clips.push_back(clip);
  };
  for (const fs::path& input : inputs) {
    std::error_code error;
    const fs::file_status status = fs::status(input, error);
    if (!fs::exists(status)) throw InputError(input.string(), 0, 0, "No such file or directory");
    if (!fs::is_directory(status))
      add(input);
    else
      for (const fs::path& clip : clips_below(input)) add(clip);
  }
  return clips;
}

std::vector<StudyJob> jobs_of(const StudyPlan& plan) {
  std::vector<StudyJob> jobs;
  for (std::size_t clip = 0; clip < plan.clips.size(); ++clip)
    for (std::size_t method = 0; method < plan.methods.size(); ++method)
      for (const Target& target : plan.clips[clip].targets) {
        const bool coefficients = target.kind == Target::Kind::CoefficientRatio;
        if (!coefficients || !find_comparison_method(plan.methods[method]))
          jobs.push_back({clip, method, target, {}});
        if (plan.methods[method] != kHeldMethod) continue;
        if (!coefficients && target.kind != Target::Kind::Ratio) continue;
        for (const double ik_ratio : plan.ik_ratios)
          jobs.push_back({clip, method, target, ik_ratio});
      }
  return jobs;
}

}  // namespace mocapress
