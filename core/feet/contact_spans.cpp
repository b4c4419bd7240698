// SPDX-License-Identifier: MIT
#include "core/feet/contact_spans.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/feet/feet.h"
#include "core/ik/correction.h"
#include "core/motion/body_tracks.h"

namespace mocapress {
namespace {

/// Speed (cm/s) at each frame, by central differences.
Eigen::VectorXd speeds(const Eigen::MatrixXd& tracks, int landmark, double sample_rate_hz) {
  const Eigen::Index frames = tracks.rows();
  Eigen::VectorXd speed = Eigen::VectorXd::Zero(frames);
  for (Eigen::Index t = 0; t < frames; ++t) {
    const Eigen::Index before = std::max<Eigen::Index>(t - 1, 0);
    const Eigen::Index after = std::min(t + 1, frames - 1);
    if (after == before) continue;
    const Eigen::RowVector3d way =
        tracks.block<1, 3>(after, 3 * landmark) - tracks.block<1, 3>(before, 3 * landmark);
    speed(t) = way.norm() * sample_rate_hz / static_cast<double>(after - before);
  }
  return speed;
}

/// The runs of planted frames of one landmark. First closes gaps of fewer than `least` frames, then
/// drops runs of fewer than `least` frames.
std::vector<ContactSpan> spans_of(const std::vector<bool>& planted, int landmark, int least) {
  std::vector<ContactSpan> spans;
  for (int t = 0; t < static_cast<int>(planted.size()); ++t) {
    if (!planted[t]) continue;
    if (!spans.empty() && t - spans.back().last_frame <= least)
      spans.back().last_frame = t;
    else
      spans.push_back({landmark, t, t});
  }
  std::erase_if(spans, [&](const ContactSpan& span) { return span.frames() < least; });
  return spans;
}

}  // namespace

double ground_height(const Eigen::MatrixXd& tracks, int landmark) {
  constexpr double kShareOfGlitches = 0.02;
  if (tracks.rows() == 0) return 0;
  std::vector<double> heights(tracks.rows());
  Eigen::Map<Eigen::VectorXd>(heights.data(), tracks.rows()) = tracks.col(3 * landmark + 1);
  const auto low = heights.begin() + static_cast<std::ptrdiff_t>(
                                         kShareOfGlitches * static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), low, heights.end());
  return *low;
}

std::vector<ContactSpan> find_contacts(const Eigen::MatrixXd& tracks, double sample_rate_hz,
                                       const std::vector<int>& landmarks,
                                       const ContactSettings& settings) {
  const int least =
      std::max(1, static_cast<int>(std::lround(settings.least_seconds * sample_rate_hz)));
  std::vector<ContactSpan> all;
  for (const int landmark : landmarks) {
    const double rest = ground_height(tracks, landmark);
    const Eigen::VectorXd speed = speeds(tracks, landmark, sample_rate_hz);
    std::vector<bool> planted(tracks.rows());
    bool in_contact = false;
    for (Eigen::Index t = 0; t < tracks.rows(); ++t) {
      const double height = tracks(t, 3 * landmark + 1) - rest;
      in_contact = in_contact ? height < settings.end_height && speed(t) < settings.end_speed
                              : height < settings.begin_height && speed(t) < settings.begin_speed;
      planted[t] = in_contact;
    }
    const std::vector<ContactSpan> spans = spans_of(planted, landmark, least);
    all.insert(all.end(), spans.begin(), spans.end());
  }
  return all;
}

std::vector<ContactSpan> find_foot_contacts(const Skeleton& skeleton, const Eigen::MatrixXd& tracks,
                                            double sample_rate_hz,
                                            const ContactSettings& settings) {
  std::vector<int> landmarks;  // joint j's origin is landmark j
  for (const Effector& foot : find_feet(skeleton)) landmarks.push_back(foot.joint);
  return find_contacts(tracks, sample_rate_hz, landmarks, settings);
}

std::vector<ContactSpan> find_foot_contacts(const Motion& motion, const ContactSettings& settings) {
  const std::vector<Effector> feet = find_feet(motion.skeleton);
  Eigen::MatrixXd tracks(motion.clip.frames(), 3 * std::ssize(feet));
  visit_tracks(motion.skeleton, motion.clip, [&](int first, const Eigen::MatrixXd& block) {
    tracks.middleRows(first, block.rows()) = effector_tracks(block, feet);
  });
  std::vector<int> numbers(feet.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  std::vector<ContactSpan> spans =
      find_contacts(tracks, motion.clip.sample_rate_hz, numbers, settings);
  for (ContactSpan& span : spans) span.landmark = feet[span.landmark].joint;
  return spans;
}

std::vector<ContactSpan> frames_of(const std::vector<ContactSpan>& contacts, int first, int count) {
  std::vector<ContactSpan> inside;
  for (const ContactSpan& span : contacts)
    if (span.last_frame >= first && span.first_frame < first + count)
      inside.push_back({span.landmark, std::max(span.first_frame - first, 0),
                        std::min(span.last_frame - first, count - 1)});
  return inside;
}

}  // namespace mocapress
