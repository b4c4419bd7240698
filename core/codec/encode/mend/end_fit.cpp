// SPDX-License-Identifier: MIT
#include "core/codec/encode/mend/end_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/codec/decode/decoder.h"
#include "core/metrics/distortion.h"
#include "core/motion/body_tracks.h"
#include "core/runtime/format/end_poses.h"
#include "core/select/error_model.h"

namespace mocapress {
namespace {

/// The error allowed at an end.
struct Tolerance {
  Weighting weighting;
  double cm;
  bool at_most;  // true: a limit for each point; false: for the RMS
};

constexpr double kEven = 0.9;  // share of the target
constexpr double kExact = 0.1;

Tolerance tolerance_of(const EncodeSettings& settings, double share, double eps_cm) {
  const bool at_most = settings.target.kind == Target::Kind::MaxError;
  const bool is_error = at_most || settings.target.kind == Target::Kind::Error;
  return {settings.weighting, share * (is_error ? settings.target.value : eps_cm), at_most};
}

/// The channels of an end; only those that move in the clip may be mended.
struct EndChannels {
  const Skeleton& skeleton;
  const std::vector<bool>& still;

  /// The original minus the decoded pose: angles by the shorter way round, zero for channels that
  /// stand still.
  Eigen::RowVectorXd lacking(const Eigen::RowVectorXd& original,
                             const Eigen::RowVectorXd& decoded) const {
    Eigen::RowVectorXd difference = original - decoded;
    for (int c = 0; c < skeleton.channel_count(); ++c)
      if (still[c])
        difference(c) = 0;
      else if (is_rotation(skeleton.channel_kind(c)))
        difference(c) = std::remainder(difference(c), 2 * std::numbers::pi);
    return difference;
  }
};

/// Counts the bits that a range coder would take.
struct CountedBits {
  double bits = 0;

  bool code(bool bit, runtime::Probability one) {
    bits -= std::log2((bit ? one : 65536 - one) / 65536.0);
    return bit;
  }
};

/// Estimates the bits of one of several coded whole numbers.
double bits_of(int whole) {
  const int magnitude = std::abs(whole);
  return magnitude == 0 ? 0.5 : 3 + 2 * std::log2(magnitude);
}

double bits_of(const Eigen::VectorXi& whole) {
  CountedBits counted;
  runtime::EndCoder coder;
  for (const int value : whole) coder.code(counted, value);
  return counted.bits;
}

/// One end of a clip and its original, from the end inwards: row 0 is the clip's first or last
/// frame. The wanted pose of row 0 is the original's plus `error`, in channels.
class End {
 public:
  End(const EndChannels& channels, const Eigen::MatrixXd& original, Eigen::MatrixXd decoded,
      const Tolerance& tolerance, const Eigen::RowVectorXd& error)
      : channels_(channels),
        tolerance_(tolerance),
        errors_(channels.skeleton, tolerance.weighting),
        original_(tracks(original)),
        decoded_(std::move(decoded)),
        lacking_(channels.lacking(original.row(0) + error, decoded_.row(0))),
        wanted_pose_(decoded_.row(0) + lacking_),
        wanted_(tracks(wanted_pose_)) {}

  /// The result of a correction that fades out over this many frames.
  struct Reach {
    int frames;
    double squares;            // squared errors of all rows, summed up, cm^2
    Eigen::RowVectorXd slope;  // change of the error to the neighbouring frame, cm
  };

  std::vector<Reach> reaches(const Eigen::RowVectorXd& added) const {
    std::vector<Reach> found;
    Eigen::MatrixXd at = tracks(decoded_);
    for (int frames = 1; frames <= decoded_.rows(); frames *= 2) {
      at.topRows(frames) = tracks(decoded_with(added, frames).topRows(frames));
      const Eigen::Index beside = std::min<Eigen::Index>(1, at.rows() - 1);
      found.push_back({frames, (errors_.squared(original_, at) * errors_.measured().weights).sum(),
                       at.row(beside) - original_.row(beside) - at.row(0) + original_.row(0)});
    }
    return found;
  }

