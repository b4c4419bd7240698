// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/global_control.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "app/cli/option_words.h"
#include "app/cli/report.h"
#include "app/cli/terminal.h"
#include "core/base/number_text.h"
#include "core/base/open_file.h"
#include "core/base/utf8_path.h"
#include "core/codec/methods/compression_method.h"
#include "core/formats/clip_files.h"
#include "core/formats/text_writer.h"
#include "core/study/published_figures.h"
#include "core/study/results.h"
#include "core/study/row.h"
#include "core/study/study_folder.h"

namespace mocapress::cli {
namespace {

namespace fs = std::filesystem;

std::string described(const StudyRow& row) {
  std::string text = utf8(utf8_path(row.clip).stem()) + " " + row.settings.method;
  if (!row.measured) return text + ": " + row.error.substr(0, 50);
  return text + " " + fixed_text(row.measured->ratio, 1) + ":1 " +
         fixed_text(row.measured->eps_cm(row.settings.weighting), 3) + " cm";
}

std::string remaining(const StudyProgress& progress, double now) {
  const int anew = progress.done - progress.kept;
  if (progress.done == progress.jobs) return ", drawing";
  if (anew < 3) return "";
  return ", about " + clock_text(now / anew * (progress.jobs - progress.done)) + " left";
}

struct Study {
  std::vector<std::string> inputs;
  MotionInput source;
  std::string folder;
  std::vector<std::string> methods;
  std::vector<double> ratios;
  std::vector<double> errors;
  std::vector<double> ik_ratios;
  bool paper = false;
  std::optional<Weighting> weighting;
  Coding coding = Coding::Deflate;
  std::uint64_t seed = 1;
  int jobs = 0;
  bool again = false;
  bool json_progress = false;

  StudyPlan plan() const {
    StudyPlan plan{
        .methods = methods, .settings = {.coding = coding, .seed = seed}, .ik_ratios = ik_ratios};
    if (plan.ik_ratios.empty() && errors.empty() && ratios.empty())
      plan.ik_ratios = {kPublishedVideoIkRatio};
    if (source.skeleton) plan.skeleton = utf8_path(*source.skeleton);
    plan.reading = source.options;
    plan.settings.weighting =
        weighting.value_or(paper ? Weighting::JointOrigins : Weighting::Surface);
    if (plan.methods.empty())
      for (const CompressionMethod& compression_method : compression_methods())
        plan.methods.emplace_back(compression_method.name);
    for (const fs::path& clip : find_clips(utf8_paths(inputs)))
      plan.clips.push_back({clip, targets_of(clip)});
    return plan;
  }

  std::vector<Target> targets_of(const fs::path& clip) const {
    std::vector<Target> targets;
    for (const double ratio : ratios) targets.push_back({Target::Kind::Ratio, ratio});
    for (const double error : errors) targets.push_back({Target::Kind::Error, error});
    if (paper)
      for (const Target& target : paper_targets(clip)) targets.push_back(target);
    if (targets.empty()) targets = usual_targets();
    std::vector<Target> once;
    for (const Target& target : targets)
      if (std::find(once.begin(), once.end(), target) == once.end()) once.push_back(target);
    return once;
  }

  void run() const {
    const StudyPlan asked = plan();
    if (again) {
      const fs::path rows = utf8_path(folder) / kRowsSoFar;
      if (!remove_file(rows) && !is_absence(errno))
        throw WriteError(utf8(rows) + ": cannot be removed: " + std::strerror(errno));
    }
    const StopOnSignals signals;
    ProgressLine line(json_progress);
    std::optional<tbb::global_control> threads;
    if (jobs > 0)
      threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(jobs));
    StudyProgress last;
    std::string last_done;
    const StudyOutcome outcome =
        run_study_in(utf8_path(folder), asked, [&](const StudyProgress& progress) {
          last = progress;
          if (progress.finished) last_done = described(*progress.finished);
          if (line.due()) {
            const double now = line.elapsed_seconds();
            line.show(std::to_string(progress.done) + " of " + std::to_string(progress.jobs) +
                      ", " + clock_text(now) + remaining(progress, now) + "   " + last_done);
          }
          if (json_progress && progress.finished) {
            std::printf("%s\n", to_json_line(*progress.finished).c_str());
            std::fflush(stdout);
          }
          return stop_signal == 0;
        });
    line.clear();
    print_warnings(outcome.warnings);
    if (!outcome.complete) {
      std::fprintf(stderr,
                   "Stopped after %zu of %d. Finished measurements are kept in %s: to continue, "
                   "run the same command.\n",
                   outcome.rows.size(), last.jobs, printable(folder).c_str());
      throw EndedWith{128 + stop_signal};
    }
    summarise(outcome, last.kept);
  }

