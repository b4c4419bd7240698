// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/preset_arguments.h"

#include "app/cli/option_words.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/metrics/visibility.h"
#include "core/mocapress/settings_json.h"
#include "core/motion/skeleton.h"

namespace mocapress::cli {

namespace {

constexpr const char* kFound = "auto";

/// Validator for CLI11 that returns an empty text if `text` is a number above 0 or "auto", else the
/// error.
std::string check_ratio(const std::string& text) {
  const bool fits = text == kFound || number_in(text).value_or(0) > 0;
  return fits ? "" : text + " is neither a number above 0 nor " + kFound;
}

}  // namespace

void CorrectionArguments::add_options(CLI::App& command) {
  CLI::Option* ik =
      command
          .add_option("--ik", ratio,
                      "Hold the feet by inverse kinematics. R_IK is the coefficient ratio of the "
                      "correction: all coefficients over those kept; auto searches for it")
          ->type_name("R_IK|auto")
          ->check(check_ratio);
  command.add_option("--effectors", effectors, "Joints that --ik holds [the feet]")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->needs(ik);
  command.add_option("--ik-solver", solver, "Solver that turns the joints [nearest-pose]")
      ->transform(one_of({IkSolver::CyclicDescent, IkSolver::NearestPose}))
      ->needs(ik);
  command.add_option("--ik-at", at, "Frames at which --ik holds the joints [every-frame]")
      ->transform(one_of({CorrectAt::EveryFrame, CorrectAt::Contacts}))
      ->needs(ik);
}

CorrectionSettings CorrectionArguments::settings() const {
  CorrectionSettings correction{.effectors = effectors, .solver = solver, .at = at};
  correction.ratio = number_in(ratio);  // an unset ratio is found by the encoder
  return correction;
}

namespace {

constexpr const char* kOption = "--importance";
constexpr const char* kContacts = "contacts";

struct Wish {
  std::string name;
  double factor;
};

Wish parse(const std::string& word) {
  const std::size_t equals = word.find('=');
  double factor = 0;
  if (equals == std::string::npos || !CLI::detail::lexical_cast(word.substr(equals + 1), factor) ||
      !(factor >= 0))
    throw CLI::ValidationError(kOption, "expects NAME=FACTOR, FACTOR 0 or more: " + word);
  return {word.substr(0, equals), factor};
}

}  // namespace

void ImportanceArguments::add_options(CLI::App& command) {
  command
      .add_option(kOption, words,
                  "Weight errors of a part by FACTOR, at the cost of the rest. Parts: feet, hands, "
                  "fingers, head, a joint's name, or contacts (feet while they stand)")
      ->type_name("NAME=FACTOR,...")
      ->delimiter(',');
}

NamedImportance ImportanceArguments::named() const {
  NamedImportance named;
  for (const std::string& word : words) {
    const auto [name, factor] = parse(word);
    if (name == kContacts)
      named.contacts = factor;
    else
      named.set(name, factor);
  }
  return named;
}

void ImportanceArguments::require_names_of(const Skeleton& skeleton) const {
  const NamedImportance wishes = named();
  for (const auto& [name, factor] : wishes.factors)
    if (joints_named(skeleton, name).empty())
      throw CLI::ValidationError(kOption, "the skeleton has no part or joint named " + name +
                                              "; parts are feet, hands, fingers, head, contacts");
}

namespace {

/// Reads "40-80=3". Throws CLI::ValidationError.
ImportantRange range_from(const std::string& word) {
  ImportantRange range;
  const std::size_t dash = word.find('-');
  const std::size_t equals = word.find('=');
  using CLI::detail::lexical_cast;
  if (dash == std::string::npos || equals == std::string::npos || equals < dash ||
      !lexical_cast(word.substr(0, dash), range.first_frame) ||
      !lexical_cast(word.substr(dash + 1, equals - dash - 1), range.last_frame) ||
      !lexical_cast(word.substr(equals + 1), range.factor) || range.first_frame < 1 ||
      range.last_frame < range.first_frame ||
      !(range.factor >= 1 && range.factor <= kMostRangeFactor))
    throw CLI::ValidationError(
        "--importance-range",
        "expects A-B=FACTOR, frames A to B from 1 on, FACTOR from 1 to 100: " + word);
  --range.first_frame;  // ImportantRange counts from 0
  --range.last_frame;
  return range;
}

}  // namespace

void add_range_option(CLI::App& command, std::vector<ImportantRange>& ranges) {
  command
      .add_option_function<std::vector<std::string>>(
          "--importance-range",
          [&ranges](const std::vector<std::string>& words) {
            ranges.clear();
            for (const std::string& word : words) ranges.push_back(range_from(word));
          },
          "Weight errors in frames A to B, counted from 1, by FACTOR (1 to 100); closed loop only")
      ->type_name("A-B=FACTOR,...")
      ->delimiter(',');
}

void add_target_options(CLI::App& command, const std::string& title,
                        const std::function<void(const Target&)>& choose) {
  CLI::Option_group* const targets = command.add_option_group("target", title);
  targets->require_option(0, 1);
  const auto add = [&](const char* flag, Target::Kind kind, const char* unit, const char* help) {
    targets
        ->add_option_function<double>(
            flag,
            [choose, kind](const double& value) {
              choose({kind, value});
            },
            help)
        ->type_name(unit)
        ->check(number_above_0());
  };
  add("--ratio", Target::Kind::Ratio, "R",
      "Compression ratio: bytes of the channels as 32-bit floats over bytes of the coded motion, "
      "met within 2 %");
  add("--coefficient-ratio", Target::Kind::CoefficientRatio, "r",
      "Coefficient ratio (r in the paper): all coefficients over those kept");
  add("--target-error", Target::Kind::Error, "CM",
      "Largest eps_x allowed: the weighted RMS error of points on the body");
  add("--target-size", Target::Kind::Size, "BYTES",
      "Most bytes that the coded motion may take, without the skeleton");
  add("--max-error", Target::Kind::MaxError, "CM",
      "Largest error allowed for any point of the weighting at any frame");
  targets
      ->add_option_function<Sight>(
          "--target",
          [choose](const Sight& sight) {
            choose({Target::Kind::Visibility, sight == Sight::Borderline ? noticed::kVisible : 1});
          },
          "Smallest file whose errors people do not notice, or hardly do")
      ->transform(one_of({Sight::NotVisible, Sight::Borderline}));
}

void PresetArguments::add_options(CLI::App& command, bool with_drafts) {
  std::string known;
  for (const Settings& one : built_in_presets())
    known += (known.empty() ? "" : ", ") + slug(one.name);
  command
      .add_option("--preset", preset,
                  "Preset: " + known +
                      ", or a preset file (.json). Other options replace parts of "
                      "it [" +
                      (preset.empty() ? "none" : preset) + "]")
      ->type_name("P|FILE");
  command
      .add_option("--method", method,
                  "Compression method; all but closed-loop are for comparison [closed-loop]")
      ->transform(one_of_the_methods());
  command
      .add_option("--coding", coding,
                  "Coding of the coefficients [closed-loop: adaptive, others: deflate]")
      ->transform(one_of({Coding::Rle16, Coding::Deflate, Coding::Adaptive}));
  command.add_option("--weighting", weighting, "Points on which errors are measured [surface]")
      ->transform(one_of(kWeightings));
  add_target_options(
      command,
      std::string(
          "One target at most; it replaces the preset's target and promises [the preset's") +
          (preset.empty() ? "; --ratio 25 without one]" : "]"),
      [this](const Target& asked) { target = asked; });
  correction.add_options(command);
  importance.add_options(command);
  sight.add_options(command, "else the preset's, else 5");
  command
      .add_option("--effort", effort,
                  std::string("Search effort of the closed loop: ") +
                      (with_drafts ? "draft is quick and only near the target, " : "") +
                      "best is about 1 % smaller in three times the time [default]")
      ->transform(with_drafts ? one_of({Effort::Draft, Effort::Default, Effort::Best})
                              : one_of({Effort::Default, Effort::Best}));
  command
      .add_option("--ends", ends,
                  "First and last pose of the closed loop: free of bounds, even (within the "
                  "target), or exact (within a tenth of it) [even]")
      ->transform(one_of({Ends::Free, Ends::Even, Ends::Exact}));
  command
      .add_option("--loop", loop,
                  "Treat clips as loops: repeats (the last frame shows the first pose again), "
                  "follows (the first frame follows the last), or none [detected]")
      ->transform(one_of({Loop::None, Loop::Repeats, Loop::Follows}));
  command.add_option("--seed", seed, "Seed of the annealing; the same seed gives the same bytes");
}

Settings PresetArguments::read() const {
  Settings read = preset.empty() ? Settings{.target = {}} : find_preset(preset);
  if (!method.empty()) {
    read.method = method;
    read.coding.reset();
  }
  if (coding) read.coding = coding;
  if (weighting) read.weighting = *weighting;
  if (target) {
    read.target = *target;
    read.promises = {};  // promises apply only to the preset's own target
  }
  if (seed) read.seed = *seed;
  if (!correction.ratio.empty()) read.correction = correction.settings();
  if (!importance.words.empty()) read.importance = importance.named();
  read.limits = sight.read(read.limits);
  if (effort && *effort != Effort::Draft) read.effort = *effort;
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
