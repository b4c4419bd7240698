// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/standard_streams.h"
#include "app/cli/terminal.h"
#include "core/base/end_without_memory.h"
#include "core/base/error.h"
#include "core/base/kept_memory.h"
#include "core/base/memory_limit.h"
#include "core/baselines/rivals.h"

namespace {

using namespace mocapress;
using namespace mocapress::cli;

ExitCode fail(ExitCode code, const std::exception& error) {
  std::fprintf(stderr, "mocapress: %s\n", printable(error.what()).c_str());
  return code;
}

/// Flushes standard output, which may be a file on a full disk.
ExitCode written_out(ExitCode code) {
  errno = 0;
  const bool is_written =
      std::cout.flush().good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_written || code != kDone) return code;
  const std::string why = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  return fail(kCannotWrite, mocapress::WriteError("standard output: cannot be written" + why));
}

const CLI::App& called(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

/// The first argument of the called command, which is its input. Errors that concern no other file
/// name this one.
std::string first_input(const CLI::App& app) {
  const CLI::App& command = called(app);
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional() && option->count() > 0) return option->results().front();
  return command.get_name();
}

/// Levenshtein's distance: how many letters to put in, take out or replace.
std::size_t slips_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
    }
  }
  return row.back();
}

/// An error message that lists unexpected words in the order given. CLI11 2.1 would reverse them,
/// and would report an unknown command as a missing one.
std::string failure_message(const CLI::App* app, const CLI::Error& error) {
  const auto told = [&](const std::string& text) {
    return CLI::FailureMessage::simple(app, CLI::ExtrasError(text, error.get_exit_code()));
  };
  const std::vector<std::string> words = app->remaining(true);
  const CLI::App& command = called(*app);
  if (command.get_require_subcommand_min() > 0 && !words.empty() &&
      !words.front().starts_with('-')) {
    std::string meant;
    std::size_t nearest = 3;  // words that differ by 3 letters or more are not suggested
    for (const CLI::App* known : command.get_subcommands({}))
      if (const std::size_t slips = slips_between(words.front(), known->get_name());
          slips < nearest) {
        nearest = slips;
        meant = known->get_name();
      }
    return told("'" + words.front() + "' is no command" +
                (meant.empty() ? "" : "; did you mean " + meant + "?"));
  }
  const bool is_extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  if (words.empty() || (!is_extra && command.get_require_subcommand_min() == 0))
    return CLI::FailureMessage::simple(app, error);
  return told("Not expected: " + CLI::detail::join(words, " "));
}

ExitCode run(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "help") {  // as the last word it is --help
    static char help[] = "--help";
    argv[1] = help;
    std::rotate(argv + 1, argv + 2, argv + argc);
  }
  CLI::App app("Compresses human motion capture clips with wavelets.", "mocapress");
  app.set_version_flag("-v,--version", MOCAPRESS_VERSION);
  app.allow_windows_style_options(false);  // "/clips/walk.bvh" is a path, not an option
  app.require_subcommand(1);
  app.footer(
      "Every command accepts --memory SIZE: files whose contents would take more are refused "
      "[2GiB].\n"
      "Exit codes: 0 done, 1 internal error, 2 wrong usage, 3 bad input, 4 quality target missed "
      "or clips that --fail-on names, 5 cannot write, 7 some clips failed, 128 + signal when "
      "stopped by it.");
  app.fallthrough();
  app.add_option_function<std::uint64_t>(
         "--memory", set_memory_limit,
         "Most memory that the contents of a file may take, such as 512MiB or 8GiB [2GiB]")
      ->type_name("SIZE")
      ->transform(CLI::AsSizeValue(false));
  add_info(app);
  add_compress(app);
  add_decompress(app);
  add_measure(app);
  add_contacts(app);
  add_bench(app);
  add_study(app);
  add_batch(app);
  add_diff(app);
  add_signoff(app);
  add_bank(app);
  refuse_streams(app);
  app.failure_message(&failure_message);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = error.get_exit_code() == 0;
    app.exit(error);
    return asked_for_help ? kDone : kUsage;
  } catch (const std::bad_alloc&) {
    throw_out_of_memory(first_input(app));
  } catch (const nlohmann::json::exception&) {
    throw InputError(first_input(app), 0, 0,
                     "has a JSON value of another type than its place asks for");
  }
  return kDone;
}

ExitCode answer(int argc, char** argv) {
  using namespace mocapress;
  try {
    return run(argc, argv);
  } catch (const EndedWith& ended) {
    return static_cast<ExitCode>(ended.exit_code);
  } catch (const InputError& error) {
    return fail(kBadInput, error);
  } catch (const FormatError& error) {
    return fail(kBadInput, error);
  } catch (const TargetMissed& error) {
    return fail(kTargetMissed, error);
  } catch (const WriteError& error) {
    return fail(kCannotWrite, error);
  } catch (const CLI::Error& error) {
    return fail(kUsage, error);
  } catch (const std::exception& error) {
    return fail(kInternal, error);
  }
}

}  // namespace

int main(int argc, char** argv) {
  mocapress::keep_freed_memory();
  mocapress::end_without_memory_by(kBadInput);
  mocapress::add_rivals();
  const Arguments arguments(argc, argv);
  return written_out(answer(arguments.count(), arguments.values()));
}
