// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bank/bank.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "app/cli/report.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/base/file_identity.h"
#include "core/base/make_folders.h"
#include "core/base/number_text.h"
#include "core/base/parallel_in_order.h"
#include "core/base/path_kind.h"
#include "core/base/staged_file.h"
#include "core/base/utf8_path.h"
#include "core/codec/format/format_error.h"
#include "core/formats/text_cursor.h"
#include "core/formats/text_writer.h"

namespace mocapress::cli {
namespace {

namespace fs = std::filesystem;

/// Checks a "key=value" argument for CLI11.
std::string wrong_pair(const std::string& text) {
  return text.find('=') == std::string::npos || text.front() == '='
             ? "'" + text + "' is not key=value"
             : std::string();
}

std::string wrong_distance(const std::string& text) {
  const std::optional<double> cm = parse_number(text);
  return cm && *cm >= 0 && *cm <= std::numeric_limits<float>::max()
             ? std::string()
             : "'" + text + "' is not a distance in cm, 0 or more";
}

/// Counts finished clips on one line until the user or the system asks to stop.
class ClipCount {
 public:
  ~ClipCount() { end(); }

  /// Shows the progress of a change to a bank, and prints its warnings at once. False: stop.
  bool done(const BankProgress& progress) {
    if (progress.warning) print_warnings({*progress.warning});
    ik_bytes_ = progress.ik_bytes;
    return done(progress.done, progress.clips);
  }

  /// Shows that `done` of `clips` are done. False: stop.
  bool done(std::size_t done, std::size_t clips) {
    done_ = done;
    clips_ = clips;
    if (line_.due())
      line_.show(clips_ > 0 ? text() : "waiting: another program is changing the bank");
    return stop_signal == 0;
  }
  std::string text() const {
    if (clips_ == 0) return "no clip";
    return std::to_string(done_) + " of " + counted(clips_, "clip");
  }
  void end() const { line_.clear(); }
  std::uint64_t ik_bytes() const { return ik_bytes_; }

 private:
  const StopOnSignals stop_;
  ProgressLine line_{false};
  std::size_t done_ = 0;
  std::size_t clips_ = 0;
  std::uint64_t ik_bytes_ = 0;
};

/// Says what is in the bank just written.
void describe_written(const std::string& path) {
  const mcpk_bank bank = read_bank_head(utf8_path(path)).value_or(mcpk_bank{});
  std::fprintf(stderr, "%s: %s, %llu bytes, %s\n", printable(path).c_str(),
               counted(bank.clips, "clip").c_str(), static_cast<unsigned long long>(bank.bytes),
               name(bank.form).data());
}

/// Describes the bank just written. If writing was stopped, says so and throws EndedWith.
void tell_of(const std::string& path, bool is_whole, const ClipCount& count) {
  count.end();
  if (!is_whole) {
    std::fprintf(stderr, "Stopped after %s. Nothing was written.\n", count.text().c_str());
    throw EndedWith{128 + stop_signal};
  }
  describe_written(path);
  if (count.ik_bytes() > 0)
    std::fprintf(stderr,
                 "IK corrections take %llu of the bytes that were cooked now. A larger --ik-error "
                 "takes less, --no-ik none.\n",
                 static_cast<unsigned long long>(count.ik_bytes()));
}

struct BankFilling {
  std::string bank;
  std::vector<std::string> inputs;
  std::vector<std::string> tags;
  std::vector<std::string> texts;
  bool cooked = false;
  bool learn = false;
  bool no_ik = false;
  std::optional<float> ik_error;
  std::optional<std::uint32_t> detail_bands;

