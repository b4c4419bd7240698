// SPDX-License-Identifier: MIT
#include "core/batch/verification.h"

#include <algorithm>
#include <functional>

#include "core/base/error.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/decode/runtime_clip.h"
#include "core/codec/encode/search/goal.h"
#include "core/codec/methods/compared_file.h"

namespace mocapress {
namespace {

/// landmark_tracks() of every frame or, for a long clip, of some thousands of its frames: enough to
/// find the ground.
Eigen::MatrixXd tracks_of_some(const Motion& motion) {
  constexpr int kMost = 8192;
  const int step = motion.clip.frames() / kMost + 1;
  const auto frames = Eigen::seq(0, motion.clip.frames() - 1, step);
  return landmark_tracks(motion.skeleton,
                         {motion.clip.sample_rate_hz, motion.clip.channels(frames, Eigen::all)});
}

/// True if the joints' axes are equal within the precision of the file's 32-bit quaternions.
bool same_axes(const Skeleton& a, const Skeleton& b) {
  constexpr double kPrecision = 1e-5;
  return std::equal(a.joints().begin(), a.joints().end(), b.joints().begin(), b.joints().end(),
                    [](const Joint& x, const Joint& y) {
                      return (x.joint_from_axes - y.joint_from_axes).cwiseAbs().maxCoeff() <
                             kPrecision;
                    });
}

/// Receives the decoded motion in blocks of frames, one after the other.
using Block = std::function<void(int first, const Clip& block)>;

class Verifier {
 public:
  Verifier(std::span<const std::byte> file, const Encoder& encoder,
           const VerificationRequest& request)
      : file_(file),
        opened_(read_coded_mcpr(file)),
        encoder_(encoder),
        request_(request),
        motion_(encoder.motion()),
        is_long_(opened_.compressed.segments.has_value()) {
    const CompressedClip& found = opened_.compressed;
    if (found.frames != motion_.clip.frames() ||
        found.skeleton.joint_count() != motion_.skeleton.joint_count() ||
        found.sample_rate_hz != motion_.clip.sample_rate_hz ||
        found.skeleton.channel_count() != motion_.skeleton.channel_count() ||
        !same_axes(found.skeleton, motion_.skeleton))
      refuse();
    coded_ = found.forms.empty() ? motion_.skeleton : with_forms(motion_.skeleton, found.forms);
  }

  Verification run() {
    const Original::Tracks tracks = [this]() -> const Eigen::MatrixXd& {
      return encoder_.original_body();
    };
    const Original original(motion_, is_long_ ? Original::Tracks() : tracks);
    const bool in_blocks = is_long_ && !request_.motion;
    DistortionMeter distortion(motion_.skeleton, motion_.clip.frames(),
                               in_blocks ? Detail::Figures : Detail::Distances);
    FootskateMeter footskate(request_.contacts, motion_.clip.sample_rate_hz);
    VisibilityMeter visibility(motion_.skeleton, motion_.clip.frames(), motion_.clip.sample_rate_hz,
                               request_.contacts, request_.limits);
    const Eigen::Index on_bones = 3 * std::ssize(landmarks(motion_.skeleton));
    const Weighting weighting = opened_.compressed.provenance.weighting;
    PosePoints wanted;
    PosePoints found;
    const auto visit = [&](int first, const TrackRows& there, const TrackRows& decoded) {
      distortion.add(first, there, decoded);
      footskate.add(first, there, decoded);
      visibility.add(first, there, decoded);
      const int row = distortion.worst(weighting).frame - first;
      if (row < 0 || row >= there.rows()) return;  // the worst frame is in an earlier block
      wanted = points_at(there.leftCols(on_bones), row);
      found = points_at(decoded.leftCols(on_bones), row);
    };
    Verification verification;
    const Block compare = [&](int first, const Clip& block) {
      original.compare(first, coded_, block, visit);
      if (!in_blocks)
        put_rows(block.channels, first, motion_.clip.frames(), verification.decoded.channels);
    };
    if (!in_blocks) verification.decoded.sample_rate_hz = motion_.clip.sample_rate_hz;
    verification.by = decode(compare);
    if (!in_blocks)
      verification.decoded =
          in_source_channels(opened_.compressed, std::move(verification.decoded));
    verification.distortion = distortion.distortion();
    verification.footskate = footskate.footskate();
    verification.visibility = visibility.visibility();
    const double ground_cm =
        is_long_ ? ground_of(tracks_of_some(motion_)) : ground_of(encoder_.original_tracks());
    verification.worst = worst_pose(motion_.skeleton, std::move(wanted), std::move(found),
                                    ground_cm, distortion.worst(weighting));
    return verification;
  }

 private:
  [[noreturn]] static void refuse() {
    throw Error("verification: the written file has another shape");
  }

  /// Decodes the motion in the coded channels. Returns the decoder's name.
  std::string_view decode(const Block& visit) const {
    if (opened_.coding() != Coding::Adaptive) {
      visit(0, mocapress::decode(opened_));
      return "library";
    }
    constexpr int kBlock = 8192;
    const RuntimeClip clip(file_, request_.tiers);
    const mcpr_clip_info info = clip.info();
    const int frames = motion_.clip.frames();
    if (info.frames != static_cast<std::uint32_t>(frames) ||
        info.sample_rate != motion_.clip.sample_rate_hz || !clip.has_joints_of(coded_))
      refuse();
    for (int first = 0; first < frames; first += kBlock)
      visit(first,
            {motion_.clip.sample_rate_hz, clip.frames(first, std::min(kBlock, frames - first))});
    return "runtime";
  }

  std::span<const std::byte> file_;
  const OpenedMcpr opened_;
  const Encoder& encoder_;
  const VerificationRequest& request_;
  const Motion& motion_;
  const bool is_long_;
  Skeleton coded_;  // the original's joints with the coded channels
};

}  // namespace

Verification verify(std::span<const std::byte> file, const Encoder& original,
                    const VerificationRequest& request) {
  try {
    return Verifier(file, original, request).run();
  } catch (const FormatError& error) {
    throw Error(std::string("verification: the written file cannot be read: ") + error.what());
  }
}

}  // namespace mocapress
