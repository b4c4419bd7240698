// SPDX-License-Identifier: MIT
#include "core/mocapress/encode.h"

#include "core/codec/encode/track_encoder.h"
#include "core/codec/format/source_section.h"
#include "core/mocapress/encode_settings.h"
#include "core/report/loaded_clip.h"

namespace mocapress {

ClipEncoder::ClipEncoder(MotionFile source)
    : clip_(std::make_unique<const LoadedClip>(std::move(source))) {}

ClipEncoder::~ClipEncoder() = default;

const Motion& ClipEncoder::motion() const {
  return clip_->motion();
}

Encoded ClipEncoder::encode(const Settings& settings, const Observer<EncodeProgress>& observer,
                            const std::stop_token& stop) const {
  check(settings);
  EncodeSettings of_clip = encode_settings(settings, motion().skeleton);
  of_clip.figures_only = true;
  Encoding made = clip_->encoder().compress(
      *find_compression_method(settings.method), of_clip, [&](const EncodeProgress& progress) {
        return !stop.stop_requested() && should_continue(observer, progress);
      });
  made.file =
      with_tracks(with_source(made.file, clip_->source()), clip_->tracks(), settings.track_error);
  std::optional<std::size_t> edited;
  if (of_clip.contacts) edited = of_clip.contacts->size();
  const Measurement measurement = clip_->measure(made, edited);
  return {std::move(made.file), measurement, made.complete};
}

Encoded encode(MotionFile source, const Settings& settings,
               const Observer<EncodeProgress>& observer, const std::stop_token& stop) {
  return ClipEncoder(std::move(source)).encode(settings, observer, stop);
}

}  // namespace mocapress
