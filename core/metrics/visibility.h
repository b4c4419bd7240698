// SPDX-License-Identifier: MIT
// Based on:
// B. De Bruyn and G. A. Orban, "Human velocity and direction discrimination measured with random
// dot patterns", 1988: speeds that differ by 7 % are told apart, from 4 degrees a second on;
// P. S. A. Reitsma and N. S. Pollard, "Perceptual metrics for character animation: sensitivity to
// errors in ballistic motion", 2003: errors along the ground are seen sooner than vertical ones,
// added acceleration sooner than removed one (their own figures were not at hand);
// M. Prazak, L. Hoyet and C. O'Sullivan, "Perceptual evaluation of footskate cleanup", 2011: feet
// that slide by less than 2.1 cm are seen to in most conditions;
// J. Harrison, R. A. Rensink and M. van de Panne, "Obscuring length changes during animated
// motion", 2004: limbs that change by 3 % of their length are seen to where one looks;
// H. R. Wilson, F. Wilkinson, L. M. Lin and M. Castillo, "Perception of head orientation", 2000:
// heads 1.9 degrees apart are told apart.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/metrics/jitter.h"
#include "core/metrics/moved_contacts.h"
#include "core/motion/landmarks.h"

namespace mocapress {

/// Whether somebody who looks at a decoded clip sees that it is not the original.
enum class Sight { NotVisible, Borderline, Visible };

/// "not-visible", "borderline", "visible".
std::string_view name(Sight sight);

/// By what an error is seen.
enum class Cue : std::uint8_t {
  Velocity,  // a joint moves about the body, or the body through the world, at another velocity
  Place,     // a joint is elsewhere about the body, as if limbs had other lengths
  Jitter,    // a joint trembles that did not
  Slide,     // a standing foot slides
  Lift,      // a standing foot floats
  Floor,     // a joint is below the floor
  Flight,    // the body in the air flies another way
  Head,      // the head is turned
  Hand,      // a hand is turned
};

inline constexpr std::size_t kCues = 9;

/// "velocity", "place", "jitter", "slide", "lift", "floor", "flight", "head", "hand".
std::string_view name(Cue cue);

/// "cm/s", "cm" or "degrees".
std::string_view unit(Cue cue);

/// From where on errors are noticed. Places are looked at in the mean of kWindowSeconds: what is
/// shorter is seen as trembling, if at all; velocities in the mean of two such windows. The figure
/// is seen from five metres (ours), so that 1 cm is 7 minutes of arc.
namespace noticed {
inline constexpr double kWindowSeconds = 0.1;     // ours
inline constexpr double kShareOfSpeed = 0.07;     // De Bruyn and Orban
inline constexpr double kLeastVelocity = 2.4;     // cm/s: their 7 % of 4 degrees/s at five metres
inline constexpr double kShareOfReach = 0.03;     // Harrison et al., of the way from the root
inline constexpr double kLeastPlace = 1;          // cm, ours
inline constexpr double kSlide = 1.05;            // cm: half of where Prazak et al. saw it
inline constexpr double kLift = 1;                // cm, ours
inline constexpr double kDepth = 1;               // cm, ours
inline constexpr double kFlightOfVelocity = 0.5;  // in the air, of what is noticed else: ours
inline constexpr double kFlightEasier = 2;  // slowed down, vertical: Reitsma and Pollard; how: ours
inline constexpr double kHead = 1.9;        // degrees, Wilson et al.
inline constexpr double kHand = 3.8;        // degrees, ours: twice the head's
inline constexpr double kJitter = 0.1;      // cm RMS, ours: by a minute of arc
inline constexpr double kJitterShare = 1;   // of the original's own, ours
inline constexpr double kVisible = 2;       // times of these: not only noticed; ours
}  // namespace noticed

/// Which that is of an error so many times as large as what is noticed.
constexpr Sight sight_of(double times_noticed) {
  if (times_noticed <= 1) return Sight::NotVisible;
  return times_noticed <= noticed::kVisible ? Sight::Borderline : Sight::Visible;
}

/// What is seen most of all.
struct WorstSight {
  Cue cue = Cue::Velocity;
  int joint = 0;
  int frame = 0;  // in the middle of where it is seen
  double value = 0;
  double noticed_from = 1;

  double times_noticed() const { return value / noticed_from; }
  bool operator==(const WorstSight&) const = default;
};

/// By joint and time: windows of equal length, the last longer by what is left over.
struct SightTable {
  int window_frames = 1;
  Eigen::MatrixXf times_noticed;                                     // windows x joints
  Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic> cues;  // of these
  Eigen::MatrixXf noticed_from;                                      // likewise

  int windows() const { return static_cast<int>(times_noticed.rows()); }
  int window_of(int frame) const;
  int first_frame(int window) const { return window * window_frames; }

