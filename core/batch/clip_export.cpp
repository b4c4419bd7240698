// SPDX-License-Identifier: MIT
#include "core/batch/clip_export.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/fnv1a.h"
#include "core/base/frame_text.h"
#include "core/base/make_folders.h"
#include "core/base/names_all.h"
#include "core/base/number_text.h"
#include "core/base/open_file.h"
#include "core/base/path_kind.h"
#include "core/base/staged_file.h"
#include "core/base/utf8_path.h"
#include "core/batch/verification.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/encode/track_encoder.h"
#include "core/codec/format/source_section.h"
#include "core/formats/amc.h"
#include "core/formats/asf.h"
#include "core/formats/bvh.h"
#include "core/formats/csv.h"
#include "core/formats/fbx/fbx_reader.h"
#include "core/formats/fbx/fbx_writer.h"
#include "core/formats/gltf_reader.h"
#include "core/formats/gltf_writer.h"
#include "core/mocapress/encode_settings.h"
#include "core/report/loaded_clip.h"
#include "core/report/review_clip.h"
#include "core/report/review_page.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// Thrown when the observer stops the export.
struct Stopped {};

using Bytes = std::vector<std::byte>;

Bytes bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

std::string hash_of_bytes(const Bytes& bytes) {
  Fnv1a hash;
  hash.add(bytes);
  return hash.text();
}

/// Estimates the progress of a clip. It is not known how long the search for a target takes: each
/// pass counts as a fifth of the rest.
double encoding_fraction(const EncodeProgress& progress) {
  double within = 0;
  if (progress.first_step > 1)
    within = 1 - std::log2(std::max(progress.step, 1)) / std::log2(progress.first_step);
  else if (progress.iteration > 0)
    within = 1 - std::pow(0.7, progress.iteration);
  return 0.1 + 0.75 * (1 - std::pow(0.8, progress.pass + within));
}

/// The names of an output's files in a format. An .amc has an .asf, too.
std::vector<std::string> file_names(const std::string& output, OutputFormat format) {
  std::vector<std::string> names = {output + '.' + std::string(name(format))};
  if (format == OutputFormat::Amc) names.insert(names.begin(), output + ".asf");
  return names;
}

/// Throws Error if a motion file, when read back, differs from the written motion by more than the
/// precision of its decimals.
void compare(const Motion& meant, const Motion& found, const std::vector<std::string>& names,
             const std::string& file) {
  constexpr double kMost = 0.02;  // cm
  if (meant.clip.frames() != found.clip.frames())
    throw Error(file + ": reads back with another number of frames");
  const Eigen::MatrixXd tracks = landmark_tracks(meant.skeleton, meant.clip);
  const Eigen::MatrixXd found_tracks = landmark_tracks(found.skeleton, found.clip);
  for (int joint = 0; joint < meant.skeleton.joint_count(); ++joint) {
    const int same = found.skeleton.find(names[joint]);
    if (same < 0) throw Error(file + ": reads back without " + names[joint]);
    const double off = (tracks.middleCols<3>(3 * joint) - found_tracks.middleCols<3>(3 * same))
                           .rowwise()
                           .norm()
                           .maxCoeff();
    if (!(off <= kMost))
      throw Error(file + ": reads back " + fixed_text(off, 6) + " cm off at " + names[joint]);
  }
}

/// The export of one clip.
class Export {
 public:
  Export(const Batch& batch, std::size_t index, const fs::path& folder, const ExportRights& rights,
         SharedCharacters& characters, const Observer<ClipProgress>& observer)
      : batch_(batch),
        item_(batch.items[index]),
        preset_(batch.presets[item_.preset]),
        folder_(folder),
        rights_(rights),
        characters_(characters),
        observer_(observer),
        row_(failed_row(batch, index, "")) {}

  /// Returns an earlier export's row with visibility judged by the limits of the batch.
  BatchRow judged_again(const BatchRow& earlier) {
    const LoadedClip clip(read());
    const Bytes bytes = read_bytes(folder_ / utf8_path(item_.output + ".mcpr"));
    const EncodeSettings options = options_for(clip.motion());
    const Verification found = mocapress::verify(
        bytes, clip.encoder().wavelets(),
        {.contacts = options.contacts.value_or(clip.contacts()), .limits = preset_.limits});
    BatchRow row = earlier;
    row.preset = preset_;
    row.measured->seen = seen_in(found.visibility, clip.motion().skeleton);
    row.sights = sight_chart(found.visibility.table, clip.motion().skeleton);
    return row;
  }

