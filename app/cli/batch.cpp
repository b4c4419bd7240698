// SPDX-License-Identifier: GPL-3.0-or-later
#include <malloc.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/cli/batch_progress.h"
#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "app/cli/preset_arguments.h"
#include "app/cli/terminal.h"
#include "core/bank/bank.h"
#include "core/base/file.h"
#include "core/batch/batch_folder.h"
#include "core/batch/queue_json.h"
#include "core/batch/slurm_script.h"

namespace mocapress::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kQueueFile = "queue.json";

/// For CLI11: empty when `text` can be parsed, else what is wrong.
template <typename Parse>
CLI::Validator parsed_by(Parse parse) {
  return CLI::Validator(
      [parse](std::string& text) {
        try {
          parse(text);
          return std::string();
        } catch (const Error& error) {
          return std::string(error.what());
        }
      },
      "");
}

struct BatchCommand {
  std::vector<std::string> inputs;
  MotionInput source;
  MotionOutput exporting;
  std::string folder;
  PresetArguments preset;
  std::vector<std::string> formats = {"mcpr"};
  std::string bank;
  bool learn = false;
  std::string names = kUsualNames;
  std::string shard = "1/1";
  int jobs = 0;
  bool resume = false;
  bool overwrite = false;
  bool keep_going = true;
  bool json_progress = false;
  bool merge = false;
  std::string slurm_file;
  int slurm_tasks = 8;
  std::vector<CLI::Option*> of_queue;  // what a queue file has settled already

  void run() const {
    if (merge) return run_merge();
    if (folder.empty()) throw CLI::RequiredError("--output");
    const Batch batch = asked();
    if (slurm_file.empty())
      run_clips(batch);
    else
      write_slurm(batch);
  }

  Batch asked() const {
    const bool is_queue = inputs.size() == 1 && fs::path(inputs.front()).extension() == ".json";
    if (is_queue) {
      for (const CLI::Option* option : of_queue)
        if (option->count() > 0)
          throw CLI::ValidationError(option->get_name(), "is set by the queue file");
      return parse_queue(inputs.front(), read_text(inputs.front()));
    }
    Batch batch{
        .presets = {preset.read()}, .reading = source.options, .writing = exporting.options};
    batch.formats.clear();
    for (const std::string& format : formats)
      if (std::count(batch.formats.begin(), batch.formats.end(), *output_format(format)) == 0)
        batch.formats.push_back(*output_format(format));
    if (!bank.empty()) batch.bank = bank_form(bank);
    batch.learn = learn;
    try {
      check(batch);
    } catch (const Error& error) {
      throw CLI::ValidationError("--bank", error.what());
    }
    const std::vector<SourceClip> sources = find_sources(inputs);
    if (std::all_of(sources.begin(), sources.end(),
                    [](const SourceClip& clip) { return !clip.problem.empty(); }))
      throw InputError(inputs.front(), 0, 0, "no clip was found: " + sources.front().problem);
    try {
      add_items(batch, sources, 0, names);
    } catch (const Error& error) {
      throw CLI::ValidationError("--name", error.what());
    }
    if (source.skeleton)
      for (std::size_t i = 0; i < batch.items.size(); ++i) {
        BatchItem item = batch.items[i];
        item.skeleton = *source.skeleton;
        batch.items.replace(i, item);
      }
    mark_collisions(batch);
    return batch;
  }

  void run_clips(const Batch& batch) const {
    const BatchRunOptions options{.shard = parse_shard(shard),
                                  .jobs = jobs,
                                  .overwrite = overwrite,
                                  .resumed = resume,
                                  .keep_going = keep_going};
    malloc_trim(0);  // the search for clips left the heap in pieces too small for them
    const StopOnSignals signals;
    BatchReporter reporter(batch, json_progress);
    reporter.begin(folder, options.shard);
    BatchControl control;
    const BatchOutcome outcome =
        run_batch_in(folder, batch, options, control, [&](const BatchProgress& progress) {
          reporter.tell(progress);
          return stop_signal == 0;
        });
    reporter.end(outcome, fs::path(folder) / report_name(options.shard));
    if (stop_signal != 0 && !outcome.complete) {
      std::fprintf(stderr, "Stopped. To continue, run the same command with --resume.\n");
      throw EndedWith{128 + stop_signal};
    }
    if (outcome.counts.failed > 0 || !outcome.complete) throw EndedWith{kSomeFailed};
  }

