// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/motion_input.h"

#include <cstdio>
#include <map>

#include "app/cli/option_words.h"
#include "app/cli/terminal.h"
#include "core/base/path_kind.h"
#include "core/base/utf8_path.h"
#include "core/formats/text_cursor.h"

namespace mocapress::cli {
namespace {

/// Checks a number against the limits for numbers in files. CLI::Range would accept "nan".
CLI::Validator possible_size() {
  return CLI::Validator(
      [](std::string& text) {
        const auto value = parse_number(text);
        const bool possible = value && *value >= 1e-9 && *value <= 1e9;
        return possible ? std::string() : "not a number from 1e-9 to 1e9: " + text;
      },
      "");
}

/// Adds --rate, --cm-per-unit and so on, with `prefix` after the dashes, as in --out-rate.
void add_format_options(CLI::App& command, const std::string& prefix, const std::string& of_file,
                        ReadOptions& options) {
  const auto flag = [&](const char* name) { return "--" + prefix + name; };
  command.add_option(flag("rate"), options.sample_rate_hz, "Frames per second" + of_file)
      ->type_name("HZ")
      ->check(possible_size());
  command
      .add_option(flag("cm-per-unit"), options.cm_per_unit,
                  "Centimetres in one length unit" + of_file)
      ->type_name("CM")
      ->check(possible_size());
  command.add_option(flag("up"), options.up, "Axis that points up" + of_file)
      ->transform(one_of({UpAxis::Y, UpAxis::Z}));
  command
      .add_option(flag("bvh-root"), options.bvh_root,
                  "Position channels of a BVH root: add to its OFFSET, or replace it" + of_file)
      ->transform(one_of({TranslationConvention::Adds, TranslationConvention::Replaces}));
}

}  // namespace

void MotionInput::add_options(CLI::App& command) {
  command.add_option("--skeleton", skeleton, "Skeleton for an .amc without an .asf beside it")
      ->type_name("S.asf");
  command
      .add_option("--take", options.take,
                  "Name or number of the take to read from an .fbx or glTF with several [the first "
                  "that moves]")
      ->type_name("TAKE");
  add_format_options(command, "", "; overrides the input file", options);
}

void MotionInput::add_character_option(CLI::App& command) {
  command
      .add_option("--character", options.character,
                  "Character (.fbx or glTF) whose joints have the clip's joint names; --weighting "
                  "skin measures errors on its mesh")
      ->type_name("FILE");
}

void MotionInput::add_tracks_option(CLI::App& command) {
  command
      .add_option("--tracks", options.tracks,
                  "More curves to keep with the clip: a line of names, then a line of numbers for "
                  "each frame [INPUT with the extension .tracks.csv, if that file exists]")
      ->type_name("T.csv");
}

void MotionOutput::add_options(CLI::App& command) {
  add_format_options(command, "out-", ", in written motion files [as in the source]", options);
  command
      .add_option("--fbx-version", options.fbx_version, "FBX version of written .fbx files [7.4]")
      ->type_name("7.4|7.7")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, int>{{"7.4", 7400}, {"7.7", 7700}}));
}

std::vector<std::filesystem::path> MotionInput::files(const std::string& path) const {
  return files_of_motion(utf8_path(path), utf8_path_if(skeleton), options);
}

MotionFile MotionInput::read_file(const std::string& path) const {
  if (path_kind(utf8_path(path)) == PathKind::Folder)
    throw InputError(path, 0, 0, "is a folder: batch takes folders of clips");
  if (equals_ignoring_case(utf8(utf8_path(path).extension()), ".mcpk"))
    throw InputError(path, 0, 0, "is a bank: 'bank list' describes it, 'bank extract' opens it");
  MotionFile file = read_motion(utf8_path(path), utf8_path_if(skeleton), options);
  print_warnings(file.warnings);
  return file;
}

void print_warnings(const Warnings& warnings) {
  for (const Warning& warning : warnings)
    std::fprintf(stderr, "warning: %s\n", printable(warning.text()).c_str());
}

}  // namespace mocapress::cli
