// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "app/cli/batch_progress.h"
#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "app/cli/option_words.h"
#include "app/cli/preset_arguments.h"
#include "app/cli/terminal.h"
#include "core/bank/bank.h"
#include "core/base/file.h"
#include "core/base/file_identity.h"
#include "core/base/kept_memory.h"
#include "core/base/make_folders.h"
#include "core/base/memory_limit.h"
#include "core/base/number_text.h"
#include "core/base/utf8_path.h"
#include "core/batch/batch_folder.h"
#include "core/batch/gate.h"
#include "core/batch/project_batch.h"
#include "core/batch/queue_json.h"
#include "core/batch/slurm_script.h"
#include "core/formats/text_writer.h"
#include "core/report/review_page.h"

namespace mocapress::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kQueueFile = "queue.json";

/// Validator for CLI11 that returns an empty text if `text` can be parsed, else the error.
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

std::string absolute(const std::string& path) {
  return utf8(fs::absolute(utf8_path(path)).lexically_normal());
}

struct BatchCommand {
  std::vector<std::string> inputs;
  MotionInput source;
  MotionOutput exporting;
  std::string folder;
  PresetArguments preset{.preset = "gameplay"};
  std::vector<std::string> formats = {"mcpr"};
  std::string bank;
  bool learn = false;
  bool review = false;
  std::string names = kUsualNames;
  std::string shard = "1/1";
  int jobs = 0;
  bool resume = false;
  bool overwrite = false;
  bool take_over = false;
  std::optional<double> clip_seconds;
  std::vector<std::string> fail_on;
  bool keep_going = true;
  bool json_progress = false;
  bool merge = false;
  std::string slurm_file;
  int slurm_tasks = 8;
  std::vector<CLI::Option*> of_queue;  // refused with a queue file, which sets them itself

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
    const bool is_queue = inputs.size() == 1 && utf8_path(inputs.front()).extension() == ".json";
    if (is_queue) {
      for (const CLI::Option* option : of_queue)
        if (option->count() > 0)
          throw CLI::ValidationError(option->get_name(), "is set by the queue file");
      return parse_queue(inputs.front(), read_text(utf8_path(inputs.front())));
    }
    const bool is_project = inputs.size() == 1 && is_project_file(inputs.front());
    Batch batch{
        .presets = {preset.read()}, .reading = source.options, .writing = exporting.options};
    batch.formats.clear();
    for (const std::string& format : formats)
      if (std::count(batch.formats.begin(), batch.formats.end(), *output_format(format)) == 0)
        batch.formats.push_back(*output_format(format));
    if (review && !has_review_viewer()) throw CLI::ValidationError("--review", kNoReviewViewer);
    if (review) batch.formats.push_back(OutputFormat::Review);
    if (!bank.empty()) batch.bank = bank_form(bank);
    batch.learn = learn;
    try {
      check(batch);
    } catch (const Error& error) {
      throw CLI::ValidationError("--bank", error.what());
    }
    if (!is_project) check_folders();
    try {
      if (is_project)
        add_project(batch, inputs.front(), read_text(utf8_path(inputs.front())), names);
      else
        add_items(batch, sources(), 0, names);
    } catch (const InputError&) {
      throw;
    } catch (const Error& error) {
      throw CLI::ValidationError("--name", error.what());
    }
    if (source.skeleton)
      for (std::size_t i = 0; i < batch.items.size(); ++i) {
        BatchItem item = batch.items[i];
        if (item.skeleton.empty()) item.skeleton = *source.skeleton;
        batch.items.replace(i, item);
      }
    mark_collisions(batch);
    return batch;
  }

  /// Refuses an output folder that is also an input, unless only .mcpr is written: the next run
  /// would compress the outputs as clips.
  void check_folders() const {
    if (formats == std::vector<std::string>{"mcpr"}) return;
    const std::optional<FileIdentity> target = identity_of(utf8_path(folder));
    for (const std::string& input : inputs)
      if (target && identity_of(utf8_path(input)) == target)
        throw CLI::ValidationError(
            "--output", folder + " is an input, too: motion files need a folder of their own");
  }

  std::vector<SourceClip> sources() const {
    std::vector<SourceClip> sources = find_sources(inputs, folder);
    if (std::all_of(sources.begin(), sources.end(),
                    [](const SourceClip& clip) { return !clip.problem.empty(); }))
      throw InputError(inputs.front(), 0, 0, "no clip was found: " + sources.front().problem);
    return sources;
  }

  /// Counts the clips that --fail-on refuses, and describes the first ones.
  struct GateKeeper {
    std::vector<Gate> gates;
    std::size_t refused = 0;
    std::string first;  // lines

    void look_at(const BatchRow& row) {
      const std::optional<std::string> reason = refusal(row, gates);
      if (!reason) return;
      constexpr std::size_t kMostDescribed = 5;
      if (++refused <= kMostDescribed)
        first += "\n  " + printable(row.input) + ": " + printable(*reason);
      else if (refused == kMostDescribed + 1)
        first += "\n  ...";
    }

    /// Throws EndedWith if any clip was refused.
    void end() const {
      if (refused == 0) return;
      std::fprintf(stderr, "--fail-on refuses %s%s\n", counted(refused, "clip").c_str(),
                   first.c_str());
      throw EndedWith{kTargetMissed};
    }
  };

  GateKeeper gate_keeper() const {
    GateKeeper keeper;
    for (const std::string& word : fail_on) keeper.gates.push_back(*gate_named(word));
    return keeper;
  }

  /// Refuses to write reports onto a queue, a project or a preset.
  void refuse_inputs_as_reports() const {
    std::vector<fs::path> read = utf8_paths(inputs);
    if (utf8_path(preset.preset).has_extension()) read.push_back(utf8_path(preset.preset));
    for (const char* extension : {".html", ".csv", ".json"})
      refuse_source(
          (utf8_path(folder) / report_name(parse_shard(shard))).replace_extension(extension), read);
  }

  void run_clips(const Batch& batch) const {
    const BatchRunOptions options{.shard = parse_shard(shard),
                                  .jobs = jobs,
                                  .overwrite = overwrite,
                                  .resumed = resume,
                                  .keep_going = keep_going,
                                  .clip_seconds = clip_seconds,
                                  .take_over = take_over};
    refuse_inputs_as_reports();
    GateKeeper keeper = gate_keeper();
    give_back_freed_memory();  // the search for clips has fragmented the heap
    const StopOnSignals signals;
    BatchReporter reporter(batch, json_progress);
    reporter.begin(utf8_path(folder), options.shard);
    BatchControl control;
    const BatchOutcome outcome = run_batch_in(utf8_path(folder), batch, options, control,
                                              [&](const BatchProgress& progress) {
                                                reporter.tell(progress);
                                                if (progress.row) keeper.look_at(*progress.row);
                                                return stop_signal == 0;
                                              });
    reporter.end(outcome, utf8_path(folder) / report_name(options.shard));
    if (stop_signal != 0 && !outcome.complete) {
      std::fprintf(stderr, "Stopped. To continue, run the same command with --resume.\n");
      throw EndedWith{128 + stop_signal};
    }
    if (outcome.counts.failed > 0 || !outcome.complete) throw EndedWith{kSomeFailed};
    keeper.end();
  }

  void run_merge() const {
    const std::vector<fs::path> folders = utf8_paths(inputs);
    const fs::path target = folder.empty() ? folders.front() : utf8_path(folder);
    GateKeeper keeper = gate_keeper();
    const MergedBatch merged =
        merge_batch(folders, target, [&](const BatchRow& row) { keeper.look_at(row); });
    std::fprintf(stderr, "%s, %zu failed, %zu still waiting\n%s\n",
                 counted(merged.clips, "clip").c_str(), merged.failed, merged.waiting,
                 printable(utf8(target / report_name({}))).c_str());
    if (merged.failed > 0 || merged.waiting > 0) throw EndedWith{kSomeFailed};
    keeper.end();
  }

  /// Writes the list of clips to a file, so that all tasks use the same list.
  void write_slurm(Batch batch) const {
    std::error_code error;
    const fs::path target = fs::absolute(utf8_path(folder)).lexically_normal();
    const fs::path queue = target / kQueueFile;
    SlurmJob job{.program = utf8(fs::read_symlink("/proc/self/exe", error)),
                 .arguments = {utf8(queue)},
                 .folder = utf8(target),
                 .shards = slurm_tasks};
    if (jobs > 0) job.processors = jobs;
    if (overwrite) job.arguments.emplace_back("--overwrite");
    if (memory_limit() != kUsualMemoryLimit)
      job.arguments.insert(job.arguments.end(), {"--memory", std::to_string(memory_limit())});
    if (clip_seconds)
      job.arguments.insert(job.arguments.end(), {"--clip-timeout", shortest_text(*clip_seconds)});
    const std::string script = slurm_script(job);
    if (error) throw Error("/proc/self/exe: cannot be read: " + error.message());
    const std::set<FileIdentity> sources = source_files(batch);
    for (const fs::path& place : {queue, utf8_path(slurm_file)}) {
      refuse_source(place, utf8_paths(inputs));
      if (const auto there = identity_of(place); there && sources.contains(*there))
        throw WriteError(utf8(place) + ": is one of the inputs: not overwritten");
    }
    make_folders(target);
    for (std::size_t i = 0; i < batch.items.size(); ++i) {
      BatchItem item = batch.items[i];
      item.input = absolute(item.input);
      if (!item.skeleton.empty()) item.skeleton = absolute(item.skeleton);
      if (item.reading && item.reading->character)
        item.reading->character = absolute(*item.reading->character);
      batch.items.replace(i, item);
    }
    if (batch.reading.character) batch.reading.character = absolute(*batch.reading.character);
    write_text(queue, queue_text(batch));
    write_text(utf8_path(slurm_file), script);
    std::fprintf(stderr, "%s in %s: sbatch %s\n", counted(batch.items.size(), "clip").c_str(),
                 counted(slurm_tasks, "task").c_str(), printable(slurm_file).c_str());
  }
};

}  // namespace

