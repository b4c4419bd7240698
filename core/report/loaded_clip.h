// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/codec/methods/compression_method.h"
#include "core/formats/motion_file.h"
#include "core/report/measurement.h"

namespace mocapress {

/// A hash over samples, rate, skeleton and mesh, as 16 hexadecimal digits. It tells whether a clip
/// has changed since it was measured; it does not protect against forgery.
std::string fingerprint(const Motion& motion);

/// A clip with everything that several compressions of it share.
class LoadedClip {
 public:
  /// Throws InputError if the file cannot be read.
  explicit LoadedClip(MotionFile file);

  const MethodEncoder& encoder() const { return encoder_; }
  const Motion& motion() const { return encoder_.wavelets().motion(); }
  const std::string& fingerprint() const { return fingerprint_; }
  const Warnings& warnings() const { return warnings_; }
  const SourceFormat& source() const { return source_; }
  const ScalarTracks& tracks() const { return tracks_; }

  /// Spans of frames in which a foot of the original is planted.
  const std::vector<ContactSpan>& contacts() const { return encoder_.wavelets().contacts(); }

  /// Returns the measurements of an encoding. `contacts` is the number of edited contacts, if
  /// footskate was measured over those instead of contacts().
  Measurement measure(const Encoding& encoding, std::optional<std::size_t> contacts = {}) const;

 private:
  Warnings warnings_;
  SourceFormat source_;
  ScalarTracks tracks_;
  std::string fingerprint_;
  MethodEncoder encoder_;
};

}  // namespace mocapress