  /// The decoded frames with `added` at the first frame, fading out over `frames` frames.
  Eigen::MatrixXd decoded_with(const Eigen::RowVectorXd& added, int frames) const {
    Eigen::MatrixXd with = decoded_;
    for (int t = 0; t < frames; ++t)
      with.row(t) += static_cast<double>(runtime::end_share(runtime::kLastPose, t, frames)) * added;
    return with;
  }

  /// Chooses a step exponent and whole numbers of steps for all channels that take the fewest bits
  /// within the tolerance. The exponent refines `steps` by half octaves. All numbers are zero if
  /// the pose is good enough already.
  std::pair<int, Eigen::VectorXi> cheapest(const std::vector<float>& steps) const {
    constexpr int kFiner = 6;  // finer exponents tried after the first that is good enough
    constexpr double kStricter = 0.9;
    std::pair<int, Eigen::VectorXi> best{0, Eigen::VectorXi::Zero(lacking_.size())};
    if (is_near(values_of(best.second, steps, 0))) return best;
    if (lacking_.size() > kMostWeighed) return coarsest(steps);
    const Eigen::MatrixXd gram = gram_of_pose();
    double most = tolerance_.cm * tolerance_.cm;  // by the quadratic model
    double least = std::numeric_limits<double>::infinity();
    int last = runtime::kMostEndStepExponent;
    for (int step_exponent = kFirst; step_exponent <= last; ++step_exponent) {
      const Eigen::RowVectorXd step =
          values_of(Eigen::VectorXi::Ones(lacking_.size()), steps, step_exponent);
      Eigen::VectorXi whole = sparsest(gram, step, most);
      // Correcting channels one by one converges too slowly if all must be exact.
      if (error_of(gram, step, whole) > most) whole = rounded(step);
      const bool is_finest = step_exponent == runtime::kMostEndStepExponent && std::isinf(least);
      if (!is_finest && error_of(gram, step, whole) > most) continue;
      const double bits = bits_of(whole);
      if (bits >= least) continue;
      if (!is_finest && !is_near(values_of(whole, steps, step_exponent))) {
        most *= kStricter;
        continue;
      }
      if (std::isinf(least)) last = std::min(last, step_exponent + kFiner);
      least = bits;
      best = {step_exponent, std::move(whole)};
    }
    return best;
  }

  /// Converts whole steps to channel values.
  static Eigen::RowVectorXd values_of(const Eigen::VectorXi& whole, const std::vector<float>& steps,
                                      int step_exponent) {
    Eigen::RowVectorXd values(whole.size());
    for (Eigen::Index c = 0; c < whole.size(); ++c)
      values(c) = runtime::end_value(whole(c), steps[c], step_exponent);
    return values;
  }

  /// Returns whether the pose with `added` is within `cm` of the original.
  bool is_within(double cm, const Eigen::RowVectorXd& added) const {
    return distance(original_.topRows(1), added) <= cm;
  }

  /// The error that remains after `added`.
  Eigen::RowVectorXd error_with(const Eigen::RowVectorXd& added) const { return added - lacking_; }

 private:
  static constexpr int kFirst = -8;  // exponent of the coarsest steps
  // Most channels that are weighed against each other. Time and memory grow with the square of
  // their number.
  static constexpr int kMostWeighed = 1024;

  /// Rounds lacking_ to whole steps and returns the coarsest that are good enough.
  std::pair<int, Eigen::VectorXi> coarsest(const std::vector<float>& steps) const {
    for (int step_exponent = kFirst;; ++step_exponent) {
      Eigen::VectorXi whole =
          rounded(values_of(Eigen::VectorXi::Ones(lacking_.size()), steps, step_exponent));
      if (step_exponent == runtime::kMostEndStepExponent ||
          is_near(values_of(whole, steps, step_exponent)))
        return {step_exponent, std::move(whole)};
    }
  }

  /// Returns gram, where d gram d^T is the squared error of small channel differences d.
  Eigen::MatrixXd gram_of_pose() const {
    const ErrorModel model(channels_.skeleton, Clip{1, wanted_pose_}, tolerance_.weighting);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(lacking_.size(), lacking_.size());
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
    for (int c = 0; c < model.channels(); ++c) {
      if (channels_.still[c]) continue;
      Eigen::MatrixXd row = Eigen::MatrixXd::Zero(1, model.channels());
      model.add_to_gradient(c, one, row);
      gram.col(c) = row.transpose();
    }
    return gram;
  }

