// SPDX-License-Identifier: MIT
#include "core/codec/encode/encoder.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/names_all.h"
#include "core/base/parallel.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/encode/analysis/clip_analysis.h"
#include "core/codec/encode/search/goal.h"
#include "core/codec/encode/segmented_encode.h"
#include "core/codec/encode/split_encode.h"
#include "core/codec/encode/trial_coder.h"
#include "core/codec/format/room.h"
#include "core/feet/feet.h"
#include "core/ik/correction.h"

namespace mocapress {
namespace {

/// Decodes an encoding, measures it, and keeps the results that were asked for.
class Outcome {
 public:
  /// `source`: the rotation forms of the decoded clip, where they differ from the coded ones.
  Outcome(const ClipAnalysis& analysis, const EncodeSettings& settings,
          const CompressedClip& compressed, const std::optional<RotationForms>& source)
      : original_(compressed.segments ? Original(analysis.motion()) : original_of(analysis)),
        keeps_all_(!settings.figures_only),
        compressed_(compressed),
        source_(source),
        landmark_columns_(3 * std::ssize(landmarks(compressed.skeleton))),
        finish_(compressed),
        distortion_(compressed.skeleton, compressed.frames,
                    keeps_all_ || !compressed.segments ? Detail::Distances : Detail::Figures),
        footskate_(contacts_for(analysis, settings), compressed.sample_rate_hz),
        visibility_(compressed.skeleton, compressed.frames, compressed.sample_rate_hz,
                    contacts_for(analysis, settings), settings.limits,
                    compressed.segments ? nullptr : &analysis.original_jitter()) {
    if (compressed.correction)
      knees_.emplace(compressed.skeleton, compressed.correction->effectors);
  }

  void run(const Trial& found, Encoding& encoding) {
    if (keeps_all_) decoded_.sample_rate_hz = compressed_.sample_rate_hz;
    visit_decoded(compressed_, [&](int first, Uncorrected& block) { add(first, block); });
    encoding.decoded = std::move(decoded_);
    encoding.tracks = std::move(tracks_);
    encoding.distortion = distortion_.distortion();
    if (!keeps_all_) encoding.distortion.distances.resize(0, 0);
    encoding.footskate = footskate_.footskate();
    encoding.visibility = visibility_.visibility();
    if (!knees_) return;
    correction_.ratio = found.correction_ratio;
    correction_.slide_without_cm = found.slide_without_cm;
    correction_.bytes = compressed_.correction_bytes();
    correction_.fastest_knee = knees_->fastest();
    correction_.fastest_knee_of_original = fastest_knee(
        original_.motion().skeleton, compressed_.correction->effectors, original_.motion().clip);
    encoding.correction = std::move(correction_);
  }

 private:
  void add(int first, Uncorrected& block) {
    finish(first, block);
    if (keeps_all_ && source_) {
      Clip converted;
      parallel_for(0, 2, [&](int part) {
        if (part == 0)
          compare(first, block.clip);
        else
          converted = with_forms(Motion{compressed_.skeleton, block.clip}, *source_).clip;
      });
      block.clip = std::move(converted);
    } else {
      compare(first, block.clip);
    }
    if (keeps_all_)
      put_rows(std::move(block.clip.channels), first, compressed_.frames, decoded_.channels);
  }

  void compare(int first, const Clip& clip) {
    const auto measure = [&](int from, const TrackRows& original, const TrackRows& decoded) {
      parallel_for(0, 2, [&](int part) {
        if (part == 0) {
          distortion_.add(from, original, decoded);
        } else {
          footskate_.add(from, original, decoded);
          visibility_.add(from, original, decoded);
        }
      });
      if (keeps_all_)
        put_rows(decoded.leftCols(landmark_columns_), from, compressed_.frames, tracks_);
    };
    original_.compare(first, compressed_.skeleton, clip, measure);
  }

  void finish(int first, Uncorrected& block) {
    if (knees_ && keeps_all_) {
      Eigen::MatrixXd uncorrected = block.clip.channels;
      finish_.add_ends(first, uncorrected);
      put_rows(std::move(uncorrected), first, compressed_.frames, correction_.uncorrected.channels);
    }
    correction_.report.add(finish_(first, block));
    if (knees_) knees_->add(block.clip);
  }

