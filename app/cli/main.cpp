// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>
#include <string>

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

/// The command's first argument, its input: errors without a file of their own name this one.
std::string first_input(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  for (const CLI::Option* option : command->get_options())
    if (option->get_positional() && option->count() > 0) return option->results().front();
  return command->get_name();
}

ExitCode run(int argc, char** argv) {
  CLI::App app("Compresses human motion capture clips with wavelets.", "mocapress");
  app.set_version_flag("--version", MOCAPRESS_VERSION);
  app.allow_windows_style_options(false);  // "/clips/walk.bvh" is a file on every system
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
