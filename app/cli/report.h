// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/codec/encode/encoder.h"
#include "core/metrics/distortion.h"
#include "core/motion/loop.h"
#include "core/motion/scalar_track.h"
#include "core/report/json_value.h"

namespace mocapress::cli {

/// Morph weights, properties, scales.
struct TrackFigures {
  std::size_t count = 0;
  std::size_t bytes = 0;  // of the file
  double max_error = 0;
};

/// Throws Error where the file has other tracks.
TrackFigures track_figures(const ScalarTracks& original, std::span<const std::byte> mcpr);

/// What `compress` and `measure` print: one compressed clip against its original.
struct Report {
  std::string input;
  const Motion* original = nullptr;
  Loop loop = Loop::None;
  std::string method;  // a method's name
  Weighting weighting = Weighting::BoneEnds;
  std::optional<Coding> coding;  // unset: of a comparison method
  std::size_t motion_bytes = 0;
  std::size_t file_bytes = 0;
  std::string verified_by;  // Verification::by
  Distortion distortion;
  Footskate footskate;  // beyond the original's own
  Visibility visibility;
  std::size_t contacts = 0;                     // over which it was measured
  std::optional<std::size_t> correction_bytes;  // unset: no correction
  std::optional<CorrectionResult> correction;   // what compress knows of it
  std::optional<double> coefficient_ratio;      // unset: not known to this command
  std::optional<int> iterations;
  std::optional<double> encode_seconds;
  TrackFigures tracks;
};

/// Stable keys: scripts depend on them. Null where a value does not apply.
Json to_json(const Report& report);

/// The same for people, on standard error.
void print(const Report& report);

/// JSON goes to standard output, alone.
void print(const Json& json);

}  // namespace mocapress::cli
