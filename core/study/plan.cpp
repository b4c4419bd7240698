// SPDX-License-Identifier: MIT
#include "core/study/plan.h"

#include "core/base/error.h"
#include "core/base/utf8_path.h"
#include "core/codec/methods/comparison_method.h"
#include "core/study/published_figures.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHeldMethod = "annealed";  // feet are held with this method

std::vector<Target> targets(Target::Kind kind, std::initializer_list<double> values) {
  std::vector<Target> all;
  for (const double value : values) all.push_back({kind, value});
  return all;
}

}  // namespace

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
  if (const PublishedClip* published = find_published(utf8(clip.stem())))
    for (const PublishedSizes& row : published->sizes)
      all.push_back({Target::Kind::Error, row.eps_cm});
  return all;
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