  void run_merge() const {
    const std::vector<fs::path> folders(inputs.begin(), inputs.end());
    const fs::path target = folder.empty() ? folders.front() : fs::path(folder);
    const MergedBatch merged = merge_batch(folders, target);
    std::fprintf(stderr, "%zu clips, %zu failed, %zu still waiting\n%s\n", merged.clips,
                 merged.failed, merged.waiting, (target / report_name({})).c_str());
    if (merged.failed > 0 || merged.waiting > 0) throw EndedWith{kSomeFailed};
  }

  /// The list is settled in a file, so that all tasks have the same one.
  void write_slurm(Batch batch) const {
    std::error_code error;
    const fs::path target = fs::absolute(folder).lexically_normal();
    const fs::path queue = target / kQueueFile;
    SlurmJob job{.program = fs::read_symlink("/proc/self/exe", error).string(),
                 .arguments = {queue.string()},
                 .folder = target.string(),
                 .shards = slurm_tasks};
    if (jobs > 0) job.processors = jobs;
    if (overwrite) job.arguments.emplace_back("--overwrite");
    const std::string script = slurm_script(job);
    fs::create_directories(target, error);
    if (error) throw WriteError(folder + ": cannot be made: " + error.message());
    for (std::size_t i = 0; i < batch.items.size(); ++i) {
      BatchItem item = batch.items[i];
      item.input = fs::absolute(item.input).lexically_normal().string();
      if (!item.skeleton.empty())
        item.skeleton = fs::absolute(item.skeleton).lexically_normal().string();
      batch.items.replace(i, item);
    }
    if (batch.reading.character)
      batch.reading.character = fs::absolute(*batch.reading.character).lexically_normal().string();
    write_text(queue, queue_text(batch));
    write_text(slurm_file, script);
    std::fprintf(stderr, "%zu clips in %d tasks: sbatch %s\n", batch.items.size(), slurm_tasks,
                 slurm_file.c_str());
  }
};

}  // namespace

void add_batch(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("batch", "Compress many clips, verify each, and report on all");
  const auto call = std::make_shared<BatchCommand>();
  command
      ->add_option("input", call->inputs,
                   "Clips, folders of clips, or a queue file (.json); with --merge folders of "
                   "batches")
      ->required()
      ->type_name("INPUT...");
  command->add_option("-o,--output", call->folder, "Where files and reports go")->type_name("DIR");
  call->preset.add_options(*command);
  command->add_option("--format", call->formats, "Output formats, comma-separated [mcpr]")
      ->delimiter(',')
      ->check(CLI::IsMember({"mcpr", "bvh", "amc", "csv", "glb"}));
  CLI::Option* const bank =
      command
          ->add_option("--bank", call->bank,
                       "Also put all .mcpr files into DIR/bank.mcpk: packed, the smallest form, or "
                       "cooked, which engines sample as it lies")
          ->type_name("FORM")
          ->check(CLI::IsMember({"packed", "cooked"}));
  command
      ->add_flag("--learn", call->learn,
                 "Code motions of a packed bank by what the clips teach of each other: up to a "
                 "minute, and 1 to 2 % fewer bytes where there are some hundred")
      ->needs(bank);
  command
      ->add_option("--name", call->names,
                   "Output names: {folder}, {stem}, {type}, {preset}, {method} [{folder}/{stem}]")
      ->type_name("PATTERN");
  call->source.add_options(*command);
  call->source.add_character_option(*command);
  call->exporting.add_options(*command);
  for (CLI::Option* option : command->get_options())
    if (const std::string name = option->get_name();
        name != "input" && name != "--output" && name != "--help")
      call->of_queue.push_back(option);
  command->add_option("--jobs", call->jobs, "Clips at a time [as many as processors]")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  command->add_option("--shard", call->shard, "Do only the i-th of n parts")
      ->type_name("i/n")
      ->excludes(bank)
      ->check(parsed_by(&parse_shard));
  command->add_flag("--resume", call->resume, "Continue DIR's batch; redo what failed or changed");
  command->add_flag("--overwrite", call->overwrite, "Replace files that are there");
  command->add_flag("--keep-going,!--stop-at-failure", call->keep_going,
                    "Continue after a failure (default)");
  command->add_flag("--json-progress", call->json_progress, "Print progress as lines of JSON");
  command->add_flag("--merge", call->merge, "Merge the reports of the shards in INPUT...");
  command
      ->add_option("--write-slurm", call->slurm_file,
                   "Write a script for sbatch instead, and DIR/queue.json for it")
      ->excludes(bank)
      ->type_name("FILE");
  command->add_option("--slurm-tasks", call->slurm_tasks, "Shards of that script [8]")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
