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

/// Figures of scalar tracks: morph weights, properties, scales.
struct TrackFigures {
  std::size_t count = 0;
  std::size_t bytes = 0;  // bytes of the tracks in the file
  double max_error = 0;
};

/// Compares the file's tracks with the original's. Throws Error if they are other tracks.
TrackFigures track_figures(const ScalarTracks& original, std::span<const std::byte> mcpr);

/// The output of `compress` and `measure`: one compressed clip compared with its original.
struct Report {
  std::string input;
  const Motion* original = nullptr;
  Loop loop = Loop::None;
  std::string method;  // a method's name
  Weighting weighting = Weighting::BoneEnds;
  std::optional<Coding> coding;  // unset: a comparison method
  std::size_t motion_bytes = 0;
  std::size_t file_bytes = 0;
  std::string verified_by;  // Verification::by
  Distortion distortion;
  Footskate footskate;  // in excess of the original's own
  Visibility visibility;
  std::size_t contacts = 0;                     // number of contacts measured
  std::optional<std::size_t> correction_bytes;  // unset: no correction
  std::optional<CorrectionResult> correction;   // unset: none, or unknown to this command
  std::optional<double> coefficient_ratio;      // unset: unknown to this command
  std::optional<int> iterations;
  std::optional<double> encode_seconds;
  TrackFigures tracks;
};

/// Keys are stable, since scripts depend on them. Null for values that do not apply.
Json to_json(const Report& report);

/// Prints the report as text to standard error.
void print(const Report& report);

/// Writes JSON and nothing else to standard output.
void print(const Json& json);

}  // namespace mocapress::cli
