// SPDX-License-Identifier: MIT
#include "core/report/review_clip.h"

#include "core/codec/format/container.h"
#include "core/codec/methods/compression_method.h"
#include "core/metrics/sight_limits.h"
#include "core/report/markup.h"
#include "core/report/report_phrases.h"
#include "core/report/review_page.h"

namespace mocapress {
namespace {

std::vector<std::byte> nearly_lossless(const Encoder& encoder,
                                       const Observer<EncodeProgress>& observer) {
  EncodeSettings options;
  options.weighting = Weighting::BoneEnds;
  options.target = {Target::Kind::Error, 0.008};  // a draft may exceed this slightly
  options.effort = Effort::Draft;
  options.figures_only = true;
  return write_container(encoder.encode(options, observer).compressed);
}

}  // namespace

std::string review_clip(std::string_view name, const Encoder& original,
                        std::span<const std::byte> file, const Clip* decoded,
                        const Observer<EncodeProgress>& observer) {
  const std::vector<std::byte> before = nearly_lossless(original, observer);
  if (decoded == nullptr) return review_script(name, before, file);
  const Encoder after({original.motion().skeleton, *decoded});
  return review_script(name, before, nearly_lossless(after, observer));
}

std::vector<std::string> review_facts(std::string_view method, double ratio,
                                      const Distortion& distortion, Weighting weighting,
                                      const Visibility& visibility, const ReportLanguage& say) {
  return {
      say(std::string(method_title(method))), ratio_text(ratio),
      say("largest error %1 cm", {format_significant(distortion.worst(weighting).cm)}),
      say("errors %1, by %2", {sight_phrase(say, visibility.sight(), visibility.limits.distance_m),
                               say(limits_text(visibility.limits))})};
}

}  // namespace mocapress