  /// Returns whether the pose with `added` is within the tolerance.
  bool is_near(const Eigen::RowVectorXd& added) const {
    return distance(wanted_, added) <= tolerance_.cm;
  }

  /// The distance in cm of the pose with `added` from tracks of one row.
  double distance(const Eigen::MatrixXd& from, const Eigen::RowVectorXd& added) const {
    Eigen::MatrixXd pose = decoded_.topRows(1);
    for (Eigen::Index c = 0; c < added.size(); ++c)
      pose(0, c) =
          static_cast<double>(static_cast<float>(pose(0, c)) + static_cast<float>(added(c)));
    const Eigen::MatrixXd squared = errors_.squared(from, tracks(pose));
    return std::sqrt(tolerance_.at_most ? squared.maxCoeff()
                                        : (squared * errors_.measured().weights).value());
  }

  static int limited(double steps) {
    constexpr double kMost = (1 << runtime::DigitCoder::kMostDigits) - 1;
    return static_cast<int>(std::lround(std::clamp(steps, -kMost, kMost)));
  }

  /// lacking_ rounded to whole steps.
  Eigen::VectorXi rounded(const Eigen::RowVectorXd& step) const {
    Eigen::VectorXi whole(lacking_.size());
    for (Eigen::Index c = 0; c < whole.size(); ++c) whole(c) = limited(lacking_(c) / step(c));
    return whole;
  }

  /// The squared error that whole steps leave.
  double error_of(const Eigen::MatrixXd& gram, const Eigen::RowVectorXd& step,
                  const Eigen::VectorXi& whole) const {
    const Eigen::RowVectorXd left = step.cwiseProduct(whole.cast<double>().transpose()) - lacking_;
    return left.dot(gram * left.transpose());
  }

  /// Chooses whole steps of few channels: one after another, the step that reduces the error most
  /// for its bits, until the squared error is at most `squared_error` or no step reduces it
  /// further.
  Eigen::VectorXi sparsest(const Eigen::MatrixXd& gram, const Eigen::RowVectorXd& step,
                           double squared_error) const {
    constexpr double kLeastBits = 0.25;
    const Eigen::Index channels = lacking_.size();
    Eigen::VectorXi whole = Eigen::VectorXi::Zero(channels);
    Eigen::VectorXd slope = -gram * lacking_.transpose();
    double error = -lacking_.dot(slope);
    for (Eigen::Index move = 0; error > squared_error && move < 2 * channels; ++move) {
      double best = 0;
      Eigen::Index channel = -1;
      int by = 0;
      for (Eigen::Index c = 0; c < channels; ++c) {
        const double wanted = -slope(c) / (gram(c, c) * step(c));
        if (!(std::abs(wanted) > 0.5) || !std::isfinite(wanted)) continue;
        const int to = limited(whole(c) + wanted);
        const double delta = (to - whole(c)) * step(c);
        const double mended = -delta * (2 * slope(c) + gram(c, c) * delta);
        const double bits = std::max(bits_of(to) - bits_of(whole(c)), kLeastBits);
        if (mended <= best * bits) continue;
        best = mended / bits;
        channel = c;
        by = to - whole(c);
      }
      if (channel < 0) break;
      const double delta = by * step(channel);
      error += delta * (2 * slope(channel) + gram(channel, channel) * delta);
      slope += delta * gram.col(channel);
      whole(channel) += by;
    }
    return whole;
  }

  Eigen::MatrixXd tracks(const Eigen::MatrixXd& channels) const {
    return body_tracks(channels_.skeleton, {1, channels});
  }