  void add_options(CLI::App& command) {
    command.add_option("bank", bank, "A .mcpk file")->required()->type_name("BANK.mcpk");
    command
        .add_option("input", inputs,
                    ".mcpr files, folders of them, or packed banks. No two may give a clip of one "
                    "name")
        ->required()
        ->type_name("INPUT...");
    command.add_option("--tag", tags, "Tag for all clips of INPUT; may be repeated")
        ->type_name("TAG")
        ->expected(1)
        ->take_all();
    command.add_option("--meta", texts, "Text to keep in the bank under a key; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all()
        ->check(wrong_pair);
    CLI::Option* const error =
        command
            .add_option(
                "--ik-error", ik_error,
                "Cooked banks: largest distance by which cooking an IK correction may move a joint "
                "at any frame, 0 for exact [the error that each clip was encoded with]")
            ->type_name("CM")
            ->check(wrong_distance);
    command.add_flag("--no-ik", no_ik, "Cooked banks: leave IK corrections out")->excludes(error);
    command
        .add_option("--detail-bands", detail_bands,
                    "Cooked banks: how many of the finest bands stay details. With 2 a pose takes "
                    "three quarters of the time, and clips 1.5 to 3.5 times the bytes [4 or 5, "
                    "whichever takes fewer bytes]")
        ->type_name("N")
        ->check(CLI::Range(1, MCPR_MOST_DETAIL_BANDS));
  }

  /// Throws CLI::ValidationError if an option for cooked banks is given with a packed bank.
  void require_use_of_options(bool make) const {
    if (!no_ik && !ik_error && !detail_bands) return;
    if (make ? cooked : BankFile(utf8_path(bank)).is_cooked()) return;
    throw CLI::ValidationError(no_ik      ? "--no-ik"
                               : ik_error ? "--ik-error"
                                          : "--detail-bands",
                               make ? "is for a cooked bank: give --cooked"
                                    : "is for a cooked bank: " + printable(bank) + " is packed");
  }

  void run(bool make) const {
    require_use_of_options(make);
    BankOptions options;
    options.form = cooked ? runtime::BankForm::Cooked : runtime::BankForm::Packed;
    options.tags = tags;
    options.learn = learn;
    options.cooking = {
        .apply_ik = !no_ik, .ik_error = ik_error, .detail_bands = detail_bands.value_or(0)};
    for (const std::string& text : texts) {
      const std::size_t at = text.find('=');
      options.texts.emplace_back(text.substr(0, at), text.substr(at + 1));
    }
    ClipCount count;
    std::vector<BankSource> sources = find_bank_sources(utf8_paths(inputs));
    const bool is_whole = (make ? make_bank : add_to_bank)(
        utf8_path(bank), std::move(sources), options,
        [&](const BankProgress& progress) { return count.done(progress); });
    tell_of(bank, is_whole, count);
  }
};

struct BankRemoval {
  std::string bank;
  std::vector<std::string> names;

  void run() const {
    ClipCount count;
    const bool is_whole = remove_from_bank(
        utf8_path(bank), names, [&](const BankProgress& progress) { return count.done(progress); });
    tell_of(bank, is_whole, count);
  }
};

Json to_json(const BankClip& clip, std::uint32_t skeleton) {
  return {{"name", clip.name},
          {"bytes", clip.bytes},
          {"motion_bytes", clip.motion_bytes > 0 ? Json(clip.motion_bytes) : Json()},
          {"sample_rate_hz", clip.sample_rate_hz},
          {"frames", clip.frames},
          {"joints", clip.joints},
          {"skeleton", skeleton},
          {"tags", clip.tags}};
}

/// Formats a hash as 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// Prints one JSON object for each clip: a single document would take 1.5 KB of memory per clip.
void print_json(const BankFile& bank, const std::string& path) {
  Json texts = Json::object();
  const SkeletonsInBank skeletons = bank.skeletons();
  Json of_bank = Json::array();
  for (const SkeletonInBank& skeleton : skeletons.all)
    of_bank.push_back({{"hash", skeleton.hash != 0 ? Json(hash_text(skeleton.hash)) : Json()},
                       {"joints", bank.describe(skeleton.clip).joints},
                       {"clips", skeleton.clips},
                       {"first_clip", bank.entry(skeleton.clip).name}});
  for (const auto& [key, value] : bank.texts()) texts[key] = value;
  std::uint32_t present = 0;
  const std::uint32_t tiers = mcpk_tiers(&bank.bank(), &present);
  const std::string around = dumped(Json{{"bank", path},
                                         {"form", name(bank.bank().form)},
                                         {"bytes", bank.bank().bytes},
                                         {"tiers", tiers},
                                         {"tiers_present", present},
                                         {"meta", texts},
                                         {"skeletons", of_bank},
                                         {"clips", Json::array()}},
                                    2);
  const std::size_t end_of_clips = around.rfind(']');
  std::cout << std::string_view(around).substr(0, end_of_clips);
  for (std::uint32_t clip = 0; clip < bank.clips(); ++clip) {
    std::istringstream lines(dumped(to_json(bank.describe(clip), skeletons.of_clip[clip]), 2));
    std::cout << (clip == 0 ? "" : ",");
    for (std::string line; std::getline(lines, line);) std::cout << "\n    " << line;
  }
  std::cout << (bank.clips() == 0 ? "" : "\n  ") << std::string_view(around).substr(end_of_clips)
            << '\n';
}

void list_bank(const std::string& path, bool json) {
  const BankFile bank(utf8_path(path));
  if (!json) {
    const SkeletonsInBank skeletons = bank.skeletons();
    for (const auto& [key, value] : bank.texts())
      std::printf("%s: %s\n", printable(key).c_str(), printable(value).c_str());
    for (std::uint32_t clip = 0; clip < bank.clips(); ++clip) {
      const BankClip described = bank.describe(clip);
      std::string tags;
      for (const std::string& tag : described.tags) tags += "  " + printable(tag);
      const std::string name = printable(described.name);
      const auto inner_bytes =  // UTF-8 continuation bytes, which take no column of their own
          std::ranges::count_if(name, [](char byte) { return (byte & 0xC0) == 0x80; });
      std::printf("%-*s %9llu bytes %7d frames at %s Hz, skeleton %u%s\n",
                  32 + static_cast<int>(inner_bytes), name.c_str(),
                  static_cast<unsigned long long>(described.bytes), described.frames,
                  significant_text(described.sample_rate_hz, 6).c_str(), skeletons.of_clip[clip],
                  tags.c_str());
    }
    for (std::size_t s = 0; s < skeletons.all.size(); ++s)
      std::printf("skeleton %zu: %s, %s, %s\n", s,
                  skeletons.all[s].hash != 0 ? hash_text(skeletons.all[s].hash).c_str()
                                             : "no engine plays it",
                  counted(bank.describe(skeletons.all[s].clip).joints, "joint").c_str(),
                  counted(skeletons.all[s].clips, "clip").c_str());
    std::uint32_t present = 0;
    const std::uint32_t tiers = mcpk_tiers(&bank.bank(), &present);
    if (tiers > 1) std::printf("tiers: %u of %u\n", present, tiers);
    return;
  }
  print_json(bank, path);
}

struct Extraction {
  std::string bank;
  std::vector<std::string> names;
  std::string folder = ".";
  bool overwrite = false;

