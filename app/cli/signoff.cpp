// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/base/file.h"
#include "core/base/utf8_path.h"
#include "core/batch/batch_folder.h"
#include "core/batch/batch_sign_off.h"

namespace mocapress::cli {
namespace {

struct SignOffCall {
  std::string folder;
  std::string output;
  bool all_approved = false;

  void run() const {
    const std::filesystem::path file = utf8_path(output);
    const bool is_table = file.extension() == ".csv";
    if (!is_table && file.extension() != ".html")
      throw CLI::ValidationError(output, "a sign-off is written as .html or .csv");
    std::filesystem::path named = std::filesystem::absolute(utf8_path(folder)).lexically_normal();
    if (!named.has_filename()) named = named.parent_path();
    std::size_t unfinished = 0;
    const SignOff report =
        sign_off_of([&](const auto& visit) { unfinished = visit_rows(utf8_path(folder), visit); },
                    utf8(named.filename()));
    write_text(file, is_table ? sign_off_csv(report) : sign_off_html(report));
    const SignOffCounts counts = count(report);
    std::printf("%zu clips: %zu approved, %zu rejected, %zu stale, %zu without a verdict\n",
                report.clips.size(), counts.approved, counts.rejected, counts.stale,
                counts.waiting);
    if (unfinished > 0) {
      std::fprintf(stderr, "%s: %zu clips have no row: the batch was not finished\n",
                   printable(folder).c_str(), unfinished);
      throw EndedWith{kSomeFailed};
    }
    if (all_approved && counts.approved < report.clips.size()) throw EndedWith{kTargetMissed};
  }
};

}  // namespace

void add_signoff(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "signoff", "Write verdicts, worst frames and notes of a batch made from a project");
  const auto call = std::make_shared<SignOffCall>();
  command->add_option("folder", call->folder, "Folder of the batch")
      ->required()
      ->type_name("FOLDER");
  command->add_option("-o,--output", call->output, "File to write: .html or .csv")
      ->required()
      ->type_name("FILE");
  command->add_flag("--all-approved", call->all_approved,
                    "Exit code 4 unless every clip is approved as it is in the batch");
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
