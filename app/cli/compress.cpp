// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/contacts.h"
#include "app/cli/motion_input.h"
#include "app/cli/option_words.h"
#include "app/cli/output_place.h"
#include "app/cli/preset_arguments.h"
#include "app/cli/report.h"
#include "app/cli/standard_streams.h"
#include "core/base/file.h"
#include "core/base/file_identity.h"
#include "core/base/frame_text.h"
#include "core/base/number_text.h"
#include "core/base/staged_file.h"
#include "core/base/utf8_path.h"
#include "core/batch/verification.h"
#include "core/codec/encode/track_encoder.h"
#include "core/codec/format/source_section.h"
#include "core/codec/format/tiers.h"
#include "core/codec/methods/additive_encoder.h"
#include "core/codec/methods/comparison_method.h"
#include "core/codec/methods/compression_method.h"
#include "core/formats/text_cursor.h"
#include "core/metrics/rate.h"
#include "core/mocapress/encode_settings.h"
#include "core/report/review_clip.h"
#include "core/report/review_page.h"

namespace mocapress::cli {
namespace {

/// Turns an Error thrown by `check` into a usage error.
void or_usage_error(const std::function<void()>& check) {
  try {
    check();
  } catch (const Error& error) {
    throw CLI::ValidationError(error.what());
  }
}

/// The error of the clip when only the first `tiers` tiers of its file are read.
TierError tier_error(const Encoder& original, std::span<const std::byte> file, int tiers,
                     Weighting weighting) {
  const Distortion found = verify(file, original, {.tiers = tiers}).distortion;
  return {static_cast<float>(found.eps(weighting)), static_cast<float>(found.max.cm)};
}

struct Compress {
  std::string input;
  std::string input_format;  // format of standard input
  MotionInput source;
  std::string output;
  std::string review;  // path of the review page
  PresetArguments preset;
  ContactInput contacts;
  std::vector<ImportantRange> ranges;
  std::optional<double> track_error;
  int tiers = 1;
  std::optional<std::string> additive;  // file of the base
  std::optional<int> base_frame;
  bool json = false;

  /// The settings from the command line, before they are fitted to the clip.
  Settings asked() const {
    Settings asked = preset.read();
    if (!ranges.empty()) asked.ranges = ranges;
    if (track_error) asked.track_error = *track_error;
    or_usage_error([&] { check(asked); });
    return asked;
  }

  /// The settings for this clip. Throws CLI::ValidationError if they do not fit it.
  EncodeSettings asked_of(const Settings& asked, const Motion& motion) const {
    preset.importance.require_names_of(motion.skeleton);
    EncodeSettings options;
    or_usage_error([&] {
      options = encode_settings(asked, motion.skeleton);
      frame_factors(options.ranges, motion.clip.frames());
    });
    if (preset.effort) options.effort = *preset.effort;
    options.figures_only = true;
    if (!options.contacts || contacts.is_given()) options.contacts = contacts.spans(motion);
    return options;
  }

  bool reads_stream() const { return input == kStandardStream; }
  bool writes_stream() const { return output == kStandardStream; }

  /// Throws CLI::ValidationError.
  void check_streams() const {
    if (reads_stream() && input_format.empty())
      throw CLI::ValidationError("standard input needs --format, as --format bvh");
    if (!reads_stream() && !input_format.empty())
      throw CLI::ValidationError("--format", "is of standard input: a file's extension says it");
    if (input_format == "amc" && !source.skeleton)
      throw CLI::ValidationError("an .amc from standard input needs --skeleton");
    if (writes_stream() && json)
      throw CLI::ValidationError("--json", "would mix with the clip on standard output");
    if (!review.empty() && !has_review_viewer())
      throw CLI::ValidationError("--review", kNoReviewViewer);
    if (!output.empty() && !writes_stream() &&
        !equals_ignoring_case(utf8(utf8_path(output).extension()), ".mcpr"))
      throw CLI::ValidationError(
          output + ": compress writes .mcpr files alone; decompress writes motion files");
  }

  /// Reads the motion from standard input. Readers go by the extension of an invented file name,
  /// which error messages leave out.
  MotionFile read_stream() const {
    const std::string named = "standard input." + input_format;
    try {
      return read_motion_bytes(named, read_standard_input(), utf8_path_if(source.skeleton),
                               source.options);
    } catch (const InputError& error) {
      const std::string text = error.what();
      if (!text.starts_with(named)) throw;
      throw InputError("standard input", error.line(), error.column(),
                       text.substr(text.find(": ", named.size()) + 2));
    }
  }

