// SPDX-License-Identifier: MIT
#include "core/codec/encode/targeted_encode.h"

#include <utility>

#include "core/codec/encode/segmented_encode.h"
#include "core/codec/encode/split_encode.h"

namespace mocapress {

Trial encode_to_target(const ClipAnalysis& analysis, const EncodeSettings& settings,
                       const Observer<EncodeProgress>& observer) {
  const SegmentLayout layout = even_segments(analysis.motion().clip.frames(), settings.segments);
  if (settings.method == Method::ClosedLoop && layout.count() > 1)
    return encode_in_segments(analysis, settings, layout, observer);
  SplitEncode encode(analysis, settings, observer);
  Trial trial = encode.run();
  if (trial.complete) encode.check(trial);
  trial.correction_ratio = encode.coder().correction_ratio();
  trial.slide_without_cm = encode.slide_without_cm();
  return trial;
}

ScaleTrial encode_at_scale(const ClipAnalysis& analysis, const EncodeSettings& settings,
                           double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights,
                           const Observer<EncodeProgress>& observer) {
  SplitEncode encode(analysis, settings, observer);
  return {encode.loop().run_at(scale, work, frame_weights), encode.coder().loop().finest_scale()};
}

Trial coarsen_to_bound(const ClipAnalysis& analysis, const EncodeSettings& settings,
                       QuantisedSignals coded, const Eigen::VectorXd& bound_cm,
                       const Observer<EncodeProgress>& observer) {
  return SplitEncode(analysis, settings, observer)
      .loop()
      .coarsen({.coded = std::move(coded)}, bound_cm);
}

double find_correction_split(const ClipAnalysis& analysis, const EncodeSettings& settings) {
  return SplitEncode(analysis, settings, {}).split();
}

}  // namespace mocapress