  std::optional<BatchRow> run() {
    try {
      if (!item_.problem.empty()) throw Error(item_.problem);
      check(preset_);
      report(ClipProgress::Stage::Reading, 0);
      look_at_places();
      row_.stamp = stamp(item_, row_.reading);
      work();
    } catch (const Stopped&) {
      return std::nullopt;
    } catch (const std::bad_alloc&) {
      row_.error = "takes more memory than this machine has to give";
      row_.files.clear();
    } catch (const std::exception& error) {
      row_.error = error.what();
      row_.files.clear();
    }
    return std::move(row_);
  }

 private:
  void report(ClipProgress::Stage stage, double fraction) const {
    if (!should_continue(observer_, ClipProgress{stage, fraction})) throw Stopped{};
  }

  /// Throws, before any work, if a file is in place that must not be replaced, or that a clip of
  /// the batch is read from.
  void look_at_places() const {
    for (const OutputFormat format : batch_.formats)
      for (const std::string& name : file_names(item_.output, format)) {
        const fs::path place = folder_ / utf8_path(name);
        if (!is_there(place)) continue;
        const std::optional<FileIdentity> there = identity_of(place);
        if (there && rights_.sources && rights_.sources->contains(*there))
          throw Error(utf8(place) + " is a file that clips of this batch are made from");
        if (!rights_.resumed && !may_replace(name)) refuse(place);
      }
  }

  [[noreturn]] static void refuse(const fs::path& place) {
    throw Error(utf8(place) + " exists and is not this batch's: not overwritten");
  }

  bool may_replace(const std::string& name) const {
    if (rights_.overwrite) return true;
    if (!rights_.earlier) return false;
    const auto& files = rights_.earlier->files;
    const auto own =
        std::ranges::find_if(files, [&](const WrittenFile& file) { return file.name == name; });
    return own != files.end() && hash_of(folder_ / utf8_path(name)) == own->hash;
  }

  MotionFile read() const {
    std::optional<fs::path> skeleton;
    if (!item_.skeleton.empty()) skeleton = utf8_path(item_.skeleton);
    return read_motion_of_many(utf8_path(item_.input), skeleton, batch_.reading_of(item_),
                               [&](const fs::path& file) { return characters_.read(file); });
  }

  void work() {
    const LoadedClip clip(read());
    for (const Warning& warning : clip.warnings()) row_.warnings.push_back(warning.text());
    row_.joints = clip.motion().skeleton.joint_count();
    report(ClipProgress::Stage::Encoding, 0.1);
    const EncodeSettings options = options_for(clip.motion());
    Encoding made = clip.encoder().compress(
        *find_compression_method(preset_.method), options, [&](const EncodeProgress& progress) {
          return should_continue(
              observer_, ClipProgress{ClipProgress::Stage::Encoding, encoding_fraction(progress)});
        });
    if (!made.complete) throw Stopped{};
    made.file =
        with_tracks(with_source(made.file, clip.source()), clip.tracks(), preset_.track_error);
    report(ClipProgress::Stage::Verifying, 0.85);
    // The .mcpr is measured even if it is not among the formats.
    StagedFile mcpr = staged(item_.output + ".mcpr", made.file);
    verify(clip, mcpr.read_back(), options.contacts.value_or(clip.contacts()), made);
    std::vector<StagedFile> files;
    const std::vector<OutputFormat>& formats = batch_.formats;
    if (std::ranges::find(formats, OutputFormat::Mcpr) != formats.end()) {
      row_.files.push_back({item_.output + ".mcpr", made.file.size(), hash_of_bytes(made.file)});
      files.push_back(std::move(mcpr));
    }
    for (const OutputFormat format : formats)
      if (format == OutputFormat::Review)
        stage_file(kReviewExtension, bytes_of(review_of(clip, made)), files);
      else if (format != OutputFormat::Mcpr)
        stage(format, {clip.motion().skeleton, made.decoded}, tracks_of(made.file), clip.source(),
              files);
    report(ClipProgress::Stage::Verifying, 0.95);
    put_in_place(files);
  }

  std::string review_of(const LoadedClip& clip, const Encoding& made) const {
    const Clip* const unplayed = row_.verified_by == "runtime" ? nullptr : &made.decoded;
    return review_clip(item_.output, clip.encoder().wavelets(), made.file, unplayed,
                       [&](const EncodeProgress&) {
                         report(ClipProgress::Stage::Verifying, 0.9);
                         return true;
                       });
  }

  EncodeSettings options_for(const Motion& motion) const {
    EncodeSettings options = encode_settings(preset_, motion.skeleton);
    options.figures_only = true;  // the written file is measured instead
    for (const ContactSpan& span : options.contacts.value_or(std::vector<ContactSpan>()))
      if (span.last_frame >= motion.clip.frames())
        throw Error("the preset has a contact up to frame " + frame_text(span.last_frame) +
                    ", but the clip ends before");
    return options;
  }