  void run() const {
    ClipCount count;
    const BankFile file(utf8_path(bank));
    const std::vector<std::uint32_t> clips = asked(file);
    const std::vector<fs::path> places = places_of(file, clips);
    constexpr std::size_t kTogether = 256;  // number of files written to the disk together
    const auto existing = overwrite ? StagedFile::Existing::Replace : StagedFile::Existing::Refuse;
    std::vector<StagedFile> staged;
    std::size_t written = 0;
    const auto commit = [&] {
      StagedFile::commit_all(staged, existing);
      written += staged.size();
      staged.clear();
    };
    parallel_in_order(
        clips.size(), [&](std::size_t i) { return file.extract(file.entry(clips[i])); },
        [&](std::size_t i, const std::vector<std::byte>& bytes) {
          stage(utf8_path(folder) / places[i], bytes, staged);
          if (staged.size() == kTogether || i + 1 == clips.size()) commit();
          return count.done(written, clips.size());
        });
    count.end();
    if (written == clips.size()) return;
    std::fprintf(stderr,
                 "Stopped. %s are written, each whole. To write all, run the same command with "
                 "--overwrite.\n",
                 count.text().c_str());
    throw EndedWith{128 + stop_signal};
  }

 private:
  /// The requested clips, each once; all clips if none is named.
  std::vector<std::uint32_t> asked(const BankFile& file) const {
    std::vector<std::uint32_t> clips;
    for (const std::string& name : names) clips.push_back(file.find(name));
    for (std::uint32_t clip = 0; names.empty() && clip < file.clips(); ++clip)
      clips.push_back(clip);
    std::ranges::sort(clips);
    clips.erase(std::unique(clips.begin(), clips.end()), clips.end());
    return clips;
  }

  /// Output paths below the folder. Throws if a clip's name leads out of it, if two paths are
  /// equal, or if a file exists there and --overwrite is not given.
  std::vector<fs::path> places_of(const BankFile& file,
                                  const std::vector<std::uint32_t>& clips) const {
    std::vector<fs::path> places;
    std::unordered_set<std::string> taken;
    for (const std::uint32_t clip : clips) {
      const std::string name = file.entry(clip).name;
      const fs::path below = utf8_path(name + ".mcpr").lexically_normal();
      if (below.has_root_path() || *below.begin() == "..")
        throw InputError(bank, 0, 0, "the clip '" + name + "' leaves the folder");
      if (!taken.insert(name_key(utf8(below))).second)
        throw InputError(bank, 0, 0, "the clip '" + name + "' would take another's place");
      places.push_back(below);
      const fs::path place = utf8_path(folder) / below;
      refuse_source(place, {utf8_path(bank)});
      std::error_code error;  // is_there() misses a link whose target is gone
      if (!overwrite && (is_there(place) || fs::is_symlink(place, error)))
        throw WriteError(utf8(place) + " exists: not overwritten");
    }
    return places;
  }

