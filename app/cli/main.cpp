// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>

#include "app/cli/commands.h"
#include "core/base/error.h"

namespace {

// Scripts depend on these.
enum ExitCode {
  kDone = 0,
  kInternal = 1,
  kUsage = 2,
  kBadInput = 3,
  kTargetMissed = 4,
  kCannotWrite = 5
};

int fail(ExitCode code, const std::exception& error) {
  std::fprintf(stderr, "mocapress: %s\n", error.what());
  return code;
}

int run(int argc, char** argv) {
  CLI::App app("Compresses human motion capture clips with wavelets.", "mocapress");
  app.set_version_flag("--version", MOCAPRESS_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 1 internal error, 2 usage, 3 bad input, 4 quality target missed, "
      "5 cannot write.");
  mocapress::cli::add_info(app);
  mocapress::cli::add_compress(app);
  mocapress::cli::add_decompress(app);
  mocapress::cli::add_measure(app);
  mocapress::cli::add_bench(app);
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
  try {
    return run(argc, argv);
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
