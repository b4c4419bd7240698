// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 3.1.

#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/metrics/end_errors.h"
#include "core/motion/body_tracks.h"

namespace mocapress {

/// A histogram of distances, in memory that does not grow with their number: one count for each
/// 4096th of an octave, for the octaves that occur.
class DistanceCounts {
 public:
  static constexpr double kPrecision = 1.0 / 4096;

  void add(float distance) {
    // The bits of non-negative floats are ordered as the floats are.
    const auto bits = std::bit_cast<std::uint32_t>(distance) & 0x7FFFFFFFU;
    const std::uint32_t exponent = bits >> kFraction;
    if (places_[exponent] == kNone) open(exponent);
    ++counts_[places_[exponent] + ((bits >> (kFraction - kBits)) & ((1U << kBits) - 1))];
    ++all_;
  }

  /// The smallest distance that at least `share` of all do not exceed. The result may be too low by
  /// up to kPrecision of its value. 0 without distances.
  double percentile(double share) const;

 private:
  static constexpr int kFraction = 23;  // bits of a float's fraction
  static constexpr int kBits = 12;      // leading bits of the fraction that choose a count
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  void open(std::uint32_t exponent);

  std::array<std::size_t, 256> places_ = [] {  // places in counts_, by a float's exponent
    std::array<std::size_t, 256> none{};
    none.fill(kNone);
    return none;
  }();
  std::vector<std::uint64_t> counts_;
  std::uint64_t all_ = 0;
};

/// The place and time of the largest distance.
struct WorstPoint {
  int frame = 0;
  int landmark = 0;  // index into landmarks(skeleton)
  double cm = 0;

  bool operator==(const WorstPoint&) const = default;
};

/// Errors of one kind of points, in centimetres.
struct Spread {
  double rms = 0;  // each point counts by its weight
  double p95 = 0;  // over all points and frames, unweighted, within 1 / 4096 (DistanceCounts)
  double p99 = 0;
  WorstPoint max;  // `landmark` is the joint that carries the point

  bool operator==(const Spread&) const = default;
};

/// Errors of a decoded clip against its original, in centimetres.
struct Distortion {
  double eps_bone_ends = 0;  // the paper's error eps_x by each weighting on bones
  double eps_joint_origins = 0;
  double p95 = 0;  // over all bone ends and frames, unweighted
  double p99 = 0;
  WorstPoint max;
  Eigen::MatrixXf distances;  // frames x landmarks; empty unless Detail::Distances
  Spread surface;             // surface, shell, skin: over the weighting's points
  Spread shell;
  std::optional<Spread> skin;  // unset: the skeleton has no skin
  // RMS and largest distance for each joint, over the skin points that it carries most: joints x 2;
  // -1: none. No rows without a skin.
  Eigen::MatrixX2d skin_of_joints;
  // Degrees by which each joint is turned wrongly in the world, RMS over the frames.
  Eigen::VectorXd joint_degrees;
  Eigen::VectorXd joint_max_degrees;  // largest over the frames
  Eigen::VectorXd joint_max_cm;       // largest distance of each joint's origin
  Eigen::MatrixXf turns;   // frames x landmarks: degrees by which the landmark's joint is turned
  double p99_degrees = 0;  // over all of `turns`
  EndErrors ends;

  /// Errors of the points of a weighting; zeros for the skin if there is none. Percentiles and
  /// maximum of both weightings on bones are those of the bone ends.
  Spread spread(Weighting weighting) const;
  double eps(Weighting weighting) const { return spread(weighting).rms; }  // eps_x
  WorstPoint worst(Weighting weighting) const { return spread(weighting).max; }

  /// RMS of joint_degrees over some joints; 0 without joints.
  double degrees(const std::vector<int>& joints) const;
};

/// The detail in which a DistortionMeter measures.
enum class Detail {
  Means,      // eps_x and the worst point, in one weighting
  Figures,    // also percentiles, within 1 / 4096 (DistanceCounts)
  Distances,  // also every distance and angle; percentiles are exact
};

/// Errors of the points of one weighting.
class PointErrors {
 public:
  PointErrors(const Skeleton& skeleton, Weighting weighting);

  /// Squared errors (cm^2), frames x points, from rows of body_tracks() of both clips.
  Eigen::MatrixXd squared(const TrackRows& original, const TrackRows& decoded) const;

  /// Squared errors as above, from JointErrors that were already computed for these rows.
  Eigen::MatrixXd squared(const TrackRows& original, const TrackRows& decoded,
                          JointErrors& errors) const;

