// SPDX-License-Identifier: MIT
#include "core/codec/encode/segmented_encode.h"

#include <algorithm>
#include <cmath>

#include "core/codec/encode/analysis/clip_analysis.h"
#include "core/codec/encode/mend/end_fit.h"
#include "core/codec/encode/search/goal.h"
#include "core/codec/encode/search/scale_search.h"
#include "core/codec/encode/split_encode.h"
#include "core/codec/encode/trial_coder.h"
#include "core/metrics/rate.h"

namespace mocapress {

SegmentLayout even_segments(int frames, const SegmentPlan& plan) {
  constexpr int kLeast = runtime::kLeastSegment;
  const int longest = std::max(plan.longest, kLeast);
  const int overlap = std::clamp(plan.overlap, 1, kLeast / 2);
  if (frames <= longest) return SegmentLayout::whole(frames);
  const int count = SegmentLayout{frames, longest, overlap}.count();
  const int length = (frames + (count - 1) * overlap + count - 1) / count;
  return {frames, std::max(length, kLeast), overlap};
}

namespace {

class SegmentedEncode {
 public:
  SegmentedEncode(const ClipAnalysis& analysis, const EncodeSettings& settings,
                  const SegmentLayout& layout, const Observer<EncodeProgress>& observer)
      : motion_(analysis.motion()),
        forms_(analysis.chosen_forms()),
        first_angles_(angles_at(motion_, forms_, first_frames(layout))),
        contacts_(contacts_for(analysis, settings)),
        settings_(settings),
        layout_(layout),
        observer_(observer),
        goal_(Original(motion_), settings.target, settings.weighting, contacts_,
              frame_factors(settings.ranges, layout.frames), settings.limits) {
    if (settings_.target.kind == Target::Kind::Size)
      share_of_size_ = static_cast<double>(layout.length) / std::max(layout.frames, 1);
    if (settings_.correction && !settings_.correction->ratio)
      settings_.correction->ratio = find_split();
  }

  Trial run() {
    const ScaleTrials trials{
        .attempt =
            [this](double scale, ClosedLoopWork work, const Eigen::VectorXd& weights) {
              return attempt_scale(scale, work, weights);
            },
        .coarsen = [this](const Trial& trial,
                          const Eigen::VectorXd& bound_cm) { return coarsen(trial, bound_cm); }};
    const ScaleGuess guess{.likely = likely_scale(settings_.target, raw_bytes(motion_.clip)),
                           .finest = [this] { return finest_scale_; },
                           .dear = true,
                           .corrected = settings_.correction.has_value()};
    Trial best =
        search_scale(guess, settings_.target, goal_, settings_.effort, layout_.frames, trials);
    if (best.complete && settings_.effort != Effort::Draft)
      goal_.require_met(best.excess, best.achieved,
                        best.count == layout_.coded_frames() * motion_.clip.channels.cols());
    if (settings_.correction) best.correction_ratio = *settings_.correction->ratio;
    return best;
  }

 private:
  static std::vector<int> first_frames(const SegmentLayout& layout) {
    std::vector<int> frames;
    for (int k = 0; k < layout.count(); ++k) frames.push_back(layout.first(k));
    return frames;
  }

  /// Finds the r_IK that suits the segment with the most contacts; all segments use it.
  double find_split() const {
    const int segment = most_contacts();
    const ClipAnalysis analysis(motion_of(segment));
    const EncodeSettings settings = settings_for(segment);
    return SplitEncode(analysis, settings, {}).split();
  }

  int most_contacts() const {
    int most = 0;
    int found = layout_.count() / 2;
    for (int k = 0; k < layout_.count(); ++k) {
      int frames = 0;
      for (const ContactSpan& span : contacts_of(k)) frames += span.frames();
      if (frames <= most) continue;
      most = frames;
      found = k;
    }
    return found;
  }

  std::vector<ContactSpan> contacts_of(int segment) const {
    return frames_of(contacts_, layout_.first(segment), layout_.frames_of(segment));
  }

  /// A segment's motion in the coded forms, with the angles that a conversion of the whole clip
  /// gives.
  Motion motion_of(int segment) const {
    return with_forms(frames_of(motion_, layout_.first(segment), layout_.frames_of(segment)),
                      forms_, first_angles_[segment]);
  }

  EncodeSettings settings_for(int segment) const {
    EncodeSettings settings = settings_;
    settings.target.value *= share_of_size_;
    settings.contacts = contacts_of(segment);
    settings.ranges =
        frames_of(settings_.ranges, layout_.first(segment), layout_.frames_of(segment));
    return settings;
  }

  Trial attempt_scale(double scale, ClosedLoopWork work, const Eigen::VectorXd& frame_weights) {
    Trial trial = encode_all(scale, [&](const Part& part, const EncodeSettings& settings,
                                        const Observer<EncodeProgress>& observer) {
      const Eigen::VectorXd weights = frame_weights.size() > 0
                                          ? frame_weights.segment(part.first, part.frames).eval()
                                          : frame_weights;
      SplitEncode encode(part.analysis, settings, observer);
      Trial coded = encode.loop().run_at(
          scale, part.should_continue ? work : ClosedLoopWork::Rounding, weights);
      finest_scale_ = std::max(finest_scale_, encode.coder().loop().finest_scale());
      // Without sweeps the observer has not been called yet.
      if (work != ClosedLoopWork::Sweeps && part.should_continue)
        coded.complete = observer(EncodeProgress{.iteration = part.index + 1});
      return coded;
    });
    if (trial.complete && work != ClosedLoopWork::Rounding) finish_ends(trial);
    weigh(work, trial);
    return trial;
  }