  /// What is seen most of a joint at a frame, and of all joints.
  WorstSight at(int frame, int joint) const;
  WorstSight at(int frame) const;

  /// How much each joint is noticed where it is noticed most: the power mean by 8 over time.
  Eigen::ArrayXd by_joint() const;
};

/// What the eye sees of a decoded clip against its original. Worst figures are the largest of any
/// joint and window.
struct Visibility {
  std::array<WorstSight, kCues> worst_of{};  // each cue
  double velocity_error = 0;                 // cm/s, RMS over joints and windows
  double worst_velocity_error = 0;
  std::optional<double> jitter_ratio;     // energy of acceleration above 10 Hz, decoded / original;
                                          // unset: none, or the sample rate is too low for it
  std::optional<MovedContacts> contacts;  // unset: there are none
  double floor_depth = 0;                 // cm below the original's lowest point
  std::optional<double> flight_error;     // cm/s; unset: the body is never in the air
  std::optional<double> worst_head;       // degrees; unset: no joint has such a name
  std::optional<double> worst_hand;
  double visible_share = 0;  // of the frames
  SightTable table;

  const WorstSight& worst() const;
  Sight sight() const { return sight_of(worst().times_noticed()); }
};

/// "velocity of rhand at frame 321: 5.2 cm/s, noticed from 3.1 cm/s"; empty where nothing differs.
std::string reason(const WorstSight& worst, const Skeleton& skeleton);

/// The verdict alone.
struct Seen {
  double times_noticed = 0;  // of the worst
  double visible_share = 0;  // of the frames
  std::string reason;        // as reason() has it

  Sight sight() const { return sight_of(times_noticed); }
  bool operator==(const Seen&) const = default;
};

Seen seen_in(const Visibility& visibility, const Skeleton& skeleton);

/// Looks at clips whose tracks come some frames at a time, in time and none left out. Up is y. Its
/// memory grows by a few numbers for each joint and window.
class VisibilityMeter {
 public:
  /// Of clips of so many frames, with feet that stand on the ground in the original, whose
  /// jitter_of() may be known: then it must outlive this.
  VisibilityMeter(const Skeleton& skeleton, int frames, double sample_rate_hz,
                  const std::vector<ContactSpan>& contacts,
                  const Jitter* original_jitter = nullptr);

  /// Rows of body_tracks() of both clips, from first_frame on.
  void add(int first_frame, const TrackRows& original, const TrackRows& decoded);

  /// Once all are there.
  Visibility visibility() const;

 private:
  /// Positions in the mean of a window: x y z of each landmark, and of the body's centre.
  struct Means {
    double seconds = 0;  // of its middle
    Eigen::Matrix3Xd points;
    Eigen::Vector3d centre;
  };
  struct Both {
    Means original;
    Means decoded;
  };

  int end_of(int window) const;
  void finish_window();
  void compare_places(const Both& now);
  void compare_velocities(const Both& first, const Both& before, const Both& now);
  void compare_flight(const Both& first, const Both& before, const Both& now);
  void add_turns(const TrackRows& original, const TrackRows& decoded);
  static void see(Visibility& seen, int window, WorstSight what);
  void see_jitter(Visibility& seen) const;
  void see_contacts(Visibility& seen) const;
  void see_floor(Visibility& seen) const;
  int middle_of(int window) const;
  const Jitter& original_jitter() const { return known_jitter_ ? *known_jitter_ : own_jitter_; }

  Skeleton skeleton_;
  int frames_;
  double sample_rate_hz_;
  std::vector<Landmark> points_;
  Eigen::VectorXd shares_;   // of the points in the body's centre
  Eigen::VectorXd reaches_;  // cm from the root, along the bones
  std::vector<int> heads_;
  std::vector<int> hands_;

  int window_ = 0;  // that is being filled
  Eigen::RowVectorXd original_sum_;
  Eigen::RowVectorXd decoded_sum_;
  std::vector<Both> last_;         // windows that are finished, the latest last
  Eigen::VectorXd squared_turns_;  // degrees^2 of heads and hands, the sum so far of the window
  double squared_velocities_ = 0;  // (cm/s)^2
  std::int64_t velocities_ = 0;
  double floor_;                // cm
  Eigen::MatrixXf lowest_;      // windows x joints: cm, of the decoded
  const Jitter* known_jitter_;  // the original's; null: it is measured here
  Jitter own_jitter_;
  Jitter decoded_jitter_;
  ContactsMeter contacts_;
  Visibility seen_;
};

/// How a clip trembles, in the windows that are looked at.
Jitter jitter_of(const Skeleton& skeleton, const TrackRows& tracks, double sample_rate_hz);

/// The same of whole body_tracks().
Visibility measure_visibility(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                              const Eigen::MatrixXd& decoded_tracks, double sample_rate_hz,
                              const std::vector<ContactSpan>& contacts);

}  // namespace mocapress
