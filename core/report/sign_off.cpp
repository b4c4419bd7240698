// SPDX-License-Identifier: MIT
#include "core/report/sign_off.h"

#include <algorithm>
#include <functional>
#include <span>

#include "core/base/number_text.h"
#include "core/report/clip_link.h"
#include "core/report/json_value.h"
#include "core/report/markup.h"
#include "core/report/report_style.h"
#include "core/report/verdict.h"

namespace mocapress {

using namespace html;

namespace {

constexpr std::size_t kWorst = 20;

/// Without variables, grids and rounded corners.
constexpr const char* kPaperStyle = R"css(
body { font-family: sans-serif; font-size: 9pt; color: #1b1f24; }
h1 { font-size: 17pt; } h2 { font-size: 12pt; }
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

std::string muted(std::string_view text) {
  return element("p", attribute("class", "muted"), text);
}

std::string left(std::string_view text) {
  return head(text, attribute("class", "name"));
}

/// "not visible", "borderline", "visible"; empty: nobody looked.
std::string sight_text(const SignOffFigures& figures) {
  if (!figures.sight) return "";
  return *figures.sight == Sight::NotVisible ? "not visible" : std::string(name(*figures.sight));
}

std::string moment_text(const SignOffClip& clip, int frame) {
  const std::string text = std::to_string(frame);
  return clip.sample_rate_hz > 0 ? text + ", " + fixed_text(frame / clip.sample_rate_hz, 2) + " s"
                                 : text;
}

std::string summary(const SignOff& report) {
  const SignOffCounts counts = count(report);
  std::string text = std::to_string(counts.reviewed()) + " of " +
                     std::to_string(report.clips.size()) +
                     " reviewed: " + std::to_string(counts.approved) + " approved, " +
                     std::to_string(counts.rejected) + " rejected";
  if (counts.stale > 0) text += "; " + std::to_string(counts.stale) + " verdicts stale";
  if (counts.waiting > 0) text += "; " + std::to_string(counts.waiting) + " without a verdict";
  return text + ".";
}

/// Clips by the largest error, the worst first.
std::string worst_table(const SignOff& report) {
  std::vector<const SignOffClip*> worst;
  for (const SignOffClip& clip : report.clips)
    if (clip.figures && clip.figures->worst_frame) worst.push_back(&clip);
  if (worst.empty()) return "";
  std::ranges::stable_sort(worst, std::greater(),
                           [](const SignOffClip* clip) { return clip->figures->max_cm; });
  std::string lines;
  for (const SignOffClip* clip : std::span(worst).first(std::min(worst.size(), kWorst))) {
    const SignOffFigures& figures = *clip->figures;
    lines += line(row_head(clip->name) +
                  cell(linked(moment_text(*clip, *figures.worst_frame),
                              link_to(*clip, figures.worst_frame, figures.worst_point))) +
                  cell(format_significant(figures.max_cm)) +
                  cell(or_nothing(figures.worst_point), "name") +
                  cell(or_nothing(sight_text(figures)), "name") +
                  cell(or_nothing(figures.stale.value_or("")), "wrap"));
  }
  return element("section", "",
                 element("h2", "", "Worst frames") +
                     muted("The frame with the largest error of each clip, the largest first. "
                           "Frames count from 0.") +
                     table(line(left("Clip") + head("frame") + head("error, cm") + left("point") +
                                left("eye") + left("stale")),
                           lines));
}

std::string notes_table(const SignOff& report) {
  std::string lines;
  for (const SignOffClip& clip : report.clips)
    for (const FrameNote& note : clip.review.notes)
      lines += line(
          row_head(clip.name) +
          cell(linked(moment_text(clip, note.frame), link_to(clip, note.frame, note.joint))) +
          cell(or_nothing(note.joint), "name") + cell(escaped(note.text), "wrap") +
          cell(or_nothing(note.reviewer), "name") + cell(or_nothing(note.time), "name") +
          cell(or_nothing(stale_reason(note, clip.source_hash, clip.settings_hash).value_or("")),
               "wrap"));
  if (lines.empty()) return "";
  return element("section", "",
                 element("h2", "", "Notes") +
                     table(line(left("Clip") + head("frame") + left("joint") + left("note") +
                                left("by") + left("when") + left("stale")),
                           lines));
}

std::string clips_table(const SignOff& report) {
  std::string lines;
  for (const SignOffClip& clip : report.clips) {
    const ClipReview& review = clip.review;
    const std::string stale = stale_verdict(clip).value_or("");
    std::string cells = head(linked(clip.name, link_to(clip)), attribute("scope", "row")) +
                        cell(or_nothing(std::string(name(review.verdict))), "name") +
                        cell(or_nothing(review.reviewer), "name") +
                        cell(or_nothing(review.time), "name") + cell(or_nothing(stale), "wrap") +
                        cell(or_nothing(clip.problem.empty()  ? review.note
                                        : review.note.empty() ? clip.problem
                                                              : review.note + "; " + clip.problem),
                             "wrap");
    if (const auto& figures = clip.figures)
      cells += cell(ratio_text(figures->ratio)) + cell(std::to_string(figures->bytes)) +
               cell(format_significant(figures->eps_cm)) +
               cell(format_significant(figures->max_cm)) +
               cell(or_nothing(sight_text(*figures)), "name");
    else
      cells += cell(kNothing) + cell(kNothing) + cell(kNothing) + cell(kNothing) + cell(kNothing);
    lines += line(cells);
  }
  return element("section", "",
                 element("h2", "", "Every clip") +
                     table(line(left("Clip") + left("verdict") + left("by") + left("when") +
                                left("stale") + left("note") + head("ratio") + head("bytes") +
                                head("error, cm") + head("largest, cm") + left("eye")),
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
  const std::string title = "Sign-off" + (report.title.empty() ? "" : ": " + report.title);
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><meta "
         "name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>" +
         element("title", "", escaped(title)) +
         element("style", "", medium == ReportMedium::Screen ? kReportStyle : kPaperStyle) +
         "</head><body><main>" +
         element("header", "",
                 element("h1", "", escaped(title)) +
                     muted(escaped(report.stamp.program + ", " + report.stamp.time)) +
                     element("p", "", element("b", "", escaped(summary(report))))) +
         worst_table(report) + notes_table(report) + clips_table(report) +
         muted(
             "A verdict or note is stale if the clip&#8217;s file or its settings have changed "
             "since; stale verdicts do not count as reviewed. Links open the clip in Mocapress "
             "on this computer.") +
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
                     figures->worst_point, sight_text(*figures), figures->stale.value_or("")});
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
