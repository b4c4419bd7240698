// SPDX-License-Identifier: GPL-3.0-or-later
// Results of compressing the clips of a library, in the studio, in a batch or in the background.
#include <algorithm>
#include <tuple>
#include <utility>

#include "app/jobs/batch_runner.h"
#include "app/studio/document/own_limits.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/batch/batch.h"
#include "core/motion/landmarks.h"

namespace mocapress {

namespace {

/// The achieved value in the unit of the clip's target.
double quantityOf(const DecodedClip& decoded, const EncodeSettings& options) {
  switch (options.target.kind) {
    case Target::Kind::Ratio:
      return decoded.ratio;
    case Target::Kind::Size:
      return static_cast<double>(decoded.compressed.motion_bytes());
    case Target::Kind::Error:
      return decoded.distortion->eps(options.weighting);
    case Target::Kind::MaxError:
      return decoded.distortion->worst(options.weighting).cm;
    case Target::Kind::Visibility:
      return decoded.visibility->worst().times_noticed();
    case Target::Kind::CoefficientRatio:
      break;
  }
  return options.target.value;
}

/// Makes the outcome, including whether the target was met. Requires a distortion.
Outcome outcomeOf(const DecodedClip& decoded, const OriginalClip& original,
                  const EncodeSettings& options, bool has_contacts) {
  const Spread spread = decoded.distortion->spread(options.weighting);
  Outcome outcome{decoded.ratio, spread.rms, spread.max.cm, decoded.compressed.motion_bytes(),
                  reached(options.target, quantityOf(decoded, options))};
  if (decoded.footskate && has_contacts) outcome.slide_cm = decoded.footskate->total_cm;
  if (decoded.visibility) {
    outcome.sight = decoded.visibility->sight();
    outcome.limits = decoded.visibility->limits;
  }
  for (const Warnings* warnings : {&original.warnings, &original.of_character})
    for (const Warning& warning : *warnings)
      outcome.warnings << QString::fromStdString(warning.text());
  outcome.worst_frame = spread.max.frame;
  const auto point = static_cast<std::size_t>(spread.max.landmark);
  outcome.worst_point = landmarks(original.motion().skeleton).at(point).name;
  outcome.source = original.stamp.source;
  return outcome;
}

/// The outcome of a batch's step. Requires that the clip was measured.
Outcome outcomeOf(const BatchStep& step, const Settings& settings) {
  const Measurement& measured = *step.measured;
  Outcome outcome{measured.ratio, measured.eps_cm(settings.weighting),
                  measured.max_cm(settings.weighting), measured.motion_bytes,
                  keeps_promise(settings, measured)};
  outcome.slide_cm = measured.footskate_cm;
  outcome.sight = measured.seen.sight();
  outcome.limits = measured.seen.limits;
  for (const std::string& warning : step.warnings)
    outcome.warnings << QString::fromStdString(warning);
  outcome.worst_frame = measured.worst_frame;
  outcome.worst_point = step.worst_point;
  outcome.source = step.source;
  return outcome;
}

}  // namespace

void Library::noteExported(const QString& path, const Settings& settings,
                           const ReadOptions& reading, const BatchStep& step) {
  ProjectClip* clip = project_.find(clipKey(path, reading.take));
  if (!clip || !step.measured) return;
  if (!clip->settings) clip->settings = NamedSettings{settings, {}};
  Outcome outcome = outcomeOf(step, settings);
  outcome.settings = settings_hash(settings, reading);
  if (settingsHash(*clip) != outcome.settings) return;
  setOutcome(*clip, outcome);
}

void Library::setOutcome(ProjectClip& clip, const Outcome& outcome) {
  known_[{outcome.source, outcome.settings}] = outcome;
  clip.outcome = outcome;
  clip.failure.clear();
  show(clip);
  if (clip.key() == project_.current) emit currentChanged();
}

/// Restores the outcome that the clip had earlier with the same file and settings.
void Library::recallOutcome(ProjectClip& clip) {
  const auto found = known_.find({clip.stamp.source, settingsHash(clip)});
  if (found != known_.end()) clip.outcome = found->second;
}

std::vector<TunedClip> Library::unencoded(std::size_t most, const std::vector<int>& first) const {
  const QString open = session_->openKey();
  // Order of the waiting clips: by place in `first`, then by length, then by row.
  std::vector<std::tuple<std::ptrdiff_t, int, int>> waiting;
  for (int row = 0; row < model_->rowCount(); ++row)
    if (const LibraryEntry& entry = model_->entry(row);
        entry.wantsEncoding() && entry.key() != open)
      waiting.emplace_back(std::find(first.begin(), first.end(), row) - first.begin(), entry.frames,
                           row);
  const std::size_t count = std::min(most, waiting.size());
  std::partial_sort(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(count),
                    waiting.end());
  waiting.resize(count);
  std::vector<TunedClip> clips;
  for (const auto& [place, frames, row] : waiting) {
    clips.push_back(tunedClip(project_, project_.clips[static_cast<std::size_t>(row)]));
    if (clips.back().settings) continue;
    clips.back().settings = NamedSettings{usualPreset(), {}};
    clips.back().settings->preset.limits = withOwnLimits(usualPreset().limits);
  }
  return clips;
}

void Library::noteEncoded(const TunedClip& tuned, const BatchStep& step) {
  const QString key = clipKey(tuned.path, tuned.reading.take);
  ProjectClip* clip = project_.find(key);
  if (!clip || session_->openKey() == key) return;
  if (step.measured) {
    noteExported(tuned.path, tuned.settings->preset, tuned.reading, step);
  } else {
    const std::string made_by = settings_hash(tuned.settings->preset, tuned.reading);
    if (clip->settings && settingsHash(*clip) != made_by) return;  // it has other settings by now
    clip->failure = QString::fromStdString(step.error);
    show(*clip);
  }
  if (step.source.empty() || step.source == clip->stamp.source) return;
  clip->failure =
      tr("The clip's files changed while it was compressed.");  // until they are looked at
  show(*clip);
  checkFiles();
}

void Library::noteOutcome() {
  ProjectClip* clip = openNow();
  const DecodedPtr& decoded = session_->document().decoded();
  if (!clip || !decoded || !decoded->distortion) return;
  if (!clip->settings) {  // opened without settings: the outcome is by the current ones
    clip->settings = settingsNow();
    touch();
  }
  clip->settings->preset.limits = session_->document().options().limits;
  Outcome outcome =
      outcomeOf(*decoded, *session_->document().original(), session_->document().options(),
                !session_->document().contacts().empty());
  outcome.settings = settingsHash(*clip);
  if (clip->outcome != outcome) setOutcome(*clip, outcome);
}

}  // namespace mocapress
