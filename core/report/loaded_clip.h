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

/// 16 hexadecimal digits that change with any sample, the rate, the skeleton or the mesh that it
/// carries: tells a changed clip from the one a row was measured on. Not against malice.
std::string fingerprint(const Motion& motion);

/// A clip that was read, with all that its compressions have in common.
class LoadedClip {
 public:
  /// Throws InputError when the file cannot be read.
  explicit LoadedClip(MotionFile file);

  const MethodEncoder& encoder() const { return encoder_; }
  const Motion& motion() const { return encoder_.wavelets().motion(); }
  const std::string& fingerprint() const { return fingerprint_; }
  const Warnings& warnings() const { return warnings_; }
  const SourceFormat& source() const { return source_; }
  const ScalarTracks& tracks() const { return tracks_; }

  /// Spans in which a foot is planted, in the original.
  const std::vector<ContactSpan>& contacts() const { return encoder_.wavelets().contacts(); }

  /// `contacts`: of edited ones, over which the footskate of the encoding was measured.
  Measurement measure(const Encoding& encoding, std::optional<std::size_t> contacts = {}) const;

 private:
  Warnings warnings_;
  SourceFormat source_;
  ScalarTracks tracks_;
  std::string fingerprint_;
  MethodEncoder encoder_;
};

}  // namespace mocapress
