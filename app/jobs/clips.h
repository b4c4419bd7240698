// SPDX-License-Identifier: GPL-3.0-or-later
// Clips that jobs return and the document holds: values that are shared and never changed.

#pragma once

#include <Eigen/Core>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/characters.h"
#include "app/jobs/clip_outline.h"
#include "core/base/error.h"
#include "core/batch/row.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/tracks_section.h"
#include "core/codec/methods/compared_file.h"
#include "core/formats/motion_file.h"
#include "core/metrics/glitches.h"
#include "core/report/report_language.h"
#include "core/report/review_page.h"

namespace mocapress {

/// Poses all joints of a motion at a frame.
using Poses = std::function<void(int frame, Pose& pose)>;

/// World positions as landmark_tracks() gives them: frames x 3 * landmarks, cm.
using Tracks = std::shared_ptr<const Eigen::MatrixXd>;

/// A motion as read from a file, ready to be compressed.
struct OriginalClip {
  QString path;
  QString skeleton;     // chosen by hand; empty: the one beside the clip
  ReadOptions reading;  // options it was read with
  InputStamp stamp;     // stamp of its files just before reading
  SourceFormat source;
  bool states_rate = true;  // the file states its rate
  Warnings warnings;
  std::shared_ptr<const Skin> skin;  // null: the file has none
  QString character;                 // path of the character put on it, whether it fits or not
  bool has_character = false;        // the character could be read
  Warnings of_character;             // warnings about the character
  Takes takes;                       // with several, reading.take is the one read
  ClipOutline outline;
  ScalarTracks scalars;  // morph weights and other tracks
  std::shared_ptr<const Encoder> encoder;

  const Motion& motion() const { return encoder->motion(); }

  /// True if `put` is on the clip already: with its skin, if that has been read.
  bool wears(const PutCharacter& put) const {
    return character == put.path && (has_character || !put.character.skin);
  }
  /// Shares ownership of the encoder, which holds the tracks.
  Tracks tracks() const { return {encoder, &encoder->original_tracks()}; }
  Poses poses() const;
};

/// A compressed clip, decoded for display.
struct DecodedClip {
  std::string method;       // a method's name
  bool of_wavelets = true;  // false: made by a comparison method; see OpenedMcpr
  CompressedClip compressed;
  std::vector<std::byte> file;  // the .mcpr; empty for a draft whose size is estimated
  SourceFormat source;          // as stated in the .mcpr it came from
  Clip clip;
  Tracks tracks;
  double ratio = 0;  // raw bytes / motion bytes
  double bits_per_joint_sample = 0;
  std::optional<Distortion> distortion;       // unset: no original to compare with
  std::optional<Footskate> footskate;         // unset: no original
  std::optional<Visibility> visibility;       // unset: no original
  std::vector<Glitch> glitches;               // empty: none, or no original
  std::shared_ptr<const Motion> uncorrected;  // null: no correction
  Tracks uncorrected_tracks;                  // tracks of `uncorrected`
  std::optional<Footskate> uncorrected_footskate;
  std::optional<CorrectionResult> correction;  // set for a clip encoded here
  std::optional<double> coefficient_ratio;     // set for a clip encoded here
  std::optional<int> iterations;               // number of iterations of annealing
  double encode_seconds = 0;
  bool complete = true;             // false: encoding was stopped early
  Effort effort = Effort::Default;  // Draft: the target may be missed
};

using OriginalPtr = std::shared_ptr<const OriginalClip>;
using DecodedPtr = std::shared_ptr<const DecodedClip>;

/// Codes the bytes of a draft that has only an estimated size.
DecodedPtr coded(const DecodedClip& decoded);

/// The .mcpr that saving writes. `tracks` come from the original.
std::vector<std::byte> savedFile(const DecodedClip& decoded, const OriginalClip* original,
                                 const CodedTracks& tracks);

/// Poses with the correction applied.
Poses posesOf(const DecodedPtr& decoded);
Poses posesOf(std::shared_ptr<const Motion> motion);

/// True if both clips have the same joints, channels, frames and rate, so that one can be the
/// compressed form of the other.
bool comparable(const Motion& original, const CompressedClip& compressed);

/// Decodes and measures an encoding made with these options.
DecodedPtr decodedClip(Encoding encoding, const Encoder& encoder, const EncodeSettings& options);

/// Decodes a clip read from a file. If there is an original, measures it and judges it by `limits`.
DecodedPtr decodedClip(OpenedMcpr opened, const OriginalClip* original, const SightLimits& limits,
                       const SourceFormat& source = {});

/// Returns the clip, measured against its original.
DecodedPtr measured(const DecodedClip& decoded, const OriginalClip& original,
                    const SightLimits& limits);

/// Judges a clip by the visibility limits in `options`. The clip must have been encoded with
/// options that differ at most in these limits.
DecodedPtr judged(const DecodedClip& decoded, const Encoder& encoder,
                  const EncodeSettings& options);

/// Returns the clip with errors on the skin measured again, on the original's current skin.
DecodedPtr measuredAgain(const DecodedClip& decoded, const OriginalClip& original);

/// Attaches to the joints the skin on which Weighting::Skin measures errors: the character's if it
/// fits, else the clip's own. Returns warnings about the character.
Warnings dress(Skeleton& skeleton, const PutCharacter& character, const Skin* own);

/// Returns the clip with another character.
OriginalPtr dressed(const OriginalClip& original, const PutCharacter& character);

/// Writes a page that shows a clip and its original in a browser; `remarks` are what reviewers
/// said of it. Throws Error.
void saveReviewPage(const QString& path, const DecodedClip& decoded, const OriginalClip& original,
                    const CodedTracks& tracks, const SightLimits& limits,
                    const ReviewRemarks& remarks, const ReportLanguage& language);

/// Writes a compressed clip. The written bytes are read back and verified before they replace an
/// older file: against the original for a clip encoded here, otherwise by decoding. Throws Error.
void saveClip(const QString& path, const DecodedClip& decoded, const OriginalClip* original,
              const CodedTracks& tracks);

}  // namespace mocapress
