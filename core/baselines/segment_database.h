// SPDX-License-Identifier: MIT
// The encoder of core/baselines/arikan.h.
#pragma once

#include <span>

#include "core/base/byte_cursor.h"
#include "core/baselines/principal_components.h"
#include "core/motion/clip.h"
#include "core/motion/landmarks.h"

namespace mocapress {

/// Segments of this many frames or fewer are kept exactly by their control points.
inline constexpr int kShortestCurve = 3;

/// Segments of `length` frames beyond the first frame, the last maybe shorter.
constexpr int curve_count(int frames, int length) {
  return frames > 1 ? (frames - 2) / length + 1 : 0;
}

/// Motions of one kind of skeleton, cut into curves and clustered in several ways.
class SegmentDatabase {
 public:
  SegmentDatabase(std::span<const Motion> motions, Weighting weighting);

  /// What one encoding of all motions comes to: the best way to cut and cluster for a tolerance.
  class Encoding {
   public:
    void write_codebook(ByteWriter& writer) const;
    void write_clip(ByteWriter& writer, std::size_t clip) const;

   private:
    friend class SegmentDatabase;
    const SegmentDatabase* database;
    std::size_t cutting;
    std::size_t clustering;
    double tolerance;             // cm
    std::vector<int> components;  // of each cluster
    float loading_step;           // cm
    float coefficient_step;       // cm
  };
  Encoding encode(double tolerance_cm) const;

 private:
  /// What of a motion does not depend on the cut.
  struct Source {
    int frames;
    Eigen::RowVectorXd first_frame;
    std::vector<int> other_channels;
    std::vector<int> angles;
    Eigen::VectorXd other_scales;  // cm for one unit of each other channel
  };
  struct Clustering {
    std::vector<int> clusters;               // of each segment, all motions in a row
    std::vector<int> places;                 // its row in its cluster
    std::vector<PrincipalComponents> parts;  // of each cluster's segments
  };
  /// All motions as curves of one length.
  struct Cutting {
    int length;                           // frames
    double error;                         // cm: root mean square of what the curves miss
    std::vector<std::size_t> first;       // segment of each motion
    Eigen::MatrixXd markers;              // segments x control points 1, 2, 3 of all markers
    std::vector<Eigen::MatrixXd> others;  // each motion's: 3 segments x other channels
    std::vector<Clustering> clusterings;
  };

  Cutting cut(const std::vector<Eigen::MatrixXd>& markers, std::span<const Motion> motions,
              int length) const;

  std::vector<Source> sources_;
  std::vector<Cutting> cuttings_;  // the longest first
  Eigen::Index coordinates_ = 0;   // of the markers of a frame
};

}  // namespace mocapress
