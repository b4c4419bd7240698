// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/correction_arguments.h"

#include "app/cli/option_words.h"
#include "core/base/number_text.h"

namespace mocapress::cli {
namespace {

constexpr const char* kFound = "auto";

/// For CLI11: empty when `text` is a number above 0 or "auto", else what is wrong.
std::string check_ratio(const std::string& text) {
  const bool fits = text == kFound || number_in(text).value_or(0) > 0;
  return fits ? "" : text + " is neither a number above 0 nor " + kFound;
}

}  // namespace

void CorrectionArguments::add_options(CLI::App& command) {
  CLI::Option* ik = command
                        .add_option("--ik", ratio,
                                    "Hold the feet by inverse kinematics: all coefficients of "
                                    "the correction over those kept, or auto")
                        ->type_name("R_IK|auto")
                        ->check(check_ratio);
  command.add_option("--effectors", effectors, "Joints to hold [the feet]")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->needs(ik);
  command.add_option("--ik-solver", solver, "How joints are turned [nearest-pose]")
      ->transform(one_of({IkSolver::CyclicDescent, IkSolver::NearestPose}))
      ->needs(ik);
  command.add_option("--ik-at", at, "When they are held [every-frame]")
      ->transform(one_of({CorrectAt::EveryFrame, CorrectAt::Contacts}))
      ->needs(ik);
}

CorrectionSettings CorrectionArguments::settings() const {
  CorrectionSettings correction{.effectors = effectors, .solver = solver, .at = at};
  correction.ratio = number_in(ratio);  // unset: to be found
  return correction;
}

}  // namespace mocapress::cli
