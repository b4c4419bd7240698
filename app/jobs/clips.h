// SPDX-License-Identifier: GPL-3.0-or-later
// What jobs return and the document holds: values, shared and never changed.

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

namespace mocapress {

/// How all joints of a motion stand at one of its frames.
using Poses = std::function<void(int frame, Pose& pose)>;

/// World positions as landmark_tracks() gives them: frames x 3 * landmarks, cm.
using Tracks = std::shared_ptr<const Eigen::MatrixXd>;

/// A motion as read from a file, ready to be compressed.
struct OriginalClip {
  QString path;
  QString skeleton;     // chosen by hand; empty: found beside the clip
  ReadOptions reading;  // by which it was read
  InputStamp stamp;     // of its files, right before they were read
  SourceFormat source;
  bool states_rate = true;  // the file does
  Warnings warnings;
  std::shared_ptr<const Skin> skin;  // null: the file has none
  QString character;           // path of the one that was put on it, also of one that does not fit
  bool has_character = false;  // that one could be read
  Warnings of_character;       // what to say of that one
  Takes takes;
  ClipOutline outline;
  ScalarTracks scalars;  // morph weights and the like
  std::shared_ptr<const Encoder> encoder;

  const Motion& motion() const { return encoder->motion(); }

  /// Whether that one, as far as it was read, is on it.
  bool wears(const PutCharacter& put) const {
    return character == put.path && (has_character || !put.character.skin);
  }
  /// Shares ownership of the encoder, which holds them.
  Tracks tracks() const { return {encoder, &encoder->original_tracks()}; }
  Poses poses() const;
};

/// A compressed clip, decoded for showing.
struct DecodedClip {
  std::string method;       // a method's name
  bool of_wavelets = true;  // else `compressed` is as OpenedMcpr has it
  CompressedClip compressed;
  std::vector<std::byte> file;  // the .mcpr; empty for a draft whose size is estimated
  SourceFormat source;          // in the .mcpr it was opened from
  Clip clip;
  Tracks tracks;
  double ratio = 0;  // raw bytes / motion bytes
  double bits_per_joint_sample = 0;
  std::optional<Distortion> distortion;       // none: its original is not there to compare with
  std::optional<Footskate> footskate;         // none: as for distortion
  std::optional<Visibility> visibility;       // likewise
  std::vector<Glitch> glitches;               // likewise
  std::shared_ptr<const Motion> uncorrected;  // null: there is no correction
  Tracks uncorrected_tracks;                  // of it
  std::optional<Footskate> uncorrected_footskate;
  std::optional<CorrectionResult> correction;  // known for what was encoded here
  std::optional<double> coefficient_ratio;     // known for what was encoded here
  std::optional<int> iterations;               // of the annealing
  double encode_seconds = 0;
  bool complete = true;             // false: the encoder was stopped early
  Effort effort = Effort::Default;  // Draft: the target was not promised
};

using OriginalPtr = std::shared_ptr<const OriginalClip>;
using DecodedPtr = std::shared_ptr<const DecodedClip>;

/// The same clip with the bytes of a draft of which only their number was estimated.
DecodedPtr coded(const DecodedClip& decoded);

/// The .mcpr that saving writes. `tracks`: those of the original.
std::vector<std::byte> savedFile(const DecodedClip& decoded, const OriginalClip* original,
                                 const CodedTracks& tracks);

/// With its correction.
Poses posesOf(const DecodedPtr& decoded);
Poses posesOf(std::shared_ptr<const Motion> motion);

/// True where the clips have the same joints, channels, frames and rate, so that one can be the
/// compressed form of the other.
bool comparable(const Motion& original, const CompressedClip& compressed);

/// Decoded positions, file size and measures of an encoding by these options.
DecodedPtr decodedClip(Encoding encoding, const Encoder& encoder, const EncodeSettings& options);

/// The same for a clip read from a file; measured where there is an original.
DecodedPtr decodedClip(OpenedMcpr opened, const OriginalClip* original,
                       const SourceFormat& source = {});

/// The same clip, measured against its original.
DecodedPtr measured(const DecodedClip& decoded, const OriginalClip& original);

/// The same clip, with the errors of its skin, as the original has it now.
DecodedPtr measuredAgain(const DecodedClip& decoded, const OriginalClip& original);

/// Puts the character on the joints, where it fits: Weighting::Skin measures on it. Else, or where
/// none was put on, on the skin of the file. Returns what to say of the character.
Warnings dress(Skeleton& skeleton, const PutCharacter& character, const Skin* own);

/// The same clip with another character on it.
OriginalPtr dressed(const OriginalClip& original, const PutCharacter& character);

/// Writes a page on which a browser shows a clip and its original; `remarks` are short texts about
/// it. Throws Error.
void saveReviewPage(const QString& path, const DecodedClip& decoded, const OriginalClip& original,
                    const CodedTracks& tracks, const std::vector<std::string>& remarks);

/// Writes a compressed clip. What the disk gives back is verified before it takes its place:
/// against its original where it was encoded here, else by being read. Throws Error.
void saveClip(const QString& path, const DecodedClip& decoded, const OriginalClip* original,
              const CodedTracks& tracks);

}  // namespace mocapress
