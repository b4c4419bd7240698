// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/figures.h"

#include <QCoreApplication>

#include "core/feet/footskate.h"
#include "widgets/models/display_names.h"
#include "widgets/models/number_text.h"

namespace mocapress {
namespace {

struct Figures {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Figures)
};

QString displayMethod(const DecodedClip& decoded) {
  if (decoded.of_wavelets && decoded.compressed.basis == Basis::Cubic)
    return displayName(decoded.compressed.provenance.method);
  return methodTitle(decoded.method);
}

}  // namespace

std::optional<ResultFigures> figuresOf(const Document& document) {
  if (!document.decoded()) return {};
  const DecodedClip& decoded = *document.decoded();
  const Provenance& provenance = decoded.compressed.provenance;
  ResultFigures figures;
  figures.ratio = decoded.ratio;
  figures.motion_bytes = decoded.compressed.motion_bytes();
  figures.size_is_estimated = decoded.compressed.likely_bytes.has_value();
  if (!figures.size_is_estimated) figures.file_bytes = document.file().size();
  figures.weighting = provenance.weighting;
  figures.eps_cm = static_cast<double>(provenance.eps_cm);
  figures.max_cm = static_cast<double>(provenance.max_error_cm);
  figures.coefficient_ratio = decoded.coefficient_ratio;
  figures.bits_per_joint_sample = decoded.bits_per_joint_sample;
  if (decoded.footskate) {
    figures.footskate_cm = decoded.footskate->total_cm;
    figures.slide = slide_per_contact(*decoded.footskate, document.contacts().size());
  }
  if (decoded.compressed.correction)
    figures.correction_bytes = decoded.compressed.correction_bytes();
  if (decoded.correction) {
    figures.correction_ratio = decoded.correction->ratio;
    figures.fastest_knee = decoded.correction->fastest_knee;
    figures.fastest_knee_of_original = decoded.correction->fastest_knee_of_original;
  }
  if (decoded.distortion) {
    const Spread spread = decoded.distortion->spread(provenance.weighting);
    figures.eps_cm = spread.rms;
    figures.p95_cm = spread.p95;
    figures.p99_cm = spread.p99;
    figures.max_cm = spread.max.cm;
    figures.skin = decoded.distortion->skin;
    figures.ends = decoded.distortion->ends;
    figures.is_loop = decoded.compressed.loop != Loop::None;
  }
  if (decoded.visibility) {
    const WorstSight& worst = decoded.visibility->worst();
    figures.seen = SeenFigures{decoded.visibility->sight(),
                               worst.cue,
                               document.landmarkNames()[static_cast<std::size_t>(worst.joint)],
                               worst.frame / decoded.clip.sample_rate_hz,
                               worst.times_noticed(),
                               decoded.visibility->unnoticed_from_m,
                               decoded.visibility->limits.distance_m};
  }
  return figures;
}

QString stateOf(const Document& document) {
  if (!document.original() && !document.decoded()) return Figures::tr("Nothing open");
  if (!document.decoded())
    return document.final() ? Figures::tr("Not compressed") : Figures::tr("Compressing…");
  const DecodedClip& decoded = *document.decoded();
  const Method method = decoded.compressed.provenance.method;
  if (!decoded.distortion) return Figures::tr("As recorded in the file");
  if (!decoded.coefficient_ratio && document.savedPath().isEmpty())
    return Figures::tr("%1, with the settings of the study").arg(displayMethod(decoded));
  if (!decoded.coefficient_ratio)
    return Figures::tr("%1, read from the file and measured against the original")
        .arg(displayMethod(decoded));
  if (!document.final()) return Figures::tr("Draft; the refined result follows");
  if (document.unanswered())
    return decoded.effort == Effort::Draft || method != document.options().method
               ? Figures::tr("No result for these settings; the draft is kept")
               : Figures::tr("No result for these settings; the last one is kept");
  if (!decoded.complete) return Figures::tr("Refinement cancelled; the best so far is kept");
  if (method != document.options().method || decoded.effort == Effort::Draft)
    return Figures::tr("Refinement cancelled; the draft is kept");
  if (method == Method::Annealed)
    return Figures::tr("%1, %Ln iteration(s), %L2 s", nullptr, decoded.iterations.value_or(0))
        .arg(displayMethod(decoded))
        .arg(decoded.encode_seconds, 0, 'f', 1);
  return (decoded.compressed.loop == Loop::None ? Figures::tr("%1, %L2 s")
                                                : Figures::tr("%1, %L2 s, as a loop"))
      .arg(displayMethod(decoded))
      .arg(decoded.encode_seconds, 0, 'f', 2);
}

QString footskateSummary(const Document& document) {
  const Footskate* footskate = document.shownFootskate();
  if (!footskate) return Figures::tr("Footskate is measured against the original.");
  const auto contacts = static_cast<int>(document.contacts().size());
  if (contacts == 0) return Figures::tr("No foot stands on the ground in this clip.");
  const SlidePerContact each =
      slide_per_contact(*footskate, document.contacts().size()).value_or(SlidePerContact());
  const QString slid = Figures::tr(
                           "%Ln contact(s): mean drift of the feet %1, worst %2; their path is %3 "
                           "longer than the original's",
                           nullptr, contacts)
                           .arg(lengthText(each.drift_mean_cm), lengthText(each.drift_worst_cm),
                                lengthText(footskate->total_cm));
  return document.uncorrected() ? Figures::tr("%1, without IK").arg(slid) : slid;
}

}  // namespace mocapress
