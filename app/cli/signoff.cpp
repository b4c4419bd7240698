// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/file_identity.h"
#include "core/base/folder_listing.h"
#include "core/base/utf8_path.h"
#include "core/batch/batch_folder.h"
#include "core/batch/batch_sign_off.h"
#include "core/formats/text_writer.h"

namespace mocapress::cli {
namespace {

namespace fs = std::filesystem;

/// Throws WriteError if the sign-off would replace a report of its batch, by having the same name
/// or by following a link to it.
void refuse_report(const fs::path& file, const fs::path& batch) {
  const fs::path folder = fs::absolute(file).parent_path();
  const std::string name = utf8(file.filename());
  if ((name.starts_with("report.") || name.starts_with("report-")) &&
      identity_of(folder) == identity_of(batch))
    throw WriteError(utf8(file) + ": is a report of the batch: not overwritten");
  std::vector<fs::path> reports;
  for (const FolderEntry& entry : list_folder(batch).entries)
    if (utf8(entry.path.filename()).starts_with("report")) reports.push_back(entry.path);
  refuse_source(file, reports);
}

struct SignOffCall {
  std::string folder;
  std::string output;
  bool all_approved = false;

  void run() const {
    const fs::path file = utf8_path(output);
    const fs::path batch = utf8_path(folder);
    const bool is_table = file.extension() == ".csv";
    if (!is_table && file.extension() != ".html")
      throw CLI::ValidationError(output, "a sign-off is written as .html or .csv");
    fs::path named = fs::absolute(batch).lexically_normal();
    if (!named.has_filename()) named = named.parent_path();
    std::size_t unfinished = 0;
    const std::string extension = utf8(file.extension());
    const auto rows = [&](const auto& visit) {
      unfinished = visit_rows(batch, [&](const BatchRow& row) {
        refuse_source(file, {batch / utf8_path(row.output + extension)});
        visit(row);
      });
    };
    const SignOff report = sign_off_of(rows, utf8(named.filename()));
    refuse_report(file, batch);
    write_text(file, is_table ? sign_off_csv(report) : sign_off_html(report));
    const SignOffCounts counts = count(report);
    std::printf("%s: %zu approved, %zu rejected, %zu stale, %zu without a verdict\n",
                counted(report.clips.size(), "clip").c_str(), counts.approved, counts.rejected,
                counts.stale, counts.waiting);
    if (unfinished > 0) {
      std::fprintf(stderr, "%s: %s without a row: the batch was not finished\n",
                   printable(folder).c_str(), counted(unfinished, "clip").c_str());
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
