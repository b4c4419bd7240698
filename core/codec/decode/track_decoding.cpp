// SPDX-License-Identifier: MIT
#include "core/codec/decode/track_decoding.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/codec/decode/decoder.h"

namespace mocapress {

ScalarTracks decode_tracks(const CodedTracks& coded) {
  ScalarTracks tracks = coded.tracks;
  if (coded.curves.signal_count() == 0) return tracks;
  std::vector<float> steps;
  for (int s = 0; s < coded.curves.signal_count(); ++s)
    steps.push_back(static_cast<float>(coded.curves.step(s)));
  const Eigen::MatrixXd samples = decode_signals(coded.curves.values, steps, coded.basis);
  Eigen::Index curve = 0;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    if (!coded.is_curve[t]) continue;
    tracks[t].values.resize(samples.rows());
    for (Eigen::Index f = 0; f < samples.rows(); ++f)
      tracks[t].values[f] = static_cast<float>(samples(f, curve));
    ++curve;
  }
  return tracks;
}

ScalarTracks tracks_of(std::span<const std::byte> mcpr) {
  return decode_tracks(coded_tracks_of(mcpr));
}

double track_error(const ScalarTracks& original, const ScalarTracks& decoded) {
  double worst = 0;
  if (original.size() != decoded.size()) throw Error("the tracks are not those of the original");
  for (std::size_t t = 0; t < original.size(); ++t) {
    if (original[t].values.size() != decoded[t].values.size())
      throw Error("the tracks have not as many frames as those of the original");
    for (std::size_t f = 0; f < original[t].values.size(); ++f)
      worst = std::max(worst, std::abs(static_cast<double>(original[t].values[f]) -
                                       static_cast<double>(decoded[t].values[f])));
  }
  return worst;
}

}  // namespace mocapress
