// SPDX-License-Identifier: MIT
#include "core/codec/encode/split_encode.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/codec/decode/decoder.h"

namespace mocapress {
namespace {

bool leaves_split_open(const EncodeSettings& settings) {
  return settings.correction && !settings.correction->ratio;
}

}  // namespace

SplitEncode::SplitEncode(const ClipAnalysis& analysis, const EncodeSettings& settings,
                         const Observer<EncodeProgress>& observer)
    : analysis_(analysis),
      settings_(settings),
      coder_(analysis, settings),
      passes_(observer),
      paper_(coder_, passes_),
      loop_(coder_, passes_, leaves_split_open(settings)) {}

Trial SplitEncode::run() {
  Trial trial = leaves_split_open(settings_) ? run_with_split()
                                             : run_with(settings_.method, settings_.effort);
  if (trial.complete) check(trial);
  trial.correction_ratio = coder_.correction_ratio();
  trial.slide_without_cm = slide_without_cm_;
  return trial;
}

Trial SplitEncode::run_with_split() {
  Trial trial = find_split();
  if (!trial.complete || (split_method() == settings_.method && split_effort() == settings_.effort))
    return trial;
  slide_without_cm_.reset();  // belongs to another encode
  return run_with(settings_.method, settings_.effort);
}

double SplitEncode::split() {
  find_split();
  return coder_.correction_ratio();
}

void SplitEncode::check(const Trial& trial) const {
  if (settings_.method == Method::ClosedLoop && settings_.effort == Effort::Draft) return;
  const bool by_count = settings_.target.kind == Target::Kind::CoefficientRatio &&
                        settings_.method != Method::ClosedLoop;  // met by construction
  if (!by_count)
    coder_.goal().require_met(trial.excess, trial.achieved,
                              trial.count == coder_.coefficients().total());
}

Trial SplitEncode::run_with(Method method, Effort effort) {
  return method == Method::ClosedLoop ? loop_.run(effort) : paper_.run(method);
}

/// Sets the r_IK of the best split and returns its trial.
Trial SplitEncode::find_split() {
  constexpr int kFinerSteps = 2;
  const bool is_draft = split_effort() == Effort::Draft;
  Trial best = run_with(split_method(), split_effort());
  if (!best.complete) return best;
  EncodeSettings plain = settings_;
  plain.correction.reset();
  const Trial uncorrected =
      SplitEncode(analysis_, plain, passes_.observer()).run_with(split_method(), split_effort());
  best.complete = uncorrected.complete;
  if (!best.complete) return best;
  slide_without_cm_ = coder_.footskate_of(decode(uncorrected.compressed)).total_cm;
  SplitSearch search(*slide_without_cm_, is_draft ? 0 : kFinerSteps);
  search.tried(split_of(best));
  while (const std::optional<double> ratio = best.complete ? search.next() : std::nullopt) {
    coder_.set_correction_ratio(*ratio);
    Trial trial = run_with(split_method(), split_effort());
    const bool complete = trial.complete;
    if (complete && search.tried(split_of(trial))) best = std::move(trial);
    best.complete = complete;
  }
  coder_.set_correction_ratio(search.best().ratio);
  return best;
}

/// The method for trials of the split. Annealing is too slow to be repeated, so standard selection
/// takes its place, unless all trials share one annealing because they keep the same number of
/// coefficients.
Method SplitEncode::split_method() const {
  const bool once = settings_.target.kind == Target::Kind::CoefficientRatio;
  return settings_.method == Method::Annealed && !once ? Method::Standard : settings_.method;
}

/// The effort for trials of the split. A hard maximum and the extras of the best effort are too
/// slow.
Effort SplitEncode::split_effort() const {
  if (is_by_worst(settings_.target)) return Effort::Draft;
  return std::min(settings_.effort, Effort::Default);
}

Split SplitEncode::split_of(const Trial& trial) const {
  const Target::Kind kind = settings_.target.kind;
  const bool is_draft = split_effort() == Effort::Draft && settings_.method == Method::ClosedLoop;
  const bool met =
      is_draft || coder_.goal().met(trial.excess) || kind == Target::Kind::CoefficientRatio;
  const bool size_is_asked = kind == Target::Kind::Ratio || kind == Target::Kind::Size;
  const Clip decoded = decode(trial.compressed);
  const double price = size_is_asked
                           ? exact_eps(analysis_.motion().skeleton, analysis_.original_body(),
                                       decoded, settings_.weighting)
                           : static_cast<double>(trial.compressed.motion_bytes());
  const Footskate slide = coder_.footskate_of(decoded);
  return {coder_.correction_ratio(), met ? price : std::numeric_limits<double>::infinity(),
          slide.total_cm, slide.findings.empty() ? 0 : slide.findings.front().slid_cm};
}

}  // namespace mocapress
