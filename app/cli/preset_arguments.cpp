// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/preset_arguments.h"

#include "app/cli/option_words.h"
#include "core/base/error.h"
#include "core/mocapress/settings_json.h"

namespace mocapress::cli {

void PresetArguments::add_options(CLI::App& command) {
  std::string known;
  for (const Settings& one : built_in_presets())
    known += (known.empty() ? "" : ", ") + slug(one.name);
  command.add_option("--preset", preset, known + ", or a file [gameplay]")->type_name("P|FILE");
  command.add_option("--method", method, "Method, instead of the preset's")
      ->transform(one_of_the_methods());
  command.add_option("--coding", coding, "Coding of the coefficients")
      ->transform(one_of({Coding::Rle16, Coding::Deflate, Coding::Adaptive}));
  command.add_option("--weighting", weighting, "Error weighting")->transform(one_of(kWeightings));
  CLI::Option_group* targets =
      command.add_option_group("target", "At most one, instead of the preset's");
  targets->require_option(0, 1);
  const auto add = [&](const char* flag, Target::Kind kind, const char* unit, const char* help) {
    targets
        ->add_option_function<double>(
            flag,
            [this, kind](const double& value) {
              target = Target{kind, value};
            },
            help)
        ->type_name(unit)
        ->check(CLI::PositiveNumber);
  };
  add("--ratio", Target::Kind::Ratio, "R", "Float32 bytes over motion bytes, met within 2 %");
  add("--coefficient-ratio", Target::Kind::CoefficientRatio, "r",
      "The paper's r: all coefficients over those kept");
  add("--target-error", Target::Kind::Error, "CM", "eps_x at most this");
  add("--target-size", Target::Kind::Size, "BYTES", "Motion bytes at most this");
  add("--max-error", Target::Kind::MaxError, "CM",
      "No point of the weighting further off, at any frame");
  targets
      ->add_option_function<Sight>(
          "--target",
          [this](const Sight&) {
            target = Target{Target::Kind::Visibility, 1};
          },
          "The smallest file with nothing off that people notice")
      ->transform(one_of({Sight::NotVisible}));
  correction.add_options(command);
  importance.add_options(command);
  command.add_option("--effort", effort, "Search effort of the closed loop [default]")
      ->transform(one_of({Effort::Default, Effort::Best}));
  command.add_option("--ends", ends, "First and last pose of the closed loop [even]")
      ->transform(one_of({Ends::Free, Ends::Even, Ends::Exact}));
  command.add_option("--loop", loop, "Whether clips are loops [found]")
      ->transform(one_of({Loop::None, Loop::Repeats, Loop::Follows}));
  command.add_option("--seed", seed, "Seed of the annealing: same seed, same bytes");
}

Settings PresetArguments::read() const {
  Settings read = find_preset(preset);
  if (!method.empty()) {
    read.method = method;
    read.coding.reset();
  }
  if (coding) read.coding = coding;
  if (weighting) read.weighting = *weighting;
  if (target) read.target = *target;
  if (seed) read.seed = *seed;
  if (!correction.ratio.empty()) read.correction = correction.settings();
  if (!importance.words.empty()) read.importance = importance.named();
  if (effort) read.effort = *effort;
  if (ends) read.ends = *ends;
  if (loop) read.loop = *loop;
  try {
    check(read);
  } catch (const Error& error) {
    throw CLI::ValidationError(error.what());
  }
  return read;
}

}  // namespace mocapress::cli
