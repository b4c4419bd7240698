// SPDX-License-Identifier: MIT
#include "core/motion/loop.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

/// Positions of a pose's landmarks, one column each. cm, y up
using Places = Eigen::Matrix3Xd;

double rms(const Places& differences) {
  return std::sqrt(differences.squaredNorm() / static_cast<double>(differences.cols()));
}

/// The rotation about the vertical that brings `places` nearest to `other` when both are centred.
Eigen::Matrix3d turn_onto(const Places& other, const Places& places) {
  const Places from = places.colwise() - places.rowwise().mean();
  const Places to = other.colwise() - other.rowwise().mean();
  const double along = from.row(0).dot(to.row(0)) + from.row(2).dot(to.row(2));
  const double across = from.row(2).dot(to.row(0)) - from.row(0).dot(to.row(2));
  return axis_rotation(1, std::atan2(across, along));
}

/// The difference that remains between two poses after a turn and the best shift along the floor.
double apart(const Places& other, const Places& places, const Eigen::Matrix3d& turn) {
  Places left = other - turn * places;
  for (const int floor : {0, 2}) left.row(floor).array() -= left.row(floor).mean();
  return rms(left);
}

class LoopFinder {
 public:
  LoopFinder(const Motion& motion, const Eigen::MatrixXd* tracks)
      : motion_(motion), tracks_(tracks), count_(std::ssize(landmarks(motion.skeleton))) {}

  Loop find() const {
    constexpr int kLeastFrames = 8;
    constexpr double kAlike = 0.5;   // share of the usual movement from frame to frame
    constexpr double kStill = 1e-3;  // cm a frame
    const int frames = motion_.clip.frames();
    if (frames < kLeastFrames) return Loop::None;
    const Usual usual = usual_changes();
    if (usual.step < kStill) return Loop::None;
    const std::vector<Places> ends = poses({0, 1, frames - 2, frames - 1});
    const Places& last = ends[3];
    const Eigen::Matrix3d turn = turn_onto(ends[0], last);
    const Places leaving = turn.transpose() * (ends[1] - ends[0]);
    const Places arriving = last - ends[2];
    const Places next = last + (arriving + leaving) / 2;
    const double of_last = apart(ends[0], last, turn);
    const double of_next = apart(ends[0], next, turn_onto(ends[0], next));
    if (std::min(of_last, of_next) > kAlike * usual.step) return Loop::None;
    const Loop loop = of_last <= of_next ? Loop::Repeats : Loop::Follows;
    const int frames_between = loop == Loop::Repeats ? 1 : 2;
    const double bend = 2 * frames_between * usual.bend;
    return rms(leaving - arriving) > kAlike * usual.step + bend ? Loop::None : loop;
  }

 private:
  std::vector<Places> poses(const std::vector<int>& frames) const {
    const Eigen::MatrixXd tracks =
        tracks_ ? Eigen::MatrixXd((*tracks_)(frames, Eigen::all))
                : landmark_tracks(motion_.skeleton, {motion_.clip.sample_rate_hz,
                                                     motion_.clip.channels(frames, Eigen::all)});
    std::vector<Places> poses;
    for (Eigen::Index row = 0; row < tracks.rows(); ++row) {
      const Eigen::RowVectorXd places = tracks.row(row);
      poses.emplace_back(Eigen::Map<const Places>(places.data(), 3, count_));
    }
    return poses;
  }

  /// The usual movement of landmarks from frame to frame, and the usual change of that movement.
  struct Usual {
    double step = 0;  // cm
    double bend = 0;  // cm
  };

  /// The usual changes, as RMS over some places of the clip.
  Usual usual_changes() const {
    constexpr int kMost = 256;
    const int starts = motion_.clip.frames() - 2;
    const int count = std::min(starts, kMost);
    std::vector<int> frames;
    for (int i = 0; i < count; ++i) {
      const auto first = static_cast<int>(static_cast<long>(starts) * i / count);
      frames.insert(frames.end(), {first, first + 1, first + 2});
    }
    const std::vector<Places> found = poses(frames);
    Usual squares;
    for (std::size_t i = 0; i < found.size(); i += 3) {
      const Places step = found[i + 1] - found[i];
      squares.step += std::pow(rms(step), 2);
      squares.bend += std::pow(rms(found[i + 2] - found[i + 1] - step), 2);
    }
    return {std::sqrt(squares.step / count), std::sqrt(squares.bend / count)};
  }

  const Motion& motion_;
  const Eigen::MatrixXd* tracks_;  // null: computed when needed
  Eigen::Index count_;             // number of landmarks
};

}  // namespace

std::string_view name(Loop loop) {
  switch (loop) {
    case Loop::None:
      return "none";
    case Loop::Repeats:
      return "repeats";
    case Loop::Follows:
      return "follows";
  }
  return "unknown";
}

Loop find_loop(const Motion& motion) {
  return LoopFinder(motion, nullptr).find();
}

Loop find_loop(const Motion& motion, const Eigen::MatrixXd& tracks) {
  return LoopFinder(motion, &tracks).find();
}

}  // namespace mocapress