  const Original original_;
  const bool keeps_all_;
  const CompressedClip& compressed_;
  const std::optional<RotationForms>& source_;
  const Eigen::Index landmark_columns_;  // columns of body_tracks() that are landmarks
  const Finish finish_;
  DistortionMeter distortion_;
  FootskateMeter footskate_;
  VisibilityMeter visibility_;
  std::optional<KneeSpeed> knees_;  // none without a correction
  CorrectionResult correction_;
  Clip decoded_;
  Eigen::MatrixXd tracks_;
};

/// The clip's shape (frames, channels, segments) under these settings.
ClipShape shape_for(const Motion& motion, const EncodeSettings& settings) {
  const int frames = motion.clip.frames();
  ClipShape shape{motion.skeleton, motion.clip.sample_rate_hz,
                  settings.method == Method::ClosedLoop ? even_segments(frames, settings.segments)
                                                        : SegmentLayout::whole(frames)};
  if (settings.correction)
    shape.effectors =
        static_cast<int>(settings.correction->joints.empty() ? find_feet(motion.skeleton).size()
                                                             : settings.correction->joints.size());
  return shape;
}

/// Encodes to the target; the closed loop encodes long clips segment by segment.
Trial encode_to_target(const ClipAnalysis& analysis, const EncodeSettings& settings,
                       const Observer<EncodeProgress>& observer) {
  const SegmentLayout layout = even_segments(analysis.motion().clip.frames(), settings.segments);
  if (settings.method == Method::ClosedLoop && layout.count() > 1)
    return encode_in_segments(analysis, settings, layout, observer);
  return SplitEncode(analysis, settings, observer).run();
}

}  // namespace

std::string_view name(Effort effort) {
  constexpr std::string_view kNames[] = {"draft", "default", "best"};
  static_assert(names_all<Effort>(kNames));
  return kNames[static_cast<std::size_t>(effort)];
}

Encoder::Encoder(Motion motion) : analysis_(std::make_unique<ClipAnalysis>(std::move(motion))) {}
Encoder::~Encoder() = default;

const Motion& Encoder::motion() const {
  return analysis_->motion();
}
const Eigen::MatrixXd& Encoder::original_tracks() const {
  return analysis_->original_tracks();
}

const Eigen::MatrixXd& Encoder::original_body() const {
  return analysis_->original_body();
}

const std::vector<ContactSpan>& Encoder::contacts() const {
  return analysis_->contacts();
}

Encoding Encoder::encode(const EncodeSettings& settings,
                         const Observer<EncodeProgress>& observer) const {
  constexpr int kRoundsOfWeights = 6;
  constexpr int kMostRounds = 16;
  Encoding encoding = encode_once(settings, observer);
  const bool promises = settings.effort != Effort::Draft && is_error(settings.target);
  EncodeSettings stricter = settings;
  for (int round = 1; promises && encoding.complete; ++round) {
    const std::vector<BrokenPromise> broken =
        broken_promises(settings.promises, motion(), encoding.distortion);
    if (broken.empty()) break;
    if (round > kMostRounds)
      throw TargetMissed("a promise beside the target is out of reach: " + broken.front().text);
    raise_importance(broken, motion().skeleton, stricter.importance);
    // If weights alone do not keep the promises, the target gets stricter, too.
    if (round > kRoundsOfWeights) stricter.target.value /= broken.front().times;
    const double seconds = encoding.seconds;
    encoding = encode_once(stricter, observer);
    encoding.seconds += seconds;
  }
  return encoding;
}

Encoding Encoder::encode_once(const EncodeSettings& settings,
                              const Observer<EncodeProgress>& observer) const {
  const auto start = std::chrono::steady_clock::now();
  EncodeSettings effective = settings;
  effective.coding = effective_coding(settings);
  check_room(shape_for(motion(), effective));
  if (!effective.loop) effective.loop = analysis_->loop();
  // Segments are converted to other forms one by one; the whole motion would be in memory twice.
  const bool is_whole = even_segments(motion().clip.frames(), effective.segments).count() == 1;
  const ClipAnalysis& analysis = effective.method == Method::ClosedLoop && is_whole
                                     ? analysis_->in_chosen_forms()
                                     : *analysis_;
  Trial found = encode_to_target(analysis, effective, observer);

  const bool is_draft = settings.method == Method::ClosedLoop && settings.effort == Effort::Draft;
  Encoding encoding;
  const bool in_other_forms = &analysis != analysis_.get();
  std::optional<RotationForms> source;
  if (in_other_forms) source = rotation_forms(motion().skeleton);
  Outcome outcome(analysis, effective, found.compressed, source);
  const bool is_estimated = found.compressed.likely_bytes.has_value();
  if (is_draft && found.compressed.known && found.compressed.motion.empty() && !is_estimated) {
    // Runs in parallel: coding takes as long as decoding and measuring together.
    std::vector<std::byte> motion;
    parallel_for(0, 2, [&](int part) {
      if (part == 0)
        motion = pack_adaptive(found.compressed.known->coded(), found.compressed);
      else
        outcome.run(found, encoding);
    });
    found.compressed.motion = std::move(motion);
  } else {
    outcome.run(found, encoding);
  }
  if (!is_estimated) found.compressed.known.reset();
  encoding.compressed = std::move(found.compressed);
  encoding.compressed.loop = *effective.loop;
  if (effective.method == Method::ClosedLoop &&
      analysis_->chosen_forms() != rotation_forms(motion().skeleton)) {
    encoding.compressed.forms = analysis_->chosen_forms();
    encoding.compressed.skeleton = motion().skeleton;
    if (!settings.figures_only && !in_other_forms)
      encoding.decoded = in_source_channels(encoding.compressed, std::move(encoding.decoded));
  }
  encoding.compressed.provenance = {
      settings.method, settings.weighting, settings.seed,
      static_cast<float>(encoding.distortion.eps(settings.weighting)),
      static_cast<float>(encoding.distortion.worst(settings.weighting).cm)};
  encoding.coefficient_ratio =
      static_cast<double>(motion().clip.channels.size()) / std::max(found.count, 1);
  if (settings.method == Method::Annealed) encoding.iterations = found.iterations;
  encoding.complete = found.complete;
  encoding.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return encoding;
}

}  // namespace mocapress
