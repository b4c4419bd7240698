// SPDX-License-Identifier: MIT
// Based on: the Slurm manual, sbatch(1): job arrays, --open-mode, --requeue, --dependency.
#include "core/batch/slurm_script.h"

#include <algorithm>

#include "core/base/error.h"

namespace mocapress {
namespace {

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

[[noreturn]] void refuse(std::string word, const std::string& why) {
  std::ranges::replace_if(word, &is_control, '?');
  throw WriteError("a script for sbatch cannot name " + word + ": it has " + why + " in it");
}

/// Quotes a text as a single word for a shell.
std::string quoted(const std::string& word) {
  if (std::ranges::any_of(word, &is_control))
    refuse(word, "a line break or another control character");
  constexpr const char* kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./=,:+";
  if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return word;
  std::string text = "'";
  for (const char c : word) c == '\'' ? text += "'\\''" : text += c;
  return text + "'";
}

/// A log's path for an #SBATCH line. Slurm replaces %A and the like, so each % is doubled. In a
/// path with a backslash it replaces nothing, so such paths are refused. The path is quoted, since
/// Slurm splits the line at blanks.
std::string log_name(const std::string& folder, const std::string& name) {
  if (folder.find('\\') != folder.npos) refuse(folder, "a backslash");
  std::string path;
  for (const char c : folder) {
    if (c == '"') path += '\\';
    path.append(c == '%' ? 2 : 1, c);
  }
  return "\"" + path + "/" + name + "\"";
}

}  // namespace

std::string slurm_script(const SlurmJob& job) {
  std::string arguments;
  for (const std::string& argument : job.arguments) arguments += " \\\n    " + quoted(argument);
  const std::string folder = quoted(job.folder);
  return "#!/bin/bash\n"
         "# Submit with: sbatch THIS_FILE. Logs and reports go to the batch's folder.\n"
         "# A task that was killed or requeued resumes; so does sbatch, run again.\n"
         "#SBATCH --job-name=mocapress\n"
         "#SBATCH --array=1-" +
         std::to_string(job.shards) +
         "\n"
         "#SBATCH --ntasks=1\n"
         "#SBATCH --cpus-per-task=" +
         std::to_string(job.processors) +
         "\n"
         "#SBATCH --output=" +
         log_name(job.folder, "slurm-%A_%a.log") +
         "\n"
         "#SBATCH --open-mode=append\n"
         "#SBATCH --requeue\n"
         "\n"
         "mocapress=" +
         quoted(job.program) +
         "\n"
         "folder=" +
         folder +
         "\n"
         "\n"
         "# The first task asks, once, for the merge of all reports when every task has ended.\n"
         "if [ \"$SLURM_ARRAY_TASK_ID\" = \"$SLURM_ARRAY_TASK_MIN\" ] &&\n"
         "   [ \"${SLURM_RESTART_COUNT:-0}\" = 0 ]; then\n"
         "  sbatch --job-name=mocapress-merge --dependency=\"afterany:$SLURM_ARRAY_JOB_ID\" \\\n"
         "    --ntasks=1 --cpus-per-task=1 --open-mode=append --requeue \\\n"
         "    --output=\"${folder//%/%%}/slurm-merge.log\" <<MERGE\n"
         "#!/bin/bash\n"
         "exec $(printf '%q' \"$mocapress\") batch --merge $(printf '%q' \"$folder\")\n"
         "MERGE\n"
         "fi\n"
         "\n"
         "shard=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN + 1))/$SLURM_ARRAY_TASK_COUNT\n"
         "exec srun \"$mocapress\" batch -o \"$folder\" --shard \"$shard\" --resume \\\n"
         "    --jobs \"${SLURM_CPUS_PER_TASK:-1}\" --json-progress" +
         arguments + "\n";
}

}  // namespace mocapress