  /// Measures the file as it was read back from the disk. Keeps the decoded motion if a format
  /// needs it.
  void verify(const LoadedClip& clip, const Bytes& bytes, const std::vector<ContactSpan>& contacts,
              Encoding& made) {
    const bool asks_for_motion = std::ranges::any_of(
        batch_.formats, [](OutputFormat format) { return format != OutputFormat::Mcpr; });
    Verification found = mocapress::verify(
        bytes, clip.encoder().wavelets(),
        {.contacts = contacts, .motion = asks_for_motion, .limits = preset_.limits});
    row_.verified_by = found.by;
    made.distortion = std::move(found.distortion);
    made.footskate = std::move(found.footskate);
    made.visibility = std::move(found.visibility);
    made.decoded = std::move(found.decoded);
    row_.measured = clip.measure(made, contacts.size());
    row_.worst = std::move(found.worst);
    row_.sights = sight_chart(made.visibility.table, clip.motion().skeleton);
    if (!keeps_promise(preset_, *row_.measured))
      throw Error("verification: " + target_text(preset_.target) +
                  " was asked for, but it came to " + came_to());
    if (!is_error(preset_.target)) return;
    const auto broken = broken_promises(preset_.promises, clip.motion(), made.distortion);
    if (!broken.empty()) throw Error("verification: " + broken.front().text);
  }

  std::string came_to() const {
    Target found = preset_.target;
    found.value = row_.measured->quantity(found.kind, preset_.weighting);
    return target_text(found);
  }

  void stage(OutputFormat format, const Motion& motion, const ScalarTracks& tracks,
             const SourceFormat& source, std::vector<StagedFile>& files) {
    const WriteOptions& writing = batch_.writing;
    const Motion exported = exported_motion(motion, source, writing);
    ReadOptions as_written{.sample_rate_hz = exported.clip.sample_rate_hz,
                           .up = writing.up.value_or(source.up)};
    switch (format) {
      case OutputFormat::Mcpr:
      case OutputFormat::Review:
        return;  // staged by work()
      case OutputFormat::Csv:
        return stage_file(".csv", bytes_of(csv_text(exported, tracks)), files);
      case OutputFormat::Bvh: {
        const BvhStyle style = bvh_style(source, writing);
        const std::string text = bvh_text(exported, style);
        stage_file(".bvh", bytes_of(text), files);
        as_written.cm_per_unit = style.cm_per_unit;
        as_written.bvh_root = style.root;
        compare(motion, read_bvh(item_.output + ".bvh", text, as_written).motion,
                bvh_names(motion.skeleton), item_.output + ".bvh");
        return;
      }
      case OutputFormat::Glb: {
        const std::string glb = gltf_bytes(motion, GltfContainer::Glb, source, writing, tracks);
        stage_file(".glb", bytes_of(glb), files);
        const SourceFormat as = gltf_format(source, writing);
        as_written.cm_per_unit = as.cm_per_unit;
        as_written.up = as.up;
        compare(motion, read_gltf(item_.output + ".glb", glb, as_written).motion,
                without_namespace(gltf_names(motion.skeleton)), item_.output + ".glb");
        return;
      }
      case OutputFormat::Fbx: {
        const std::string fbx = fbx_bytes(motion, source, writing, tracks);
        stage_file(".fbx", bytes_of(fbx), files);
        const SourceFormat as = fbx_format(source, writing);
        as_written.cm_per_unit = as.cm_per_unit;
        as_written.up = as.up;
        compare(motion, read_fbx(item_.output + ".fbx", fbx, as_written).motion,
                without_namespace(fbx_names(motion.skeleton)), item_.output + ".fbx");
        return;
      }
      case OutputFormat::Amc: {
        const Motion acclaim = acclaim_motion(exported);
        const double cm_per_unit = asf_cm_per_unit(source, writing);
        const std::string asf = asf_text(acclaim.skeleton, cm_per_unit);
        const std::string amc = amc_text(acclaim, cm_per_unit);
        stage_file(".asf", bytes_of(asf), files);
        stage_file(".amc", bytes_of(amc), files);
        const AsfSkeleton skeleton = read_asf(item_.output + ".asf", asf);
        compare(motion, read_amc(item_.output + ".amc", amc, skeleton, as_written).motion,
                asf_names(motion.skeleton), item_.output + ".amc");
        return;
      }
    }
  }