  MotionFile read_source() const {
    const bool writes_file = !output.empty() && !writes_stream();
    std::vector<std::filesystem::path> sources;
    if (!reads_stream()) sources = source.files(input);
    if (!review.empty()) require_place(utf8_path(review), sources);
    if (writes_file) require_place(utf8_path(output), sources);
    if (writes_file && additive) refuse_source(utf8_path(output), source.files(*additive));
    if (!reads_stream()) return source.read_file(input);
    MotionFile file = read_stream();
    for (Warning& warning : file.warnings) warning.file = "standard input";
    print_warnings(file.warnings);
    return file;
  }

  void run() {
    check_streams();
    check_additive();
    const Settings asked = this->asked();
    const bool of_wavelets = find_comparison_method(asked.method) == nullptr;
    MotionFile file = read_source();
    if (additive) return run_additive(std::move(file), asked);
    const MethodEncoder encoder(std::move(file.motion));
    const EncodeSettings options = asked_of(asked, encoder.wavelets().motion());
    if (tiers > 1 && (!of_wavelets || effective_coding(options) != Coding::Adaptive))
      throw CLI::ValidationError("--tiers", "needs the adaptive coding, as the closed loop has it");
    Encoding made = encoder.compress(*find_compression_method(asked.method), options);
    made.file = with_tracks(with_source(made.file, file.source), file.tracks, asked.track_error);
    made.file = with_tiers(made.file, tiers, [&](std::span<const std::byte> mcpr, int first) {
      return tier_error(encoder.wavelets(), mcpr, first, options.weighting);
    });
    Verification found =
        write(made.file, encoder.wavelets(),
              {.contacts = *options.contacts, .motion = !review.empty(), .limits = options.limits});
    made.decoded = std::move(found.decoded);
    const Report report{
        .input = input,
        .original = &encoder.wavelets().motion(),
        .loop = options.loop.value_or(find_loop(encoder.wavelets().motion())),
        .method = asked.method,
        .weighting = options.weighting,
        .coding = of_wavelets ? std::optional(options.coding) : std::nullopt,
        .motion_bytes = made.compressed.motion_bytes(),
        .file_bytes = made.file.size(),
        .verified_by = std::string(found.by),
        .distortion = std::move(found.distortion),
        .footskate = std::move(found.footskate),
        .visibility = std::move(found.visibility),
        .contacts = options.contacts->size(),
        .correction_bytes = made.correction ? std::optional(made.correction->bytes) : std::nullopt,
        .correction = std::move(made.correction),
        .coefficient_ratio = made.coefficient_ratio,
        .iterations = made.iterations,
        .encode_seconds = made.seconds,
        .tracks = track_figures(file.tracks, made.file)};
    if (!review.empty()) write_review(report, encoder, made);
    json ? print(to_json(report)) : print(report);
  }

  /// Throws CLI::ValidationError.
  void check_additive() const {
    if (base_frame && !additive) throw CLI::ValidationError("--base-frame", "is of --additive");
    if (!additive) return;
    if (tiers > 1) throw CLI::ValidationError("--additive", "takes no --tiers");
    if (!review.empty()) throw CLI::ValidationError("--additive", "takes no --review");
  }

  /// The base: a whole clip, or one pose of it.
  Motion read_base() const {
    Motion base = source.read(*additive);
    if (!base_frame) return base;
    if (*base_frame > base.clip.frames())
      throw InputError(*additive, 0, 0, "has no frame " + frame_text(*base_frame - 1));
    return frames_of(base, *base_frame - 1, 1);
  }