void add_batch(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("batch", "Compress many clips, verify each, and report on all");
  const auto call = std::make_shared<BatchCommand>();
  command
      ->add_option("input", call->inputs,
                   "Clips and folders of clips, one project (.mocapress) or one queue file "
                   "(.json); with --merge, output folders of batches")
      ->required()
      ->type_name("INPUT...");
  command->add_option("-o,--output", call->folder, "Folder for compressed files and reports")
      ->type_name("DIR");
  call->preset.add_options(*command, false);
  command
      ->add_option("--format", call->formats,
                   "Formats to write each clip in, comma-separated [mcpr]")
      ->delimiter(',')
      ->check(CLI::IsMember({"mcpr", "bvh", "amc", "csv", "glb", "fbx"}));
  command->add_flag("--review", call->review,
                    "Let report.html show original and compressed motion of each clip in 3D; "
                    "writes NAME.review.js for each");
  CLI::Option* const bank =
      command
          ->add_option("--bank", call->bank,
                       "Also put all .mcpr files into DIR/bank.mcpk: packed (the smallest form) or "
                       "cooked (engines sample it without unpacking)")
          ->type_name("FORM")
          ->check(CLI::IsMember({"packed", "cooked"}));
  command
      ->add_flag("--learn", call->learn,
                 "Fit the statistics of the coder to the clips of a packed bank. This takes up to "
                 "a minute and saves 1 to 2 % of the bytes of some hundred clips")
      ->needs(bank);
  command
      ->add_option("--name", call->names,
                   "Pattern of output names, made of {folder}, {stem}, {type}, {preset} and "
                   "{method} [{folder}/{stem}]")
      ->type_name("PATTERN");
  call->source.add_options(*command);
  call->source.add_character_option(*command);
  call->exporting.add_options(*command);
  for (CLI::Option* option : command->get_options())
    if (const std::string name = option->get_name();
        name != "input" && name != "--output" && name != "--help")
      call->of_queue.push_back(option);
  command
      ->add_option("--jobs", call->jobs,
                   "Number of clips compressed at the same time [one for each processor]")
      ->type_name("N")
      ->check(number_above_0());
  command->add_option("--shard", call->shard, "Compress only part i of n parts of the clips")
      ->type_name("i/n")
      ->excludes(bank)
      ->check(parsed_by(&parse_shard));
  command->add_flag(
      "--resume", call->resume,
      "Continue the batch in DIR: clips that failed or whose source changed are compressed again");
  command->add_flag("--overwrite", call->overwrite,
                    "Replace existing files that are not from this batch");
  command->add_flag("--take-over", call->take_over,
                    "Continue a batch that another computer has locked but no longer works on");
  command
      ->add_option("--clip-timeout", call->clip_seconds,
                   "Give up clips that take longer: they count as failed, others continue")
      ->type_name("SECONDS")
      ->check(number_above_0());
  command
      ->add_option(
          "--fail-on", call->fail_on,
          "Exit with code 4 if a finished clip is one of these, comma-separated; "
          "borderline includes visible, rejected includes stale verdicts, damaged is a file cut "
          "short or with values that are no numbers, warning any repair or guess")
      ->delimiter(',')
      ->check(CLI::IsMember({"visible", "borderline", "rejected", "damaged", "warning"}));
  command->add_flag("--keep-going,!--stop-at-failure", call->keep_going,
                    "After a clip that failed, continue with the others (default) or stop");
  command->add_flag("--json-progress", call->json_progress, "Print progress as lines of JSON");
  command->add_flag("--merge", call->merge,
                    "Merge the reports of the shards in the folders INPUT into one");
  command
      ->add_option("--write-slurm", call->slurm_file,
                   "Instead of compressing, write a job script for Slurm's sbatch, and the "
                   "DIR/queue.json that it needs")
      ->excludes(bank)
      ->type_name("FILE");
  command
      ->add_option("--slurm-tasks", call->slurm_tasks,
                   "Number of shards (array tasks) of that script [8]")
      ->type_name("N")
      ->check(number_above_0());
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
