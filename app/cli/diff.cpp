// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/report.h"
#include "app/cli/terminal.h"
#include "core/base/number_text.h"
#include "core/base/utf8_path.h"
#include "core/batch/batch_difference.h"
#include "core/batch/batch_folder.h"
#include "core/formats/text_writer.h"

namespace mocapress::cli {
namespace {

struct Diff {
  std::string before;
  std::string after;
  double percent = 1;
  std::vector<std::string> fail_on;
  bool json = false;

  void run() const {
    std::size_t waiting = 0;
    const auto rows_of = [&waiting](const std::string& folder) {
      return [&waiting, folder](const std::function<void(const BatchRow&)>& visit) {
        waiting = visit_rows(utf8_path(folder), visit);
        if (waiting > 0)
          std::fprintf(stderr, "%s: %s without a row: the batch was not finished\n",
                       printable(folder).c_str(), counted(waiting, "clip").c_str());
      };
    };
    const BatchDifference difference =
        difference_of(rows_of(before), rows_of(after), percent / 100);
    json ? print(to_json(difference)) : print_lines(difference);
    if (difference.judged_otherwise > 0)
      std::fprintf(stderr,
                   "%s judged from another distance or by other limits: visibility is not "
                   "compared there\n",
                   counted(difference.judged_otherwise, "clip").c_str());
    refuse(difference);
    if (waiting > 0)
      throw EndedWith{kSomeFailed};  // `waiting` counts the later batch, which was read last
  }

  /// Throws EndedWith if a clip changed in a way that --fail-on names, or if --fail-on names a
  /// change of visibility and clips were judged by different limits.
  void refuse(const BatchDifference& difference) const {
    bool refused = false;
    for (const std::string& word : fail_on) {
      const ClipChange change = *clip_change_named(word);
      if (change == ClipChange::NewlyVisible || change == ClipChange::NoLongerSeen)
        refused |= difference.judged_otherwise > 0;
      const std::size_t count = difference.count(change);
      if (count == 0) continue;
      std::fprintf(stderr, "%s %s (--fail-on)\n", counted(count, "clip").c_str(), word.c_str());
      refused = true;
    }
    if (refused) throw EndedWith{kTargetMissed};
  }

  static std::string described(const std::optional<ClipFigures>& figures) {
    if (!figures) return "-";
    if (!figures->done) return "failed: " + figures->reason;
    return std::to_string(figures->bytes) + " bytes, " + significant_text(figures->eps_cm, 3) +
           " cm, worst " + significant_text(figures->max_cm, 3) + " cm" +
           (figures->sight ? ", " + std::string(name(*figures->sight)) : "");
  }

  static void print_lines(const BatchDifference& difference) {
    std::printf("%s in both: %zu -> %zu bytes\n", counted(difference.clips, "clip").c_str(),
                difference.bytes_before, difference.bytes_after);
    for (const ClipChange change : kClipChanges)
      if (const std::size_t count = difference.count(change); count > 0)
        std::printf("%6zu %s\n", count, std::string(name(change)).c_str());
    for (const ClipDifference& clip : difference.changed) {
      std::string changes;
      for (const ClipChange change : clip.changes)
        changes.append(changes.empty() ? "" : ", ").append(name(change));
      std::printf("\n%s: %s\n  before  %s\n  after   %s\n", printable(clip.output).c_str(),
                  changes.c_str(), printable(described(clip.before)).c_str(),
                  printable(described(clip.after)).c_str());
      if (clip.after && clip.after->done && !clip.after->reason.empty())
        std::printf("  most noticeable: %s\n", printable(clip.after->reason).c_str());
    }
  }
};

}  // namespace

void add_diff(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "diff", "Say which clips of a batch got larger, worse or newly visible since an earlier one");
  const auto call = std::make_shared<Diff>();
  command->add_option("old", call->before, "Folder of the earlier batch")
      ->required()
      ->type_name("OLD");
  command->add_option("new", call->after, "Folder of the later batch")
      ->required()
      ->type_name("NEW");
  command->add_option("--above", call->percent, "Ignore changes of bytes and errors below this [1]")
      ->type_name("PERCENT")
      ->check(CLI::Range(0.0, 1e6, "NONNEGATIVE"));
  std::vector<std::string> words;
  for (const ClipChange change : kClipChanges) words.emplace_back(name(change));
  command
      ->add_option("--fail-on", call->fail_on,
                   "Exit code 4 if a clip is one of these, comma-separated: failed, newly-visible, "
                   "worse, larger, gone, added, done, no-longer-visible, better, smaller")
      ->delimiter(',')
      ->check(CLI::IsMember(words));
  command->add_flag("--json", call->json, "Print one JSON object");
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