  /// Compresses the clip as an additive one: only what it adds to the base.
  void run_additive(MotionFile file, const Settings& asked) const {
    EncodeSettings options = asked_of(asked, file.motion);
    const std::vector<ContactSpan> spans = *std::exchange(options.contacts, std::nullopt);
    const AdditiveEncoder encoder(file.motion, read_base());
    Encoding made = encoder.compress(*find_compression_method(asked.method), options, spans);
    made.file = with_tracks(with_source(made.file, file.source), file.tracks, asked.track_error);
    Comparison found;
    write(made.file, [&](std::span<const std::byte> mcpr) {
      found = encoder.measure(mcpr, spans, options.limits);
    });
    const Report report{.input = input,
                        .original = &file.motion,
                        .loop = made.compressed.loop,
                        .method = asked.method,
                        .weighting = options.weighting,
                        .coding = Coding::Adaptive,
                        .motion_bytes = made.compressed.motion_bytes(),
                        .file_bytes = made.file.size(),
                        .verified_by = "runtime",
                        .distortion = std::move(found.distortion),
                        .footskate = std::move(found.footskate),
                        .visibility = std::move(found.visibility),
                        .contacts = spans.size(),
                        .correction_bytes = {},
                        .correction = {},
                        .coefficient_ratio = made.coefficient_ratio,
                        .iterations = made.iterations,
                        .encode_seconds = made.seconds,
                        .tracks = track_figures(file.tracks, made.file)};
    json ? print(to_json(report)) : print(report);
  }

  void write_review(const Report& report, const MethodEncoder& encoder,
                    const Encoding& made) const {
    const Clip& original = encoder.wavelets().motion().clip;
    const std::vector<std::string> facts =
        review_facts(report.method, compression_ratio(original, report.motion_bytes),
                     report.distortion, report.weighting, report.visibility);
    const std::string title = reads_stream() ? "standard input" : utf8(utf8_path(input).filename());
    const Clip* const unplayed = report.verified_by == "runtime" ? nullptr : &made.decoded;
    const std::string script = review_clip(title, encoder.wavelets(), made.file, unplayed);
    write_text(utf8_path(review), review_page(title, facts, script));
  }

  Verification write(const std::vector<std::byte>& file, const Encoder& original,
                     const VerificationRequest& request) const {
    Verification found;
    write(file, [&](std::span<const std::byte> mcpr) { found = verify(mcpr, original, request); });
    return found;
  }

  /// Writes the file and measures it as read back from the disk, before it replaces an older one.
  void write(const std::vector<std::byte>& file,
             const std::function<void(std::span<const std::byte> mcpr)>& measure) const {
    if (output.empty() || writes_stream()) {
      measure(file);
      if (writes_stream())
        write_standard_output({reinterpret_cast<const char*>(file.data()), file.size()});
      return;
    }
    StagedFile staged(utf8_path(output));
    staged.write(file);
    measure(staged.read_back());
    staged.commit();
  }
};

}  // namespace

void add_compress(CLI::App& app) {
  CLI::App* command = app.add_subcommand("compress", "Compress a clip and measure its errors");
  const auto call = std::make_shared<Compress>();
  command
      ->add_option("input", call->input,
                   "Clip to compress (.bvh, .amc, .fbx, .gltf or .glb), or - for standard input")
      ->required()
      ->type_name("INPUT");
  command->add_option("--format", call->input_format, "Format of a clip on standard input")
      ->check(CLI::IsMember({"bvh", "amc", "fbx", "gltf", "glb"}));
  call->source.add_options(*command);
  call->source.add_character_option(*command);
  call->source.add_tracks_option(*command);
  command
      ->add_option("-o,--output", call->output,
                   "File to write, or - for standard output; without -o the clip is only measured")
      ->type_name("OUT.mcpr");
  call->preset.add_options(*command, true);
  call->contacts.add_options(*command);
  add_range_option(*command, call->ranges);
  command->add_option("--track-error", call->track_error,
                      "Largest error allowed for values of morph weights, properties and scales [" +
                          shortest_text(kUsualTrackError) + "]");
  command
      ->add_option("--review", call->review,
                   "Also write a web page that shows original and compressed motion")
      ->type_name("PAGE.html");
  command
      ->add_option("--tiers", call->tiers,
                   "Parts of the file, coarse to fine: its first parts alone can be played")
      ->check(CLI::Range(1, runtime::kMostTiers))
      ->capture_default_str();
  command
      ->add_option(
          "--additive", call->additive,
          "Compress what the clip adds to this base: one pose, or a clip of as many frames. "
          "Errors are those of base plus difference")
      ->type_name("BASE");
  command->add_option("--base-frame", call->base_frame, "Frame of BASE that is the pose, from 1")
      ->check(number_above_0());
  command->add_flag("--json", call->json, "Print one JSON object");
  command->callback([call] { call->run(); });
}

}  // namespace mocapress::cli
