// SPDX-License-Identifier: MIT
// Values published in "Adapting Wavelet Compression to Human Motion Capture Clips", Tables 1 and 2
// and section 6. Nothing in this file was measured by this program.
#pragma once

#include <array>
#include <string_view>

namespace mocapress {

/// A coded size in KB (1024 bytes), and the ratio of the uncompressed floats' size to it.
struct PublishedSize {
  double kb;
  double ratio;
};

/// A row of Table 1: sizes at one error.
struct PublishedSizes {
  double eps_cm;
  PublishedSize pca, standard, annealed;
};

/// A row of Table 2: the time of optimised selection on a 2 GHz AMD Athlon 64.
struct PublishedTiming {
  double ratio;
  double ms_per_frame;
  int iterations;
};

/// The values published for one clip of the CMU library.
struct PublishedClip {
  std::string_view stem;  // file name without extension
  std::string_view title;
  int frames;
  std::array<PublishedSizes, 5> sizes;
  std::array<PublishedTiming, 5> timings;
};

inline constexpr std::array<PublishedClip, 2> kPublishedClips = {{
    {"09_01",
     "Running",
     148,
     {{{1.40, {6.02, 6.0}, {1.27, 28}, {0.75, 48}},
       {0.96, {6.49, 5.5}, {1.51, 24}, {0.94, 38}},
       {0.58, {7.67, 4.7}, {2.31, 16}, {1.24, 29}},
       {0.26, {9.42, 3.8}, {3.69, 9.7}, {2.18, 16}},
       {0.08, {11.5, 3.1}, {8.74, 4.1}, {5.08, 7.0}}}},
     {{{50, 133, 264}, {40, 214, 415}, {30, 254, 496}, {15, 293, 542}, {7, 327, 669}}}},
    {"49_02",
     "Jumping",
     2085,
     {{{0.67, {153, 3.3}, {18.6, 27}, {9.97, 51}},
       {0.45, {157, 3.2}, {24.8, 20}, {13.5, 37}},
       {0.29, {164, 3.1}, {33.8, 15}, {18.4, 27}},
       {0.14, {168, 3.0}, {62.7, 8.1}, {32.9, 15}},
       {0.05, {177, 2.9}, {135, 3.7}, {79.2, 6.4}}}},
     {{{50, 308, 247}, {40, 312, 243}, {30, 391, 311}, {15, 456, 369}, {7, 483, 380}}}},
}};

/// The error up to which, and the mean ratio at which, the paper saw no artifact in its 15 clips.
inline constexpr double kPublishedInvisibleEpsCm = 0.5;
inline constexpr double kPublishedMeanRatio = 25;

/// The coefficient ratios in the paper's video: of the angles, and of the IK correction.
inline constexpr double kPublishedVideoRatio = 30;
inline constexpr double kPublishedVideoIkRatio = 16;

/// The values published for a clip, by its file name without extension; null if there are none.
constexpr const PublishedClip* find_published(std::string_view stem) {
  for (const PublishedClip& clip : kPublishedClips)
    if (clip.stem == stem) return &clip;
  return nullptr;
}

}  // namespace mocapress