  /// The points; a point of the skin belongs to the joint that carries most of it.
  const MeasuredPoints& measured() const { return measured_; }
  Weighting weighting() const { return weighting_; }

 private:
  Skeleton skeleton_;
  Weighting weighting_;
  MeasuredPoints measured_;
};

/// Compares two clips whose tracks arrive in blocks of frames, each once. Its memory does not grow
/// with the number of frames, except for Detail::Distances.
class DistortionMeter {
 public:
  /// Takes clips of `frames` frames. Detail::Means measures the given weighting, and weights each
  /// frame's errors by `frame_factors` unless that is empty; other details measure all weightings.
  DistortionMeter(const Skeleton& skeleton, int frames, Detail detail,
                  Weighting weighting = Weighting::BoneEnds, Eigen::VectorXd frame_factors = {});

  /// Adds rows of body_tracks() of both clips, starting at first_frame.
  void add(int first_frame, const TrackRows& original, const TrackRows& decoded);

  /// The result, once all frames were added. Not with Detail::Means.
  Distortion distortion() const;

  double eps() const { return eps(0); }  // in the weighting of Detail::Means
  // The point with the largest distance in the weighting of Detail::Means.
  const WorstPoint& worst() const { return sets_.front().worst; }
  /// The point with the largest distance in any weighting, as Distortion::worst(). Not with
  /// Detail::Means.
  const WorstPoint& worst(Weighting weighting) const;

 private:
  /// Points of one kind.
  struct Set {
    PointErrors errors;
    Eigen::VectorXd squares;   // cm^2, each point's sum over the frames so far
    Eigen::VectorXd greatest;  // cm^2, each point's maximum so far
    double worst_square = -1;  // cm^2
    WorstPoint worst;
    DistanceCounts counts;
  };
  void add(Set& set, int first_frame, const Eigen::MatrixXd& squared) const;
  void add_some(int first_frame, const TrackRows& original, const TrackRows& decoded);
  void add_turns(int first_frame, Eigen::Index frames, JointErrors& errors);
  double eps(std::size_t set) const { return eps(set, sets_[set].errors.measured().weights); }
  double eps(std::size_t set, const Eigen::VectorXd& weights) const;
  Spread spread(std::size_t set) const;
  Eigen::MatrixX2d skin_of_joints() const;

  Skeleton skeleton_;
  Detail detail_;
  Eigen::VectorXd frame_factors_;  // empty: all frames count alike
  // Landmarks, surface, shell and, if any, skin; one set alone for Detail::Means.
  std::vector<Set> sets_;
  Eigen::Index frames_ = 0;
  Eigen::MatrixXf distances_;
  Eigen::MatrixXf turns_;           // degrees
  Eigen::VectorXd squared_turns_;   // degrees^2, each joint's sum over the frames so far
  Eigen::VectorXd greatest_turns_;  // degrees, each joint's maximum so far
  EndErrorMeter ends_;
};

/// Compares clips of one skeleton. Requires equal shapes.
Distortion measure(const Skeleton& skeleton, const Clip& original, const Clip& decoded);

/// measure() where body_tracks() of the original are already computed.
Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Clip& decoded);

/// measure() where body_tracks() of both clips are already computed.
Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Eigen::MatrixXd& decoded_tracks);

/// eps_x alone, by full forward kinematics: the exact value that the quadratic model approximates.
double exact_eps(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                 const Clip& decoded, Weighting weighting);

/// The world rotation error of a body part, taken from its worst joint: the left hand is not
/// averaged with the right one, nor with its wrist.
struct PartTurn {
  double rms_degrees = 0;  // over the frames
  double max_degrees = 0;  // largest of all frames

  bool operator==(const PartTurn&) const = default;
};

/// Distortion of the body, summarised.
struct BodyFigures {
  Spread surface;  // cm
  Spread shell;
  std::optional<Spread> skin;    // unset: no mesh
  std::optional<PartTurn> head;  // over namesakes_of(); unset: no joint has such a name
  std::optional<PartTurn> hand;
  std::optional<PartTurn> finger;
  std::optional<PartTurn> foot;
  double root_max_cm = 0;        // largest distance of the root
  double root_max_degrees = 0;   // largest rotation error of the root
  double angle_rms_degrees = 0;  // over all joints
  EndErrors ends;

  bool operator==(const BodyFigures&) const = default;
};

/// The rotation error of the worst among some joints; unset without joints.
std::optional<PartTurn> worst_turn(const Distortion& distortion, const std::vector<int>& joints);

BodyFigures body_figures(const Skeleton& skeleton, const Distortion& distortion);

}  // namespace mocapress