  void summarise(const StudyOutcome& outcome, int kept) const {
    const Results results(outcome.rows);
    std::size_t unread = 0;
    std::string last_unread;
    for (const StudyRow& row : outcome.rows)
      if (row.fingerprint.empty() && row.clip != last_unread) {
        std::fprintf(stderr, "not read: %s\n", printable(row.error).c_str());
        last_unread = row.clip;
        ++unread;
      }
    std::fprintf(stderr, "%s of %s, %d of them made by an earlier run\n",
                 counted(outcome.rows.size(), "compression").c_str(),
                 counted(results.clips().size(), "clip").c_str(), kept);
    std::fprintf(stderr, "%s\n", printable(utf8(utf8_path(folder) / kReport)).c_str());
    if (unread > 0) throw EndedWith{kSomeFailed};
  }
};

}  // namespace

void add_study(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "study", "Compress clips by many methods at many targets: tables and a report");
  const auto call = std::make_shared<Study>();
  command->add_option("input", call->inputs, "Clips and folders of clips")
      ->required()
      ->type_name("INPUT...");
  command->add_option("-o,--output", call->folder, "Folder for report.html, rows.csv and rows.json")
      ->required()
      ->type_name("DIR");
  command->add_option("--methods", call->methods, "Methods, comma-separated [all]")
      ->delimiter(',')
      ->transform(one_of_the_methods())
      ->type_name("a,b,...");
  const auto add_targets = [&](const char* flag, std::vector<double>& values, const char* unit,
                               const char* help) {
    command->add_option(flag, values, help)
        ->delimiter(',')
        ->check(number_above_0())
        ->type_name(unit);
  };
  add_targets("--ratios", call->ratios, "r,r,...",
              "Compression ratios to compress to, comma-separated");
  add_targets("--errors", call->errors, "CM,CM,...",
              "Largest eps_x allowed (weighted RMS error) to compress to, comma-separated");
  command
      ->add_option("--ik", call->ik_ratios,
                   "Coefficient ratios of the IK correction at which the annealed method also "
                   "holds the feet [16; none if targets are given]")
      ->delimiter(',')
      ->check(number_above_0())
      ->type_name("r,r,...");
  command->add_flag("--paper", call->paper,
                    "Repeat the paper's evaluation with its weighting, ratios and errors, and "
                    "print its figures beside ours");
  command
      ->add_option("--weighting", call->weighting,
                   "Points on which errors are measured [surface; with --paper joint-origins]")
      ->transform(one_of(kWeightings));
  command->add_option("--coding", call->coding, "Coding of the coefficients [deflate]")
      ->transform(one_of({Coding::Rle16, Coding::Deflate, Coding::Adaptive}));
  command->add_option("--seed", call->seed,
                      "Seed of the annealing; the same seed gives the same figures");
  command
      ->add_option("--jobs", call->jobs,
                   "Number of compressions at the same time [one for each processor]")
      ->type_name("N")
      ->check(number_above_0());
  command->add_flag("--again", call->again, "Repeat the measurements that DIR already holds");
  command->add_flag("--json-progress", call->json_progress,
                    "Print each finished row as a line of JSON");
  call->source.add_options(*command);
  call->source.add_character_option(*command);
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