  static void stage(const fs::path& place, const std::vector<std::byte>& bytes,
                    std::vector<StagedFile>& staged) {
    make_folders(place.parent_path());
    staged.emplace_back(place).write(bytes);
  }
};

void verify_bank(const std::string& path) {
  ClipCount count;
  const BankFile bank(utf8_path(path));
  std::uint32_t unplayed = 0;
  bool is_stopped = false;
  parallel_in_order(
      bank.clips(), [&](std::size_t clip) { return bank.play(static_cast<std::uint32_t>(clip)); },
      [&](std::size_t clip, bool is_played) {
        unplayed += is_played ? 0 : 1;
        is_stopped = !count.done(clip + 1, bank.clips());
        return !is_stopped;
      });
  count.end();
  if (is_stopped) {
    std::fprintf(stderr, "Stopped after %s.\n", count.text().c_str());
    throw EndedWith{128 + stop_signal};
  }
  std::fprintf(stderr, "%s: %s whole and playable\n", printable(path).c_str(),
               counted(bank.clips() - unplayed, "clip").c_str());
  if (unplayed > 0)
    std::fprintf(stderr, "%s whole, but in a coding that engines cannot play\n",
                 counted(unplayed, "clip").c_str());
}

void add_bank_argument(CLI::App& command, std::string& bank) {
  command.add_option("bank", bank, "A .mcpk file")->required()->type_name("BANK.mcpk");
}

}  // namespace

void add_bank(CLI::App& app) {
  CLI::App* command = app.add_subcommand("bank", "Keep many clips in one file");
  command->require_subcommand(1);
  CLI::App* make = command->add_subcommand("make", "Make a bank of .mcpr files");
  const auto making = std::make_shared<BankFilling>();
  making->add_options(*make);
  CLI::Option* const cooked =
      make->add_flag("--cooked", making->cooked,
                     "Make a cooked bank, which engines sample without unpacking, with IK "
                     "corrections applied; packed banks are smaller");
  make->add_flag("--learn", making->learn,
                 "Fit the statistics of the coder to these clips. This takes some seconds and "
                 "saves 1 to 2 % of the bytes of some hundred clips")
      ->excludes(cooked);
  make->callback([making] { making->run(true); });
  CLI::App* add = command->add_subcommand("add", "Add clips to a bank, or replace them by name");
  const auto adding = std::make_shared<BankFilling>();
  adding->add_options(*add);
  add->callback([adding] { adding->run(false); });

  CLI::App* remove = command->add_subcommand("remove", "Take clips out of a bank");
  const auto removal = std::make_shared<BankRemoval>();
  add_bank_argument(*remove, removal->bank);
  remove->add_option("name", removal->names, "Names of the clips")
      ->required()
      ->type_name("NAME...");
  remove->callback([removal] { removal->run(); });

  struct Stripping {
    std::string bank;
    std::string output;
    int tiers = 1;

    void run() const {
      ClipCount count;
      const bool is_whole =
          strip_bank(utf8_path(bank), utf8_path(output), tiers,
                     [&](const BankProgress& progress) { return count.done(progress); });
      tell_of(output, is_whole, count);
    }
  };
  CLI::App* strip = command->add_subcommand("strip", "Copy a bank without its finest tiers");
  const auto stripping = std::make_shared<Stripping>();
  add_bank_argument(*strip, stripping->bank);
  strip->add_option("-o,--output", stripping->output, "The bank to write")
      ->required()
      ->type_name("OUT.mcpk");
  strip->add_option("--tiers", stripping->tiers, "Tiers to keep: see compress --tiers")
      ->capture_default_str();
  strip->callback([stripping] { stripping->run(); });

  struct Listing {
    std::string bank;
    bool json = false;
  };
  CLI::App* list = command->add_subcommand("list", "List the clips of a bank");
  const auto listing = std::make_shared<Listing>();
  add_bank_argument(*list, listing->bank);
  list->add_flag("--json", listing->json, "Print one JSON object");
  list->callback([listing] { list_bank(listing->bank, listing->json); });

  CLI::App* extract =
      command->add_subcommand("extract", "Write clips of a packed bank as .mcpr files");
  const auto extraction = std::make_shared<Extraction>();
  add_bank_argument(*extract, extraction->bank);
  extract->add_option("name", extraction->names, "Names of the clips [all]")->type_name("NAME...");
  extract->add_option("-o,--output", extraction->folder, "Folder to write to [.]")
      ->type_name("DIR");
  extract->add_flag("--overwrite", extraction->overwrite, "Replace existing files");
  extract->callback([extraction] { extraction->run(); });

  CLI::App* verify =
      command->add_subcommand("verify", "Check every byte of a bank, and play each clip");
  const auto verified = std::make_shared<std::string>();
  add_bank_argument(*verify, *verified);
  verify->callback([verified] { verify_bank(*verified); });
}

}  // namespace mocapress::cli
