// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/clips.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/base/file.h"
#include "core/base/staged_file.h"
#include "core/batch/verification.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/format/container.h"
#include "core/codec/format/source_section.h"
#include "core/metrics/rate.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/skin_points.h"
#include "core/report/review_clip.h"
#include "core/report/review_page.h"

namespace mocapress {

namespace {

bool sameChannels(const Skeleton& a, const Skeleton& b) {
  return std::equal(a.joints().begin(), a.joints().end(), b.joints().begin(), b.joints().end(),
                    [](const Joint& x, const Joint& y) {
                      return x.name == y.name && x.parent == y.parent && x.channels == y.channels;
                    });
}

Tracks tracksOf(const Skeleton& skeleton, const Clip& clip) {
  return std::make_shared<const Eigen::MatrixXd>(landmark_tracks(skeleton, clip));
}

/// Fills in figures that follow from the bytes, or from their estimated number.
void completeSize(DecodedClip& decoded) {
  const std::size_t motion_bytes = decoded.compressed.motion_bytes();
  decoded.ratio = compression_ratio(decoded.clip, motion_bytes);
  decoded.bits_per_joint_sample =
      bits_per_joint_sample({decoded.compressed.skeleton, decoded.clip}, motion_bytes);
  if (decoded.compressed.likely_bytes) return;
  decoded.file = decoded.of_wavelets
                     ? write_container(decoded.compressed)
                     : write_compared(*find_comparison_method(decoded.method), decoded.compressed);
}

/// Fills in figures that follow from the compressed clip and its decoded motion.
void complete(DecodedClip& decoded) {
  completeSize(decoded);
  if (!decoded.tracks) decoded.tracks = tracksOf(decoded.compressed.skeleton, decoded.clip);
  if (decoded.compressed.correction) {
    decoded.uncorrected = std::make_shared<const Motion>(Motion{
        decoded.compressed.coded_skeleton(), decoded.correction
                                                 ? decoded.correction->uncorrected
                                                 : decode_uncorrected(decoded.compressed).clip});
    decoded.uncorrected_tracks = tracksOf(decoded.uncorrected->skeleton, decoded.uncorrected->clip);
  }
}

Visibility visibilityOf(const DecodedClip& decoded, const Encoder& encoder,
                        const std::vector<ContactSpan>& contacts, const SightLimits& limits) {
  const Skeleton& skeleton = encoder.motion().skeleton;
  return measure_visibility(skeleton, encoder.original_body(), body_tracks(skeleton, decoded.clip),
                            decoded.clip.sample_rate_hz, contacts, limits);
}

void findArtifacts(DecodedClip& decoded, const Encoder& encoder,
                   const std::vector<ContactSpan>& contacts, const SightLimits& limits) {
  const auto measure = [&](const Eigen::MatrixXd& tracks) {
    return measure_footskate(contacts, encoder.original_tracks(), tracks,
                             decoded.clip.sample_rate_hz);
  };
  if (!decoded.footskate) decoded.footskate = measure(*decoded.tracks);
  if (!decoded.visibility) decoded.visibility = visibilityOf(decoded, encoder, contacts, limits);
  decoded.glitches = find_glitches(encoder.original_tracks(), *decoded.tracks);
  if (decoded.uncorrected_tracks)
    decoded.uncorrected_footskate = measure(*decoded.uncorrected_tracks);
}

const std::vector<ContactSpan>& contactsOf(const Encoder& encoder, const EncodeSettings& options) {
  return options.contacts ? *options.contacts : encoder.contacts();
}

}  // namespace

Poses OriginalClip::poses() const {
  return [encoder = encoder](int frame, Pose& pose) {
    compute_pose(encoder->motion().skeleton, encoder->motion().clip.channels.row(frame), pose);
  };
}

Poses posesOf(const DecodedPtr& decoded) {
  return [decoded](int frame, Pose& pose) {
    compute_pose(decoded->compressed.skeleton, decoded->clip.channels.row(frame), pose);
  };
}

Poses posesOf(std::shared_ptr<const Motion> motion) {
  return [motion = std::move(motion)](int frame, Pose& pose) {
    compute_pose(motion->skeleton, motion->clip.channels.row(frame), pose);
  };
}

bool comparable(const Motion& original, const CompressedClip& compressed) {
  const double rate = original.clip.sample_rate_hz;
  return original.clip.frames() == compressed.frames &&
         std::abs(rate - compressed.sample_rate_hz) <= 1e-3 * rate &&
         sameChannels(original.skeleton, compressed.skeleton);
}

DecodedPtr decodedClip(Encoding encoding, const Encoder& encoder, const EncodeSettings& options) {
  DecodedClip decoded;
  decoded.method = wavelet_method_name(encoding.compressed);
  decoded.compressed = std::move(encoding.compressed);
  decoded.clip = std::move(encoding.decoded);
  if (encoding.tracks.size() > 0)
    decoded.tracks = std::make_shared<const Eigen::MatrixXd>(std::move(encoding.tracks));
  decoded.distortion = std::move(encoding.distortion);
  decoded.footskate = std::move(encoding.footskate);
  decoded.visibility = std::move(encoding.visibility);
  decoded.correction = std::move(encoding.correction);
  decoded.coefficient_ratio = encoding.coefficient_ratio;
  decoded.iterations = encoding.iterations;
  decoded.encode_seconds = encoding.seconds;
  decoded.complete = encoding.complete;
  decoded.effort = options.effort;
  complete(decoded);
  findArtifacts(decoded, encoder, contactsOf(encoder, options), options.limits);
  return std::make_shared<const DecodedClip>(std::move(decoded));
}

DecodedPtr decodedClip(OpenedMcpr opened, const OriginalClip* original, const SightLimits& limits,
                       const SourceFormat& source) {
  DecodedClip decoded;
  decoded.source = source;
  decoded.method = std::move(opened.method);
  decoded.of_wavelets = opened.of_wavelets;
  decoded.compressed = std::move(opened.compressed);
  decoded.clip = std::move(opened.decoded);
  complete(decoded);
  return original ? measured(decoded, *original, limits)
                  : std::make_shared<const DecodedClip>(std::move(decoded));
}

DecodedPtr judged(const DecodedClip& decoded, const Encoder& encoder,
                  const EncodeSettings& options) {
  DecodedClip result = decoded;
  result.visibility = visibilityOf(decoded, encoder, contactsOf(encoder, options), options.limits);
  return std::make_shared<const DecodedClip>(std::move(result));
}

DecodedPtr measured(const DecodedClip& decoded, const OriginalClip& original,
                    const SightLimits& limits) {
  DecodedClip result = decoded;
  result.footskate.reset();
  result.visibility.reset();
  result.distortion =
      measure(original.motion().skeleton, original.encoder->original_body(), result.clip);
  findArtifacts(result, *original.encoder, original.encoder->contacts(), limits);
  return std::make_shared<const DecodedClip>(std::move(result));
}

DecodedPtr measuredAgain(const DecodedClip& decoded, const OriginalClip& original) {
  DecodedClip result = decoded;
  result.distortion =
      measure(original.motion().skeleton, original.encoder->original_body(), result.clip);
  return std::make_shared<const DecodedClip>(std::move(result));
}

Warnings dress(Skeleton& skeleton, const PutCharacter& put, const Skin* own) {
  measure_on(own, skeleton);
  if (!put.character.skin) return {};
  const std::filesystem::path file = put.path.toStdU16String();
  try {
    Warnings warnings;
    put_character(file, put.character, skeleton, warnings);
    return warnings;
  } catch (const Error& error) {
    // The character does not fit: the clip keeps its own skin.
    return {{file.string(), 0, std::string("is not put on: ") + error.what()}};
  }
}

OriginalPtr dressed(const OriginalClip& original, const PutCharacter& character) {
  OriginalClip result = original;
  Motion motion = original.motion();
  result.of_character = dress(motion.skeleton, character, original.skin.get());
  result.character = character.path;
  result.has_character = character.character.skin != nullptr;
  result.encoder = std::make_shared<const Encoder>(std::move(motion));
  result.encoder->original_tracks();
  result.encoder->contacts();
  return std::make_shared<const OriginalClip>(std::move(result));
}

DecodedPtr coded(const DecodedClip& decoded) {
  DecodedClip result = decoded;
  code_motion(result.compressed);
  completeSize(result);
  return std::make_shared<const DecodedClip>(std::move(result));
}

std::vector<std::byte> savedFile(const DecodedClip& decoded, const OriginalClip* original,
                                 const CodedTracks& tracks) {
  if (decoded.compressed.likely_bytes) return savedFile(*coded(decoded), original, tracks);
  if (!original || !decoded.coefficient_ratio) return with_source(decoded.file, decoded.source);
  return with_coded_tracks(with_source(decoded.file, original->source), tracks);
}

void saveClip(const QString& path, const DecodedClip& decoded, const OriginalClip* original,
              const CodedTracks& tracks) {
  const bool was_encoded_here = decoded.coefficient_ratio.has_value();
  StagedFile file(std::filesystem::path(path.toStdU16String()));
  file.write(savedFile(decoded, original, tracks));
  if (original && was_encoded_here)
    verify(file.read_back(), *original->encoder);
  else
    read_mcpr(file.read_back());
  file.commit();
}

void saveReviewPage(const QString& path, const DecodedClip& decoded, const OriginalClip& original,
                    const CodedTracks& tracks, const SightLimits& limits,
                    const ReviewRemarks& remarks, const ReportLanguage& language) {
  const std::vector<std::byte> file = savedFile(decoded, &original, tracks);
  const Verification found = verify(file, *original.encoder, {.motion = true, .limits = limits});
  std::vector<std::string> facts =
      review_facts(decoded.method, decoded.ratio, found.distortion,
                   decoded.compressed.provenance.weighting, found.visibility, language);
  facts.insert(facts.end(), remarks.texts.begin(), remarks.texts.end());
  const std::string name = QFileInfo(original.path).fileName().toStdString();
  const std::string script =
      review_clip(name, *original.encoder, file, found.by == "runtime" ? nullptr : &found.decoded);
  write_text(path.toStdU16String(), review_page(name, facts, script, language, remarks.notes));
}

}  // namespace mocapress
