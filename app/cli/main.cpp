// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>

#include "app/cli/commands.h"
#include "app/cli/standard_streams.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/base/kept_memory.h"
#include "core/baselines/rivals.h"

namespace {

using namespace mocapress::cli;

int fail(ExitCode code, const std::exception& error) {
  std::fprintf(stderr, "mocapress: %s\n", printable(error.what()).c_str());
  return code;
}

int run(int argc, char** argv) {
  CLI::App app("Compresses human motion capture clips with wavelets.", "mocapress");
  app.set_version_flag("--version", MOCAPRESS_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 1 internal error, 2 usage, 3 bad input, 4 quality target missed or "
      "--fail-on, "
      "5 cannot write, 7 some clips failed; 128 + signal when stopped.");
  add_info(app);
  add_compress(app);
  add_decompress(app);
  add_measure(app);
  add_contacts(app);
  add_bench(app);
  add_study(app);
  add_batch(app);
  add_bank(app);
  refuse_streams(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = error.get_exit_code() == 0;
    app.exit(error);
    return asked_for_help ? kDone : kUsage;
  }
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace mocapress;
  keep_freed_memory();
  add_rivals();
  try {
    return run(argc, argv);
  } catch (const EndedWith& ended) {
    return ended.exit_code;
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
