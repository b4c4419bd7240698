// SPDX-License-Identifier: MIT
#include "core/metrics/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/frame_text.h"
#include "core/base/names_all.h"
#include "core/base/number_text.h"
#include "core/motion/body.h"
#include "core/motion/body_part.h"

namespace mocapress {
namespace {

int window_frames(double sample_rate_hz) {
  return std::max(1, static_cast<int>(std::lround(noticed::kWindowSeconds * sample_rate_hz)));
}

int windows_in(int frames, double sample_rate_hz) {
  return frames > 0 ? std::max(1, frames / window_frames(sample_rate_hz)) : 0;
}

/// Jitter without any frame measured.
Jitter no_jitter(const Skeleton& skeleton, int frames, double sample_rate_hz) {
  return {skeleton.joint_count(), windows_in(frames, sample_rate_hz), window_frames(sample_rate_hz),
          sample_rate_hz};
}

/// Lengths (cm) from the root to each point, along the bones.
Eigen::VectorXd reaches(const Skeleton& skeleton, const std::vector<Landmark>& points) {
  Eigen::VectorXd of_joints = Eigen::VectorXd::Zero(skeleton.joint_count());
  for (int j = 0; j < skeleton.joint_count(); ++j)
    if (skeleton.joint(j).parent >= 0)
      of_joints(j) = of_joints(skeleton.joint(j).parent) + skeleton.joint(j).offset.norm();
  Eigen::VectorXd reaches(std::ssize(points));
  for (Eigen::Index p = 0; p < reaches.size(); ++p) {
    const Landmark& point = points[p];
    reaches(p) = of_joints(point.joint) + point.in_joint.norm();
  }
  return reaches;
}

/// Each point's weight in the body's centre.
Eigen::VectorXd shares(const Skeleton& skeleton) {
  Eigen::VectorXd shares = landmark_weights(skeleton, Weighting::BoneEnds);
  const double sum = shares.sum();
  if (sum > 0) return shares / sum;
  return Eigen::VectorXd::Constant(shares.size(), 1.0 / static_cast<double>(shares.size()));
}

void raise(std::optional<double>& most, double value) {
  most = std::max(most.value_or(0), value);
}

}  // namespace

std::string_view name(Sight sight) {
  constexpr std::string_view kNames[] = {"not-visible", "borderline", "visible"};
  static_assert(names_all<Sight>(kNames));
  return kNames[static_cast<std::size_t>(sight)];
}

std::string sight_text(Sight sight, double distance_m) {
  return std::string(sight == Sight::NotVisible ? "not visible" : name(sight)) + " from " +
         significant_text(distance_m, 3) + " m";
}

std::string reason(const WorstSight& worst, const Skeleton& skeleton) {
  if (worst.value == 0) return "";
  const std::string of_unit = ' ' + std::string(unit(worst.cue));
  return std::string(name(worst.cue)) + " of " + skeleton.joint(worst.joint).name + " at frame " +
         frame_text(worst.frame) + ": " + significant_text(worst.value, 3) + of_unit +
         ", noticed from " + significant_text(worst.noticed_from, 3) + of_unit;
}

Seen seen_in(const Visibility& visibility, const Skeleton& skeleton) {
  const WorstSight& worst = visibility.worst();
  return {worst.times_noticed(), visibility.visible_share, reason(worst, skeleton),
          visibility.unnoticed_from_m, visibility.limits};
}

const WorstSight& Visibility::worst() const {
  return *std::ranges::max_element(worst_of, [](const WorstSight& a, const WorstSight& b) {
    return a.times_noticed() < b.times_noticed();
  });
}

int SightTable::window_of(int frame) const {
  return std::min(frame / window_frames, windows() - 1);
}

WorstSight SightTable::at(int frame, int joint) const {
  const int window = window_of(frame);
  const auto from = static_cast<double>(noticed_from(window, joint));
  const auto times = static_cast<double>(times_noticed(window, joint));
  return {static_cast<Cue>(cues(window, joint)), joint, frame, times * from, from};
}

WorstSight SightTable::at(int frame) const {
  Eigen::Index joint = 0;
  times_noticed.row(window_of(frame)).maxCoeff(&joint);
  return at(frame, static_cast<int>(joint));
}

Eigen::ArrayXd SightTable::by_joint() const {
  constexpr double kPower = 8;
  if (windows() == 0) return Eigen::ArrayXd::Zero(times_noticed.cols());
  return times_noticed.cast<double>()
      .array()
      .pow(kPower)
      .colwise()
      .mean()
      .pow(1 / kPower)
      .transpose();
}

VisibilityMeter::VisibilityMeter(const Skeleton& skeleton, int frames, double sample_rate_hz,
                                 const std::vector<ContactSpan>& contacts,
                                 const SightLimits& limits, const Jitter* original_jitter)
    : skeleton_(skeleton),
      frames_(frames),
      sample_rate_hz_(sample_rate_hz),
      points_(landmarks(skeleton)),
      shares_(shares(skeleton)),
      reaches_(reaches(skeleton, points_)),
      heads_(namesakes_of(skeleton, BodyPart::Head)),
      hands_(joints_of(skeleton, BodyPart::Hands)),
      turns_easier_(kUsualStature / stature(skeleton).value_or(kUsualStature)),
      squared_turns_(Eigen::VectorXd::Zero(std::ssize(heads_) + std::ssize(hands_))),
      floor_(std::numeric_limits<double>::infinity()),
      known_jitter_(original_jitter),
      own_jitter_(no_jitter(skeleton, frames, sample_rate_hz)),
      decoded_jitter_(own_jitter_),
      contacts_(contacts, window_frames(sample_rate_hz)) {
  const int windows = windows_in(frames, sample_rate_hz);
  seen_.limits = limits;
  seen_.table.window_frames = window_frames(sample_rate_hz);
  seen_.table.times_noticed = Eigen::MatrixXf::Zero(windows, skeleton.joint_count());
  seen_.table.cues.setZero(windows, skeleton.joint_count());
  seen_.table.noticed_from = Eigen::MatrixXf::Ones(windows, skeleton.joint_count());
  lowest_.resize(windows, skeleton.joint_count());
  original_sum_ = decoded_sum_ = Eigen::RowVectorXd::Zero(3 * std::ssize(points_));
}

int VisibilityMeter::end_of(int window) const {
  const SightTable& table = seen_.table;
  return window + 1 == table.windows() ? frames_ : table.first_frame(window + 1);
}

int VisibilityMeter::middle_of(int window) const {
  return (seen_.table.first_frame(window) + end_of(window) - 1) / 2;
}

void VisibilityMeter::add(int first_frame, const TrackRows& original, const TrackRows& decoded) {
  if (!known_jitter_) own_jitter_.add(first_frame, original);
  decoded_jitter_.add(first_frame, decoded);
  contacts_.add(first_frame, original, decoded);
  const Eigen::Index on_bones = original_sum_.size();
  const auto end = first_frame + static_cast<int>(original.rows());
  for (int t = first_frame; t < end;) {
    const int until = std::min(end, end_of(window_));
    const Eigen::Index row = t - first_frame;
    const Eigen::Index count = until - t;
    original_sum_ += original.block(row, 0, count, on_bones).colwise().sum();
    decoded_sum_ += decoded.block(row, 0, count, on_bones).colwise().sum();
    add_turns(original.middleRows(row, count), decoded.middleRows(row, count));
    if (until == end_of(window_)) finish_window();
    t = until;
  }
}

void VisibilityMeter::add_turns(const TrackRows& original, const TrackRows& decoded) {
  JointErrors errors(skeleton_, original, decoded);
  for (Eigen::Index i = 0; i < squared_turns_.size(); ++i) {
    const auto head = static_cast<std::size_t>(i);
    const int joint = head < heads_.size() ? heads_[head] : hands_[head - heads_.size()];
    squared_turns_(i) += JointErrors::degrees(errors.of(joint)).squaredNorm();
  }
}

void VisibilityMeter::finish_window() {
  const SightTable& table = seen_.table;
  const int first = table.first_frame(window_);
  const double count = end_of(window_) - first;
  const auto means = [&](const Eigen::RowVectorXd& sum) {
    Means found;
    found.seconds = (first + (count - 1) / 2) / sample_rate_hz_;
    found.points = sum.reshaped(3, std::ssize(points_)) / count;
    found.centre = found.points * shares_;
    return found;
  };
  last_.push_back({means(original_sum_), means(decoded_sum_)});
  if (last_.size() > 3) last_.erase(last_.begin());
  original_sum_.setZero();
  decoded_sum_.setZero();
  const Both& now = last_.back();
  floor_ = std::min(floor_, now.original.points.row(1).minCoeff());
  lowest_.row(window_).setConstant(std::numeric_limits<float>::infinity());
  for (Eigen::Index p = 0; p < std::ssize(points_); ++p) {
    float& lowest = lowest_(window_, points_[p].joint);
    lowest = std::min(lowest, static_cast<float>(now.decoded.points(1, p)));
  }
  compare_places(now);
  if (last_.size() > 2) {
    compare_velocities(last_[0], last_[1], now);
    compare_flight(last_[0], last_[1], now);
  } else if (last_.size() == 2 && seen_.table.windows() == 2) {
    compare_velocities(last_[0], now, now);
  }
  for (Eigen::Index i = 0; i < squared_turns_.size(); ++i) {
    const auto head = static_cast<std::size_t>(i);
    const bool is_head = head < heads_.size();
    const double degrees = std::sqrt(squared_turns_(i) / count);
    raise(is_head ? seen_.worst_head : seen_.worst_hand, degrees);
    see(seen_, window_,
        {is_head ? Cue::Head : Cue::Hand, is_head ? heads_[head] : hands_[head - heads_.size()],
         middle_of(window_), degrees, 0, turns_easier_});
  }
  squared_turns_.setZero();
  ++window_;
}

void VisibilityMeter::compare_places(const Both& now) {
  const Eigen::Vector3d body = now.decoded.centre - now.original.centre;
  for (Eigen::Index p = 0; p < std::ssize(points_); ++p) {
    const double off = (now.decoded.points.col(p) - now.original.points.col(p) - body).norm();
    see(seen_, window_, {Cue::Place, points_[p].joint, middle_of(window_), off, reaches_(p)});
  }
}

void VisibilityMeter::compare_velocities(const Both& first, const Both& before, const Both& now) {
  const double early = before.original.seconds - first.original.seconds;
  const double late = now.original.seconds - before.original.seconds;
  const double seconds = early + late;
  const int frame = middle_of(window_ - (late > 0 ? 1 : 0));
  const auto compare = [&](int joint, const Eigen::Vector3d& off, double way) {
    const double error = off.norm() / seconds;
    squared_velocities_ += error * error;
    ++velocities_;
    seen_.worst_velocity_error = std::max(seen_.worst_velocity_error, error);
    const Deviation what = {Cue::Velocity, joint, frame, error, way / seconds};
    for (int window = std::max(window_ - 2, 0); window <= window_; ++window)
      see(seen_, window, what);
  };
  const Means& a = first.original;
  const Means& b = before.original;
  const Means& c = now.original;
  const auto way_of = [&](Eigen::Index p) {
    const auto length = [p](const Means& one, const Means& other) {
      return (other.points.col(p) - other.centre - one.points.col(p) + one.centre).norm();
    };
    return length(a, b) + length(b, c);
  };
  const Eigen::Vector3d of_body =
      (now.decoded.centre - c.centre) - (first.decoded.centre - a.centre);
  compare(0, of_body, (b.centre - a.centre).norm() + (c.centre - b.centre).norm());
  for (Eigen::Index p = 0; p < std::ssize(points_); ++p)
    compare(points_[p].joint,
            (now.decoded.points.col(p) - c.points.col(p)) -
                (first.decoded.points.col(p) - a.points.col(p)) - of_body,
            way_of(p));
}

void VisibilityMeter::compare_flight(const Both& first, const Both& before, const Both& now) {
  constexpr double kGravity = 981;  // cm/s^2
  constexpr double kFalling = 0.25;
  constexpr double kWay = 10;  // cm/s: a slower body has no horizontal direction
  const double early = before.original.seconds - first.original.seconds;
  const double late = now.original.seconds - before.original.seconds;
  const Eigen::Vector3d acceleration = 2 / (early + late) *
                                       ((now.original.centre - before.original.centre) / late -
                                        (before.original.centre - first.original.centre) / early);
  if (std::abs(acceleration.y() + kGravity) > kFalling * kGravity) return;
  const Eigen::Vector3d original = (now.original.centre - first.original.centre) / (early + late);
  const Eigen::Vector3d error = ((now.decoded.centre - now.original.centre) -
                                 (first.decoded.centre - first.original.centre)) /
                                (early + late);
  const Eigen::Vector2d along(original.x(), original.z());
  const Eigen::Vector2d level(error.x(), error.z());
  const double speed = along.norm();
  const double added = speed > kWay ? level.dot(along) / speed : level.norm();
  const auto compare = [&](double value, double easier) {
    raise(seen_.flight_error, value);
    for (int window = window_ - 2; window <= window_; ++window)
      see(seen_, window, {Cue::Flight, 0, middle_of(window_ - 1), value, speed, easier});
  };
  compare(std::abs(added), added > 0 ? 1 : noticed::kFlightEasier);
  compare(std::abs(error.y()), noticed::kFlightEasier);
}

void VisibilityMeter::see(Visibility& seen, int window, const Deviation& error) const {
  const WorstSight what = {error.cue, error.joint, error.frame, error.value,
                           error.easier * seen.limits.noticed_from(error.cue, error.own)};
  const auto times = static_cast<float>(what.times_noticed());
  float& most = seen.table.times_noticed(window, what.joint);
  if (times > most) {
    most = times;
    seen.table.cues(window, what.joint) = static_cast<std::uint8_t>(what.cue);
    seen.table.noticed_from(window, what.joint) = static_cast<float>(what.noticed_from);
  }
  WorstSight& worst = seen.worst_of[static_cast<std::size_t>(what.cue)];
  if (what.times_noticed() > worst.times_noticed()) worst = what;
  seen.unnoticed_from_m =
      std::max(seen.unnoticed_from_m,
               seen.limits.unnoticed_from(error.cue, error.own, error.value / error.easier));
}

void VisibilityMeter::see_jitter(Visibility& seen) const {
  constexpr float kStill = 1e-8F;  // cm^2: below a thousandth of a mm there is no jitter
  if (original_jitter().squares().size() > 0 && original_jitter().squares().maxCoeff() > kStill)
    seen.jitter_ratio = decoded_jitter_.energy() / original_jitter().energy();
  // Judges two windows at a time, so that movement that is a little late does not count as
  // trembling.
  for (int window = 0; window < seen.table.windows(); ++window) {
    const int before = std::max(window - 1, 0);
    const double count = end_of(window) - seen.table.first_frame(before);
    for (int j = 0; j < skeleton_.joint_count(); ++j) {
      const auto mean = [&](const Jitter& jitter) {
        return jitter.squares().col(j).segment(before, window - before + 1).sum() / count;
      };
      const double own = mean(original_jitter());
      const double added = mean(decoded_jitter_) - own;
      if (added <= 0) continue;
      const Deviation what = {Cue::Jitter, j, seen.table.first_frame(window), std::sqrt(added),
                              std::sqrt(own)};
      see(seen, before, what);
      see(seen, window, what);
    }
  }
}

void VisibilityMeter::see_contacts(Visibility& seen) const {
  for (const MovedContact& contact : contacts_.contacts()) {
    MovedContacts& worst = seen.contacts ? *seen.contacts : seen.contacts.emplace();
    worst.worst_slide_cm = std::max(worst.worst_slide_cm, contact.slide_cm);
    worst.worst_lift_cm = std::max(worst.worst_lift_cm, contact.lift_cm);
    const ContactSpan& span = contact.span;
    const int joint = points_[span.landmark].joint;
    const int frame = (span.first_frame + span.last_frame) / 2;
    for (int window = seen.table.window_of(span.first_frame);
         window <= seen.table.window_of(span.last_frame); ++window) {
      see(seen, window, {Cue::Slide, joint, frame, contact.slide_cm});
      see(seen, window, {Cue::Lift, joint, frame, contact.lift_cm});
    }
  }
}

void VisibilityMeter::see_floor(Visibility& seen) const {
  for (int window = 0; window < seen.table.windows(); ++window)
    for (int j = 0; j < skeleton_.joint_count(); ++j) {
      const double depth = static_cast<float>(floor_) - lowest_(window, j);
      if (depth <= 0) continue;
      seen.floor_depth = std::max(seen.floor_depth, depth);
      see(seen, window, {Cue::Floor, j, middle_of(window), depth});
    }
}

Visibility VisibilityMeter::visibility() const {
  Visibility seen = seen_;
  if (velocities_ > 0)
    seen.velocity_error = std::sqrt(squared_velocities_ / static_cast<double>(velocities_));
  see_jitter(seen);
  see_contacts(seen);
  see_floor(seen);
  int visible = 0;
  for (int window = 0; window < seen.table.windows(); ++window)
    if (sight_of(seen.table.times_noticed.row(window).maxCoeff()) == Sight::Visible)
      visible += end_of(window) - seen.table.first_frame(window);
  if (frames_ > 0) seen.visible_share = static_cast<double>(visible) / frames_;
  return seen;
}

Jitter jitter_of(const Skeleton& skeleton, const TrackRows& tracks, double sample_rate_hz) {
  Jitter jitter = no_jitter(skeleton, static_cast<int>(tracks.rows()), sample_rate_hz);
  jitter.add(0, tracks);
  return jitter;
}

Visibility measure_visibility(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                              const Eigen::MatrixXd& decoded_tracks, double sample_rate_hz,
                              const std::vector<ContactSpan>& contacts, const SightLimits& limits) {
  VisibilityMeter meter(skeleton, static_cast<int>(original_tracks.rows()), sample_rate_hz,
                        contacts, limits);
  meter.add(0, original_tracks, decoded_tracks);
  return meter.visibility();
}

}  // namespace mocapress
