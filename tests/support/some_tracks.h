// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "core/codec/format/tracks_section.h"

namespace mocapress::test {

/// A switch, a smile, a temperature, a constant and a scale.
inline ScalarTracks some_tracks(int frames) {
  ScalarTracks tracks = {
      {.kind = TrackKind::Property, .node = "prop", .name = "visible", .steps = true, .values = {}},
      {.kind = TrackKind::MorphWeight, .node = "Face", .name = "smile", .values = {}},
      {.kind = TrackKind::Property, .node = "", .name = "heat", .values = {}},
      {.kind = TrackKind::MorphWeight, .node = "Face", .name = "frown", .values = {}},
      {.kind = TrackKind::ScaleY, .node = "spine", .name = "", .values = {}}};
  for (int t = 0; t < frames; ++t) {
    tracks[0].values.push_back(t % 17 < 5 ? 1.0F : 0.0F);
    tracks[1].values.push_back(static_cast<float>(0.5 - 0.5 * std::cos(0.11 * t)));
    tracks[2].values.push_back(static_cast<float>(300 + 25 * std::sin(0.05 * t + 0.001 * t * t)));
    tracks[3].values.push_back(0.25F);
    tracks[4].values.push_back(t < frames / 3 ? 1.0F : 1.5F);
  }
  return tracks;
}

/// The same in a file's form, with other curves for smile and heat: integers only, so that every
/// machine makes the same bytes.
inline CodedTracks some_coded_tracks(int frames) {
  CodedTracks coded{some_tracks(frames), {}, Basis::Linear, {}};
  coded.curves = {.scale = 0.5F, .step_exponent = {3, -4}, .values = Eigen::MatrixXi(frames, 2)};
  for (int i = 0; i < frames; ++i) coded.curves.values.row(i) << i % 7 - 3, i == 5 ? 100'000 : 0;
  for (ScalarTrack& track : coded.tracks) {
    coded.is_curve.push_back(track.name == "smile" || track.name == "heat");
    if (coded.is_curve.back()) track.values.clear();
  }
  return coded;
}

}  // namespace mocapress::test