  void finish_ends(Trial& trial) const {
    if (!codes_ends(settings_)) return;
    const int rows = frames_at_ends(layout_.frames);
    const Motion first = motion_of(0);
    const Motion last = motion_of(layout_.count() - 1);
    fit_ends(settings_, trial, first.skeleton, still_channels(motion_.clip), goal_,
             first.clip.channels.topRows(rows), last.clip.channels.bottomRows(rows));
  }

  /// Coarsens each segment by itself. Where two segments blend, the error is at most the larger of
  /// theirs, apart from non-linear effects.
  Trial coarsen(const Trial& trial, const Eigen::VectorXd& bound_cm) {
    AdaptiveSegments coded(trial.compressed);
    Trial coarser = encode_all(trial.scale, [&](const Part& part, const EncodeSettings& settings,
                                                const Observer<EncodeProgress>& observer) {
      if (!part.should_continue) return Trial{.complete = false};
      return SplitEncode(part.analysis, settings, observer)
          .loop()
          .coarsen({.coded = coded.next()}, bound_cm.segment(part.first, part.frames));
    });
    if (!coarser.complete) return coarser;
    finish_ends(coarser);
    weigh(ClosedLoopWork::Sweeps, coarser);
    return coarser;
  }

  /// A segment to be coded.
  struct Part {
    int index;
    const ClipAnalysis& analysis;
    int first;  // its first frame
    int frames;
    bool should_continue;  // false: the observer ended it
  };

  /// Runs all segments; the result is not measured yet.
  template <typename EncodePart>
  Trial encode_all(double scale, const EncodePart& encode) {
    Trial trial{.compressed = {.skeleton = with_forms(motion_.skeleton, forms_),
                               .sample_rate_hz = motion_.clip.sample_rate_hz,
                               .frames = layout_.frames,
                               .basis = settings_.basis,
                               .coding = settings_.coding,
                               .segments = CodedSegments{layout_.length, layout_.overlap, {}}},
                .scale = scale};
    double squares = 0;
    for (int k = 0; k < layout_.count(); ++k) {
      const ClipAnalysis analysis(motion_of(k));  // freed before the next segment
      const Part part{k, analysis, layout_.first(k), layout_.frames_of(k), trial.complete};
      const Trial coded = encode(part, settings_for(k), [&](const EncodeProgress& of_segment) {
        EncodeProgress progress = of_segment;
        progress.pass = pass_;
        progress.iteration += trial.iterations;
        return should_continue(observer_, progress);
      });
      add(coded, trial);
      squares += part.frames * coded.eps_cm * coded.eps_cm;
    }
    ++pass_;
    trial.eps_cm = std::sqrt(squares / static_cast<double>(layout_.coded_frames()));
    return trial;
  }

  static void add(const Trial& segment, Trial& whole) {
    const CompressedClip& coded = segment.compressed;
    CompressedClip& to = whole.compressed;
    to.motion.insert(to.motion.end(), coded.motion.begin(), coded.motion.end());
    to.segments->bytes.push_back(static_cast<std::uint32_t>(coded.motion.size()));
    to.correction = coded.correction;
    whole.count += segment.count;
    whole.iterations += segment.iterations;
    whole.complete = whole.complete && segment.complete;
  }

  void weigh(ClosedLoopWork work, Trial& trial) const {
    const bool is_guess = settings_.effort == Effort::Draft || work == ClosedLoopWork::Rounding;
    const bool by_model = is_guess && settings_.target.kind == Target::Kind::Error &&
                          !settings_.correction && settings_.importance.is_even() &&
                          settings_.ranges.empty();
    if (by_model)
      trial.achieved = trial.eps_cm;  // the model's estimate is close enough
    else if (settings_.target.kind == Target::Kind::CoefficientRatio)
      trial.achieved = static_cast<double>(motion_.clip.channels.size()) / std::max(trial.count, 1);
    else
      trial.achieved = goal_.achieved(trial.compressed);
    trial.excess = goal_.excess(trial.achieved);
  }

  const Motion& motion_;
  const RotationForms& forms_;
  const std::vector<Eigen::Matrix3Xd> first_angles_;  // one for each segment
  const std::vector<ContactSpan> contacts_;
  EncodeSettings settings_;
  const SegmentLayout layout_;
  const Observer<EncodeProgress>& observer_;
  const Goal goal_;
  double share_of_size_ = 1;
  double finest_scale_ = 0;  // largest finest_scale() of the segments so far
  int pass_ = 0;
};

}  // namespace

Trial encode_in_segments(const ClipAnalysis& analysis, const EncodeSettings& settings,
                         const SegmentLayout& layout, const Observer<EncodeProgress>& observer) {
  return SegmentedEncode(analysis, settings, layout, observer).run();
}

}  // namespace mocapress
