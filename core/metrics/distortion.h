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

/// How many of many distances are about how large, in memory that does not grow with them: a
/// count for each 4096th of an octave, in the octaves there are.
class DistanceCounts {
 public:
  static constexpr double kPrecision = 1.0 / 4096;

  void add(float distance) {
    // Ordered as the floats are, where these are not negative.
    const auto bits = std::bit_cast<std::uint32_t>(distance) & 0x7FFFFFFFU;
    const std::uint32_t exponent = bits >> kFraction;
    if (places_[exponent] == kNone) open(exponent);
    ++counts_[places_[exponent] + ((bits >> (kFraction - kBits)) & ((1U << kBits) - 1))];
    ++all_;
  }

  /// The smallest distance that at least `share` of all do not exceed, or up to kPrecision of it
  /// less. 0 where there are none.
  double percentile(double share) const;

 private:
  static constexpr int kFraction = 23;  // bits of a float
  static constexpr int kBits = 12;      // of its fraction
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  void open(std::uint32_t exponent);

  std::array<std::size_t, 256> places_ = [] {  // in counts_, by the exponent of a float
    std::array<std::size_t, 256> none{};
    none.fill(kNone);
    return none;
  }();
  std::vector<std::uint64_t> counts_;
  std::uint64_t all_ = 0;
};

/// Where the largest distance is.
struct WorstPoint {
  int frame = 0;
  int landmark = 0;  // index into landmarks(skeleton)
  double cm = 0;

  bool operator==(const WorstPoint&) const = default;
};

/// How far points of a kind are off, in centimetres.
struct Spread {
  double rms = 0;  // each point by its weight
  double p95 = 0;  // of all points and frames alike, but for 1 / 4096 (DistanceCounts)
  double p99 = 0;
  WorstPoint max;  // its landmark: the joint that carries the point

  bool operator==(const Spread&) const = default;
};

/// How far a decoded clip is from its original, in centimetres.
struct Distortion {
  double eps_bone_ends = 0;  // the paper's eps_x with each weighting
  double eps_joint_origins = 0;
  double p95 = 0;  // over all landmarks and frames, unweighted
  double p99 = 0;
  WorstPoint max;
  Eigen::MatrixXf distances;  // frames x landmarks; empty where only figures were asked for
  Spread surface;             // of the points of these weightings
  Spread shell;
  std::optional<Spread> skin;  // unset: the skeleton has none
  // RMS and greatest distance of the points of the skin that each joint carries most of, joints x
  // 2; -1: there are none. No rows without a skin.
  Eigen::MatrixX2d skin_of_joints;
  Eigen::VectorXd joint_degrees;  // how far each joint is turned in the world, RMS over the frames
  Eigen::VectorXd joint_max_degrees;  // the same at most
  Eigen::VectorXd joint_max_cm;       // how far each joint's origin is off, at most
  Eigen::MatrixXf turns;   // as distances: by how many degrees a landmark's joint is turned
  double p99_degrees = 0;  // over all of them
  EndErrors ends;

  /// On the skin 0 where there is none.
  double eps(Weighting weighting) const;
  WorstPoint worst(Weighting weighting) const;

  /// RMS of joint_degrees over some joints. 0 for none.
  double degrees(const std::vector<int>& joints) const;
};

/// What a DistortionMeter is asked for.
enum class Detail {
  Means,      // eps_x and the worst point of one weighting
  Figures,    // and percentiles, but for 1 / 4096 of them (DistanceCounts)
  Distances,  // and every distance and angle; percentiles are exact
};

/// How far the points of a weighting are off.
class PointErrors {
 public:
  PointErrors(const Skeleton& skeleton, Weighting weighting);

  /// cm^2, frames x points, of rows of body_tracks() of both clips.
  Eigen::MatrixXd squared(const TrackRows& original, const TrackRows& decoded) const;

  /// The same where their JointErrors are there.
  Eigen::MatrixXd squared(const TrackRows& original, const TrackRows& decoded,
                          JointErrors& errors) const;

  /// Of the skin: each by the joint that carries most of it.
  const MeasuredPoints& measured() const { return measured_; }
  Weighting weighting() const { return weighting_; }

 private:
  Skeleton skeleton_;
  Weighting weighting_;
  MeasuredPoints measured_;
};

/// Compares two clips whose tracks come some frames at a time, each once. Without distances its
/// memory does not grow with them.
class DistortionMeter {
 public:
  /// Of clips of so many frames. Means are those of the weighting; else all are measured.
  DistortionMeter(const Skeleton& skeleton, int frames, Detail detail,
                  Weighting weighting = Weighting::BoneEnds);

  /// Rows of body_tracks() of both clips, from first_frame on.
  void add(int first_frame, const TrackRows& original, const TrackRows& decoded);

  /// Once all are there. Not of means.
  Distortion distortion() const;

  double eps() const { return eps(0); }                            // of the weighting
  const WorstPoint& worst() const { return sets_.front().worst; }  // among its points

 private:
  /// Points of one kind.
  struct Set {
    PointErrors errors;
    Eigen::VectorXd squares;   // cm^2, the sum over the frames so far of each point
    Eigen::VectorXd greatest;  // cm^2, likewise the greatest
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
  std::vector<Set> sets_;  // landmarks, surface, shell, skin if there is one; of means one alone
  Eigen::Index frames_ = 0;
  Eigen::MatrixXf distances_;
  Eigen::MatrixXf turns_;           // degrees
  Eigen::VectorXd squared_turns_;   // degrees^2, the sum over the frames so far of each joint
  Eigen::VectorXd greatest_turns_;  // degrees, likewise the greatest
  EndErrorMeter ends_;
};

/// Compares clips of one skeleton. Requires equal shapes.
Distortion measure(const Skeleton& skeleton, const Clip& original, const Clip& decoded);

/// The same against body_tracks(skeleton, original) computed before.
Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Clip& decoded);

/// The same of two body_tracks().
Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Eigen::MatrixXd& decoded_tracks);

/// eps_x alone, by full forward kinematics: the exact value the quadratic model approximates.
double exact_eps(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                 const Clip& decoded, Weighting weighting);

/// How far a part of the body is turned in the world, by the one of its joints that fares worst:
/// the left hand is not averaged with the right one, nor with its wrist.
struct PartTurn {
  double rms_degrees = 0;  // over the frames
  double max_degrees = 0;  // at any frame

  bool operator==(const PartTurn&) const = default;
};

/// A distortion of the body in a few figures.
struct BodyFigures {
  Spread surface;  // cm
  Spread shell;
  std::optional<Spread> skin;    // unset: there is no mesh
  std::optional<PartTurn> head;  // by namesakes_of(); unset: no joint has such a name
  std::optional<PartTurn> hand;
  std::optional<PartTurn> finger;
  std::optional<PartTurn> foot;
  double root_max_cm = 0;        // how far the root is off, at any frame
  double root_max_degrees = 0;   // how far it is turned
  double angle_rms_degrees = 0;  // over all joints
  EndErrors ends;

  bool operator==(const BodyFigures&) const = default;
};

/// The turn of the worst of some joints; unset for none.
std::optional<PartTurn> worst_turn(const Distortion& distortion, const std::vector<int>& joints);

BodyFigures body_figures(const Skeleton& skeleton, const Distortion& distortion);

}  // namespace mocapress
