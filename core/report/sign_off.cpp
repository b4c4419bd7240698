// SPDX-License-Identifier: MIT
#include "core/report/sign_off.h"

#include <algorithm>
#include <functional>
#include <set>
#include <span>

#include "core/base/frame_text.h"
#include "core/base/number_text.h"
#include "core/metrics/sight_limits.h"
#include "core/report/clip_link.h"
#include "core/report/json_value.h"
#include "core/report/markup.h"
#include "core/report/report_phrases.h"
#include "core/report/report_style.h"
#include "core/report/verdict.h"

namespace mocapress {

using namespace html;

namespace {

constexpr std::size_t kWorst = 20;

/// A style sheet without variables, grids and rounded corners, for simple renderers.
constexpr const char* kPaperStyle = R"css(
body { font-family: sans-serif; font-size: 9pt; color: #1b1f24; }
h1 { font-size: 17pt; } h2 { font-size: 12pt; }
h2.every { page-break-before: always; }
p.muted { color: #5a6470; } a { color: #1b1f24; text-decoration: none; }
th { text-align: left; background-color: #e7eaee; font-size: 8pt; }
th, td { padding: 3px; font-size: 8pt; vertical-align: top; }
)css";

std::optional<std::string> stale_verdict(const SignOffClip& clip) {
  return stale_reason(clip.review, clip.source_hash, clip.settings_hash);
}

std::string link_to(const SignOffClip& clip, std::optional<int> frame = {},
                    const std::string& joint = {}) {
  ClipLink link{.clip = clip.path, .frame = frame, .joint = joint};
  if (!clip.take.empty()) link.take = clip.take;
  return link_text(link);
}

std::string linked(const std::string& text, const std::string& link) {
  return element("a", attribute("href", link), escaped(text));
}

std::string or_nothing(const std::string& text) {
  return text.empty() ? kNothing : escaped(text);
}

/// A reason why something is stale, in the report's language; a dash without one.
std::string reason_text(const ReportLanguage& say, const std::optional<std::string>& reason) {
  return or_nothing(reason ? say(*reason) : "");
}

/// Describes visibility: "not visible from 8 m". Empty if visibility was not judged.
std::string sight_text(const ReportLanguage& say, const SignOffFigures& figures) {
  return figures.sight ? sight_phrase(say, *figures.sight, figures.limits.distance_m) : "";
}

/// Describes the limits by which clips were judged, each once: "built-in limits".
std::string limits_text(const SignOff& report) {
  std::set<std::string> texts;
  for (const SignOffClip& clip : report.clips)
    if (clip.figures && clip.figures->sight)
      texts.insert(report.language(limits_text(clip.figures->limits)));
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all;
}

/// A frame's number and time. `numbers` is the number as text, or the numbers of a range that
/// begins there.
std::string moment_text(const SignOffClip& clip, int frame, const std::string& numbers) {
  return clip.sample_rate_hz > 0
             ? numbers + ", " + fixed_text(frame / clip.sample_rate_hz, 2) + " s"
             : numbers;
}

std::string summary(const SignOff& report) {
  const ReportLanguage& say = report.language;
  const SignOffCounts counts = count(report);
  std::string text = say("%1 of %2 reviewed: %3 approved, %4 rejected",
                         {std::to_string(counts.reviewed()), std::to_string(report.clips.size()),
                          std::to_string(counts.approved), std::to_string(counts.rejected)});
  if (counts.stale > 0) text += say("; %1 verdicts stale", {std::to_string(counts.stale)});
  if (counts.waiting > 0) text += say("; %1 without a verdict", {std::to_string(counts.waiting)});
  return text + ".";
}

/// A table of the clips with the largest errors, the worst first.
std::string worst_table(const SignOff& report) {
  const ReportLanguage& say = report.language;
  std::vector<const SignOffClip*> worst;
  for (const SignOffClip& clip : report.clips)
    if (clip.figures && clip.figures->worst_frame) worst.push_back(&clip);
  if (worst.empty()) return "";
  std::ranges::stable_sort(worst, std::greater(),
                           [](const SignOffClip* clip) { return clip->figures->max_cm; });
  std::string lines;
  for (const SignOffClip* clip : std::span(worst).first(std::min(worst.size(), kWorst))) {
    const SignOffFigures& figures = *clip->figures;
    lines += line(
        row_head(clip->name) +
        cell(linked(moment_text(*clip, *figures.worst_frame, frame_text(*figures.worst_frame)),
                    link_to(*clip, figures.worst_frame, figures.worst_point))) +
        cell(format_significant(figures.max_cm)) + cell(or_nothing(figures.worst_point), "name") +
        cell(or_nothing(sight_text(say, figures)), "name") +
        cell(reason_text(say, figures.stale), "wrap"));
  }
  return element(
      "section", attribute("class", "signed"),
      element("h2", "", say("Worst frames")) +
          muted(say("The frame with the largest error of each clip, the largest first.")) +
          table(line(text_head(say("Clip")) + head(say("frame")) + head(say("error, cm")) +
                     text_head(say("point")) + text_head(say("eye")) + text_head(say("stale"))),
                lines));
}

std::string notes_table(const SignOff& report) {
  const ReportLanguage& say = report.language;
  std::string lines;
  for (const SignOffClip& clip : report.clips)
    for (const FrameNote& note : clip.review.notes)
      lines += line(
          row_head(clip.name) +
          cell(linked(moment_text(clip, note.frame, frames_text(note)),
                      link_to(clip, note.frame, note.joint))) +
          cell(or_nothing(note.joint), "name") + cell(escaped(note.text), "wrap") +
          cell(or_nothing(note.reviewer), "wrap") + cell(or_nothing(note.time), "name") +
          cell(reason_text(say, stale_reason(note, clip.source_hash, clip.settings_hash)), "wrap"));
  if (lines.empty()) return "";
  return element(
      "section", attribute("class", "signed"),
      element("h2", "", say("Notes")) +
          table(line(text_head(say("Clip")) + head(say("frame")) + text_head(say("joint")) +
                     text_head(say("note")) + text_head(say("by")) + text_head(say("when")) +
                     text_head(say("stale"))),
                lines));
}

std::string clips_table(const SignOff& report) {
  const ReportLanguage& say = report.language;
  std::string lines;
  for (const SignOffClip& clip : report.clips) {
    const ClipReview& review = clip.review;
    const std::string problem = clip.problem.empty() ? "" : say(clip.problem);
    std::string cells = head(linked(clip.name, link_to(clip)), attribute("scope", "row")) +
                        cell(or_nothing(say(std::string(name(review.verdict)))), "name") +
                        cell(or_nothing(review.reviewer), "wrap") +
                        cell(or_nothing(review.time), "name") +
                        cell(reason_text(say, stale_verdict(clip)), "wrap") +
                        cell(or_nothing(problem.empty()       ? review.note
                                        : review.note.empty() ? problem
                                                              : review.note + "; " + problem),
                             "wrap");
    if (const auto& figures = clip.figures)
      cells += cell(ratio_text(figures->ratio)) + cell(std::to_string(figures->bytes)) +
               cell(format_significant(figures->eps_cm)) +
               cell(format_significant(figures->max_cm)) +
               cell(or_nothing(sight_text(say, *figures)), "name");
    else
      cells += cell(kNothing) + cell(kNothing) + cell(kNothing) + cell(kNothing) + cell(kNothing);
    lines += line(cells);
  }
  return element(
      "section", attribute("class", "signed"),
      element("h2", attribute("class", "every"), say("Every clip")) +
          table(line(text_head(say("Clip")) + text_head(say("verdict")) + text_head(say("by")) +
                     text_head(say("when")) + text_head(say("stale")) + text_head(say("note")) +
                     head(say("ratio")) + head(say("bytes")) + head(say("error, cm")) +
                     head(say("largest, cm")) + text_head(say("eye"))),
                lines));
}

}  // namespace

SignOffCounts count(const SignOff& report) {
  SignOffCounts counts;
  for (const SignOffClip& clip : report.clips) {
    const Verdict verdict = clip.review.verdict;
    if (verdict == Verdict::None)
      ++counts.waiting;
    else if (stale_verdict(clip))
      ++counts.stale;
    else
      ++(verdict == Verdict::Approved ? counts.approved : counts.rejected);
  }
  return counts;
}

std::string sign_off_html(const SignOff& report, ReportMedium medium) {
  const ReportLanguage& say = report.language;
  const std::string judged_by = limits_text(report);
  const std::string title =
      report.title.empty() ? say("Sign-off") : say("Sign-off: %1", {report.title});
  return page_begin(say.code, escaped(title),
                    medium == ReportMedium::Screen ? kReportStyle : kPaperStyle) +
         element("header", "",
                 element("h1", "", escaped(title)) +
                     muted(escaped(report.stamp.program + ", " + report.stamp.time)) +
                     element("p", "", element("b", "", escaped(summary(report))))) +
         worst_table(report) + notes_table(report) + clips_table(report) +
         (judged_by.empty()
              ? ""
              : muted(escaped(say("The eye judges from the viewing distance that is named, by %1.",
                                  {judged_by})))) +
         muted(escaped(say("A verdict or note is stale if the clip's file or its settings have "
                           "changed since; stale verdicts do not count as reviewed. Links open "
                           "the clip in Mocapress on this computer."))) +
         "</main></body></html>\n";
}

std::string sign_off_csv(const SignOff& report) {
  std::string text =
      "clip,take,verdict,reviewer,reviewed,stale,note,ratio,bytes,eps_cm,max_cm,worst_frame,"
      "worst_point,visibility,figures_stale,problem,notes,link,program,reported\n";
  for (const SignOffClip& clip : report.clips) {
    std::string notes;
    for (const FrameNote& note : clip.review.notes)
      notes += (notes.empty() ? "" : "; ") +
               note_text(note, stale_reason(note, clip.source_hash, clip.settings_hash));
    const ClipReview& review = clip.review;
    std::vector<std::string> fields = {
        clip.path,       clip.take,   std::string(name(review.verdict)),
        review.reviewer, review.time, stale_verdict(clip).value_or(""),
        review.note};
    if (const auto& figures = clip.figures)
      fields.insert(fields.end(),
                    {shortest_text(figures->ratio), std::to_string(figures->bytes),
                     shortest_text(figures->eps_cm), shortest_text(figures->max_cm),
                     figures->worst_frame ? std::to_string(*figures->worst_frame) : "",
                     figures->worst_point, sight_text({}, *figures), figures->stale.value_or("")});
    else
      fields.resize(fields.size() + 8);
    fields.insert(fields.end(),
                  {clip.problem, notes, link_to(clip), report.stamp.program, report.stamp.time});
    for (std::size_t i = 0; i < fields.size(); ++i)
      text += (i > 0 ? "," : "") + csv_quoted(fields[i]);
    text += '\n';
  }
  return text;
}

}  // namespace mocapress
