// SPDX-License-Identifier: MIT
#include "core/codec/encode/targeted_encode.h"

#include <utility>

#include "core/codec/encode/segmented_encode.h"
#include "core/codec/encode/split_encode.h"

namespace mocapress {

TargetedEncoding encode_to_target(const ClipAnalysis& analysis, const EncodeOptions& options,
                                  const Observer<EncodeProgress>& observer) {
  const SegmentLayout layout = even_segments(analysis.motion().clip.frames(), options.segments);
  if (options.method == Method::ClosedLoop && layout.count() > 1)
    return encode_in_segments(analysis, options, layout, observer);
  SplitEncode encode(analysis, options, observer);
  Trial trial = encode.run();
  if (trial.complete) encode.check(trial);
  return {std::move(trial.compressed), trial.count,      encode.coder().correction_ratio(),
          encode.slide_without_cm(),   trial.iterations, trial.complete};
}

ScaleTrial encode_at_scale(const ClipAnalysis& analysis, const EncodeOptions& options, double scale,
                           ClosedLoopWork work, const Eigen::VectorXd& frame_weights,
                           const Observer<EncodeProgress>& observer) {
  SplitEncode encode(analysis, options, observer);
  return {encode.loop().run_at(scale, work, frame_weights), encode.coder().loop().finest_scale()};
}

Trial coarsen_to_bound(const ClipAnalysis& analysis, const EncodeOptions& options,
                       QuantisedSignals coded, const Eigen::VectorXd& bound_cm,
                       const Observer<EncodeProgress>& observer) {
  return SplitEncode(analysis, options, observer)
      .loop()
      .coarsen({.coded = std::move(coded)}, bound_cm);
}

double find_correction_split(const ClipAnalysis& analysis, const EncodeOptions& options) {
  return SplitEncode(analysis, options, {}).split();
}

}  // namespace mocapress
