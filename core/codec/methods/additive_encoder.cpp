// SPDX-License-Identifier: MIT
#include "core/codec/methods/additive_encoder.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/decode/runtime_clip.h"
#include "core/codec/format/container.h"
#include "core/motion/body_tracks.h"
#include "core/motion/difference.h"

namespace mocapress {
namespace {

constexpr int kTries = 8;        // most encodes for a target error
constexpr double kShrink = 0.9;  // a try's target is at most this share of the last one's
constexpr double kSafe = 0.995;  // margin on the target that the last try suggests

// Share of a target that is left to the rounding of an engine's floats.
constexpr double kRounding = 1e-5;

void require_possible(const EncodeSettings& settings) {
  const Target::Kind kind = settings.target.kind;
  if (settings.correction) throw Error("inverse kinematics cannot correct an additive clip");
  if (kind == Target::Kind::CoefficientRatio || kind == Target::Kind::Visibility)
    throw Error("an additive clip has a ratio, a size or an error in cm as its target");
}

}  // namespace

AdditiveEncoder::AdditiveEncoder(Motion motion, Motion base)
    : base_(std::move(base)),
      difference_(difference_to(base_, motion)),
      sum_(sum_of(base_, difference_)),
      body_(body_tracks(sum_.skeleton, sum_.clip)),
      on_base_pose_(mocapress::on_base_pose(base_, difference_)) {}

Encoding AdditiveEncoder::compress(const CompressionMethod& method, EncodeSettings settings,
                                   const std::vector<ContactSpan>& contacts,
                                   const Observer<EncodeProgress>& observer) const {
  if (!choose_wavelets(method, settings) || effective_coding(settings) != Coding::Adaptive)
    throw Error("an additive clip needs the adaptive coding, as the closed loop has it");
  require_possible(settings);
  settings.contacts = contacts;
  const Target wanted = settings.target;
  const auto error_cm = [&](const Comparison& found) {
    return settings.target.kind == Target::Kind::Error
               ? found.distortion.eps(settings.weighting)
               : found.distortion.worst(settings.weighting).cm;
  };
  const bool is_error =
      settings.target.kind == Target::Kind::Error || settings.target.kind == Target::Kind::MaxError;
  if (is_error) settings.target.value *= 1 - kRounding;
  for (int left = kTries;; --left) {
    Encoding made = on_base_pose_.compress(method, settings, observer);
    CompressedClip& clip = made.compressed;
    clip.skeleton = difference_.skeleton;  // the same channels, about the joints' own axes
    const Comparison found = measure(write_container(clip), contacts, settings.limits);
    const double found_cm = error_cm(found);
    if (is_error && !reached(wanted, found_cm) && made.complete) {
      if (left == 1) throw TargetMissed("the target error was not met on the base");
      settings.target.value *= std::min(kSafe * wanted.value / found_cm, kShrink);
      continue;
    }
    static_cast<Comparison&>(made) = found;
    clip.provenance.eps_cm = static_cast<float>(found.distortion.eps(settings.weighting));
    clip.provenance.max_error_cm =
        static_cast<float>(found.distortion.worst(settings.weighting).cm);
    made.file = write_container(clip);
    return made;
  }
}

Comparison AdditiveEncoder::measure(std::span<const std::byte> file,
                                    const std::vector<ContactSpan>& contacts,
                                    const SightLimits& limits) const {
  const RuntimeClip coded(file);
  const Clip decoded = in_source_channels(
      read_container(file),
      {difference_.clip.sample_rate_hz, coded.frames(0, difference_.clip.frames())});
  const Motion sum = sum_of(base_, {difference_.skeleton, decoded});
  return compare(sum_, body_, sum.clip, contacts, limits);
}

}  // namespace mocapress
