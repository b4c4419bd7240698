// SPDX-License-Identifier: MIT
#include "core/codec/encode/track_encoder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/format/container.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/some_tracks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

/// A file of so many frames with the tracks, and what they come back as.
std::vector<std::byte> file_with(const ScalarTracks& tracks, double bound) {
  const auto frames = static_cast<int>(tracks.front().values.size());
  return with_tracks(write_container(test::segmented_clip(test::smooth_motion(frames),
                                                          SegmentLayout::whole(frames))),
                     tracks, bound);
}

/// Noise of some smoothness.
std::vector<float> noise(int frames, double smoothness, double size, unsigned seed) {
  Random random(seed);
  std::vector<float> values;
  double value = 0;
  for (int t = 0; t < frames; ++t) {
    value = smoothness * value + (1 - smoothness) * (2 * random.unit() - 1);
    values.push_back(static_cast<float>(size * value));
  }
  return values;
}

TEST(TrackEncoder, NoValueIsFurtherOffThanTheBound) {
  for (const int frames : {1, 2, 3, 4, 5, 63, 300})
    for (const double bound : {0.1, 0.002, 1e-5}) {
      ScalarTracks tracks = test::some_tracks(frames);
      for (const double smoothness : {0.0, 0.9, 0.99})
        for (const double size : {1e-6, 1.0, 1e3, 1e8})
          tracks.push_back({.name = "noise", .values = noise(frames, smoothness, size, 5)});
      const ScalarTracks found = tracks_of(file_with(tracks, bound));
      EXPECT_LE(track_error(tracks, found), bound) << frames;
      for (std::size_t t = 0; t < tracks.size(); ++t) {
        EXPECT_EQ(label(found[t]), label(tracks[t]));
        EXPECT_EQ(found[t].steps, tracks[t].steps);
      }
    }
}

TEST(TrackEncoder, SwitchesAndWhatStaysAreExact) {
  const ScalarTracks tracks = test::some_tracks(500);
  const ScalarTracks found = tracks_of(file_with(tracks, 0.05));
  for (const std::size_t t : {0U, 3U, 4U}) EXPECT_EQ(found[t], tracks[t]) << label(tracks[t]);
  EXPECT_NE(found[1], tracks[1]);
}

TEST(TrackEncoder, ACurveTakesLessTheMoreItMayBeOff) {
  ScalarTracks tracks;
  for (unsigned s = 0; s < 8; ++s)
    tracks.push_back({.name = "w" + std::to_string(s), .values = noise(2000, 0.95, 1, s)});
  std::size_t last = SIZE_MAX;
  for (const double bound : {1e-4, 1e-3, 1e-2}) {
    const std::size_t bytes = track_bytes_of(file_with(tracks, bound));
    EXPECT_LT(bytes, last * 4 / 5) << bound;
    last = bytes;
  }
  EXPECT_LT(last, 8 * 2000 * sizeof(float) / 8);
}

TEST(TrackEncoder, WithoutTracksTheFileStaysAsItWas) {
  const std::vector<std::byte> file =
      write_container(test::segmented_clip(test::smooth_motion(50), SegmentLayout::whole(50)));
  EXPECT_EQ(with_tracks(file, {}, 0.01), file);
}

}  // namespace
}  // namespace mocapress
