// SPDX-License-Identifier: MIT
#include "tests/support/segmented_clip.h"

#include <cmath>

#include "core/codec/encode/segmented_encode.h"
#include "core/select/ranking.h"

namespace mocapress::test {
namespace {

QuantisedSignals coded(const Clip& clip, double kept_share, float scale) {
  const RankedCoefficients ranked = rank_coefficients(clip, Basis::Cubic);
  const std::vector<double> alike(static_cast<std::size_t>(ranked.channels()), 1.0);
  const auto count = static_cast<int>(kept_share * ranked.total());
  return quantise_kept(ranked, alike, keep_per_channel(ranked, count), scale);
}

}  // namespace

CompressedClip segmented_clip(const Motion& motion, const SegmentLayout& layout, bool corrected,
                              double kept_share) {
  CompressedClip clip{.skeleton = motion.skeleton,
                      .sample_rate_hz = motion.clip.sample_rate_hz,
                      .frames = layout.frames,
                      .coding = Coding::Adaptive,
                      .motion = {}};
  clip.provenance.method = Method::ClosedLoop;
  if (layout.count() > 1) clip.segments = CodedSegments{layout.length, layout.overlap, {}};
  const int joints = motion.skeleton.joint_count();
  if (corrected)
    clip.correction = CodedCorrection{.solver = IkSolver::NearestPose,
                                      .effectors = {effector_at(motion.skeleton, joints - 1),
                                                    effector_at(motion.skeleton, joints - 4)}};
  for (int k = 0; k < layout.count(); ++k) {
    const int first = layout.first(k);
    const float scale = file_scale(0.4 + 0.1 * k);  // other than before, so that blends show
    const Motion part = frames_of(motion, first, layout.frames_of(k));
    QuantisedSignals signals_of_part = coded(part.clip, kept_share, scale);
    if (corrected) {
      Clip differences{clip.sample_rate_hz, Eigen::MatrixXd(part.clip.frames(), 6)};
      for (int t = 0; t < part.clip.frames(); ++t)
        for (int s = 0; s < 6; ++s)
          differences.channels(t, s) = 2 * std::sin(0.03 * (first + t) + s + 0.3 * k);
      append(coded(differences, kept_share, scale), signals_of_part);
    }
    const std::vector<std::byte> bytes = pack_adaptive(signals_of_part, clip);
    if (clip.segments) clip.segments->bytes.push_back(static_cast<std::uint32_t>(bytes.size()));
    clip.motion.insert(clip.motion.end(), bytes.begin(), bytes.end());
  }
  return clip;
}

}  // namespace mocapress::test
