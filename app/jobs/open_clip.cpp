// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/open_clip.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/jobs/clip_sources.h"
#include "core/codec/format/source_section.h"
#include "core/codec/methods/compression_method.h"
#include "core/formats/motion_file.h"
#include "core/study/row.h"

namespace mocapress {
namespace {

std::filesystem::path toPath(const QString& path) {
  return path.toStdU16String();
}

OpenedClip openCompressed(OpenRequest& request) {
  OpenedMcpr opened = open_mcpr(toPath(request.path));
  const bool together =
      request.original && comparable(request.original->motion(), opened.compressed);
  const OriginalPtr original = together ? request.original : nullptr;
  if (!original) readCharacterOn(request.characters, opened.compressed.skeleton);
  return {original, decodedClip(std::move(opened), original.get(), request.limits,
                                load_source(toPath(request.path)))};
}

OriginalPtr readOriginal(OpenRequest& request) {
  const ReadOptions reading = request.reading.value_or(ReadOptions());
  const bool is_open = request.original && request.original->path == request.path;
  const SourceNow now =
      lookAt({request.path, request.skeleton, is_open ? request.original->stamp : InputStamp()});
  if (is_open && request.original->reading == reading &&
      request.original->stamp.hash == now.stamp.hash) {
    const PutCharacter put =
        readCharacterOn(request.characters, request.original->motion().skeleton);
    return request.original->wears(put) ? request.original : dressed(*request.original, put);
  }
  std::optional<std::filesystem::path> skeleton;
  if (!request.skeleton.isEmpty()) skeleton = toPath(request.skeleton);
  MotionFile file = read_motion(toPath(request.path), skeleton, reading);

  OriginalClip original;
  original.path = request.path;
  original.skeleton = request.skeleton;
  original.reading = reading;
  original.stamp = now.stamp;
  original.source = file.source;
  original.states_rate = file.states_rate;
  original.warnings = std::move(file.warnings);
  original.skin = std::move(file.skin);
  original.takes = std::move(file.takes);
  original.reading.take = takeAmong(original.takes);
  original.scalars = std::move(file.tracks);
  // The outline is made here, off the GUI thread, before it is first shown.
  original.outline = outlineOf(file.motion, original.skin.get());
  const PutCharacter put = readCharacterOn(request.characters, file.motion.skeleton);
  original.character = put.path;
  original.has_character = put.character.skin != nullptr;
  original.of_character = dress(file.motion.skeleton, put, original.skin.get());
  original.encoder = std::make_shared<const Encoder>(std::move(file.motion));
  original.encoder->original_tracks();
  original.encoder->contacts();
  return std::make_shared<const OriginalClip>(std::move(original));
}

OpenedClip openOriginal(OpenRequest& request) {
  const OriginalPtr original = readOriginal(request);
  const bool together =
      request.decoded && comparable(original->motion(), request.decoded->compressed);
  if (request.compare && !together)
    throw Error(QCoreApplication::translate("mocapress::OpenClip",
                                            "%1 is not the original of the compressed clip: "
                                            "joints, frames or sample rate differ.")
                    .arg(request.path)
                    .toStdString());
  return {original, together ? measured(*request.decoded, *original, request.limits) : nullptr};
}

/// Compresses the clip by a comparison method and opens the result.
OpenedClip openCompared(OpenRequest& request, const Job& job) {
  const OriginalPtr original = readOriginal(request);
  const CompressionMethod* compression_method = find_compression_method(request.comparison);
  if (!compression_method) throw Error("there is no method \"" + request.comparison + "\"");
  const Encoding made =
      MethodEncoder(original->motion())
          .compress(*compression_method, request.options.value_or(EncodeSettings()),
                    [&](const EncodeProgress&) { return !job.stopRequested(); });
  return {original, decodedClip(read_mcpr(made.file), original.get(), request.limits)};
}

/// The studio has no target for coefficient ratios, so the achieved file ratio replaces it.
Target targetOf(const StudyRow& row) {
  if (row.settings.target.kind != Target::Kind::CoefficientRatio || !row.measured)
    return row.settings.target;
  return {Target::Kind::Ratio, row.measured->ratio};
}

}  // namespace

bool isCompressedFile(const QString& path) {
  return path.endsWith(QStringLiteral(".mcpr"), Qt::CaseInsensitive);
}

OpenRequest requestOf(const StudyRow& row) {
  OpenRequest request;
  request.path = QFileInfo(QString::fromStdString(row.clip)).absoluteFilePath();
  EncodeSettings options{
      .weighting = row.settings.weighting, .target = targetOf(row), .seed = row.settings.seed};
  if (const auto coding = coding_of(row.settings)) options.coding = *coding;
  if (row.ik_ratio()) options.correction = EncodeCorrection{.ratio = row.ik_ratio()};
  const CompressionMethod* compression_method = find_compression_method(row.settings.method);
  if (!compression_method || !choose_wavelets(*compression_method, options))
    request.comparison = row.settings.method;
  request.options = options;
  return request;
}

OpenedClip openClip(const OpenRequest& request, const Job& job) {
  OpenRequest with_character = request;
  OpenedClip opened = !request.comparison.empty()      ? openCompared(with_character, job)
                      : isCompressedFile(request.path) ? openCompressed(with_character)
                                                       : openOriginal(with_character);
  opened.characters = std::move(with_character.characters);
  return opened;
}

}  // namespace mocapress
