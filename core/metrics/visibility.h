// SPDX-License-Identifier: MIT
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
#include "core/metrics/sight_limits.h"
#include "core/motion/landmarks.h"

namespace mocapress {

/// Verdict whether a viewer of a decoded clip sees that it is not the original.
enum class Sight { NotVisible, Borderline, Visible };

/// "not-visible", "borderline", "visible".
std::string_view name(Sight sight);

/// "not visible from 8 m".
std::string sight_text(Sight sight, double distance_m);

/// Further parameters by which errors are judged, besides SightLimits. Places are compared in means
/// over kWindowSeconds: anything shorter is seen as trembling, if at all. Velocities are compared
/// in means over two such windows.
namespace noticed {
inline constexpr double kWindowSeconds = 0.1;  // ours
// Factor on the limit of flight for errors that slow the body down or are vertical. The factor is
// from Reitsma and Pollard; its use is ours.
inline constexpr double kFlightEasier = 2;
inline constexpr double kVisible = 2;  // visible from this multiple of the limit on, ours
}  // namespace noticed

/// Classifies an error given as a multiple of the noticeable threshold.
constexpr Sight sight_of(double times_noticed) {
  if (times_noticed <= 1) return Sight::NotVisible;
  return times_noticed <= noticed::kVisible ? Sight::Borderline : Sight::Visible;
}

/// The most noticeable error.
struct WorstSight {
  Cue cue = Cue::Velocity;
  int joint = 0;
  int frame = 0;  // middle of the time over which it is seen
  double value = 0;
  double noticed_from = 1;

  double times_noticed() const { return value / noticed_from; }
  bool operator==(const WorstSight&) const = default;
};

/// Errors by joint and time, in windows of equal length; the last also takes the remaining frames.
struct SightTable {
  int window_frames = 1;
  Eigen::MatrixXf times_noticed;  // windows x joints
  // The cue behind each of times_noticed.
  Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic> cues;
  Eigen::MatrixXf noticed_from;  // the threshold behind each of times_noticed

  int windows() const { return static_cast<int>(times_noticed.rows()); }
  int window_of(int frame) const;
  int first_frame(int window) const { return window * window_frames; }

  /// The most noticeable error of a joint at a frame, and of all joints.
  WorstSight at(int frame, int joint) const;
  WorstSight at(int frame) const;

  /// For each joint, the power mean of times_noticed over time with exponent 8: it stresses the
  /// most noticeable moments.
  Eigen::ArrayXd by_joint() const;
};

/// Visible differences of a decoded clip from its original. Worst values are the largest of any
/// joint and window.
struct Visibility {
  SightLimits limits;                        // limits by which it was judged
  std::array<WorstSight, kCues> worst_of{};  // one for each cue
  double velocity_error = 0;                 // cm/s, RMS over joints and windows
  double worst_velocity_error = 0;
  // Energy of acceleration above 10 Hz, decoded / original; unset: the original has none, or the
  // sample rate is too low.
  std::optional<double> jitter_ratio;
  std::optional<MovedContacts> contacts;  // unset: no contacts
  double floor_depth = 0;                 // cm below the original's lowest point
  std::optional<double> flight_error;     // cm/s; unset: the body is never in the air
  std::optional<double> worst_head;       // degrees; unset: no joint has such a name
  std::optional<double> worst_hand;
  double visible_share = 0;     // share of the frames
  double unnoticed_from_m = 0;  // distance of the viewer from which nothing is noticed
  SightTable table;

  const WorstSight& worst() const;
  Sight sight() const { return sight_of(worst().times_noticed()); }
};

/// A sentence about an error, as "velocity of rhand at frame 321: 5.2 cm/s, noticed from 3.1 cm/s";
/// empty if nothing differs.
std::string reason(const WorstSight& worst, const Skeleton& skeleton);

/// The verdict of a Visibility, without its table.
struct Seen {
  double times_noticed = 0;     // the worst error's
  double visible_share = 0;     // share of the frames
  std::string reason;           // the text from reason()
  double unnoticed_from_m = 0;  // distance from which nothing is noticed
  SightLimits limits;           // limits by which it was judged

  Sight sight() const { return sight_of(times_noticed); }
  bool operator==(const Seen&) const = default;
};

Seen seen_in(const Visibility& visibility, const Skeleton& skeleton);

/// Measures clips whose tracks arrive in blocks of frames, in order and without gaps. Up is y. Its
/// memory grows by a few numbers for each joint and window.
class VisibilityMeter {
 public:
  /// Takes clips of `frames` frames and the contacts of the original's feet. `original_jitter`, if
  /// known, is jitter_of() of the original and must outlive this.
  VisibilityMeter(const Skeleton& skeleton, int frames, double sample_rate_hz,
                  const std::vector<ContactSpan>& contacts, const SightLimits& limits = {},
                  const Jitter* original_jitter = nullptr);

  /// Adds rows of body_tracks() of both clips, starting at first_frame.
  void add(int first_frame, const TrackRows& original, const TrackRows& decoded);

  /// The result, once all frames were added.
  Visibility visibility() const;

 private:
  /// Mean positions over a window: x y z of each landmark, and of the body's centre.
  struct Means {
    double seconds = 0;  // middle of the window
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

  /// An error to be judged. `own` is the original's value of which the limit is a share. `easier`
  /// is a factor on the limit, for example for the head of a small figure, which may turn further.
  struct Deviation {
    Cue cue;
    int joint;
    int frame;
    double value;
    double own = 0;
    double easier = 1;
  };
  void see(Visibility& seen, int window, const Deviation& error) const;
  void see_jitter(Visibility& seen) const;
  void see_contacts(Visibility& seen) const;
  void see_floor(Visibility& seen) const;
  int middle_of(int window) const;
  const Jitter& original_jitter() const { return known_jitter_ ? *known_jitter_ : own_jitter_; }

  Skeleton skeleton_;
  int frames_;
  double sample_rate_hz_;
  std::vector<Landmark> points_;
  Eigen::VectorXd shares_;   // each point's weight in the body's centre
  Eigen::VectorXd reaches_;  // cm from the root, along the bones
  std::vector<int> heads_;
  std::vector<int> hands_;
  double turns_easier_;  // factor on the limits of heads and hands

  int window_ = 0;  // the one being filled
  Eigen::RowVectorXd original_sum_;
  Eigen::RowVectorXd decoded_sum_;
  std::vector<Both> last_;         // finished windows, the latest last
  Eigen::VectorXd squared_turns_;  // degrees^2 of heads and hands, summed over the window so far
  double squared_velocities_ = 0;  // (cm/s)^2
  std::int64_t velocities_ = 0;
  double floor_;                // cm
  Eigen::MatrixXf lowest_;      // windows x joints: cm, decoded
  const Jitter* known_jitter_;  // the original's; null: measured here
  Jitter own_jitter_;
  Jitter decoded_jitter_;
  ContactsMeter contacts_;
  Visibility seen_;
};

/// Jitter of a clip, in the windows that VisibilityMeter uses.
Jitter jitter_of(const Skeleton& skeleton, const TrackRows& tracks, double sample_rate_hz);

/// measure_visibility() of complete body_tracks().
Visibility measure_visibility(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                              const Eigen::MatrixXd& decoded_tracks, double sample_rate_hz,
                              const std::vector<ContactSpan>& contacts,
                              const SightLimits& limits = {});

}  // namespace mocapress