  const EndChannels& channels_;
  Tolerance tolerance_;
  PointErrors errors_;
  Eigen::MatrixXd original_;
  Eigen::MatrixXd decoded_;
  Eigen::RowVectorXd lacking_;
  Eigen::RowVectorXd wanted_pose_;
  Eigen::MatrixXd wanted_;  // tracks of wanted_pose_: one row
};

/// The reach with the least squared error.
const End::Reach& best_of(const std::vector<End::Reach>& reaches) {
  return *std::ranges::min_element(
      reaches, [](const auto& a, const auto& b) { return a.squares < b.squares; });
}

/// For a loop: the reaches with the smallest change of the velocity error across the seam, among
/// those whose squared errors are not much larger than the least.
std::array<int, 2> smoothest(const std::vector<End::Reach>& first,
                             const std::vector<End::Reach>& last) {
  constexpr double kMost = 1.5;  // times the least squared errors
  const double most = kMost * (best_of(first).squares + best_of(last).squares);
  std::array<int, 2> found{best_of(first).frames, best_of(last).frames};
  double least = std::numeric_limits<double>::infinity();
  for (const End::Reach& a : first)
    for (const End::Reach& b : last) {
      // The slope at the last frame runs against time, so the sum is the change across the seam.
      const double bend = (a.slope + b.slope).squaredNorm();
      if (a.squares + b.squares > most || bend >= least) continue;
      least = bend;
      found = {a.frames, b.frames};
    }
  return found;
}

/// The decoded frames at both ends, from each end inwards.
std::array<Eigen::MatrixXd, 2> decoded_at_ends(const CompressedClip& compressed, int rows) {
  const Eigen::Index channels = compressed.coded_skeleton().channel_count();
  std::array<Eigen::MatrixXd, 2> found{Eigen::MatrixXd(rows, channels),
                                       Eigen::MatrixXd(rows, channels)};
  const Finish finish(compressed);
  visit_decoded(compressed, [&](int first, Uncorrected& block) {
    finish(first, block);
    const Eigen::MatrixXd& decoded = block.clip.channels;
    for (int i = 0; i < rows; ++i) {
      const int last = compressed.frames - 1 - i;
      if (i >= first && i < first + decoded.rows()) found[0].row(i) = decoded.row(i - first);
      if (last >= first && last < first + decoded.rows())
        found[1].row(i) = decoded.row(last - first);
    }
  });
  return found;
}

CodedEnds with_velocity(CodedEnds ends, int reach, int step_exponent,
                        const Eigen::VectorXi& steps) {
  ends.reaches.frames[runtime::kVelocity] = static_cast<std::uint8_t>(reach);
  ends.step_exponent[runtime::kVelocity] = step_exponent;
  ends.steps.conservativeResize(Eigen::NoChange, runtime::kMostEnds);
  ends.steps.col(runtime::kVelocity) = steps;
  return ends;
}

/// Codes a correction of a loop's last velocity if the error of the velocity jumps more at the seam
/// than between any consecutive frames. `original_first` runs forwards from the first frame,
/// `original_last` backwards from the last; `last_steps` are the last segment's steps.
void mend_velocity(const EndChannels& channels, const Goal& goal,
                   const Eigen::MatrixXd& original_first, const Eigen::MatrixXd& original_last,
                   const std::vector<float>& last_steps, CompressedClip& compressed) {
  constexpr int kLeastRows = 8;
  constexpr double kMostMore = 1.05;  // limit relative to the largest earlier change
  const auto rows = static_cast<int>(original_first.rows());
  const EndErrors before = goal.ends(compressed);
  if (rows < kLeastRows || before.seam_cm_per_frame <= before.worst_neighbours_cm_per_frame) return;
  const auto [first, last] = decoded_at_ends(compressed, rows);
  const auto error = [&](const Eigen::MatrixXd& original, const Eigen::MatrixXd& decoded,
                         int row) -> Eigen::RowVectorXd {
    return -channels.lacking(original.row(row), decoded.row(row));
  };
  // The wanted error of the frame before the last: from there to the last frame, the error changes
  // by as much as from the first frame to the second.
  const Eigen::RowVectorXd wanted = error(original_last, last, 0) +
                                    error(original_first, first, 0) -
                                    error(original_first, first, 1);
  const double most = before.worst_neighbours_cm_per_frame;
  const CodedEnds poses = *compressed.ends;
  for (const double share : {0.7, 0.5, 0.35, 0.2}) {
    const End end(channels, original_last.bottomRows(rows - 1), last.bottomRows(rows - 1),
                  {Weighting::Surface, share * most, false}, wanted);
    for (int reach = 8; reach <= rows; reach *= 2) {
      std::vector<float> steps = last_steps;
      for (float& step : steps) step *= runtime::end_share(runtime::kVelocity, 1, reach);
      const auto [step_exponent, whole] = end.cheapest(steps);
      compressed.ends = with_velocity(poses, reach, step_exponent, whole);
      // A short reach would only move the break to the frame before.
      const EndErrors after = goal.ends(compressed);
      if (after.seam_cm_per_frame <= after.worst_neighbours_cm_per_frame &&
          after.worst_neighbours_cm_per_frame <= kMostMore * most)
        return;
    }
  }
  compressed.ends = poses;
}

}  // namespace

bool codes_ends(const EncodeSettings& settings) {
  if (settings.method != Method::ClosedLoop || settings.ends == Ends::Free) return false;
  if (settings.effort == Effort::Draft) return settings.ends == Ends::Exact;
  const bool loops = settings.loop.value_or(Loop::None) != Loop::None;
  return loops || settings.ends == Ends::Exact || settings.target.kind != Target::Kind::MaxError;
}

int frames_at_ends(int frames) {
  constexpr int kMost = 32;
  return std::min((frames + 1) / 2, kMost);
}

void fit_ends(const EncodeSettings& settings, Trial& trial, const Skeleton& coded_skeleton,
              const std::vector<bool>& still, const Goal& goal,
              const Eigen::MatrixXd& original_first, const Eigen::MatrixXd& original_last) {
  const EndChannels moving{coded_skeleton, still};
  CompressedClip& compressed = trial.compressed;
  compressed.ends.reset();
  const auto rows = static_cast<int>(original_first.rows());
  const int channels = coded_skeleton.channel_count();
  auto [decoded_first, decoded_last] = decoded_at_ends(compressed, rows);
  const Eigen::MatrixXd backwards = original_last.colwise().reverse();
  const auto tolerance = [&](double share) { return tolerance_of(settings, share, trial.eps_cm); };
  const bool is_exact =
      settings.ends == Ends::Exact || compressed.correction;  // otherwise feet slide
  const double share = is_exact ? kExact : kEven;
  const bool is_loop = settings.loop.value_or(Loop::None) != Loop::None;
  const auto [first_steps, last_steps] = steps_at_ends(compressed);

  Eigen::RowVectorXd error = Eigen::RowVectorXd::Zero(channels);
  const End first(moving, original_first, std::move(decoded_first), tolerance(share), error);
  const auto [first_exponent, first_whole] = first.cheapest(first_steps);
  const Eigen::RowVectorXd to_first = End::values_of(first_whole, first_steps, first_exponent);
  if (is_loop) error = first.error_with(to_first);
  // In a loop the last pose gets the first one's error in channels. Where the poses differ, that
  // may be too large in centimetres; then the last pose gets only a part of it.
  const double promise = tolerance(settings.ends == Ends::Exact ? kExact : 1).cm;
  std::optional<End> last;
  std::pair<int, Eigen::VectorXi> lacks_at_last;
  Eigen::RowVectorXd to_last;
  for (const double part : {1.0, 0.5, 0.25, 0.0}) {
    last.emplace(moving, backwards, decoded_last, tolerance(is_loop ? kExact : share),
                 part * error);
    lacks_at_last = last->cheapest(last_steps);
    to_last = End::values_of(lacks_at_last.second, last_steps, lacks_at_last.first);
    if (!is_loop || last->is_within(promise, to_last)) break;
  }
  const auto& [last_exponent, last_whole] = lacks_at_last;

  CodedEnds& ends = compressed.ends.emplace();
  ends.step_exponent = {first_exponent, last_exponent};
  ends.steps.resize(channels, 2);
  ends.steps << first_whole, last_whole;
  // With an IK correction, only the end frames change, since it holds effectors in all others.
  if (!compressed.correction) {
    std::array reaches = {1, 1};
    if (is_loop)
      reaches = smoothest(first.reaches(to_first), last->reaches(to_last));
    else if (!ends.steps.isZero())
      reaches = {best_of(first.reaches(to_first)).frames, best_of(last->reaches(to_last)).frames};
    std::ranges::copy(reaches, ends.reaches.frames);
    if (is_loop) mend_velocity(moving, goal, original_first, backwards, last_steps, compressed);
  }
  if (compressed.ends->steps.isZero()) compressed.ends.reset();
}

}  // namespace mocapress