  /// Writes a file that commit() will put in place. Makes its folders.
  StagedFile staged(const std::string& name, const Bytes& bytes) const {
    const fs::path path = folder_ / utf8_path(name);
    make_folders(path.parent_path());
    StagedFile file(path);
    file.write(bytes);
    return file;
  }

  /// Writes a file, reads it back and compares the bytes. It is put in place later.
  void stage_file(const char* extension, const Bytes& bytes, std::vector<StagedFile>& files) {
    const std::string name = item_.output + extension;
    files.push_back(staged(name, bytes));
    if (files.back().read_back() != bytes)
      throw Error("verification: " + name + " does not read back as it was written");
    row_.files.push_back({name, bytes.size(), hash_of_bytes(bytes)});
  }

  void put_in_place(std::vector<StagedFile>& files) {
    using Existing = StagedFile::Existing;
    std::vector<Existing> existing;
    for (std::size_t i = 0; i < files.size(); ++i) {
      const bool replaces = is_there(files[i].path());
      const bool same =
          replaces && rights_.resumed && hash_of(files[i].path()) == row_.files[i].hash;
      if (replaces && !same && !may_replace(row_.files[i].name)) refuse(files[i].path());
      existing.push_back(replaces ? Existing::Replace : Existing::Refuse);
    }
    for (std::size_t i = 0; i < files.size(); ++i) files[i].commit(existing[i]);
  }

  const Batch& batch_;
  const BatchItem item_;
  const Settings& preset_;
  const fs::path& folder_;
  const ExportRights& rights_;
  SharedCharacters& characters_;
  const Observer<ClipProgress>& observer_;
  BatchRow row_;
};

}  // namespace

std::string_view name(ClipProgress::Stage stage) {
  constexpr std::string_view kNames[] = {"reading", "encoding", "verifying"};
  static_assert(names_all<ClipProgress::Stage>(kNames));
  return kNames[static_cast<std::size_t>(stage)];
}

bool still_done(const BatchRow& row, const Batch& batch, const BatchItem& item,
                const fs::path& folder) {
  Settings wanted = batch.presets[item.preset];
  if (wanted.target.kind != Target::Kind::Visibility) wanted.limits = row.preset.limits;
  if (!row.done() || !item.problem.empty() || row.input != item.input || row.preset != wanted ||
      row.formats != batch.formats || row.reading != batch.reading_of(item) ||
      row.writing != batch.writing)
    return false;
  try {
    for (const WrittenFile& file : row.files) {
      const fs::path path = folder / utf8_path(file.name);
      const std::optional<FileStatus> found = status_of(path);
      if (!found || found->size != file.bytes || hash_of(path) != file.hash) return false;
    }
  } catch (const InputError&) {
    return false;
  }
  return unchanged(item, row.reading, row.stamp);
}

std::set<FileIdentity> source_files(const Batch& batch) {
  std::set<FileIdentity> found;
  for (const BatchItem item : batch.items) {
    std::optional<fs::path> skeleton;
    if (!item.skeleton.empty()) skeleton = utf8_path(item.skeleton);
    const auto add = [&](const fs::path& file) {
      if (const auto identity = identity_of(file)) found.insert(*identity);
    };
    try {
      add(utf8_path(item.input));
      for (const fs::path& file :
           files_of_motion(utf8_path(item.input), skeleton, batch.reading_of(item)))
        add(file);
    } catch (const InputError&) {  // becomes the clip's error in its row later
    }
  }
  return found;
}

BatchRow failed_row(const Batch& batch, std::size_t index, const std::string& why) {
  const BatchItem item = batch.items[index];
  BatchRow row;
  row.index = index;
  row.input = item.input;
  row.output = item.output;
  row.review = item.review;
  row.preset = batch.presets[item.preset];
  row.formats = batch.formats;
  row.reading = batch.reading_of(item);
  row.writing = batch.writing;
  row.error = why;
  return row;
}

std::optional<BatchRow> judged_again(const BatchRow& row, const Batch& batch, std::size_t index,
                                     const fs::path& folder, SharedCharacters& characters) {
  if (std::ranges::find(row.formats, OutputFormat::Mcpr) == row.formats.end() || !row.measured)
    return std::nullopt;
  try {
    return Export(batch, index, folder, {}, characters, {}).judged_again(row);
  } catch (const std::exception&) {
    return std::nullopt;  // the clip is exported again, and its row tells what failed
  }
}

std::optional<BatchRow> export_clip(const Batch& batch, std::size_t index, const fs::path& folder,
                                    const ExportRights& rights, SharedCharacters& characters,
                                    const Observer<ClipProgress>& observer) {
  return Export(batch, index, folder, rights, characters, observer).run();
}

}  // namespace mocapress
